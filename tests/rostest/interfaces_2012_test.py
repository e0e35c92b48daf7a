#!/usr/bin/python3
"""Programs of 2012 still work: a server gets goals byte for byte, and a client's goals run an RFNServer.

Typed arguments beside a goal change nothing for either.
"""

import struct
import unittest
from typing import Any, List, Tuple

import actionlib
import roboframenet_msgs.msg
import rospy
from roboframenet_msgs.msg import Reply
from rosgraph_msgs.msg import Log
from std_msgs.msg import String

import definitions_2012
from rfnserver import RFNServer
from roboframenet_demo.ros_pipeline import is_pipeline_complete
from roboframenet_rostest import can_do
from roboframenet_testing import wait_until
from typed_arguments import Measure, TypedArgument, from_goal_text, to_goal_text

CAPTAIN = TypedArgument("addressee", "captain", relation="to", head="captain", measure=Measure("number", si=1.0))


def packed(text: str) -> bytes:
    """Return a string as ROS serializes it."""
    data = text.encode("utf-8")
    return struct.pack("<I", len(data)) + data


def frame_2012(server: str) -> bytes:
    """Return the goal of 2012 for "Salute the captain.", serialized by hand: name, elements, servers."""
    elements = packed("addressee") + packed("captain") + packed("manner") + packed("plainly")
    return packed("saluting") + struct.pack("<I", 2) + elements + struct.pack("<I", 1) + packed(server)


def taken_apart(data: bytes) -> Tuple[str, bytes]:
    """Return the text of the header and the bytes of the goal of a FilledSemanticFrameActionGoal as sent."""
    at = 12
    (length,) = struct.unpack_from("<I", data, at)
    text = data[at + 4 : at + 4 + length].decode("ascii")
    at += 4 + length + 8
    (length,) = struct.unpack_from("<I", data, at)
    return text, data[at + 4 + length :]


def goal_of(definitions: Any, server: str) -> Any:
    """Return the goal of `frame_2012` as an instance of a class."""
    elements = [
        definitions.FilledFrameElement(name="addressee", argument="captain"),
        definitions.FilledFrameElement(name="manner", argument="plainly"),
    ]
    frame = definitions.FilledSemanticFrame(name="saluting", frame_elements=elements, action_server_topics=[server])
    return definitions.FilledSemanticFrameGoal(frame=frame)


class TypedClient:
    """A client that sends typed arguments beside each goal, as the executor may."""

    def __init__(self, server: str) -> None:
        self.text = ""
        self._client = actionlib.ActionClient(server, roboframenet_msgs.msg.FilledSemanticFrameAction)
        self._client.manager.register_send_goal_fn(self._send)
        assert self._client.wait_for_server(rospy.Duration(60.0))

    def _send(self, goal: Any) -> None:
        goal.header.frame_id = self.text
        self._client.pub_goal.publish(goal)

    def is_done_by_server(self, goal: Any) -> bool:
        """Send the goal; return whether the server succeeds."""
        handle = self._client.send_goal(goal)
        wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE)
        result = handle.get_result()
        return result is not None and result.success

    def close(self) -> None:
        self._client.stop()


class Interfaces2012Test(unittest.TestCase):
    """The pipeline, a server of 2012, and an RFNServer."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.replies: List[Reply] = []
        cls.errors: List[str] = []
        cls.goals: List[bytes] = []
        cls.heard: List[Tuple[str, Any]] = []
        cls.text = rospy.Publisher("text", String, queue_size=100)
        cls.subscribers = [
            rospy.Subscriber("reply", Reply, cls.replies.append, queue_size=100),
            rospy.Subscriber("goals_2012", String, lambda message: cls.goals.append(bytes.fromhex(message.data))),
            rospy.Subscriber("/rosout", Log, cls.note_error, queue_size=1000),
        ]
        cls.rfn_server = RFNServer("salute_rfn", cls.salute)
        cls.rfn_server.start()
        wait_until(is_pipeline_complete, 120.0, "the pipeline did not come up")
        wait_until(lambda: all(subscriber.get_num_connections() > 0 for subscriber in cls.subscribers))
        assert can_do(["saluting"], unit_files=["add_lexical_unit.yaml"]), "the server of 2012 did not register"

    @classmethod
    def note_error(cls, log: Log) -> None:
        if log.level >= Log.ERROR:
            cls.errors.append(f"{log.name}: {log.msg}")

    @classmethod
    def salute(cls, frame: Any) -> None:
        cls.heard.append((cls.rfn_server.current_goal.goal.header.frame_id, frame))

    def setUp(self) -> None:
        self.goals.clear()
        self.heard.clear()
        self.errors.clear()

    def tearDown(self) -> None:
        self.assertEqual(self.errors, [])

    def test_definitions_are_those_of_2012(self) -> None:
        theirs = definitions_2012.FilledSemanticFrameAction
        self.assertEqual(theirs._md5sum, definitions_2012.ACTION_SUM)
        self.assertIsNot(theirs, roboframenet_msgs.msg.FilledSemanticFrameAction)

    def test_sentence_reaches_a_server_of_2012_byte_for_byte(self) -> None:
        self.text.publish(String(data="Salute the captain."))
        wait_until(lambda: bool(self.replies))
        self.assertEqual(self.replies[0].outcome, Reply.DONE, self.replies[0].sentence)
        wait_until(lambda: bool(self.goals))
        _, goal = taken_apart(self.goals[0])
        self.assertEqual(goal, frame_2012("salute_2012"))

    def test_empty_frame_is_served_as_in_2012(self) -> None:
        frame = rospy.ServiceProxy("get_empty_frame", definitions_2012.GetEmptyFrame)("saluting").frame
        elements = [(element.name, element.default, element.is_core) for element in frame.frame_elements]
        self.assertEqual(elements, [("addressee", "", True), ("manner", "plainly", False)])

    def test_client_of_2012_runs_an_rfnserver(self) -> None:
        # The simple client logs an error, and may miss the end, of a goal that ends before its send_goal has returned.
        client = actionlib.ActionClient("salute_rfn", definitions_2012.FilledSemanticFrameAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(60.0)))
        handle = client.send_goal(goal_of(definitions_2012, "salute_rfn"))
        wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE)
        self.assertTrue(handle.get_result().success)
        text, frame = self.heard[0]
        said = [(element.name, element.argument) for element in frame.frame_elements]
        found = from_goal_text(text, said)
        self.assertEqual(found.arguments, tuple(TypedArgument(name, argument) for name, argument in said))
        self.assertEqual(found.reason, "")
        client.stop()

    def test_typed_arguments_reach_a_server_of_2012_unharmed(self) -> None:
        client = TypedClient("salute_2012")
        texts = [to_goal_text([CAPTAIN]), to_goal_text([TypedArgument("addressee", "x" * 60_000)]), "map", "0"]
        for text in texts:
            client.text = text
            self.goals.clear()
            self.assertTrue(client.is_done_by_server(goal_of(roboframenet_msgs.msg, "salute_2012")), text[:80])
            wait_until(lambda: bool(self.goals))
            self.assertEqual(taken_apart(self.goals[0]), (text, frame_2012("salute_2012")))
        client.close()

    def test_rfnserver_gets_the_typed_arguments_of_each_goal(self) -> None:
        client = TypedClient("salute_rfn")
        said = [("addressee", "captain"), ("manner", "plainly")]
        for count in range(20):
            typed = TypedArgument("addressee", "captain", count=count)
            client.text = to_goal_text([typed])
            self.heard.clear()
            self.assertTrue(client.is_done_by_server(goal_of(roboframenet_msgs.msg, "salute_rfn")))
            found = from_goal_text(self.heard[0][0], said)
            self.assertEqual((found.arguments[0], found.reason), (typed, ""))
        client.close()


if __name__ == "__main__":
    import rostest

    rospy.init_node("interfaces_2012_test")
    rostest.rosrun("roboframenet_tests", "interfaces_2012", Interfaces2012Test)
