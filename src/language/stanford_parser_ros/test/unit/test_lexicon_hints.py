"""What units say of their words: which hints they give, where a tree differs from them, and the tree that has them."""

from typing import FrozenSet, List, Tuple

import numpy as np
import pytest

from semantic_frames import load_lexical_units
from stanford_parser_ros.joint.lexicon_hints import RULE, Hint, Use, hints_of, masked, named_words
from stanford_parser_ros.joint.spanning_tree import heads_of_best_tree
from stanford_parser_ros.model import KnownWords, shipped_parser
from utterance_passes.trees.conllu import from_short
from utterance_passes.trees.vocabulary import NamedWord

CRAWL_UP = frozenset([Hint("crawl", Use.PREPOSITION, "up")])
WITH_OBJECT = CRAWL_UP | {Hint("crawl", Use.OBJECT)}
AS_PARTICLE = frozenset([Hint("crawl", Use.PARTICLE, "up")])


def hints(*relations: str, verb: str = "crawl") -> FrozenSet[Hint]:
    """The hints of a unit that has an element for each relation."""
    lines = "".join(f"  - {{name: e{number}, relation: {one}}}\n" for number, one in enumerate(relations))
    text = f"frame_name: crawling\nverb: {verb}\nframe_element_grammatical_relations:\n{lines}"
    return hints_of(load_lexical_units(text, "unit.yaml"))


@pytest.mark.parametrize(
    ("relations", "verb", "expected"),
    [
        (["prep_up"], "crawl", [("crawl", Use.PREPOSITION, "up")]),
        (["obl:out_of"], "crawl", [("crawl", Use.PREPOSITION, "out of")]),
        (["[dobj, prep_up]"], "crawl", [("crawl", Use.OBJECT, ""), ("crawl", Use.PREPOSITION, "up")]),
        (["obj"], "pick up", [("pick up", Use.OBJECT, "")]),
        (["obj, words: [home]"], "crawl", []),
        (["obj, semantic_type: Sentient"], "crawl", []),
        (["obj, semantic_type: Container"], "crawl", [("crawl", Use.OBJECT, "")]),
        (["prt, words: [up, down]"], "crawl", [("crawl", Use.PARTICLE, "up"), ("crawl", Use.PARTICLE, "down")]),
        (["[prt, advmod], words: [up]"], "crawl", []),
        (["prt"], "crawl", []),
        (["nsubj"], "crawl", []),
        (["dobj/prep_of"], "[crawl, creep]", [("crawl", Use.OBJECT, ""), ("creep", Use.OBJECT, "")]),
    ],
)
def test_what_a_unit_says(relations: List[str], verb: str, expected: List[Tuple[str, Use, str]]) -> None:
    assert hints(*relations, verb=verb) == {Hint(*one) for one in expected}


@pytest.mark.parametrize(
    ("said", "of", "expected"),
    [
        ("Crawl|VERB|0|root up|ADP|1|compound:prt the|DET|4|det wall|NOUN|1|obj", CRAWL_UP, (2, 1, 4, 1, False)),
        ("Crawl|VERB|0|root up|ADP|4|case the|DET|4|det wall|NOUN|1|obj", CRAWL_UP, (2, 1, 4, 1, False)),
        ("Crawl|VERB|0|root up|VERB|1|xcomp the|DET|4|det wall|NOUN|2|obj", CRAWL_UP, (2, 1, 4, 1, False)),
        # The box is the object, so the wall is none.
        (
            "Crawl|VERB|0|root the|DET|3|det box|NOUN|1|obj up|ADP|1|compound:prt walls|NOUN|1|obj",
            WITH_OBJECT,
            (4, 1, 5, 1, False),
        ),
        ("Crawl|VERB|0|root up|ADV|1|advmod it|PRON|2|obj", WITH_OBJECT, (2, 1, 3, 1, False)),
        # "Crawl through" takes an object, and "crawl" none.
        (
            "Crawl|VERB|0|root up|ADP|1|compound:prt walls|NOUN|1|obj",
            CRAWL_UP | {Hint("crawl through", Use.OBJECT)},
            (2, 1, 3, 1, False),
        ),
        (
            "Crawl|VERB|0|root close|ADV|1|advmod to|ADP|5|case the|DET|5|det wall|NOUN|2|obl",
            frozenset([Hint("crawl", Use.PREPOSITION, "close to")]),
            (2, 2, 5, 1, False),
        ),
        ("Crawl|VERB|0|root up|ADV|1|advmod", AS_PARTICLE, (2, 1, 0, 1, True)),
        (
            "Crawl|VERB|0|root up|ADP|4|case the|DET|4|det wall|NOUN|1|obl",
            AS_PARTICLE | {Hint("crawl", Use.OBJECT)},
            (2, 1, 4, 1, True),
        ),
    ],
)
def test_where_a_tree_is_not_what_the_units_say(
    said: str, of: FrozenSet[Hint], expected: Tuple[int, int, int, int, bool]
) -> None:
    assert named_words(from_short(said), of) == (NamedWord(*expected),)


@pytest.mark.parametrize(
    ("said", "of"),
    [
        # The tree is as the units say.
        ("Crawl|VERB|0|root up|ADP|4|case the|DET|4|det wall|NOUN|1|obl", CRAWL_UP),
        ("Crawl|VERB|0|root the|DET|3|det box|NOUN|1|obj up|ADP|5|case walls|NOUN|3|nmod", CRAWL_UP),
        ("Crawl|VERB|0|root up|ADP|1|compound:prt", AS_PARTICLE),
        # Another verb, none, and one in between.
        ("Climb|VERB|0|root up|ADP|1|compound:prt the|DET|4|det wall|NOUN|1|obj", CRAWL_UP),
        ("the|DET|2|det crawl|NOUN|0|root up|ADP|2|advmod walls|NOUN|2|nmod", CRAWL_UP),
        ("Crawl|VERB|0|root and|CCONJ|3|cc climb|VERB|1|conj up|ADP|3|compound:prt walls|NOUN|3|obj", CRAWL_UP),
        # Whether the wall is the object, the network knows.
        (
            "Crawl|VERB|0|root up|ADP|1|compound:prt walls|NOUN|1|obj",
            CRAWL_UP | {Hint("crawl up", Use.OBJECT)},
        ),
        ("Crawl|VERB|0|root up|ADP|1|compound:prt the|DET|4|det wall|NOUN|1|obj", WITH_OBJECT),
        # "Crawl over" is another verb.
        (
            "Crawl|VERB|0|root up|ADP|1|compound:prt walls|NOUN|1|obj",
            frozenset([Hint("crawl over", Use.PREPOSITION, "up")]),
        ),
        # The noun phrase begins before the word: "the upper wall".
        ("Crawl|VERB|0|root the|DET|4|det up|ADV|4|amod wall|NOUN|1|obj", CRAWL_UP),
        # No noun phrase stands right behind the word, or it is how far, or it is of another verb.
        ("Crawl|VERB|0|root up|ADP|1|advmod to|ADP|4|case walls|NOUN|1|obl", CRAWL_UP),
        ("Crawl|VERB|0|root up|ADV|1|advmod and|CCONJ|4|cc stop|VERB|1|conj", CRAWL_UP),
        ("Crawl|VERB|0|root up|ADV|1|advmod two|NUM|4|nummod feet|NOUN|1|obl:unmarked", CRAWL_UP),
        ("Crawl|VERB|0|root up|ADV|1|advmod walls|NOUN|4|nsubj fall|VERB|1|parataxis", CRAWL_UP),
        ("Crawl|VERB|0|root up|ADV|1|advmod Bob|PROPN|1|vocative", CRAWL_UP),
        # A clause: "while avoiding the hall".
        (
            "Crawl|VERB|0|root while|SCONJ|3|mark avoiding|VERB|1|advcl the|DET|5|det hall|NOUN|3|obj",
            frozenset([Hint("crawl", Use.PREPOSITION, "avoiding")]),
        ),
        ("Crawl|VERB|0|root up|ADP|1|compound:prt the|DET|4|det wall|NOUN|1|obj", frozenset()),
    ],
)
def test_where_the_units_change_nothing(said: str, of: FrozenSet[Hint]) -> None:
    assert named_words(from_short(said), of) == ()


@pytest.mark.parametrize("seed", range(50))
def test_whatever_the_scores_are_the_tree_has_what_was_named(seed: int) -> None:
    logs = np.log(np.random.RandomState(seed).dirichlet(np.full(9, 0.1), 9) + 1e-9)
    np.fill_diagonal(logs, -np.inf)
    given = masked(logs, [NamedWord(3, 2, 6, 2, is_particle=False), NamedWord(7, 1, 8, 2, is_particle=True)])
    heads = heads_of_best_tree(given.logs)
    assert [heads[word] for word in (3, 4, 6, 7, 8)] == [6, 3, 2, 2, 2]
    assert given.relations == {3: "case", 4: "fixed", 6: "obl", 7: "compound:prt", 8: "obj"}
    assert given.tags == {3: ("ADP", "IN"), 7: ("ADP", "RP")}
    assert heads[1:].count(0) == 1
    assert heads[5] != 3
    for word in range(1, 9):
        seen = set()
        while word:
            assert word not in seen
            seen.add(word)
            word = heads[word]


def test_nothing_is_ruled_out_when_nothing_is_named() -> None:
    logs = np.log(np.random.RandomState(0).dirichlet(np.ones(5), 5))
    assert np.array_equal(masked(logs, ()).logs, logs)


@pytest.mark.parametrize(
    ("text", "of", "word", "noun"),
    [
        # No treebank has the word, so the models cannot know it by themselves.
        ("Crawl zibble the wall.", hints("prep_zibble"), "case of wall", "obl of Crawl"),
        ("crawl zibble the old wall of the hall", hints("prep_zibble"), "case of wall", "obl of crawl"),
        ("Bob should crawl zibble the wall.", hints("prep_zibble"), "case of wall", "obl of crawl"),
        ("Crawl the box zibble the wall.", hints("dobj", "prep_zibble"), "case of wall", "obl of Crawl"),
        ("Crawl zibble the wall.", hints("dobj", "prt, words: [zibble]"), "compound:prt of Crawl", "obj of Crawl"),
    ],
)
def test_the_tree_of_the_models_is_what_the_units_say(text: str, of: FrozenSet[Hint], word: str, noun: str) -> None:
    parser = shipped_parser()
    found = parser.traced(text, KnownWords(hints=of))
    told = {one.form: f"{one.deprel} of {found.tree.word(one.head).form}" for one in found.tree.words if one.head}
    assert (told["zibble"], told["wall"]) == (word, noun)
    assert found.tree.is_connected
    assert RULE in {line.rule for line in found.trace}
    without = parser.traced(text, KnownWords(hints=of), without=frozenset([RULE]))
    assert without.tree != found.tree
    assert without.tree == parser.traced(text).tree
