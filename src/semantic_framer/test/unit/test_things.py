"""What people do, what happens, and ways are no things: nothing takes, brings, gives, puts or holds them."""

from typing import Any

import pytest

from semantic_framer.framer import Question, Understood

NO_THINGS = """
take a photo northwards
take a photo southwards
take a picture from the door
make a step towards the wall
take two steps to the left
have a nap
take a nap on the sofa
take the lift
take the lift to the hall
take the stairs
take the tram to the museum
take the second door on the left
take the next exit
get the door
take care of the cat
take a break
take a deep breath
take your time
take part in the game
take an order from the guest
take the temperature
take a stroll around the garden
go get some rest
fetch me some sleep
grab a seat
take a shower
hold a meeting
give me a hand
give the dog a walk
give Anna a shout
give me your opinion
put some pressure on the lid
bring the party to the garden
bring an end to the noise
put a stop to the music
set a timer
set an alarm on the table
""".strip().splitlines()
THINGS = {
    "take the step ladder to the garage": {"theme": "the step ladder", "goal": "the garage"},
    "take the seat to the hall": {"theme": "the seat", "goal": "the hall"},
    "put a timer on the table": {"theme": "a timer", "goal": "the table"},
    "set the timer on the table": {"theme": "the timer", "goal": "the table"},
    "bring the end table to the hall": {"theme": "the end table", "goal": "the hall"},
    "bring me a seat": {"theme": "a seat", "beneficiary": "me"},
    "take the rest of the plates to the kitchen": {"theme": "the rest of the plates", "goal": "the kitchen"},
    "take the photo to Anna": {"theme": "the photo", "beneficiary": "Anna"},
    "take the picture from the wall": {"theme": "the picture", "source": "the wall"},
    "take the remote control": {"theme": "the remote control"},
    "bring me the toy train": {"theme": "the toy train", "beneficiary": "me"},
    "take the note to the office": {"theme": "the note", "goal": "the office"},
    "put the bus on the shelf": {"theme": "the bus", "goal": "the shelf"},
    "take the part to the workshop": {"theme": "the part", "goal": "the workshop"},
    "take the break room key": {"theme": "the break room key"},
}


@pytest.mark.parametrize("text", NO_THINGS)
def test_what_is_no_thing_is_not_moved(understand: Any, text: str) -> None:
    outcome, _ = understand(text)
    assert not isinstance(outcome, Understood)


@pytest.mark.parametrize("text, arguments", THINGS.items())
def test_a_thing_is_moved(understand: Any, text: str, arguments: Any) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Understood)
    assert {value.name: value.text for value in outcome.clauses[0][0].arguments} == arguments


@pytest.mark.parametrize(
    "text, frame",
    [
        ("take a left", "turning"),
        ("take a photo of the door", "photographing"),
        ("have a look at the door", "perceiving"),
    ],
)
def test_the_unit_that_is_about_a_deed_does_it(understand: Any, text: str, frame: str) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Understood) and outcome.clauses[0][0].unit.frame_name == frame


@pytest.mark.parametrize(
    "text, asked",
    [
        ("go to the", "Where should I go?"),
        ("go to my", "Where should I go?"),
        ("go to the uh", "Where should I go?"),
        ("bring me the", "What should I bring?"),
        ("take a", "What should I take?"),
        ("pick up the", "What should I take?"),
        ("follow your", "Whom should I follow?"),
        ("open every", "What should I open?"),
        ("put the mug on the", "Where should I put it?"),
        ("bring the mug to the", "Where should I bring it?"),
        ("bring the to the kitchen", "What should I bring?"),
    ],
)
def test_an_article_alone_is_a_missing_element(understand: Any, text: str, asked: str) -> None:
    outcome, context = understand(text)
    assert isinstance(outcome, Question) and outcome.sentence.startswith(asked)
    for unfinished in ("the", "to the"):
        answered, _ = understand(unfinished, context)
        assert not isinstance(answered, Understood)
    assert isinstance(understand("the office", context)[0], Understood)


@pytest.mark.parametrize(
    "text, arguments",
    [
        ("bring the mug to room C", {"theme": "the mug", "goal": "room C"}),
        ("bring the parcel to building C", {"theme": "the parcel", "goal": "building C"}),
        ("go to room 5", {"goal": "room 5"}),
        ("go to room B12", {"goal": "room B12"}),
        ("go to lab x", {"goal": "lab x"}),
        ("drive to bay D", {"goal": "bay D"}),
        ("drive to gate seven", {"goal": "gate seven"}),
        ("put the box on shelf a", {"theme": "the box", "goal": "shelf a"}),
        ("take the box from shelf A to room C", {"theme": "the box", "source": "shelf A", "goal": "room C"}),
        ("turn to section D", {"goal": "section D"}),
        ("go to point A", {"goal": "point A"}),
        ("take the mug I need", {"theme": "the mug I need"}),
        ("put a mug on a table", {"theme": "a mug", "goal": "a table"}),
    ],
)
def test_a_letter_behind_a_noun_is_its_name(understand: Any, text: str, arguments: Any) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Understood)
    assert {value.name: value.text for value in outcome.clauses[0][0].arguments} == arguments


@pytest.mark.parametrize(
    "text, arguments",
    [
        ("drive as quickly as you can to the gate", {"goal": "the gate"}),
        ("as fast as possible go to the kitchen", {"goal": "the kitchen"}),
        ("bring me the mug as fast as you possibly can", {"theme": "the mug", "beneficiary": "me"}),
        ("move as slowly as you can to the wall", {"goal": "the wall", "manner": "slowly"}),
        ("as quietly as you can go to the bedroom", {"goal": "the bedroom", "manner": "quietly"}),
    ],
)
def test_as_well_as_it_can_be_done_is_no_place(understand: Any, text: str, arguments: Any) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Understood)
    assert {value.name: value.text for value in outcome.clauses[0][0].arguments} == arguments


@pytest.mark.parametrize("text", ["drive as far as you can", "walk as quickly as a cat home"])
def test_other_comparisons_are_left_over(understand: Any, text: str) -> None:
    assert not isinstance(understand(text)[0], Understood)
