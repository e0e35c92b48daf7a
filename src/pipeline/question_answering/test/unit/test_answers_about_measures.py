"""Answers about measures, of a small world whose sizes are known."""

from dataclasses import replace
from typing import Dict, Optional, Tuple

import pytest

from question_answering.answers import answer
from question_answering.robot_knowledge import RobotKnowledge
from typed_arguments import Modifier, TypedArgument
from world_model import Pose, Sort, World, WorldObject

_FRIDGE = WorldObject("fridge", name="fridge", size_m=(0.6, 0.7, 1.8), pose=Pose("map", 3.0, 4.0))
_TABLE = WorldObject("table", name="table", size_m=(1.2, 0.8, 0.75), pose=Pose("map", 0.0, 4.0))
_VASE = WorldObject("vase", name="vase")
_MUGS = tuple(WorldObject(f"mug_{number}", category="mug") for number in range(2))
_ROBOT = WorldObject("robot", sort=Sort.ROBOT, pose=Pose("map", 0.0, 0.0))
KNOWN = RobotKnowledge(World(objects=(_FRIDGE, _TABLE, _VASE, *_MUGS, _ROBOT)))


def said(name: str, text: str) -> TypedArgument:
    noun = text.split()[-1]
    return TypedArgument(name, text, words=text, head=noun, lemma=noun.rstrip("s"), is_plural=noun.endswith("s"))


def ask(frame: str, attribute: str, theme: str, **others: str) -> Optional[str]:
    arguments = [said("theme", theme), TypedArgument("attribute", attribute)]
    return answer(frame, (*arguments, *(said(name, text) for name, text in others.items())), KNOWN)


@pytest.mark.parametrize(
    ("attribute", "theme", "expected"),
    [
        ("tall", "the fridge", "The fridge is 1.8 m tall."),
        ("high", "the table", "The table is 0.75 m high."),
        ("big", "the fridge", "The fridge is 0.60 by 0.70 m, and 1.8 m high."),
        ("height", "the table", "The table is 0.75 m high."),
        ("weight", "the table", "I do not know the weight of the table."),
        ("far", "the fridge", "The fridge is 5.0 m away from me."),
        ("tall", "the vase", "I do not know how tall the vase is."),
        ("heavy", "the fridge", "I do not know how heavy the fridge is."),
        ("tall", "the spoon", "I know of no spoon."),
    ],
)
def test_amounts(attribute: str, theme: str, expected: str) -> None:
    assert ask("question_of_measure", attribute, theme) == expected


def test_a_distance_may_begin_elsewhere() -> None:
    found = ask("question_of_measure", "far", "the fridge", standard="the table")
    assert found == "The fridge is 3.0 m away from the table."


@pytest.mark.parametrize(
    ("attribute", "others", "expected"),
    [
        ("taller", {"standard": "the table"}, "Yes, the fridge is taller than the table."),
        ("smaller", {"standard": "the table"}, "No, the fridge is not smaller than the table."),
        ("heavier", {"standard": "the table"}, "I do not know whether the fridge is heavier."),
        ("bigger", {"standard": "the vase"}, "I do not know whether the fridge is bigger."),
        ("lower", {"alternative": "the table"}, "The table is lower."),
        ("taller", {"standard": "the fridge"}, "As far as I know, the fridge and the fridge are alike in that."),
    ],
)
def test_comparisons(attribute: str, others: Dict[str, str], expected: str) -> None:
    assert ask("question_of_comparison", attribute, "the fridge", **others) == expected


def test_numbers_are_compared() -> None:
    assert ask("question_of_comparison", "more", "mugs", standard="spoons") == "Yes, I know of 2 mugs and no spoons."
    assert ask("question_of_comparison", "fewer", "mugs", standard="spoons") == "No, I know of 2 mugs and no spoons."


def test_the_second_most_is_found_by_its_rank() -> None:
    second = replace(said("theme", "the second tallest thing"), modifiers=_modifiers())
    found = answer("question_of_which", (second,), KNOWN)
    assert found == "It is the table."


def _modifiers() -> Tuple[Modifier, ...]:
    return (Modifier("ordinal", "second", "second", number=2), Modifier("superlative", "tallest", "tall"))
