"""The words that a user's own unit names are heard, whatever the models think of them by themselves."""

from typing import Dict, Tuple

import pytest

from offline_pipeline.knowledge import load_texts, pretend_servers
from offline_pipeline.pipeline import Pipeline
from stanford_parser_ros.joint.lexicon_hints import RULE
from stanford_parser_ros.model import Parser, shipped_parser

#: Those of English, and what the training part of EWT has as ``case`` ten times or more. There "due", "because",
#: "according" and "prior" begin a preposition of two words. "Instead of" and "such as" are no place to crawl.
PREPOSITIONS = """
    aboard about above according_to across after against along alongside amid among amongst around as at athwart atop
    because_of before behind below beneath beside between beyond by concerning despite down due_to during except
    following for from in including inside into like near next_to of off on onto opposite out out_of outside over past
    per prior_to regarding round since than through throughout till to toward towards under underneath unlike until up
    upon via with within without
""".split()
#: Behind a thing these say when.
OF_TIMES = frozenset(["after", "before"])
PARTICLES = "about across along around by down in off on out over round through under up".split()
FRAME = """
name: crawling
frame_elements:
  - {name: path, is_core: True}
  - {name: theme, is_core: False}
"""


@pytest.fixture(scope="module")
def parser() -> Parser:
    return shipped_parser()


def heard(parser: Parser, text: str, *elements: str, without: str = "") -> Tuple[str, Dict[str, str]]:
    """The code of the reply, and the arguments, with one unit of "crawl".

    Args:
        text: what is said
        elements: of the unit
        without: a rule that is switched off
    """
    lines = "".join(f"  - {{{one}}}\n" for one in elements)
    unit = f"frame_name: crawling\nverb: crawl\nframe_element_grammatical_relations:\n{lines}"
    knowledge = load_texts([("frame.yaml", lambda: FRAME)], [("unit.yaml", lambda: unit)])
    assert knowledge.problems == ()
    pretend_servers(knowledge.graph)
    found = Pipeline(knowledge, parser, without=frozenset([without])).understand(text)
    return found.reply.code, {one.name: one.text for reading in found.readings for one in reading.arguments}


@pytest.mark.parametrize("name", PREPOSITIONS)
def test_a_preposition_of_a_unit_is_heard(parser: Parser, name: str) -> None:
    word, path = name.replace("_", " "), f"name: path, relation: prep_{name}"
    assert heard(parser, f"Crawl {word} the wall.", path) == ("DONE", {"path": "wall"})


@pytest.mark.parametrize("name", [name for name in PREPOSITIONS if name not in OF_TIMES])
def test_a_preposition_behind_the_object_is_heard(parser: Parser, name: str) -> None:
    found = heard(
        parser,
        f"Crawl the box {name.replace('_', ' ')} the wall.",
        "name: theme, relation: dobj",
        f"name: path, relation: prep_{name}",
    )
    assert found == ("DONE", {"theme": "box", "path": "wall"})


@pytest.mark.parametrize("word", PARTICLES)
def test_a_particle_of_a_unit_is_heard(parser: Parser, word: str) -> None:
    theme, path = "name: theme, relation: dobj", f"name: path, relation: prt, words: [{word}]"
    assert heard(parser, f"Crawl {word}.", path) == ("DONE", {"path": word})
    for text in (f"Crawl {word} the wall.", f"Crawl the wall {word}."):
        assert heard(parser, text, theme, path) == ("DONE", {"theme": "wall", "path": word})


def test_without_the_rule_a_word_that_the_models_do_not_know_is_not_heard(parser: Parser) -> None:
    text, path = "Crawl zibble the wall.", "name: path, relation: prep_zibble"
    assert heard(parser, text, path) == ("DONE", {"path": "wall"})
    assert heard(parser, text, path, without=RULE)[0] == "LEFT_OVER_WORDS"
