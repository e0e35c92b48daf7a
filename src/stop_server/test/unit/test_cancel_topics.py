"""Which servers are cancelled."""
import pytest

from stop_server.cancel_topics import FRAME_GOAL_TYPE, cancel_topic, find_servers
from stop_server.settings import Settings
from stop_server.stop_window import StopWindow

TYPES = {
    "/turn/goal": FRAME_GOAL_TYPE, "/turn/cancel": "actionlib_msgs/GoalID",
    "/gone/goal": FRAME_GOAL_TYPE, "/gone/cancel": "actionlib_msgs/GoalID",
    "/command/goal": "roboframenet_msgs/ExecuteCommandActionGoal", "/command/cancel": "actionlib_msgs/GoalID",
    "/move_base/goal": "move_base_msgs/MoveBaseActionGoal", "/text": "std_msgs/String",
}
HEARD = {"/turn/cancel", "/command/cancel", "/move_base/cancel", "/text", "/gone/goal"}


def test_servers_of_frames_that_are_there():
    assert find_servers(TYPES, HEARD, ()) == {"/turn"}


def test_other_servers_count_when_they_are_there():
    assert find_servers(TYPES, HEARD, ("/move_base", "/arm")) == {"/turn", "/move_base"}


def test_no_graph_no_servers():
    assert find_servers({}, set(), ("/move_base", "")) == frozenset()


def test_names_with_a_slash_at_the_end():
    assert find_servers(TYPES, HEARD, ("/move_base/",)) == {"/turn", "/move_base"}
    assert cancel_topic("/move_base/") == "/move_base/cancel"


@pytest.mark.parametrize("wrong", [
    {"velocity_topics": "cmd_vel"}, {"velocity_topics": [""]}, {"also_cancel": [3]},
    {"zero_velocity_duration_s": float("nan")}, {"zero_velocity_duration_s": -1.0}, {"zero_velocity_rate_hz": 0.0},
    {"refresh_period_s": "1"}, {"master_timeout_s": True}])
def test_wrong_settings_are_refused_by_name(wrong):
    with pytest.raises(ValueError, match="~" + next(iter(wrong))):
        Settings(**wrong)


def test_lists_from_the_parameter_server_are_taken():
    assert Settings(velocity_topics=["a", "b"]).velocity_topics == ("a", "b")


def test_window_is_open_for_its_time_after_the_last_stop():
    now_s = [0.0]
    window = StopWindow(duration_s=1.0, now=lambda: now_s[0])
    assert not window.is_open
    window.open()
    now_s[0] = 0.9
    assert window.is_open
    window.open()
    now_s[0] = 1.8
    assert window.is_open
    now_s[0] = 1.9
    assert not window.is_open
