"""Arguments of the frames, as the speaker said them."""

import math

import pytest

from move_action_server.motion import MotionKind, Pace
from move_action_server.spoken_motion import (
    PACES,
    SPEEDS,
    NotUnderstood,
    backward_goal,
    compass_goal,
    forward_goal,
    turn_goal,
)
from semantic_frames.server_statement import stated_profile
from typed_arguments import Measure, TypedArgument


def texts(**arguments):
    """What a client of 2012 sends."""
    return {name: TypedArgument(name, text) for name, text in arguments.items()}


@pytest.mark.parametrize(
    "distance,unit,metres",
    [
        ("3", "feet", 0.9144),
        ("1", "metre", 1.0),
        ("2", "yards", 1.8288),
        ("three", "feet", 0.9144),
        ("3 feet", "", 0.9144),
        ("0.5", "meters", 0.5),
        ("50", "cm", 0.5),
        ("-2", "metres", -2.0),
        ("minus two", "metres", -2.0),
        ("3 feet", "feet", 0.9144),
        ("3", "kilometres", 3000.0),
    ],
)
def test_distances(distance, unit, metres):
    arguments = texts(distance=distance, distance_unit=unit)
    assert forward_goal(arguments).kind is MotionKind.STRAIGHT
    assert forward_goal(arguments).amount == pytest.approx(metres)
    assert backward_goal(arguments).amount == pytest.approx(-metres)


@pytest.mark.parametrize(
    "direction,angle,unit,radians",
    [
        ("left", "120", "degrees", math.radians(120)),
        ("right", "2", "radians", -2.0),
        ("Left", "ninety", "degrees", math.pi / 2),
        ("right", "-30", "degrees", math.radians(30)),
        ("left", "1", "turn", 2 * math.pi),
        ("clockwise", "1", "radian", -1.0),
        ("counterclockwise", "1", "radian", 1.0),
        ("around", "", "", math.pi),
        ("around", "90", "degrees", math.pi / 2),
        ("around", "360", "degrees", 2 * math.pi),
        ("left", "120 degrees", "", math.radians(120)),
    ],
)
def test_turns(direction, angle, unit, radians):
    goal = turn_goal(texts(direction=direction, angle=angle, angle_unit=unit))
    assert goal.kind is MotionKind.TURN
    assert goal.amount == pytest.approx(radians)


@pytest.mark.parametrize(
    "arguments,words",
    [
        ({}, "How far"),
        ({"distance": "3"}, "unit"),
        ({"distance": "3", "distance_unit": "degrees"}, "length"),
        ({"distance": "far", "distance_unit": "feet"}, "far"),
        ({"distance": "1e400", "distance_unit": "feet"}, "count"),
        ({"distance": "nan", "distance_unit": "feet"}, "nan"),
        ({"distance": "3", "distance_unit": "elephants"}, 'unit "elephants"'),
    ],
)
def test_distances_that_name_no_motion(arguments, words):
    for read in (forward_goal, backward_goal):
        with pytest.raises(NotUnderstood) as caught:
            read(texts(**arguments))
        assert words in str(caught.value)


@pytest.mark.parametrize(
    "arguments,words",
    [
        ({"angle": "3", "angle_unit": "degrees"}, "left or right"),
        ({"direction": "up", "angle": "3"}, '"up"'),
        ({"direction": "left"}, "How far"),
        ({"direction": "left", "angle": "3"}, "unit"),
        ({"direction": "left", "angle": "1e400", "angle_unit": "degrees"}, "count"),
        ({"direction": "around", "angle": "much", "angle_unit": "degrees"}, "much"),
    ],
)
def test_turns_that_name_no_motion(arguments, words):
    with pytest.raises(NotUnderstood) as caught:
        turn_goal(texts(**arguments))
    assert words in str(caught.value)


def test_the_measure_of_the_framer_is_not_read_again():
    measure = Measure("angle", "a bit more than that", amount=None, unit="", si=0.25)
    arguments = {**texts(direction="right"), "angle": TypedArgument("angle", "a bit more", measure=measure)}
    assert turn_goal(arguments).amount == -0.25


def test_a_measure_of_another_kind_is_not_used():
    arguments = {"distance": TypedArgument("distance", "3 degrees", measure=Measure("angle", si=0.05))}
    with pytest.raises(NotUnderstood, match="length"):
        forward_goal(arguments)


@pytest.mark.parametrize(
    "said, pace",
    [
        ({}, Pace.USUAL),
        ({"speed": "quickly"}, Pace.QUICK),
        ({"manner": "slowly"}, Pace.SLOW),
        ({"manner": "more carefully"}, Pace.SLOW),
        ({"manner": "gently"}, Pace.SLOW),
        ({"speed": "half speed"}, Pace.SLOW),
        ({"speed": "a slow pace"}, Pace.SLOW),
        ({"speed": "top speed", "manner": "fast"}, Pace.QUICK),
    ],
)
def test_manner_and_speed_change_the_pace(said, pace):
    for goal_of in (forward_goal, backward_goal):
        assert goal_of(texts(distance="1 metre", **said)).pace is pace
    for direction in ("left", "right", "around"):
        assert turn_goal(texts(direction=direction, angle="90 degrees", **said)).pace is pace


@pytest.mark.parametrize("said", [{"manner": "happily"}, {"manner": "slowly", "speed": "quickly"}])
def test_other_manners_are_refused(said):
    with pytest.raises(NotUnderstood, match="only slowly or quickly"):
        forward_goal(texts(distance="1 metre", **said))


def test_everything_that_is_heeded_is_understood():
    profile = stated_profile({"heeds": {"Manner": PACES, "Speed": SPEEDS}})
    for heeded in profile.heeds:
        for value in heeded.values:
            said = TypedArgument(heeded.name.lower(), value)
            assert forward_goal({**texts(distance="1 metre"), said.name: said}).pace is not Pace.USUAL
    for text in ("slowly", "a slow pace", "half speed", "quickly"):
        quantifier = "a" if text.startswith("a ") else ""
        said = TypedArgument("speed", text, quantifier=quantifier)
        assert profile.heeds_argument(said, None)
    assert not profile.heeds_argument(TypedArgument("manner", "happily"), None)


@pytest.mark.parametrize(
    "direction, yaw_deg, turn_deg",
    [
        ("north", 0.0, 90.0),
        ("east", 0.0, 0.0),
        ("South", 0.0, -90.0),
        ("west", 170.0, 10.0),
        ("north east", 0.0, 45.0),
        ("southwest", -90.0, -45.0),
        ("northwards", 80.0, 10.0),
        ("westward", -170.0, -10.0),
    ],
)
def test_a_direction_of_the_compass_is_reached_the_shorter_way(direction, yaw_deg, turn_deg):
    goal = compass_goal(texts(direction=direction), north_rad=math.pi / 2.0)
    motion = goal.motion(math.radians(yaw_deg))
    assert motion.kind is MotionKind.TURN
    assert motion.amount == pytest.approx(math.radians(turn_deg))


def test_north_may_be_elsewhere():
    assert compass_goal(texts(direction="north"), north_rad=0.0).motion(0.0).amount == pytest.approx(0.0)


def test_an_angle_towards_a_direction_of_the_compass():
    goal = compass_goal(texts(direction="south", angle="10", angle_unit="degrees"), north_rad=math.pi / 2.0)
    assert goal.motion(0.0).amount == pytest.approx(math.radians(-10.0))


def test_what_is_no_direction_of_the_compass_is_refused():
    with pytest.raises(NotUnderstood, match="upward"):
        compass_goal(texts(direction="upward"), north_rad=0.0)
