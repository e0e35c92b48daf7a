"""Verbs of the lexicon that stand for a verb of a unit, and verbs that say an element by themselves."""

from typing import Any

import pytest

from semantic_framer.framer import Policy, Question, Understood, read
from semantic_framer.units.lexicon import Lexicon
from semantic_frames import load_frame

TAKING = "name: taking\nframe_elements: [{name: theme, is_core: True}]\n"
KEEPING = "name: keeping\nframe_elements: [{name: theme, is_core: True}]\n"
OF_CLASS = "frame_name: taking\nverb: [get, take]\nverb_class: {obtain: get.v.01}\n"
WRITTEN = "frame_name: keeping\nverb: obtain\n"


def frames_of(outcome: Any) -> Any:
    return [clause[0].unit.frame_name for clause in outcome.clauses]


def test_a_verb_of_the_class_is_asked_about_the_first_time_and_never_again(understand: Any) -> None:
    asked, context = understand("Obtain the mug.", policy=Policy())
    assert asked == Question("CONFIRM", 'By "obtain the mug", do you mean "get the mug"? Say yes or no.')
    outcome, context = understand("Yes.", context, policy=Policy())
    assert frames_of(outcome) == ["taking"]
    outcome, context = understand("Obtain the spoon.", context, policy=Policy())
    assert isinstance(outcome, Understood) and frames_of(outcome) == ["taking"]


def test_a_no_does_nothing_and_the_verb_is_asked_about_again(understand: Any) -> None:
    _, context = understand("Obtain the mug.", policy=Policy())
    outcome, context = understand("No.", context, policy=Policy())
    assert not isinstance(outcome, Understood)
    assert isinstance(understand("Obtain the mug.", context, policy=Policy())[0], Question)


def test_a_frame_that_wants_a_yes_is_asked_about_in_the_same_question(understand: Any) -> None:
    asked, _ = understand("Reheat the soup.", policy=Policy())
    words = (
        'By "reheat the soup", do you mean "heat the soup"? Shall I really do this: "reheat the soup"? Say yes or no.'
    )
    assert asked == Question("CONFIRM", words)


@pytest.mark.parametrize("units", [(OF_CLASS, WRITTEN), (WRITTEN, OF_CLASS)])
def test_a_unit_that_lists_the_verb_is_preferred(parser: Any, units: Any) -> None:
    lexicon = Lexicon()
    for number, text in enumerate(units):
        lexicon.add_file(text, f"{number}.yaml")
    frames = {frame.name: frame for frame in (load_frame(TAKING, "t.yaml"), load_frame(KEEPING, "k.yaml"))}
    outcome, _ = read(parser.parse("Obtain the mug.", frozenset(["obtain"])), lexicon, frames, policy=Policy())
    assert frames_of(outcome) == ["keeping"]


@pytest.mark.parametrize(
    ("text", "frame"),
    [
        ("Refrigerate the salad.", "placing(theme=the salad, goal=the fridge)"),
        # What is said goes before what the verb says.
        ("Chill the wine in the freezer.", "placing(theme=the wine, goal=the freezer)"),
        ("Mute the speakers.", "switching_device(device=the speakers, operational_state=muted)"),
    ],
)
def test_a_verb_says_an_element(understand: Any, text: str, frame: str) -> None:
    outcome, _ = understand(text)
    assert [str(clause[0]) for clause in outcome.clauses] == [frame]


def test_a_preposition_in_the_value_is_its_relation(understand: Any) -> None:
    outcome, _ = understand("Refrigerate the salad.")
    assert outcome.clauses[0][0].argument("goal").relation == "in"
