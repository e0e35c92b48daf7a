"""The arm that is named moves."""

from typing import Any, Tuple

import pytest

from pr2_props.named_arms import UnknownArm, named_arms
from pr2_props.props import JOINTS, Arm, mirrored
from typed_arguments import Modifier, TypedArgument

LEFT = (Modifier("adjective", "left", "left"),)


@pytest.mark.parametrize(
    "argument, arms",
    [
        ({}, ()),
        ({"text": "arm"}, ()),
        ({"text": "arm", "count": 1}, ()),
        ({"text": "arm", "modifiers": LEFT}, (Arm.LEFT,)),
        ({"text": "your left hand", "modifiers": LEFT}, (Arm.LEFT,)),
        ({"text": "your right hand"}, (Arm.RIGHT,)),
        ({"text": "each arm", "quantifier": "each"}, (Arm.RIGHT, Arm.LEFT)),
        ({"text": "every arm", "quantifier": "every"}, (Arm.RIGHT, Arm.LEFT)),
        ({"text": "an arm", "quantifier": "a"}, ()),
        ({"text": "the arm", "quantifier": "the"}, ()),
        ({"text": "arms", "is_plural": True}, (Arm.RIGHT, Arm.LEFT)),
        ({"text": "both arms", "is_plural": True, "count": 2}, (Arm.RIGHT, Arm.LEFT)),
    ],
)
def test_named_arms(argument: Any, arms: Tuple[Arm, ...]) -> None:
    assert named_arms(TypedArgument("limb", **argument)) == arms


@pytest.mark.parametrize("argument", [{"modifiers": (Modifier("adjective", "other"),)}, {"count": 3}])
def test_arm_that_is_unclear_is_said(argument: Any) -> None:
    with pytest.raises(UnknownArm, match='"your other arm"'):
        named_arms(TypedArgument("limb", "arm", words="your other arm", **argument))


def test_other_arm_does_the_same_at_its_side() -> None:
    positions = (-0.2, -0.2, -1.2, -1.8, 0.1, -0.3, 1.57)
    assert mirrored(mirrored(positions)) == positions
    changed = {joint for joint, one, other in zip(JOINTS, positions, mirrored(positions)) if one != other}
    assert changed == {"shoulder_pan_joint", "upper_arm_roll_joint", "forearm_roll_joint", "wrist_roll_joint"}
