"""The file of meanings."""

import pytest

from checked_files.problem import FileRefused
from phrase_meanings.meaning_file import load_meanings, measure_of, shipped_meanings
from typed_arguments.attribute_names import QUANTIFIERS, RELATIONS


def test_shipped_spellings_lead_to_one_meaning() -> None:
    meanings = shipped_meanings()
    assert meanings.relation("Next to") == "next_to"
    assert meanings.relation("concerning") == "concerning"
    assert meanings.quantifiers["an"] == "a"


def test_adjectives_measure_in_every_degree() -> None:
    assert [measure_of(word) for word in ("tall", "taller", "biggest", "smallest", "furthest", "nearest", "fewer")] == [
        "height",
        "height",
        "size",
        "-size",
        "distance",
        "-distance",
        "-number",
    ]
    assert [measure_of(word) for word in ("red", "honest", "best", "forest")] == [""] * 4


def test_every_relation_and_quantifier_may_be_declared() -> None:
    assert frozenset(shipped_meanings().relations.values()) <= RELATIONS
    assert frozenset(shipped_meanings().quantifiers.values()) <= QUANTIFIERS


def test_a_spelling_with_two_meanings_is_refused() -> None:
    text = "relations: {a: [x], b: [x]}\ndirections: {}\nquantifiers: {}\nbounds: {}\nmeasures: {}\nexceptions: []"
    with pytest.raises(FileRefused) as refused:
        load_meanings(text, "m.yaml")
    assert refused.value.problems[0].key == "relations.b"
