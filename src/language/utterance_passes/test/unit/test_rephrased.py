"""The tree of a sentence that is said without some words, and with another verb."""

from typing import FrozenSet, Sequence

import pytest

from stanford_parser_ros.model import shipped_parser
from utterance_passes.trees.tree import DependencyTree
from utterance_passes.trees.tree_edits import NotATree, rephrased

PARSER = shipped_parser()


def tree_of(text: str) -> DependencyTree:
    return PARSER.parse(text, frozenset())


def said(text: str, words: str) -> FrozenSet[int]:
    wanted = words.split()
    return frozenset(word.index for word in tree_of(text).words if word.form in wanted)


@pytest.mark.parametrize(
    ("text", "left_out", "verb", "expected"),
    [
        ("Make your way to the hall.", "your way", ["go"], "go to the hall."),
        ("Have a look at the shelf.", "a look", ["watch"], "watch at the shelf."),
        ("Freshen the room up.", "up", ["tidy", "up"], "tidy up the room."),
        ("Go quickly to the hall, please.", "quickly", [], "Go to the hall, please."),
    ],
)
def test_the_other_words_stay_in_their_order(text: str, left_out: str, verb: Sequence[str], expected: str) -> None:
    made = rephrased(tree_of(text), said(text, left_out), verb, 1)
    assert made.text == expected
    assert made.is_connected and [word.index for word in made.words] == list(range(1, len(made.words) + 1))
    assert all(made.text[word.start_character : word.end_character] == word.form for word in made.words)


def test_what_hung_on_a_word_that_is_left_out_hangs_on_its_governor() -> None:
    text = "Have a look at the shelf."
    made = rephrased(tree_of(text), said(text, "a look"), ["look"], 1)
    (shelf,) = [word for word in made.words if word.form == "shelf"]
    assert (shelf.head, shelf.deprel) == (1, "obl")


def test_the_words_of_another_verb_are_verb_and_particle() -> None:
    made = rephrased(tree_of("Freshen the room."), frozenset(), ["tidy", "up"], 1)
    assert [(word.form, word.upos, word.head, word.deprel) for word in made.words[:2]] == [
        ("tidy", "VERB", 0, "root"),
        ("up", "ADP", 1, "compound:prt"),
    ]


def test_nothing_is_no_sentence() -> None:
    tree = tree_of("Go.")
    with pytest.raises(NotATree):
        rephrased(tree, frozenset(word.index for word in tree.words))
