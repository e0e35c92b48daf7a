"""The meaning of a phrase, as the typed argument says it: real sentences and the shipped models."""

from typing import Any, Dict, List

import pytest

from semantic_framer.framer import Understood
from typed_arguments import Modifier, Source, TypedArgument


def argument(outcome: Any, element: str) -> TypedArgument:
    assert isinstance(outcome, Understood), outcome
    found = outcome.clauses[0][0].argument(element)
    assert found is not None, outcome
    return found


@pytest.mark.parametrize(
    "text, element, expected",
    [
        ("Put the mug on the table.", "goal", {"text": "the table", "relation": "on", "quantifier": "the"}),
        ("Put the mug under the table.", "goal", {"text": "the table", "relation": "under", "head": "table"}),
        ("Put the mug behind the table.", "goal", {"relation": "behind"}),
        ("Put the mug next to the plate.", "goal", {"text": "the plate", "relation": "next_to"}),
        ("Put the mug on top of the table.", "goal", {"relation": "on", "head": "table"}),
        ("Go in front of the fridge.", "goal", {"relation": "in_front_of", "head": "fridge"}),
        ("Go to the left of the table.", "goal", {"text": "the left of the table", "relation": "left_of"}),
        ("Put the cup to the right of the plate.", "goal", {"relation": "right_of", "head": "plate"}),
        ("Go around the hedge.", "path", {"relation": "around"}),
        ("Go through the hedge.", "path", {"relation": "through"}),
        ("Go past the hedge.", "path", {"relation": "past"}),
        ("Bring two apples.", "theme", {"text": "two apples", "count": 2, "lemma": "apple", "is_plural": True}),
        ("Bring three apples.", "theme", {"count": 3}),
        ("Take all of the mugs.", "theme", {"quantifier": "all", "head": "mugs"}),
        ("Take all the mugs.", "theme", {"quantifier": "all"}),
        ("Take both mugs.", "theme", {"quantifier": "both", "count": 2}),
        ("Take each mug.", "theme", {"quantifier": "each"}),
        ("Take some mugs.", "theme", {"quantifier": "some"}),
        ("Take a mug.", "theme", {"quantifier": "a", "count": None, "is_plural": False}),
        ("Take the other one.", "theme", {"quantifier": "other", "head": "one"}),
        ("Go to Roger's office.", "goal", {"text": "Roger's office", "head": "office"}),
        ("Turn left.", "direction", {"direction": "left", "source": Source.SAID}),
        ("Turn left.", "angle", {"text": "90", "source": Source.DEFAULT}),
        ("Turn anticlockwise 120 degrees.", "direction", {"direction": "counterclockwise"}),
    ],
)
def test_attributes(understand: Any, text: str, element: str, expected: Dict[str, Any]) -> None:
    found = argument(understand(text)[0], element)
    assert {name: getattr(found, name) for name in expected} == expected


@pytest.mark.parametrize(
    "text, element, expected",
    [
        ("Take the red mug.", "theme", [("adjective", "red", 0)]),
        ("Take the big red mug.", "theme", [("adjective", "big", 0), ("adjective", "red", 0)]),
        ("Take the biggest mug.", "theme", [("superlative", "biggest", 0)]),
        ("Take the coffee mug.", "theme", [("compound", "coffee", 0)]),
        ("Go to room 5.", "goal", [("name", "5", 5)]),
        ("Open the second door.", "container_portal", [("ordinal", "second", 2)]),
        ("Open the last door.", "container_portal", [("ordinal", "last", -1)]),
        ("Raise your right arm.", "limb", [("adjective", "right", 0)]),
        ("Raise your left arm.", "limb", [("adjective", "left", 0)]),
    ],
)
def test_modifiers(understand: Any, text: str, element: str, expected: Any) -> None:
    found = argument(understand(text)[0], element)
    assert [(modifier.kind, modifier.word, modifier.number) for modifier in found.modifiers] == expected


def test_degree_of_an_adjective(understand: Any) -> None:
    (modifier,) = argument(understand("Take the very big mug.")[0], "theme").modifiers
    assert modifier == Modifier("adjective", "big", "big", degree="very", position=4)


def test_members_have_their_own_meaning(understand: Any) -> None:
    found = argument(understand("Bring me two cups and the red plate.")[0], "theme")
    assert found.conjunction == "and"
    assert [(one.text, one.count, one.quantifier) for one in found.members] == [
        ("two cups", 2, ""),
        ("the red plate", None, "the"),
    ]
    assert [modifier.word for modifier in found.members[1].modifiers] == ["red"]


def test_places_describe_the_head_as_frames(understand: Any) -> None:
    for text in ("Take the cup on the shelf.", "Take the cup that is on the shelf."):
        (frame,) = argument(understand(text)[0], "theme").frames
        assert (frame.role, frame.frame_name, frame.head_element) == ("describes", "being_located", "theme")
        (place,) = frame.frame_elements
        assert (place.name, place.relation, place.text) == ("location", "on", "the shelf")


def test_clause_that_describes_keeps_its_words(understand: Any) -> None:
    (frame,) = argument(understand("Follow the guest wearing a hat.")[0], "cotheme").frames
    assert (frame.role, frame.words) == ("describes", "wearing a hat")


def test_message_keeps_its_clause(understand: Any) -> None:
    found = argument(understand("Tell Anna where the keys are.")[0], "message")
    assert [(frame.role, frame.words, frame.mood) for frame in found.frames] == [
        ("says", "where the keys are", "question")
    ]
    assert not found.modifiers


@pytest.mark.parametrize(
    "text, bound, change",
    [
        ("Turn left 120 degrees.", "", ""),
        ("Turn left about 120 degrees.", "about", ""),
        ("Move forward two more metres.", "", "more"),
    ],
)
def test_measures(understand: Any, text: str, bound: str, change: str) -> None:
    outcome = understand(text)[0]
    found = argument(outcome, "angle" if "Turn" in text else "distance")
    assert found.measure is not None
    assert (found.measure.bound, found.measure.change) == (bound, change)
    assert found.si == pytest.approx(2.0943951 if "Turn" in text else 2.0)


def test_pronoun_is_inferred(understand: Any) -> None:
    _, context = understand("Take the red mug.")
    found = argument(understand("Put it on the table.", context)[0], "theme")
    assert (found.text, found.source, found.words) == ("the red mug", Source.INFERRED, "it")


def test_two_directions_are_two_turns(understand: Any) -> None:
    # One turn to two sides, one after the other, or two turns: the robot does the same.
    outcome = understand("Turn to the left and then to the right.")[0]
    assert isinstance(outcome, Understood), outcome
    sides = [readings[0].argument("direction") for readings in outcome.clauses]
    assert [one.text for side in sides if side is not None for one in side.members or (side,)] == ["left", "right"]


@pytest.mark.parametrize(
    "text, element, members",
    [
        ("Go either to the kitchen or to the hall.", "goal", ["the kitchen", "the hall"]),
        ("Take both the cup and the plate.", "theme", ["the cup", "the plate"]),
        ("Take both mugs and the plate.", "theme", ["both mugs", "the plate"]),
    ],
)
def test_words_before_a_list_are_part_of_no_member(
    understand: Any, text: str, element: str, members: List[str]
) -> None:
    assert [member.text for member in argument(understand(text)[0], element).members] == members
