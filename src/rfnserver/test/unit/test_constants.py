"""What a goal always holds, also in its lists, and elements that fill fields of what stands in lists."""

import pytest
from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import Path
from trajectory_msgs.msg import JointTrajectory
from visualization_msgs.msg import MarkerArray

from rfnserver.goal_binding import BoundElement, goal_values, plan_goal
from rfnserver.ros_goal_messages import fields_in_lists, fill, with_constants
from typed_arguments import TypedArgument


def test_lists_of_messages_are_held() -> None:
    constants = {"joint_names": ["a"], "points": [{"positions": [1, 2.5], "time_from_start": {"secs": 3, "nsecs": 0}}]}
    message = with_constants(JointTrajectory, constants)
    assert message.joint_names == ["a"] and message.points[0].positions == [1, 2.5]
    assert message.points[0].time_from_start.to_sec() == 3.0
    # Each goal is a message of its own.
    message.points[0].positions[0] = 9
    assert with_constants(JointTrajectory, constants).points[0].positions == [1, 2.5]


@pytest.mark.parametrize(
    "constants", [{"jointnames": ["a"]}, {"points": [{"place": 1}]}, {"joint_names": [1]}, {"points": "far"}]
)
def test_what_the_message_cannot_hold_is_refused(constants: "dict[str, object]") -> None:
    with pytest.raises(ValueError, match="constants"):
        with_constants(JointTrajectory, constants)


def test_an_element_fills_a_field_of_a_message_in_a_list() -> None:
    constants = {"markers": [{"id": 1}, {"id": 2, "ns": "words"}]}
    fields = fields_in_lists(with_constants(MarkerArray, constants))
    plan = plan_goal(fields, [BoundElement("message", is_core=True)], mapping={"markers[1].text": "message"})
    values = goal_values(plan, {"message": TypedArgument(text="hello")})
    filled = fill(with_constants(MarkerArray, constants), values)
    assert [one.text for one in filled.markers] == ["", "hello"] and filled.markers[1].ns == "words"


def test_a_place_fills_an_item_of_a_list() -> None:
    fields = fields_in_lists(with_constants(Path, {"poses": [{}]}))
    plan = plan_goal(fields, [BoundElement("goal", is_core=True)], mapping={"poses[0]": "goal"})
    place = PoseStamped()
    place.pose.position.x = 3.0
    values = goal_values(plan, {"goal": TypedArgument(text="the office")}, locate=lambda words: place)
    assert fill(with_constants(Path, {"poses": [{}]}), values).poses[0].pose.position.x == 3.0
