#!/usr/bin/python3
"""Servers that are started by the first goal, kept, and ended; and many servers in one process."""

import unittest
from typing import Any, Tuple

import actionlib
import rosgraph
import rospy
from actionlib_msgs.msg import GoalStatus
from roboframenet_msgs.msg import (
    FilledFrameElement,
    FilledSemanticFrame,
    FilledSemanticFrameAction,
    FilledSemanticFrameGoal,
)

from roboframenet_testing import wait_until


def is_up(server: str) -> bool:
    """Whether somebody publishes the status of a server."""
    published = rosgraph.Master(rospy.get_name()).getSystemState()[0]
    return any(topic == rospy.resolve_name(server + "/status") for topic, _ in published)


class ServerHostingTest(unittest.TestCase):
    """Goals to the node on_demand, and to servers of the host."""

    def send(self, frame_name: str, server: str = "on_demand", **arguments: str) -> Any:
        self.client = actionlib.ActionClient(server, FilledSemanticFrameAction)
        self.assertTrue(self.client.wait_for_server(rospy.Duration(60.0)), server)
        elements = [FilledFrameElement(name=name, argument=value) for name, value in arguments.items()]
        return self.client.send_goal(
            FilledSemanticFrameGoal(frame=FilledSemanticFrame(name=frame_name, frame_elements=elements))
        )

    def end(self, handle: Any) -> Tuple[int, str]:
        wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE)
        return handle.get_goal_status(), handle.get_goal_status_text()

    def test_started_by_the_first_goal_kept_for_the_second_and_ended_when_idle(self) -> None:
        wait_until(lambda: not is_up("chopping_server"))
        status, first = self.end(self.send("chopping"))
        self.assertEqual(GoalStatus.SUCCEEDED, status, first)
        self.assertEqual((GoalStatus.SUCCEEDED, first), self.end(self.send("slicing")))
        wait_until(lambda: not is_up("chopping_server"), message="it was not ended")
        status, again = self.end(self.send("chopping"))
        self.assertEqual(GoalStatus.SUCCEEDED, status, again)
        self.assertNotEqual(first, again)

    def test_a_server_that_works_for_others_is_not_ended(self) -> None:
        status, first = self.end(self.send("chopping"))
        self.assertEqual(GoalStatus.SUCCEEDED, status, first)
        # Longer than it may be idle, and past the node that started it.
        self.assertEqual((status, first), self.end(self.send("chopping", server="chopping_server", duration_s="14")))

    def test_launch_file_and_preemption(self) -> None:
        handle = self.send("folding", duration_s="100")
        wait_until(lambda: is_up("folding_server"))
        handle.cancel()
        self.assertEqual(GoalStatus.PREEMPTED, self.end(handle)[0])

    def test_what_cannot_be_started_is_said(self) -> None:
        for frame_name, reason in (
            ("missing_program", "nowhere cannot be started"),
            ("missing_file", "no_such.launch"),
            ("silent", "another_name is not running"),
            ("unknown", "no manifest names a server"),
        ):
            status, text = self.end(self.send(frame_name))
            self.assertEqual(GoalStatus.ABORTED, status, frame_name)
            self.assertIn(reason, text)

    def test_server_that_dies_at_work_fails_and_is_started_again(self) -> None:
        status, text = self.end(self.send("folding", manner="deadly"))
        self.assertEqual(GoalStatus.ABORTED, status, text)
        self.assertEqual(GoalStatus.SUCCEEDED, self.end(self.send("folding"))[0])

    def test_two_servers_of_one_process_answer_and_the_broken_one_is_left_out(self) -> None:
        nodes = set()
        for server in ("pinging", "mooing"):
            self.assertEqual(GoalStatus.SUCCEEDED, self.end(self.send(server, server=server))[0])
            published = rosgraph.Master(rospy.get_name()).getSystemState()[0]
            nodes.update(*(names for topic, names in published if topic == f"/{server}/status"))
        self.assertEqual({"/host"}, nodes)


if __name__ == "__main__":
    import rostest

    rospy.init_node("server_hosting_test")
    rostest.rosrun("server_hosting", "server_hosting_test", ServerHostingTest)
