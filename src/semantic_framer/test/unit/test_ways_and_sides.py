"""Directions of the compass, sides of the hearer, distances along a way, and verbs that only say that a deed begins."""

from typing import Any, Dict

import pytest

from semantic_framer.framer import Question, Refusal, Understood


def only_frame(outcome: Any) -> str:
    """The frame of the only clause with the arguments that were said."""
    assert isinstance(outcome, Understood), outcome
    (readings,) = outcome.clauses
    said = ", ".join(f"{value.name}={value.text}" for value in readings[0].arguments if value.positions)
    return f"{readings[0].unit.frame_name}({said})"


@pytest.mark.parametrize(
    ("text", "frame"),
    [
        # The parser makes a name or a property of the distance of a direction.
        ("turn north", "turning_to_direction(direction=north)"),
        ("turn fifty degrees south west", "turning_to_direction(direction=south west, angle=50, angle_unit=degrees)"),
        ("walk north three metres", "moving_in_direction(direction=north, distance=3, distance_unit=metres)"),
        ("drive two yards to the east", "moving_in_direction(direction=east, distance=2, distance_unit=yards)"),
        ("go to the north door", "navigating_to_location(goal=the north door)"),
        # A side of the hearer behind a place says which place is meant.
        ("go through the gate on the left", "moving_along_path(path=the gate on the left)"),
        ("go past the gate directly ahead of you", "moving_along_path(path=the gate directly ahead of you)"),
        ("approach the sofa ahead of you", "arriving(goal=the sofa ahead of you)"),
        ("go through the hall to the kitchen", "navigating_to_location(goal=the kitchen, path=the hall)"),
        ("put the mug in front of me", "placing(theme=the mug, goal=front of me)"),
        ("drive closer to the sofa", "navigating_to_location(goal=the sofa)"),
        # Ways with a distance.
        ("walk down the hall ten metres", "moving_along_path(path=the hall, distance=10, distance_unit=metres)"),
        ("go back down the corridor", "moving_along_path(path=the corridor, direction=back)"),
        # The deed counts, and not that it begins or goes on.
        ("start turning left", "turning(direction=left)"),
        ("continue to follow me", "following(cotheme=me)"),
        ("begin by opening the door", "opening(container_portal=the door)"),
        ("keep moving two metres", "moving(distance=2, distance_unit=metres)"),
        # Pictures.
        ("take a picture to your left", "photographing(representation=picture, direction=your left)"),
        ("take a photo of the tv to your left", "photographing(represented=the tv to your left, representation=photo)"),
        ("take a photo at the gate", "photographing(representation=photo, place=the gate)"),
    ],
)  # fmt: skip
def test_what_is_meant(understand: Any, text: str, frame: str) -> None:
    assert only_frame(understand(text)[0]) == frame


@pytest.mark.parametrize("text", ["I started moving the table"])
def test_no_command_now(understand: Any, text: str) -> None:
    assert isinstance(understand(text)[0], Refusal)


def test_how_far_is_asked(understand: Any) -> None:
    outcome = understand("start moving north")[0]
    assert isinstance(outcome, Question)
    assert "How far" in outcome.sentence


def test_both_words_of_a_direction_count(understand: Any) -> None:
    told: Dict[str, str] = {text: only_frame(understand(text)[0]) for text in ("turn south east", "turn east")}
    assert told["turn south east"] != told["turn east"]
