"""A stop finds the servers that it cancels."""

import pytest

from robot_stop.servers import FRAME_GOAL_TYPE, Server, find_servers, shown_names
from robot_stop.settings import BrakeSettings

TYPES = {
    "/turn/goal": FRAME_GOAL_TYPE,
    "/gone/goal": FRAME_GOAL_TYPE,
    "/command/goal": "roboframenet_msgs/ExecuteCommandActionGoal",
    "/move_base/goal": "move_base_msgs/MoveBaseActionGoal",
    "/text": "std_msgs/String",
    "/fibonacci/goal": "actionlib_tutorials/FibonacciActionGoal",
    "/fibonacci/frame/goal": FRAME_GOAL_TYPE,
    "/arm/goal": "arm_msgs/ArmActionGoal",
    "/arm/frame/goal": FRAME_GOAL_TYPE,
}
LISTENERS = {
    "/turn/cancel": {"/turner"},
    "/gone/cancel": set(),
    "/command/cancel": {"/command_server"},
    "/move_base/cancel": {"/move_base"},
    "/text": {"/stop_server"},
    "/gone/goal": {"/turner"},
    "/fibonacci/cancel": {"/maths"},
    "/fibonacci/frame/cancel": {"/maths"},
    "/arm/cancel": {"/arm_driver"},
    "/arm/frame/cancel": {"/somebody_else"},
}
TURN = Server("/turn", takes_frames=True)
OF_FRAMES = {TURN, Server("/fibonacci/frame", takes_frames=True), Server("/arm/frame", takes_frames=True)}
PORTED = Server("/fibonacci", takes_frames=False)


def find(registered=(), others=(), types=None):
    return find_servers(TYPES if types is None else types, LISTENERS, registered=registered, others=others)


def test_present_frame_servers_are_found_and_ported_ones_under_both_names():
    assert find() == OF_FRAMES | {PORTED}


def test_registered_server_takes_frames_whatever_its_type():
    assert find(registered=("/move_base", "/nobody")) == OF_FRAMES | {PORTED, Server("/move_base", takes_frames=True)}


def test_ported_server_that_registered_is_found_without_a_type():
    assert find(registered=("/fibonacci/frame",), types={}) == {PORTED, Server("/fibonacci/frame", takes_frames=True)}


def test_also_cancelled_servers_are_found_when_present():
    assert find(others=("/move_base", "/nobody")) == OF_FRAMES | {PORTED, Server("/move_base", takes_frames=False)}


def test_also_cancelled_server_that_takes_frames_is_marked_so():
    assert find(others=("/turn",)) == find()


def test_no_graph_no_servers():
    assert find_servers({}, {}, registered=("/turn",), others=("/move_base", "")) == frozenset()


def test_names_with_a_slash_at_the_end():
    assert find(others=("/move_base/",)) == find(others=("/move_base",))
    assert (TURN.cancel_topic, TURN.status_topic) == ("/turn/cancel", "/turn/status")


def test_both_names_of_a_ported_server_are_one_for_a_person():
    assert shown_names(["/fibonacci", "/fibonacci/frame", "/arm/frame"]) == {"/fibonacci", "/arm/frame"}


@pytest.mark.parametrize(
    "wrong",
    [
        {"velocity_topics": "cmd_vel"},
        {"velocity_topics": [""]},
        {"also_cancel": [3]},
        {"zero_velocity_duration_s": float("nan")},
        {"zero_velocity_duration_s": -1.0},
        {"zero_velocity_rate_hz": 0.0},
        {"zero_velocity_limit_s": 601.0},
        {"confirmation_timeout_s": 0.1},
        {"refresh_period_s": "1"},
        {"master_timeout_s": True},
    ],
)
def test_wrong_settings_are_refused_by_name(wrong):
    with pytest.raises(ValueError, match="~" + next(iter(wrong))):
        BrakeSettings(**wrong)


def test_lists_from_the_parameter_server_are_taken():
    assert BrakeSettings(velocity_topics=["a", "b"]).velocity_topics == ("a", "b")
