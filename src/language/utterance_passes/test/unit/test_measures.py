"""Amounts in the words of a sentence, and what beside them makes them doubtful: no model needed."""

import re
from dataclasses import replace
from typing import List, Tuple

import pytest

from utterance_passes.phrases.measures import Amount, amounts_of, find_amounts
from utterance_passes.trees.tree import DependencyTree, Word

_TOKENS = re.compile(r"\d+(?:\.\d+)?|[A-Za-z]+\d*|[^\sA-Za-z\d]")
_NUMBERS = frozenset("one two three five ten fifteen twenty forty hundred".split())
_NOUNS = frozenset("degrees metres metre feet turn turns chairs".split())


def sentence_of(text: str) -> DependencyTree:
    """A sentence in which every word hangs on the first, written as it was said."""
    words: List[Word] = []
    for index, token in enumerate(_TOKENS.finditer(text), start=1):
        form = token.group(0)
        upos = "NUM" if form in _NUMBERS or form[0].isdigit() else "NOUN" if form in _NOUNS else "X"
        head = 0 if index == 1 else 1
        words.append(Word(index, form, form, upos, "", "", head, "dep", token.start(), token.end()))
    return DependencyTree(text=text, words=tuple(words))


def amounts_in(text: str) -> List[Amount]:
    tree = sentence_of(text)
    return list(find_amounts(tree, [word.index for word in tree.words]))


@pytest.mark.parametrize(
    "text, si_amount, unit",
    [
        ("turn forty-five degrees", 0.7853981633974483, "degrees"),
        ("move -2 metres", -2.0, "metres"),
        ("move minus two metres", -2.0, "metres"),
        ("move 3 1/2 feet", 1.0668, "feet"),
        ("move 3/4 metre", 0.75, "metre"),
        ("turn a 45-degree turn", 0.7853981633974483, "degree"),
        ("move one hundred and twenty-five metres", 125.0, "metres"),
        ("move two-and-a-half metres", 2.5, "metres"),
        ("move two more metres", 2.0, "metres"),
        ("turn three quarters of a turn", 4.71238898038469, "turn"),
        ("move about two metres", 2.0, "metres"),
    ],
)
def test_an_amount_is_read_from_the_characters_as_they_were_said(text: str, si_amount: float, unit: str) -> None:
    (amount,) = amounts_in(text)
    assert not amount.is_doubtful
    assert (amount.si_amount, amount.unit) == (pytest.approx(si_amount), unit)


@pytest.mark.parametrize(
    "text, si_amount, unit",
    [
        ("move at 0.5 metres per second", 0.5, "metres per second"),
        ("move two metres a second", 2.0, "metres a second"),
        ("move three feet per minute", 3 * 0.3048 / 60.0, "feet per minute"),
        ("move at 36 kmh", 10.0, "kmh"),
    ],
)
def test_a_length_and_its_time_are_a_speed(text: str, si_amount: float, unit: str) -> None:
    (amount,) = amounts_in(text)
    assert (amount.quantity, amount.unit, amount.is_doubtful) == ("speed", unit, False)
    assert amount.si_amount == pytest.approx(si_amount)


@pytest.mark.parametrize(
    "text, words",
    [
        ("turn ten to fifteen degrees", "ten to fifteen degrees"),
        ("move from two to three metres", "from two to three metres"),
        ("move between two and three metres", "between two and three metres"),
        ("move two metres or three metres", "two metres or three metres"),
        ("move 2-3 metres", "2-3 metres"),
        ("move 1,5 metres", "1,5 metres"),
        ("move 1 000 metres", "1 000 metres"),
        ("move five five metres", "five five metres"),
        ("move two metres minus one", "two metres minus one"),
        ("move not two metres", "not two metres"),
        ("move at least two metres", "at least two metres"),
        ("move more than two metres", "than two metres"),
        ("move two metres or more", "two metres or more"),
        ("move - two metres", "- two metres"),
        ("turn 20%", "20%"),
        ("turn e5 degrees", "degrees"),
        ("turn umpteen degrees", "degrees"),
        ("move two metres per person", "two metres per"),
        ("move twice two metres", "twice two metres"),
        ("turn quarter turns", "quarter turns"),
    ],
)
def test_what_an_amount_does_not_account_for_makes_it_doubtful(text: str, words: str) -> None:
    amounts = amounts_in(text)
    assert any(amount.is_doubtful and amount.numeral == words for amount in amounts), amounts
    assert all(amount.is_doubtful for amount in amounts)


@pytest.mark.parametrize("unit", ["turn", "turns"])
def test_a_number_that_counts_a_unit_apart_is_no_bare_number(unit: str) -> None:
    tree = sentence_of(f"make two left {unit}")
    words = list(tree.words)
    words[1] = replace(words[1], head=4, deprel="nummod")
    (amount,) = find_amounts(replace(tree, words=tuple(words)), range(1, 5))
    assert amount.is_doubtful and {2, 4} <= set(amount.positions)


@pytest.mark.parametrize(
    "text, amounts",
    [
        ("go two metres and turn ninety degrees", [("two", "metres"), ("ninety", "degrees")]),
        ("go two metres 10 degrees", [("two", "metres"), ("10", "degrees")]),
        ("go two metres three times", [("two", "metres"), ("three", "")]),
        ("go two metres, then ten degrees", [("two", "metres"), ("ten", "degrees")]),
    ],
)
def test_two_amounts_one_after_the_other_are_two(text: str, amounts: List[Tuple[str, str]]) -> None:
    found = [(amount.numeral, amount.unit) for amount in amounts_in(text) if not amount.is_doubtful]
    assert found == amounts


@pytest.mark.parametrize(
    "text, ends",
    [
        ("turn ten to fifteen degrees", ["ten degrees", "fifteen degrees"]),
        ("move two metres or three metres", ["two metres", "three metres"]),
        ("move a metre or two", []),
        ("move at least two metres", ["two metres"]),
        ("move less than two metres", []),
    ],
)
def test_a_range_leaves_a_choice(text: str, ends: List[str]) -> None:
    tree = sentence_of(text)
    (amount,) = find_amounts(tree, [word.index for word in tree.words])
    assert [tree.text_of(end) for end in amount.ends] == ends


def test_an_amount_that_is_cut_by_the_bounds_of_its_clause_is_doubtful() -> None:
    tree = sentence_of("turn forty five degrees")
    (whole,) = amounts_of(tree, frozenset([1, 2, 3, 4]), 1)
    (cut,) = amounts_of(tree, frozenset([1, 2]), 1)
    assert not whole.is_doubtful and cut.is_doubtful


def test_digits_that_the_parser_was_given_apart_are_two_numbers() -> None:
    tree = DependencyTree(
        text="move 2½ metres",
        words=(
            Word(1, "move", "move", "VERB", "", "", 0, "root", 0, 4),
            Word(2, "2", "2", "NUM", "", "", 6, "nummod", 5, 6),
            Word(3, "1", "1", "NUM", "", "", 6, "nummod", 6, 6),
            Word(4, "/", "/", "SYM", "", "", 6, "punct", 6, 6),
            Word(5, "2", "2", "NUM", "", "", 6, "nummod", 6, 7),
            Word(6, "metres", "metre", "NOUN", "", "", 1, "obj", 8, 14),
        ),
    )
    (amount,) = find_amounts(tree, range(1, 7))
    assert amount.si_amount == 2.5
