"""What was said, as a motion: arguments of a frame in, metres and radians out."""
import math
from typing import Mapping

from move_action_server.motion import MotionGoal, MotionKind
from spoken_quantities import QuantityError, parse_measure

LEFT_WORDS = ("left", "counterclockwise", "anticlockwise")
RIGHT_WORDS = ("right", "clockwise")
AROUND = "around"
QUARTER_TURN_RAD = math.pi / 2.0


class NotUnderstood(ValueError):
    """Arguments that name no motion; the message is a sentence for a person."""


def _amount(arguments: Mapping[str, str], *, element: str, quantity: str, question: str) -> float:
    """Read an amount with its unit, which stands in an element of its own or behind the number.

    Returns:
        metres or radians; finite, with the sign that was said
    """
    number = arguments.get(element, "").strip()
    unit = arguments.get(element + "_unit", "").strip()
    if not number:
        raise NotUnderstood(question)
    try:
        if unit and parse_measure(number).quantity == "number":
            number = f"{number} {unit}"
        return parse_measure(number, quantity=quantity).si_amount
    except QuantityError as error:
        raise NotUnderstood(str(error)) from error


def _distance_m(arguments: Mapping[str, str]) -> float:
    return _amount(arguments, element="distance", quantity="length", question="How far should I move?")


def forward_goal(arguments: Mapping[str, str]) -> MotionGoal:
    """Read moving_forward(distance, distance_unit). A negative distance moves back.

    Raises:
        NotUnderstood: no number, no unit, or no length
    """
    return MotionGoal(kind=MotionKind.STRAIGHT, amount=_distance_m(arguments))


def backward_goal(arguments: Mapping[str, str]) -> MotionGoal:
    """Read moving_backward(distance, distance_unit). A negative distance moves forward.

    Raises:
        NotUnderstood: no number, no unit, or no length
    """
    return MotionGoal(kind=MotionKind.STRAIGHT, amount=-_distance_m(arguments))


def turn_goal(arguments: Mapping[str, str]) -> MotionGoal:
    """Read turning(direction, angle, angle_unit). A negative angle turns the other way.

    "Turn around" is half a turn to the left. The frame fills an angle that was not said with a quarter turn, so with
    this direction a quarter turn counts as not said.

    Raises:
        NotUnderstood: no number, no unit, no angle, or no direction
    """
    direction = arguments.get("direction", "").strip().lower()
    if direction == AROUND:
        angle_rad = math.pi
        if arguments.get("angle", "").strip():
            said_rad = _angle_rad(arguments)
            angle_rad = said_rad if not math.isclose(said_rad, QUARTER_TURN_RAD, rel_tol=1e-6) else math.pi
        return MotionGoal(kind=MotionKind.TURN, amount=angle_rad)
    if direction in LEFT_WORDS:
        return MotionGoal(kind=MotionKind.TURN, amount=_angle_rad(arguments))
    if direction in RIGHT_WORDS:
        return MotionGoal(kind=MotionKind.TURN, amount=-_angle_rad(arguments))
    if direction:
        raise NotUnderstood(f'I cannot turn "{direction}", only left, right or around.')
    raise NotUnderstood("Should I turn left or right?")


def _angle_rad(arguments: Mapping[str, str]) -> float:
    return _amount(arguments, element="angle", quantity="angle", question="How far should I turn?")
