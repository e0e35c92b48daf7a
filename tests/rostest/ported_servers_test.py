#!/usr/bin/python3
"""Action servers ported by one line serve their old clients as before, and people by language."""

import os
import unittest
from io import BytesIO
from typing import Any, List, Tuple

import actionlib
import rospy
from actionlib.msg import TwoIntsAction, TwoIntsGoal, TwoIntsResult
from actionlib_msgs.msg import GoalStatus
from actionlib_tutorials.msg import (
    AveragingAction,
    AveragingGoal,
    FibonacciAction,
    FibonacciActionFeedback,
    FibonacciActionResult,
    FibonacciFeedback,
    FibonacciGoal,
    FibonacciResult,
)
from roboframenet_msgs.msg import (
    FilledFrameElement,
    FilledSemanticFrame,
    FilledSemanticFrameAction,
    FilledSemanticFrameGoal,
    Reply,
)
from std_msgs.msg import Float32, String

from rfnserver import RFNActionServer, RFNServer
from roboframenet_demo.ros_pipeline import is_pipeline_complete
from roboframenet_rostest import can_do
from roboframenet_testing import wait_until
from roboframenet_testing.ros_connections import is_connected

#: Steps of the sequence that a server computes before it can be preempted.
LONG = 1000
Record = Tuple[int, str, bytes, Tuple[bytes, ...]]


def written(message: Any) -> bytes:
    """Return a message as ROS serializes it."""
    buffer = BytesIO()
    message.serialize(buffer)
    return buffer.getvalue()


def counting(make_server: Any, name: str) -> Any:
    """Create a server of a given class that counts to the order of its goal."""

    def execute(goal: FibonacciGoal) -> None:
        feedback = FibonacciFeedback()
        for number in range(goal.order):
            if server.is_preempt_requested():
                server.set_preempted(FibonacciResult(sequence=[-1]), "stopped")
                return
            feedback.sequence = [number]
            if goal.order != LONG:
                server.publish_feedback(feedback)
            rospy.sleep(0.01)
        if goal.order == 2:
            raise KeyError("/x")
        if goal.order == 0:
            server.set_aborted(FibonacciResult(), "nothing to count")
        elif goal.order != 3:  # order 3: the callback forgets to end the goal
            server.set_succeeded(FibonacciResult(sequence=[goal.order]), "counted")

    server = make_server(name, FibonacciAction, execute_cb=execute, auto_start=False)
    server.start()
    return server


class Client:
    """An old client that records what it receives."""

    def __init__(self, name: str) -> None:
        self._client = actionlib.ActionClient(name, FibonacciAction)
        # Feedback has its own connection, and actionlib drops feedback that arrives after the result.
        self._heard: List[FibonacciActionFeedback] = []
        self._feedback = rospy.Subscriber(name + "/feedback", FibonacciActionFeedback, self._heard.append)
        assert self._client.wait_for_server(rospy.Duration(60.0)), f"no server {name}"
        # The servers run in this node.
        wait_until(lambda: is_connected(rospy.get_name(), self._feedback.name, rospy.get_name()))

    def send(self, order: int) -> Any:
        return self._client.send_goal(FibonacciGoal(order=order))

    def end(self, handle: Any) -> Record:
        wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE, message="the goal does not end")
        goal = handle.comm_state_machine.action_goal
        expected = 0 if goal.goal.order == LONG else goal.goal.order
        wait_until(lambda: len(self._feedback_of(goal.goal_id.id)) >= expected)
        feedback = tuple(written(message.feedback) for message in self._feedback_of(goal.goal_id.id))
        return handle.get_goal_status(), handle.get_goal_status_text(), written(handle.get_result()), feedback

    def _feedback_of(self, goal_id: str) -> List[FibonacciActionFeedback]:
        return [message for message in list(self._heard) if message.status.goal_id.id == goal_id]


def story(name: str) -> List[Record]:
    """Return what a client sees: success, abort, a forgotten end, an exception, a cancel, a goal that replaces one."""
    client = Client(name)
    records = [client.end(client.send(order)) for order in (5, 0, 3, 2)]
    cancelled = client.send(LONG)
    wait_until(lambda: cancelled.get_goal_status() == GoalStatus.ACTIVE)
    cancelled.cancel()
    records.append(client.end(cancelled))
    replaced = client.send(LONG)
    wait_until(lambda: replaced.get_goal_status() == GoalStatus.ACTIVE)
    last = client.send(4)
    return records + [client.end(replaced), client.end(last)]


class PortedServersTest(unittest.TestCase):
    """Ported servers in the process of the test and in their own."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.replies: List[Reply] = []
        cls.subscriber = rospy.Subscriber("reply", Reply, cls.replies.append, queue_size=100)
        cls.text = rospy.Publisher("text", String, queue_size=100)
        cls.numbers = rospy.Publisher("random_number", Float32, queue_size=10)
        cls.timer = rospy.Timer(rospy.Duration(0.02), lambda _: cls.numbers.publish(Float32(data=0.75)))
        wait_until(lambda: cls.text.get_num_connections() >= 2, message="nobody listens to 'text'")
        wait_until(is_pipeline_complete, 120.0, "the pipeline did not come up")
        # A frame for the servers in the test; the sentences for the other servers must not evoke it.
        cls.frames = RFNServer("frames", lambda frame: None)
        path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "ported", "frames", "counting.yaml")
        assert cls.frames.add_semantic_frame(path), cls.frames.last_error
        assert can_do(("computing_fibonacci_sequence", "averaging"), unit_files=("compute.yaml", "average.yaml")), (
            "the servers did not register"
        )
        # The parser reads the lexicon too, and may still be busy with it.
        cls.text.publish(String(data="Hello."))
        wait_until(lambda: cls.replies, message="no reply")

    @classmethod
    def tearDownClass(cls) -> None:
        cls.timer.shutdown()

    def say(self, text: str) -> None:
        self.text.publish(String(data=text))

    def reply_to(self, text: str) -> Reply:
        wait_until(lambda: any(reply.command.text == text for reply in self.replies), message=text)
        return next(reply for reply in self.replies if reply.command.text == text)

    def carry_out(self, server: str, name: str, **arguments: str) -> Tuple[int, str]:
        client = actionlib.ActionClient(server + "/frame", FilledSemanticFrameAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(60.0)), server)
        elements = [FilledFrameElement(name=key, argument=value) for key, value in arguments.items()]
        handle = client.send_goal(
            FilledSemanticFrameGoal(frame=FilledSemanticFrame(name=name, frame_elements=elements))
        )
        wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE)
        return handle.get_goal_status(), handle.get_goal_status_text()

    def test_old_clients_see_no_difference(self) -> None:
        servers = [counting(actionlib.SimpleActionServer, "stock"), counting(RFNServer, "ported")]
        servers[1].register_with_frame("counting")
        self.assertEqual(story("stock"), story("ported"))

    def test_tutorial_client_of_fibonacci(self) -> None:
        client = actionlib.SimpleActionClient("fibonacci", FibonacciAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(60.0)))
        client.send_goal(FibonacciGoal(order=10))
        self.assertTrue(client.wait_for_result(rospy.Duration(60.0)))
        self.assertEqual((0, 1, 1, 2, 3, 5, 8, 13, 21, 34, 55), client.get_result().sequence)

    def test_tutorial_client_of_averaging(self) -> None:
        client = actionlib.SimpleActionClient("averaging", AveragingAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(60.0)))
        client.send_goal(AveragingGoal(samples=10))
        self.assertTrue(client.wait_for_result(rospy.Duration(60.0)))
        self.assertEqual(GoalStatus.SUCCEEDED, client.get_state())
        self.assertAlmostEqual(0.75, client.get_result().mean)

    def test_fibonacci_through_language(self) -> None:
        results: List[FibonacciActionResult] = []
        subscriber = rospy.Subscriber("fibonacci/result", FibonacciActionResult, results.append)
        wait_until(lambda: is_connected("/fibonacci", subscriber.name, rospy.get_name()))
        text = "Compute the Fibonacci sequence to order seven."
        self.say(text)
        reply = self.reply_to(text)
        self.assertEqual(Reply.DONE, reply.outcome, reply.sentence)
        wait_until(lambda: results)
        self.assertEqual((0, 1, 1, 2, 3, 5, 8, 13), results[-1].result.sequence)

    def test_goal_callbacks_through_language_and_their_preemption(self) -> None:
        self.say("Average five samples.")
        self.assertEqual(Reply.DONE, self.reply_to("Average five samples.").outcome)
        client = actionlib.ActionClient("averaging", AveragingAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(60.0)))

        def statuses() -> List[int]:
            return [status.status for status in client.last_status_msg.status_list]

        self.say("Average 999 samples.")
        wait_until(lambda: GoalStatus.ACTIVE in statuses())
        self.say("Stop.")
        self.assertEqual(Reply.SUPERSEDED, self.reply_to("Average 999 samples.").outcome)
        wait_until(lambda: GoalStatus.PREEMPTED in statuses() and GoalStatus.ACTIVE not in statuses())

    def test_plain_action_server(self) -> None:
        def on_goal(handle: Any) -> None:
            handle.set_accepted()
            goal = handle.get_goal()
            handle.set_succeeded(TwoIntsResult(sum=goal.a + goal.b), f"{goal.a} and {goal.b}")

        server = RFNActionServer(
            "adding", TwoIntsAction, on_goal, auto_start=False, goal_mapping={"a": "samples", "b": {"value": 5}}
        )
        server.start()
        self.assertTrue(server.register_with_frame("counting"), server.last_error)
        self.assertEqual((GoalStatus.SUCCEEDED, "12 and 5"), self.carry_out("adding", "counting", samples="twelve"))
        # The simple client would miss the end of a goal that ends before its send_goal has returned.
        client = actionlib.ActionClient("adding", TwoIntsAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(60.0)))
        handle = client.send_goal(TwoIntsGoal(a=1, b=2))
        wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE)
        self.assertEqual((GoalStatus.SUCCEEDED, 3), (handle.get_goal_status(), handle.get_result().sum))
        status, text = self.carry_out("adding", "counting", samples="half")
        self.assertEqual(GoalStatus.ABORTED, status)
        self.assertIn("whole number", text)

    def test_frame_callback_makes_the_goal(self) -> None:
        server = counting_with_frames()
        self.assertTrue(server.register_with_frame("counting"), server.last_error)
        self.assertEqual((GoalStatus.SUCCEEDED, "counted"), self.carry_out("framed", "counting", samples="6"))

    def test_unmappable_goal_is_reported_at_registration(self) -> None:
        server = RFNServer("unmapped", FibonacciAction, execute_cb=lambda goal: None, auto_start=False)
        server.start()
        self.assertFalse(server.register_with_frame("counting"))
        self.assertIn("'samples' fills no field", server.last_error)
        self.assertIn("order", server.last_error)
        wrong = RFNServer(
            "mismapped",
            FibonacciAction,
            execute_cb=lambda goal: None,
            auto_start=False,
            goal_mapping={"ordre": "samples"},
        )
        wrong.start()
        self.assertFalse(wrong.register_with_frame("counting"))
        self.assertIn("did you mean 'order'", wrong.last_error)


def counting_with_frames() -> RFNServer:
    """Create a server whose frame callback makes the goals."""

    def execute(goal: FibonacciGoal) -> None:
        server.set_succeeded(FibonacciResult(sequence=[goal.order]), "counted")

    server = RFNServer(
        "framed",
        FibonacciAction,
        execute_cb=execute,
        auto_start=False,
        frame_callback=lambda frame: FibonacciGoal(order=len(frame["samples"].text)),
    )
    server.start()
    return server


if __name__ == "__main__":
    import rostest

    rospy.init_node("ported_servers_test")
    rostest.rosrun("roboframenet_tests", "ported_servers", PortedServersTest)
