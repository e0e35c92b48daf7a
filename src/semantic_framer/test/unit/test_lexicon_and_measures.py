"""The lexicon, amounts found in words, yes and no: no model needed."""

from typing import List, Tuple

import pytest

from checked_files import FileRefused
from semantic_framer.units.lexicon import Lexicon
from semantic_framer.values.dialogue import is_no, is_yes
from utterance_passes.phrases.measures import find_amounts
from utterance_passes.trees.tree import DependencyTree, Word


def sentence_of(text: str) -> DependencyTree:
    """A sentence without structure: every word hangs on the first."""
    forms = text.split()
    return DependencyTree(
        text=text,
        words=tuple(
            Word(index, form, form.lower(), "NOUN" if form == "times" else "X", "", "", 0 if index == 1 else 1, "dep")
            for index, form in enumerate(forms, start=1)
        ),
    )


@pytest.mark.parametrize(
    "text, amounts",
    [
        ("move 3 feet forward", [("3", "feet", "length")]),
        ("turn minus two degrees", [("-2", "degrees", "angle")]),
        ("wait half an hour", [("0.5", "hour", "duration")]),
        ("a couple of metres", [("2", "metres", "length")]),
        ("one hundred and twenty degrees left", [("120", "degrees", "angle")]),
        ("give me 5", [("5", "", "number")]),
        ("go two metres and turn ninety degrees", [("2", "metres", "length"), ("90", "degrees", "angle")]),
        ("take a mug", []),
        ("go to the office", []),
        ("move forward 5 feet 6 inches", [("5.5", "feet", "length")]),
        ("five foot six", [("5.5", "foot", "length")]),
        ("two metres fifty forward", [("2.5", "metres", "length")]),
        ("wait an hour and a half", [("1.5", "hour", "duration")]),
        ("go two metres 90 degrees", [("2", "metres", "length"), ("90", "degrees", "angle")]),
        ("go five feet six times", [("5", "feet", "length"), ("6", "", "number")]),
        ("go two metres and turn", [("2", "metres", "length")]),
        ("turn 1e400 degrees", [("1e400", "degrees", "angle")]),
    ],
)
def test_find_amounts(text: str, amounts: List[Tuple[str, str, str]]) -> None:
    sentence = sentence_of(text)
    found = find_amounts(sentence, range(1, len(text.split()) + 1))
    assert [(amount.digits(), amount.unit, amount.quantity) for amount in found] == amounts


def test_file_that_is_added_again_replaces_its_units() -> None:
    lexicon = Lexicon()
    lexicon.add_file("frame_name: a\nverb: [go, pick up]\n", "x.yaml")
    lexicon.add_file("frame_name: b\nverb: go\n", "x.yaml")
    assert lexicon.verbs == {"go"} and [unit.frame_name for unit in lexicon.units_of("go")] == ["b"]


def test_refused_file_leaves_what_was_there() -> None:
    lexicon = Lexicon()
    lexicon.add_file("frame_name: a\nverb: go\n", "x.yaml")
    with pytest.raises(FileRefused):
        lexicon.add_file("frame_name: a\n", "x.yaml")
    assert lexicon.verbs == {"go"}


def test_all_units_of_a_verb_are_recalled() -> None:
    lexicon = Lexicon()
    lexicon.add_file("- {frame_name: a, verb: give}\n- {frame_name: b, verb: give}\n", "x.yaml")
    assert [unit.frame_name for unit in lexicon.units_of("give")] == ["a", "b"]


def test_verbs_with_particles_come_first() -> None:
    lexicon = Lexicon()
    lexicon.add_file("frame_name: a\nverb: [pick, pick up]\n", "x.yaml")
    assert lexicon.verbs_beginning_with("pick") == ("pick up", "pick")


def test_nearest_verbs() -> None:
    lexicon = Lexicon()
    lexicon.add_file("frame_name: a\nverb: [turn, move]\n", "x.yaml")
    assert lexicon.nearest_verbs("trun") == ("turn",) and lexicon.nearest_verbs("xylophone") == ()


@pytest.mark.parametrize("text", ["Yes.", "yes, please", "OK", "do it!"])
def test_yes(text: str) -> None:
    assert is_yes(text) and not is_no(text)


@pytest.mark.parametrize("text", ["No.", "never mind", "no, thanks"])
def test_no(text: str) -> None:
    assert is_no(text) and not is_yes(text)
