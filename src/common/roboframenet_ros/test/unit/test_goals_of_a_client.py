"""The client of a server with many goals: each hears what is said about it, as with actionlib's own client."""

from typing import Any, Dict, List, Tuple

import actionlib
import pytest
import rospy
from actionlib.action_client import GoalManager
from actionlib_msgs.msg import GoalID, GoalStatus, GoalStatusArray
from actionlib_msgs.msg import GoalStatus as Status
from roboframenet_msgs.msg import (
    FilledSemanticFrameAction,
    FilledSemanticFrameActionFeedback,
    FilledSemanticFrameActionResult,
    FilledSemanticFrameGoal,
)

from roboframenet_ros.ros_action_connection import _GoalManager


class Client:
    """Goals of one manager, and what each has heard: its states and its feedback."""

    def __init__(self, manager: GoalManager) -> None:
        self.manager = manager
        manager.register_send_goal_fn(self._send)
        manager.register_cancel_fn(lambda _: None)
        self.heard: Dict[str, List[object]] = {}
        self.handles: List[actionlib.ClientGoalHandle] = []
        self.at_sending: Any = lambda _: None

    def _send(self, goal: Any) -> None:
        self.at_sending(goal.goal_id.id)

    def send(self) -> None:
        heard: List[object] = []
        handle = self.manager.init_goal(
            FilledSemanticFrameGoal(),
            lambda handle: heard.append((handle.get_comm_state(), handle.get_goal_status())),
            lambda _, feedback: heard.append(feedback.is_succeeding),
        )
        self.handles.append(handle)
        self.heard[handle.comm_state_machine.action_goal.goal_id.id] = heard

    @property
    def ids(self) -> List[str]:
        return list(self.heard)


@pytest.fixture(params=(GoalManager, _GoalManager))
def client(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Client:
    monkeypatch.setattr(rospy, "get_rostime", lambda: rospy.Time(5))
    monkeypatch.setattr(rospy.Time, "now", lambda: rospy.Time(5))
    return Client(request.param(FilledSemanticFrameAction))


def status_of(goal_id: str, status: int) -> GoalStatus:
    return GoalStatus(goal_id=GoalID(id=goal_id), status=status)


def feedback_of(goal_id: str, holds: bool) -> FilledSemanticFrameActionFeedback:
    feedback = FilledSemanticFrameActionFeedback(status=status_of(goal_id, Status.ACTIVE))
    feedback.feedback.is_succeeding = holds
    return feedback


def told(*statuses: Tuple[str, int]) -> GoalStatusArray:
    return GoalStatusArray(status_list=[status_of(*one) for one in statuses])


def test_each_goal_hears_its_own_status_feedback_and_result(client: Client) -> None:
    for _ in range(3):
        client.send()
    one, two, three = client.ids
    client.manager.update_statuses(told((three, Status.ACTIVE), ("stranger", Status.ABORTED), (one, Status.ACTIVE)))
    client.manager.update_feedbacks(feedback_of(three, True))
    client.manager.update_feedbacks(feedback_of("stranger", True))
    result = FilledSemanticFrameActionResult(status=status_of(one, Status.SUCCEEDED))
    client.manager.update_results(result)
    comm = actionlib.CommState
    waiting, done = (comm.WAITING_FOR_RESULT, Status.SUCCEEDED), (comm.DONE, Status.SUCCEEDED)
    assert client.heard[one] == [(comm.ACTIVE, Status.ACTIVE), waiting, done]
    assert client.heard[two] == []
    assert client.heard[three] == [(comm.ACTIVE, Status.ACTIVE), True]


def test_goal_that_the_server_has_forgotten_is_lost(client: Client) -> None:
    for _ in range(2):
        client.send()
    one, two = client.ids
    client.manager.update_statuses(told((one, Status.ACTIVE), (two, Status.ACTIVE)))
    client.manager.update_statuses(told((two, Status.ACTIVE)))
    assert client.heard[one][-1] == (actionlib.CommState.DONE, Status.LOST)
    assert client.heard[two] == [(actionlib.CommState.ACTIVE, Status.ACTIVE)]


def test_goal_whose_handle_is_not_kept_is_forgotten(client: Client) -> None:
    client.send()
    (one,) = client.ids
    client.handles.clear()
    client.manager.update_statuses(told((one, Status.ACTIVE)))
    client.manager.update_feedbacks(feedback_of(one, True))
    assert client.heard[one] == []


def test_feedback_that_comes_while_the_goal_is_being_sent_is_heard(client: Client) -> None:
    client.at_sending = lambda goal_id: client.manager.update_feedbacks(feedback_of(goal_id, True))
    client.send()
    (heard,) = client.heard.values()
    assert heard == [True]
