"""Semantic types decide between readings, and a wrong type is asked about."""

import pytest

from semantic_framer.framer import hear
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.outcome import Question, Understood
from semantic_types import WordTypes


@pytest.mark.parametrize(
    ("text", "frame"),
    [
        ("take Anna to the hall", "guiding"),
        ("take me to the lift", "guiding"),
        ("bring the guests to the kitchen", "guiding"),
        ("take the box to the hall", "bringing"),
        ("take the newspaper to the sofa", "bringing"),
        ("take the cup to my grandmother", "bringing"),
        ("go to the hall with the tray", "navigating_to_location"),
        ("go to the hall with Anna", "following"),
        ("open the drawer", "opening_container"),
        ("open the fridge", "opening"),
        ("open the frobnicator", "opening"),
        ("leave the kitchen", "departing"),
        ("wash the socks", "washing_clothes"),
        ("take the frobnicator to the hall", "bringing"),
        ("go with Zorblax", "following"),
    ],
)
def test_types_choose_the_frame(understand, text: str, frame: str) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Understood), outcome
    assert outcome.clauses[0][0].unit.frame_name == frame


@pytest.mark.parametrize(
    ("text", "types"),
    [
        ("take the box to the hall", {"theme": "Container", "goal": "Location"}),
        ("take Anna to the hall", {"cotheme": "Human", "goal": "Location"}),
        ("open the drawer", {"containing_object": "Container"}),
        ("take the frobnicator to the hall", {"theme": "", "goal": "Location"}),
    ],
)
def test_arguments_have_semantic_types(understand, text: str, types) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Understood)
    arguments = outcome.clauses[0][0].arguments
    assert {argument.name: argument.semantic_type for argument in arguments if argument.positions} == types


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("carry Anna to the hall", '"Anna" is a person'),
        ("carry the mug and the nurse to the hall", '"nurse" is a person'),
        ("guide the box to the hall", '"the box" is a container'),
        ("bring me the kitchen", '"the kitchen" is a room'),
    ],
)
def test_a_wrong_type_is_asked_about_and_yes_does_it(understand, text: str, words: str) -> None:
    question, context = understand(text)
    assert isinstance(question, Question)
    assert question.code == "CONFIRM"
    assert words in question.sentence
    assert isinstance(understand("yes", context)[0], Understood)
    assert not isinstance(understand("no", context)[0], (Understood, Question))


def test_a_name_changes_what_is_done(parser, lexicon, frames) -> None:
    verbs = frozenset(verb.split()[0] for verb in lexicon.verbs)
    tree = parser.parse("take the butler to the hall", verbs)

    def frame_with(names) -> str:
        outcome = hear(tree, FramedLexicon(lexicon, frames, WordTypes(names=names))).outcome
        assert isinstance(outcome, Understood)
        return outcome.clauses[0][0].unit.frame_name

    assert frame_with({}) == "guiding"
    assert frame_with({"butler": ("Device",)}) == "bringing"
