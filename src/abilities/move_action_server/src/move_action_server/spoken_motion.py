"""Converts the arguments of a frame to a motion in metres or radians."""

import math
from dataclasses import dataclass
from typing import Mapping, Optional

from move_action_server.motion import MotionGoal, MotionKind, Pace, wrap
from semantic_frames.server_profile import spellings
from spoken_quantities import QuantityError, parse_measure
from typed_arguments import TypedArgument
from word_classes import word_class, word_list

LEFTWARD = word_class("leftward")
RIGHTWARD = word_class("rightward")
AROUND = "around"
#: Directions of the compass from north, counterclockwise by an eighth of a turn each, as yaw counts in REP 103.
COMPASS = word_list("compass_points")
SLOW = word_class("slow_words")
QUICK = word_class("quick_words")
#: What the servers heed of the manner and the speed of a motion: "slowly", "at half speed".
PACES = tuple(sorted(SLOW | QUICK))
SPEEDS = PACES + tuple(f"{pace} {noun}" for pace in PACES for noun in sorted(word_class("speed_nouns")))


class NotUnderstood(ValueError):
    """The arguments describe no motion; the message is a sentence for a person."""


def _amount(arguments: Mapping[str, TypedArgument], *, element: str, quantity: str, question: str) -> float:
    """Read an amount and its unit. The unit is in an element of its own, or follows the number.

    Returns:
        metres or radians; finite, with the spoken sign
    """
    argument = arguments.get(element, TypedArgument())
    if argument.measure is not None and argument.measure.kind == quantity and argument.si is not None:
        return argument.si
    # A client of 2012 sends only texts.
    number = argument.text.strip()
    unit = _text(arguments, element + "_unit")
    if not number:
        raise NotUnderstood(question)
    try:
        if unit and parse_measure(number).quantity == "number":
            number = f"{number} {unit}"
        return parse_measure(number, quantity=quantity).si_amount
    except QuantityError as error:
        raise NotUnderstood(str(error)) from error


def _text(arguments: Mapping[str, TypedArgument], element: str) -> str:
    return arguments.get(element, TypedArgument()).text.strip()


def _distance_m(arguments: Mapping[str, TypedArgument]) -> float:
    return _amount(arguments, element="distance", quantity="length", question="How far should I move?")


def forward_goal(arguments: Mapping[str, TypedArgument]) -> MotionGoal:
    """Read moving_forward(distance, distance_unit, manner, speed). A negative distance moves back.

    Raises:
        NotUnderstood: the number or the unit is missing, it is not a length, or the manner says no pace
    """
    return MotionGoal(kind=MotionKind.STRAIGHT, amount=_distance_m(arguments), pace=_pace(arguments))


def backward_goal(arguments: Mapping[str, TypedArgument]) -> MotionGoal:
    """Read moving_backward(distance, distance_unit, manner, speed). A negative distance moves forward.

    Raises:
        NotUnderstood: the number or the unit is missing, it is not a length, or the manner says no pace
    """
    return MotionGoal(kind=MotionKind.STRAIGHT, amount=-_distance_m(arguments), pace=_pace(arguments))


def turn_goal(arguments: Mapping[str, TypedArgument]) -> MotionGoal:
    """Read turning(direction, angle, angle_unit, manner, speed). A negative angle turns the other way.

    "Around" turns left, by half a turn when no angle is given.

    Raises:
        NotUnderstood: the number, the unit or the direction is missing, it is not an angle, or the manner says no pace
    """
    direction = _text(arguments, "direction").lower()
    if direction == AROUND:
        is_said = bool(_text(arguments, "angle"))
        return MotionGoal(MotionKind.TURN, _angle_rad(arguments) if is_said else math.pi, _pace(arguments))
    if direction in LEFTWARD:
        return MotionGoal(MotionKind.TURN, _angle_rad(arguments), _pace(arguments))
    if direction in RIGHTWARD:
        return MotionGoal(MotionKind.TURN, -_angle_rad(arguments), _pace(arguments))
    if direction:
        raise NotUnderstood(f'I cannot turn "{direction}", only left, right or around.')
    raise NotUnderstood("Should I turn left or right?")


@dataclass(frozen=True)
class CompassGoal:
    """A turn towards a direction of the compass; how far depends on where the base faces when it starts.

    Attributes:
        heading_rad: yaw of the direction in the frame of the odometry
        angle_rad: how far to turn towards it; None until the base faces it
        pace: how fast
    """

    heading_rad: float
    angle_rad: Optional[float] = None
    pace: Pace = Pace.USUAL

    def motion(self, yaw_rad: float) -> MotionGoal:
        """Return the turn of a base that faces a yaw; the shorter way round."""
        turn_rad = wrap(self.heading_rad - yaw_rad)
        amount = turn_rad if self.angle_rad is None else math.copysign(self.angle_rad, turn_rad)
        return MotionGoal(MotionKind.TURN, amount, self.pace)


def compass_goal(arguments: Mapping[str, TypedArgument], *, north_rad: float) -> CompassGoal:
    """Read turning_to_direction(direction, angle, angle_unit, manner, speed).

    Args:
        arguments: by element
        north_rad: yaw of north in the frame of the odometry
    Raises:
        NotUnderstood: the direction is none of the compass, or the angle or the manner is not understood
    """
    said = _text(arguments, "direction").lower()
    point = said.replace(" ", "").replace("-", "").replace("_", "").split("ward")[0]
    if point not in COMPASS:
        raise NotUnderstood(f'I cannot turn to "{said}", only to a direction of the compass.')
    heading_rad = wrap(north_rad + COMPASS.index(point) * math.pi / 4.0)
    is_said = bool(_text(arguments, "angle"))
    return CompassGoal(heading_rad, _angle_rad(arguments) if is_said else None, _pace(arguments))


def _angle_rad(arguments: Mapping[str, TypedArgument]) -> float:
    return _amount(arguments, element="angle", quantity="angle", question="How far should I turn?")


def _pace(arguments: Mapping[str, TypedArgument]) -> Pace:
    """Return how fast to go: "slowly", "at half speed", "more carefully".

    Raises:
        NotUnderstood: words that say neither, or both
    """
    said = [text for text in (_text(arguments, name) for name in ("speed", "manner")) if text]
    words = spellings(*" ".join(said).split())
    is_slow, is_quick = bool(words & SLOW), bool(words & QUICK)
    if said and is_slow == is_quick:
        raise NotUnderstood(f'I cannot move "{" and ".join(said)}", only slowly or quickly.')
    return Pace.SLOW if is_slow else Pace.QUICK if is_quick else Pace.USUAL
