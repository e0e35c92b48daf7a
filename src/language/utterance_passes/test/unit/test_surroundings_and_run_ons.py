"""A command is parsed without what is said around it, and each of several commands alone."""

from dataclasses import replace
from typing import List, Tuple

import pytest

from utterance_passes.engine.trace import TraceLine, moved
from utterance_passes.trees.conllu import from_short
from utterance_passes.trees.spelling import as_said
from utterance_passes.trees.tree import DependencyTree
from utterance_passes.trees.tree_edits import WordAround, joined, said_after, with_words_around
from utterance_passes.trees.vocabulary import Verbs
from utterance_passes.wording.run_ons import run_ons
from utterance_passes.wording.surroundings import surroundings

VERBS = Verbs(frozenset(["turn", "open", "close", "take", "bring", "scrub", "bake", "tie", "switch"]))


@pytest.mark.parametrize(
    "said, command, around",
    [
        ("could you turn left", "turn left", ["could:aux", "you:nsubj"]),
        ("Please turn left.", "Turn left.", ["Please:discourse", ".:punct"]),
        ("robot, would you mind turning left", "turn left", "robot:vocative ,:punct would:discourse:aside".split()),
        ("you wouldn't mind scrubbing it", "scrub it", ["you:discourse:aside"]),
        ("you wouldn't mind baking it", "bake it", ["you:discourse:aside"]),
        ("I was wondering if you could take the mug, please", "Take the mug", ["I:discourse:aside"]),
        ("turn left, robot", "turn left", [",:punct", "robot:vocative"]),
    ],
)
def test_a_command_is_found_in_what_is_said_around_it(said: str, command: str, around: List[str]) -> None:
    found = surroundings.run(as_said(said), VERBS)
    assert found is not None and found.command.text == command
    assert [f"{word.form}:{word.deprel}" for word in found.words][: len(around)] == around


@pytest.mark.parametrize(
    "said",
    [
        "turn left",
        "could I turn left",
        "did you turn left",
        "can you really turn left",
        "I turned left",
        "I want to turn left",
        "could you whistle",
        "would you mind turn left",
        "could you have turned left",
        "",
    ],
)
def test_there_is_no_command_alone_in_it(said: str) -> None:
    assert surroundings.run(as_said(said), VERBS) is None


def test_the_words_of_the_command_keep_their_places_in_the_text() -> None:
    said = "would you mind tying it"
    found = surroundings.run(as_said(said), VERBS)
    assert found is not None and found.command.text == "tie it" and found.verb == "tying"
    start = found.command.origins[found.command.text.index("it")]
    assert said[start:] == "it"


@pytest.mark.parametrize(
    "text, positions",
    [
        ("open|VERB the|DET box|NOUN close|ADJ the|DET door|NOUN", (4,)),
        ("open|VERB it|PRON then|ADV close|VERB it|PRON", ()),
        ("switch|VERB off|ADP the|DET radio|NOUN switch|VERB on|ADP the|DET fan|NOUN", (5,)),
        ("i|PRON am|AUX tired|ADJ please|INTJ bring|VERB my|PRON cup|NOUN", (4,)),
        ("open|VERB the|DET box|NOUN could|AUX you|PRON close|VERB it|PRON", (4,)),
        # These are one command each.
        ("say|VERB open|VERB the|DET door|NOUN close|VERB the|DET box|NOUN", ()),
        ("help|VERB me|PRON open|VERB the|DET door|NOUN", ()),
        ("you|PRON open|VERB the|DET door|NOUN", ()),
        ("open|VERB the|DET close|ADJ the|DET door|NOUN", ()),
        ("turn|VERB left|ADV", ()),
    ],
)
def test_run_ons(text: str, positions: Tuple[int, ...]) -> None:
    words = [item.split("|") for item in text.split()]
    assert run_ons.run([word[0] for word in words], [word[1] for word in words], VERBS) == positions


COMMAND = from_short("turn|VERB|0|root left|ADV|1|advmod")


def test_words_around_a_command_hang_on_its_root() -> None:
    around = (WordAround("could", "AUX", "MD", "aux", -2, -1), WordAround("please", "INTJ", "UH", "discourse", 99, 105))
    tree = with_words_around(COMMAND, "could turn left please", "turn", "turn", around)
    assert [(word.form, word.head, word.deprel) for word in tree.words] == [
        ("could", 2, "aux"),
        ("turn", 0, "root"),
        ("left", 2, "advmod"),
        ("please", 2, "discourse"),
    ]


def test_trees_of_parts_are_joined_beside_the_first() -> None:
    tree = joined("turn left turn left", [COMMAND, COMMAND])
    assert [(word.head, word.deprel) for word in tree.words] == [
        (0, "root"),
        (1, "advmod"),
        (1, "parataxis"),
        (3, "advmod"),
    ]


def test_what_goes_on_with_an_utterance_stands_behind_it() -> None:
    words = tuple(replace(word, start_character=start) for word, start in zip(COMMAND.words, (0, 5)))
    timed = DependencyTree("turn left", words, times=(frozenset({2}),))
    tree = said_after(timed, timed)
    assert tree.text == "turn left turn left"
    assert [(word.index, word.head, word.start_character) for word in tree.words] == [
        (1, 0, 0),
        (2, 1, 5),
        (3, 1, 10),
        (4, 3, 15),
    ]
    assert tree.times == (frozenset({2}), frozenset({4}))


def test_what_was_written_on_a_part_is_about_the_words_of_the_whole() -> None:
    words = tuple(replace(word, start_character=start) for word, start in zip(COMMAND.words, (6, 11)))
    part = DependencyTree("turn left", words)
    around = (WordAround("could", "AUX", "MD", "aux", 0, 5),)
    whole = with_words_around(part, "could turn left", "turn", "turn", around)
    (line,) = moved([TraceLine("reroot", (1,), "turn", "", "root")], part, whole)
    assert line.positions == (2,)
