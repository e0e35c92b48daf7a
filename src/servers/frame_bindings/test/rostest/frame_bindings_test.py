#!/usr/bin/python3
"""Frames bound to a stock action server, a service and a topic, none of which knows anything of frames."""

import threading
import time
import unittest
from typing import Any, List, Tuple

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus
from actionlib_tutorials.msg import FibonacciAction, FibonacciGoal, FibonacciResult
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from roboframenet_msgs.msg import (
    FilledFrameElement,
    FilledSemanticFrame,
    FilledSemanticFrameAction,
    FilledSemanticFrameActionFeedback,
    FilledSemanticFrameGoal,
)
from sensor_msgs.msg import BatteryState
from std_msgs.msg import Header, String
from std_srvs.srv import SetBool, SetBoolRequest, SetBoolResponse

from roboframenet_testing import wait_until


class FrameBindingsTest(unittest.TestCase):
    """The node, and what it is bound to."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.orders: List[int] = []
        cls.lights: List[bool] = []
        cls.go_on = threading.Event()
        cls.server = actionlib.SimpleActionServer(
            "fibonacci", FibonacciAction, execute_cb=cls.execute, auto_start=False
        )
        cls.server.start()
        cls.service = rospy.Service("set_light", SetBool, cls.switch)

    @classmethod
    def execute(cls, goal: FibonacciGoal) -> None:
        cls.orders.append(goal.order)
        while goal.order > 100 and not rospy.is_shutdown():
            if cls.server.is_preempt_requested():
                cls.server.set_preempted(FibonacciResult())
                return
            time.sleep(0.01)
        if goal.order == 0:
            cls.server.set_aborted(FibonacciResult(), "nothing to compute")
        else:
            cls.server.set_succeeded(FibonacciResult(sequence=[goal.order]))

    @classmethod
    def switch(cls, request: SetBoolRequest) -> SetBoolResponse:
        cls.lights.append(request.data)
        return SetBoolResponse(success=request.data, message="as you wish" if request.data else "the switch is broken")

    def send(self, server: str, **arguments: str) -> Any:
        self.client = actionlib.ActionClient(server, FilledSemanticFrameAction)
        self.assertTrue(self.client.wait_for_server(rospy.Duration(60.0)), server)
        elements = [FilledFrameElement(name=name, argument=value) for name, value in arguments.items()]
        return self.client.send_goal(
            FilledSemanticFrameGoal(frame=FilledSemanticFrame(name=server, frame_elements=elements))
        )

    def end(self, handle: Any) -> Tuple[int, str]:
        wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE)
        return handle.get_goal_status(), handle.get_goal_status_text()

    def watch(self, server: str, **arguments: str) -> Tuple[Any, List[FilledSemanticFrameActionFeedback]]:
        """Watch a condition; returns the handle, and what the server says of it."""
        said: List[FilledSemanticFrameActionFeedback] = []
        subscriber = rospy.Subscriber(f"{server}/feedback", FilledSemanticFrameActionFeedback, said.append)
        self.addCleanup(subscriber.unregister)
        wait_until(lambda: subscriber.get_num_connections() == 1)
        return self.send(server, **arguments), said

    def values(self, said: List[FilledSemanticFrameActionFeedback]) -> List[bool]:
        """What was said, without repetitions."""
        found = [one.feedback.is_succeeding for one in list(said)]
        return [one for place, one in enumerate(found) if place == 0 or found[place - 1] != one]

    def test_condition_on_a_stream_ends_when_that_is_dead(self) -> None:
        publisher = rospy.Publisher("battery_state", BatteryState, queue_size=1)
        handle, said = self.watch("battery_watch")
        wait_until(lambda: publisher.get_num_connections() == 1)
        level, stamp = 0.5, rospy.Time.now()

        def publish() -> None:
            message = BatteryState(percentage=level)
            message.header.stamp = stamp
            publisher.publish(message)

        wait_until(lambda: (publish(), self.values(said) == [False])[1])
        level, stamp = 0.1, rospy.Time.now()
        publish()
        wait_until(lambda: self.values(said) == [False, True])
        self.assertEqual(stamp, said[-1].header.stamp)
        self.assertEqual((GoalStatus.ABORTED, "battery_state has said nothing for 1 s"), self.end(handle))
        wait_until(lambda: publisher.get_num_connections() == 0)

    def test_condition_on_a_state_that_is_told_once(self) -> None:
        publisher = rospy.Publisher("lights", DiagnosticArray, queue_size=1, latch=True)
        publisher.publish(DiagnosticArray(status=[DiagnosticStatus(name="lamp", message="on")]))
        handle, said = self.watch("light_watch", theme="the lamp", state="on")
        wait_until(lambda: len(said) > 3)
        self.assertEqual([True], self.values(said))
        # What holds is said as of now: nobody takes it for an old observation.
        self.assertLess((rospy.Time.now() - said[-1].header.stamp).to_sec(), 2.0)
        unknown, _ = self.watch("light_watch", theme="the stove", state="on")
        self.assertEqual((GoalStatus.ABORTED, 'lights: there is no "stove"'), self.end(unknown))
        publisher.unregister()
        self.assertEqual((GoalStatus.ABORTED, "nobody publishes lights"), self.end(handle))

    def test_condition_on_events_holds_for_a_moment(self) -> None:
        publisher = rospy.Publisher("bell", Header, queue_size=1)
        wait_until(lambda: publisher.get_num_connections() == 1)
        handle, said = self.watch("bell_watch")
        wait_until(lambda: self.values(said) == [False])
        stamp = rospy.Time.now()
        publisher.publish(Header(stamp=stamp))
        wait_until(lambda: self.values(said) == [False, True, False])
        handle.cancel()
        self.assertEqual(GoalStatus.PREEMPTED, self.end(handle)[0])

    def test_condition_with_a_wrong_field_is_not_served(self) -> None:
        self.assertNotIn("/misnamed/status", [name for name, _ in rospy.get_published_topics()])

    def test_action(self) -> None:
        self.assertEqual(GoalStatus.SUCCEEDED, self.end(self.send("computing", steps="seven"))[0])
        self.assertEqual(7, self.orders[-1])

    def test_abort_of_the_action_is_passed_on(self) -> None:
        self.assertEqual((GoalStatus.ABORTED, "nothing to compute"), self.end(self.send("computing", steps="0")))

    def test_preemption_reaches_the_action(self) -> None:
        handle = self.send("computing", steps="101")
        wait_until(lambda: self.orders[-1:] == [101])
        handle.cancel()
        self.assertEqual(GoalStatus.PREEMPTED, self.end(handle)[0])
        self.assertFalse(self.server.is_active())

    def test_words_that_do_not_fit_are_said(self) -> None:
        status, text = self.end(self.send("computing", steps="many"))
        self.assertEqual(GoalStatus.ABORTED, status)
        self.assertIn("steps", text)

    def test_service(self) -> None:
        self.assertEqual((GoalStatus.SUCCEEDED, "as you wish"), self.end(self.send("switching", state="on")))
        self.assertEqual((GoalStatus.ABORTED, "the switch is broken"), self.end(self.send("switching", state="off")))
        self.assertEqual([True, False], self.lights)

    def test_topic(self) -> None:
        status, text = self.end(self.send("speaking", message="hello"))
        self.assertEqual(GoalStatus.ABORTED, status)
        self.assertIn("nobody listens to speech", text)
        heard: List[str] = []
        subscriber = rospy.Subscriber("speech", String, lambda message: heard.append(message.data))
        wait_until(lambda: subscriber.get_num_connections() == 1)
        self.assertEqual(GoalStatus.SUCCEEDED, self.end(self.send("speaking", message="hello"))[0])
        wait_until(lambda: heard == ["hello"])

    def test_binding_to_another_type_is_refused_with_both(self) -> None:
        status, text = self.end(self.send("mistaken", steps="3"))
        self.assertEqual(GoalStatus.ABORTED, status)
        self.assertIn("is of type actionlib_tutorials/FibonacciAction, not actionlib_tutorials/AveragingAction", text)

    def test_type_is_that_of_the_server_and_not_that_of_its_last_client(self) -> None:
        status, text = self.end(self.send("miscounting", steps="3"))
        self.assertEqual(GoalStatus.ABORTED, status)
        self.assertIn("is of type actionlib_tutorials/FibonacciAction, not actionlib_tutorials/AveragingAction", text)
        self.assertEqual(GoalStatus.SUCCEEDED, self.end(self.send("computing", steps="three"))[0])


if __name__ == "__main__":
    import rostest

    rospy.init_node("frame_bindings_test")
    rostest.rosrun("frame_bindings", "frame_bindings_test", FrameBindingsTest)
