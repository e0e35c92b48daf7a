"""The file of word classes: what is in a class, and what is said of a wrong file."""

from typing import List

import pytest

from checked_files import FileRefused, Problem
from word_classes import load_word_classes

COLOURS = "colours:\n  for: What a thing looks like.\n  words: red green\n"


def problems_of(text: str) -> List[Problem]:
    with pytest.raises(FileRefused) as refused:
        load_word_classes(text, "words.yaml")
    return list(refused.value.problems)


def test_words_stand_in_their_order() -> None:
    assert load_word_classes(COLOURS, "words.yaml")["colours"].words == ("red", "green")


def test_a_list_holds_phrases_and_words_that_yaml_takes_for_others() -> None:
    classes = load_word_classes("places:\n  for: Places.\n  words: [next to, on, 'no', yes]\n", "words.yaml")
    assert classes["places"].words == ("next to", "on", "no", "yes")


def test_words_of_included_classes_come_first() -> None:
    text = COLOURS + "looks:\n  for: All of it.\n  includes: [colours]\n  words: shiny\n"
    assert load_word_classes(text, "words.yaml")["looks"].words == ("red", "green", "shiny")


@pytest.mark.parametrize(
    "text, code, line, key",
    [
        ("- red\n", "WRONG_TYPE", 1, "file"),
        ("colours: red\n", "WRONG_TYPE", 1, "colours"),
        ("colours:\n  words: red\n", "MISSING_KEY", 2, "colours.for"),
        ("colours:\n  for: Looks.\n  word: red\n", "UNKNOWN_KEY", 3, "colours.word"),
        ("colours:\n  for: Looks.\n", "EMPTY_CLASS", 1, "colours"),
        ("colours:\n  for: Looks.\n  words: []\n", "EMPTY_CLASS", 1, "colours"),
        ("colours:\n  for: Looks.\n  words: red Green\n", "NOT_LOWER_CASE", 3, "colours.words"),
        ("colours:\n  for: Looks.\n  words: red red\n", "DUPLICATE_WORD", 3, "colours.words"),
        (COLOURS + COLOURS, "DUPLICATE_CLASS", 4, "colours"),
        (COLOURS + COLOURS.replace("colours", "colors"), "SAME_WORDS", 4, "colors"),
        (COLOURS + "looks:\n  for: All.\n  includes: [colour]\n  words: shiny\n", "UNKNOWN_CLASS", 6, "looks.includes"),
        (COLOURS + "looks:\n  for: All.\n  includes: [colours]\n", "EMPTY_CLASS", 4, "looks"),
        (COLOURS + "looks:\n  for: All.\n  includes: [colours]\n  words: red\n", "DUPLICATE_WORD", 7, "looks.words"),
        ("one:\n  for: One.\n  includes: [one]\n  words: red\n", "CIRCLE", 3, "one.includes"),
    ],
)
def test_what_is_wrong_is_named_with_its_line(text: str, code: str, line: int, key: str) -> None:
    problem = problems_of(text)[0]
    assert (problem.code, problem.line, problem.key) == (code, line, key)


def test_every_mistake_is_named_at_once() -> None:
    text = "colours:\n  for: Looks.\n  words: red red\nlooks:\n  words: Shiny\n"
    assert [problem.code for problem in problems_of(text)] == ["DUPLICATE_WORD", "MISSING_KEY", "NOT_LOWER_CASE"]


def test_an_unknown_class_is_hinted_at() -> None:
    text = COLOURS + "looks:\n  for: All.\n  includes: [colour]\n  words: shiny\n"
    assert problems_of(text)[0].hint == "did you mean 'colours'?"


def test_a_circle_of_several_classes_is_found() -> None:
    text = "one:\n  for: One.\n  includes: [two]\n  words: red\ntwo:\n  for: Two.\n  includes: [one]\n  words: green\n"
    assert {problem.code for problem in problems_of(text)} == {"CIRCLE"}
