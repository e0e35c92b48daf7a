"""No word is lost: the property on the sentences of the tables and the examples of the shipped units.

The tier "test" asks a third of them, the tier "acceptance" all.
"""

import re
from dataclasses import replace
from typing import Iterator, List, Tuple

import pytest
from talking_table import TABLES, read_table

from offline_pipeline.pipeline import Pipeline
from semantic_framer.clauses.readings import Heard
from semantic_framer.framer import hear
from semantic_framer.judging.said_words import positions_named, words_left
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.outcome import Policy, Understood
from stanford_parser_ros.model import UnparsableText

_CONTENT = ("NOUN", "PROPN", "NUM", "ADJ")
#: Behind a negation, a reason or in a greeting, words are understood without an element.
_UNDERSTOOD_OTHERWISE = frozenset(
    [
        "Make sure nobody is in the garage.",
        "Tell Anna to come because dinner is ready.",
        "Go to the garage without going through the workshop.",
        "yell good morning",
    ]
)


def sentences(pipeline: Pipeline) -> List[str]:
    tables = (text for table in sorted(TABLES.glob("*.tsv")) for line in read_table(table.stem) for text in line.said)
    examples = (example.text for unit in pipeline.knowledge.lexicon.units for example in unit.examples)
    return list(dict.fromkeys(text for text in (*tables, *examples) if re.search(r"\w", text)))


THIRD, ALL = 3, 1


@pytest.fixture(scope="module", params=[THIRD, pytest.param(ALL, marks=pytest.mark.acceptance)], ids=["third", "all"])
def understood(pipeline: Pipeline, request: pytest.FixtureRequest) -> Tuple[Tuple[str, Heard], ...]:
    """The sentences that would be carried out, with what was understood."""
    known: FramedLexicon = pipeline._known
    found = []
    for text in sentences(pipeline)[:: request.param]:
        try:
            heard = hear(pipeline.parse(text), known, policy=Policy())
        except UnparsableText:
            continue
        if isinstance(heard.outcome, Understood) and heard.sentence is not None:
            found.append((text, heard))
    assert len(found) > 1500 // request.param
    return tuple(found)


def lacking_one(heard: Heard) -> Iterator[Tuple[str, ...]]:
    """Yield the words that are told for each argument whose content words nothing else names, if it is not read."""
    assert isinstance(heard.outcome, Understood) and heard.sentence is not None
    readings = [readings[0] for readings in heard.outcome.clauses]
    tree = heard.sentence.tree
    for place, reading in enumerate(readings):
        for argument in reading.arguments:
            others = tuple(one for one in reading.arguments if one is not argument)
            less = [*readings[:place], replace(reading, arguments=others), *readings[place + 1 :]]
            lost = set(argument.positions) - positions_named(less) - heard.named
            if any(tree.word(index).upos in _CONTENT for index in lost):
                yield words_left(tree, less, heard.named)


def test_what_no_element_has_is_told(understood: Tuple[Tuple[str, Heard], ...]) -> None:
    silent = {text for text, heard in understood if any(not left for left in lacking_one(heard))}
    assert silent <= _UNDERSTOOD_OTHERWISE


def test_a_word_of_the_text_that_no_pass_kept_is_told(understood: Tuple[Tuple[str, Heard], ...]) -> None:
    """A pass that takes a word out of the text cannot hide it: the text says it still."""
    silent = []
    for text, heard in understood:
        assert isinstance(heard.outcome, Understood) and heard.sentence is not None
        readings = [readings[0] for readings in heard.outcome.clauses]
        told = replace(heard.sentence.tree, text=f"{heard.sentence.tree.text} sideways")
        if "sideways" not in words_left(told, readings, heard.named):
            silent.append(text)
    assert silent == []
