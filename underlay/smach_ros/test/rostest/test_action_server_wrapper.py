#!/usr/bin/python3
"""ActionServerWrapper with a real actionlib client."""

import threading
import unittest

import actionlib
import rospy
import rostest
from actionlib.msg import TestAction, TestFeedback, TestGoal, TestResult, TwoIntsAction, TwoIntsGoal
from actionlib_msgs.msg import GoalStatus

import smach
import smach_ros

STOP_ME, RAISE, STRANGE = 90, 91, 92
DEADLINE = rospy.Duration(20.0)


class Client(actionlib.SimpleActionClient):
    """Client that cannot miss the end of a goal that ends before send_goal() has returned."""

    def __init__(self, name, spec):
        self._sending = threading.Lock()
        super().__init__(name, spec)

    def send_goal(self, *args, **kwargs):
        with self._sending:
            super().send_goal(*args, **kwargs)

    def _handle_transition(self, handle):
        with self._sending:
            pass
        super()._handle_transition(handle)


class Work(smach.State):
    """Ends as the goal says; its result is the number of earlier goals."""

    def __init__(self):
        super().__init__(
            outcomes=["good", "bad", "stopped", "strange"],
            input_keys=["action_goal"],
            output_keys=["action_feedback", "action_result"],
        )
        self.started, self._asked = threading.Event(), threading.Event()

    def request_preempt(self):
        super().request_preempt()
        self._asked.set()

    def execute(self, userdata):
        number = userdata.action_goal.goal
        userdata.action_feedback = TestFeedback(feedback=number)
        userdata.action_result = TestResult(result=number + 1)
        if number == RAISE:
            raise RuntimeError("broken on purpose")
        if number == STRANGE:
            return "strange"
        if number != STOP_ME:
            return "good" if number > 0 else "bad"
        self.started.set()
        assert self._asked.wait(20.0)
        self._asked.clear()
        self.service_preempt()
        return "stopped"


class ActionServerWrapperTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = Work()
        cls.may_end = threading.Event()
        cls.may_end.set()
        machine = smach.StateMachine(
            ["did_something", "did_nothing", "gave_up", "preempted", "strange"],
            input_keys=["action_goal"],
            output_keys=["action_result"],
        )
        with machine:
            smach.StateMachine.add("WORK", cls.work, {"good": "REST", "bad": "gave_up", "stopped": "preempted"})
            smach.StateMachine.add("REST", smach.CBState(cls.rest, outcomes=["did_something"]))
        cls.machine = machine
        cls.wrapper = smach_ros.ActionServerWrapper(
            "plan",
            TestAction,
            wrapped_container=machine,
            succeeded_outcomes=["did_something", "did_nothing"],
            aborted_outcomes=["gave_up"],
            preempted_outcomes=["preempted"],
        )
        cls.wrapper.run_server()
        cls.client = Client("plan", TestAction)
        assert cls.client.wait_for_server(DEADLINE)

    @classmethod
    def rest(cls, userdata):
        assert cls.may_end.wait(20.0)
        return "did_something"

    def setUp(self):
        self.work.started.clear()
        self.may_end.set()

    def ends(self, number):
        self.client.send_goal(TestGoal(number))
        self.assertTrue(self.client.wait_for_result(DEADLINE))
        return self.client.get_state(), self.client.get_result()

    def test_outcomes_end_the_goal(self):
        self.assertEqual(self.ends(5), (GoalStatus.SUCCEEDED, TestResult(6)))
        self.assertEqual(self.ends(-5), (GoalStatus.ABORTED, TestResult(-4)))
        self.assertEqual(self.ends(6), (GoalStatus.SUCCEEDED, TestResult(7)))

    def test_outcome_that_is_named_nowhere_and_exception_abort(self):
        self.assertEqual(self.ends(STRANGE)[0], GoalStatus.ABORTED)
        self.assertIn("strange", self.client.get_goal_status_text())
        self.assertEqual(self.ends(RAISE)[0], GoalStatus.ABORTED)
        self.assertIn("broken on purpose", self.client.get_goal_status_text())
        self.assertEqual(self.ends(5)[0], GoalStatus.SUCCEEDED)

    def test_feedback_at_transitions(self):
        seen = []

        def hear(feedback):
            seen.append(feedback.feedback)
            self.may_end.set()

        # Feedback comes on another connection than the result, and is dropped behind it.
        self.may_end.clear()
        self.client.send_goal(TestGoal(5), feedback_cb=hear)
        self.assertTrue(self.client.wait_for_result(DEADLINE))
        self.assertEqual(set(seen), {5})

    def test_cancel_preempts_the_container(self):
        self.client.send_goal(TestGoal(STOP_ME))
        self.assertTrue(self.work.started.wait(20.0))
        self.client.cancel_goal()
        self.assertTrue(self.client.wait_for_result(DEADLINE))
        self.assertEqual(
            (self.client.get_state(), self.client.get_result()), (GoalStatus.PREEMPTED, TestResult(STOP_ME + 1))
        )
        self.assertFalse(self.machine.preempt_requested())
        self.assertEqual(self.ends(5)[0], GoalStatus.SUCCEEDED)

    def test_newer_goal_preempts_the_older(self):
        older = Client("plan", TestAction)
        self.assertTrue(older.wait_for_server(DEADLINE))
        older.send_goal(TestGoal(STOP_ME))
        self.assertTrue(self.work.started.wait(20.0))
        self.assertEqual(self.ends(5), (GoalStatus.SUCCEEDED, TestResult(6)))
        self.assertTrue(older.wait_for_result(DEADLINE))
        self.assertEqual(older.get_state(), GoalStatus.PREEMPTED)

    def test_request_that_is_left_over_does_not_stop_the_next_goal(self):
        self.wrapper.preempt_cb()
        self.assertEqual(self.ends(5)[0], GoalStatus.SUCCEEDED)

    def test_fields_of_goal_and_result_as_userdata(self):
        def add(userdata):
            userdata.sum = userdata.first + userdata.b
            return "added"

        state = smach.CBState(add, outcomes=["added"], input_keys=["first", "b"], output_keys=["sum"])
        machine = smach.StateMachine(["added"])
        with machine:
            smach.StateMachine.add("ADD", state)
        wrapper = smach_ros.ActionServerWrapper(
            "add",
            TwoIntsAction,
            machine,
            ["added"],
            goal_slots_map={"a": "first"},
            expand_goal_slots=True,
            pack_result_slots=True,
        )
        wrapper.run_server()
        client = Client("add", TwoIntsAction)
        self.assertTrue(client.wait_for_server(DEADLINE))
        client.send_goal(TwoIntsGoal(a=3, b=4))
        self.assertTrue(client.wait_for_result(DEADLINE))
        self.assertEqual((client.get_state(), client.get_result().sum), (GoalStatus.SUCCEEDED, 7))

    def test_wrong_descriptions(self):
        with self.assertRaises(smach.InvalidStateError):
            smach_ros.ActionServerWrapper("x", TestAction, self.machine, ["preempted"], [], ["preempted"])
        with self.assertRaises(smach.InvalidStateError):
            smach_ros.ActionServerWrapper("x", TestAction, self.machine, result_slots_map={"nothing": "a"})


if __name__ == "__main__":
    rospy.init_node("test_action_server_wrapper")
    rostest.rosrun("smach_ros", "action_server_wrapper", ActionServerWrapperTest)
