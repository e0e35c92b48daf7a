"""Finds the arms that a person names: "your left hand", "both arms"."""

from typing import Tuple

from pr2_props.props import Arm
from typed_arguments import TypedArgument

#: What may be called an arm.
ARM_NOUNS = ("arm", "hand")
_ALL = frozenset(["each", "every", "all", "both"])


class UnknownArm(ValueError):
    """It is unclear which arm is meant; the message is for the person."""


def named_arms(argument: TypedArgument) -> Tuple[Arm, ...]:
    """Return the arms that are named; none for "your arm", which leaves the choice.

    Args:
        argument: the phrase that names an arm; an empty one names none
    Raises:
        UnknownArm: a property that no arm has: "your other arm"
    """
    said = [modifier.word.lower() for modifier in argument.modifiers] or argument.text.lower().split()
    arms = tuple(arm for arm in Arm if arm.value in said)
    if arms:
        return arms
    if argument.quantifier in _ALL or argument.is_plural or argument.count == len(Arm):
        return tuple(Arm)
    if argument.modifiers or argument.count not in (None, 1):
        raise UnknownArm(f'I do not know which arm "{argument.words or argument.text}" is: left or right?')
    return ()
