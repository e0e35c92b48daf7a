"""What people do, what happens, and ways are no things: nothing takes, brings, gives, puts or holds them."""

from typing import Any

import pytest

from semantic_framer.framer import Understood

NO_THINGS = """
take a photo northwards
take a photo southwards
take a picture from the door
make a step towards the wall
take two steps to the left
take a step back
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
walk a dozen steps
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
""".strip().splitlines()
THINGS = {
    "take the step ladder to the garage": {"theme": "the step ladder", "goal": "the garage"},
    "take the seat to the hall": {"theme": "the seat", "goal": "the hall"},
    "bring me a seat": {"theme": "a seat", "beneficiary": "me"},
    "take the rest of the plates to the kitchen": {"theme": "the rest of the plates", "goal": "the kitchen"},
    "take the photo to Anna": {"theme": "the photo", "goal": "Anna"},
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
    assert {value.name: value.argument for value in outcome.clauses[0][0].values} == arguments


@pytest.mark.parametrize(
    "text, frame",
    [("take a left", "turning"), ("take a photo of the door", "photographing"), ("have a look at the door", "perceiving")],
)
def test_the_unit_that_is_about_a_deed_does_it(understand: Any, text: str, frame: str) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Understood) and outcome.clauses[0][0].unit.frame_name == frame
