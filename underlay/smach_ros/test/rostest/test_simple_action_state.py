#!/usr/bin/python3
"""SimpleActionState with a real actionlib server."""

import threading
import unittest

import actionlib
import rospy
import rostest
from actionlib.msg import TestAction, TestFeedback, TestGoal, TestRequestAction, TestRequestGoal, TestResult
from actionlib_msgs.msg import GoalStatus

import smach
import smach_ros
from roboframenet_testing import wait_until

SUCCEED, ABORT, PREEMPT_ITSELF, OBEY, STUBBORN = range(5)


class Server:
    """Ends each goal as the goal says."""

    def __init__(self, name):
        self.goals, self.cancelled, self.release = [], threading.Event(), threading.Event()
        self._server = actionlib.SimpleActionServer(name, TestAction, self._execute, auto_start=False)
        self._server.register_preempt_callback(self.cancelled.set)
        self._server.start()
        self.is_active = self._server.is_active

    def _execute(self, goal):
        self.goals.append(goal.goal)
        self._server.publish_feedback(TestFeedback(feedback=goal.goal))
        result = TestResult(result=goal.goal + 100)
        if goal.goal == ABORT:
            self._server.set_aborted(result)
        elif goal.goal == PREEMPT_ITSELF:
            self._server.set_preempted(result)
        elif goal.goal == OBEY:
            if self.cancelled.wait(20.0):
                self._server.set_preempted(result)
        elif goal.goal == STUBBORN:
            self.release.wait(20.0)
            self._server.set_succeeded(result)
        else:
            self._server.set_succeeded(result)


class SimpleActionStateTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = Server("act")

    def setUp(self):
        del self.server.goals[:]
        self.server.cancelled.clear()
        self.server.release.clear()

    def tearDown(self):
        self.server.release.set()
        wait_until(lambda: not self.server.is_active())

    def run_in_machine(self, state, userdata=None, outcomes=("succeeded", "aborted", "preempted")):
        """Return the outcome of the state and the userdata behind it."""
        machine = smach.StateMachine(list(outcomes))
        for key, value in (userdata or {}).items():
            machine.userdata[key] = value
        with machine:
            smach.StateMachine.add("ACT", state)
        return machine.execute(), machine.userdata

    def start(self, state):
        """Execute in a thread; return the thread and the list that gets the outcome."""
        outcomes = []
        thread = threading.Thread(target=lambda: outcomes.append(self.run_in_machine(state)[0]), daemon=True)
        thread.start()
        return thread, outcomes

    def state(self, **kwargs):
        return smach_ros.SimpleActionState("act", TestAction, **kwargs)

    # Goals

    def test_empty_and_fixed_goal(self):
        self.assertEqual(self.run_in_machine(self.state())[0], "succeeded")
        self.assertEqual(
            self.run_in_machine(smach_ros.SimpleActionState("act", TestAction, TestGoal(7)))[0], "succeeded"
        )
        self.assertEqual(self.server.goals, [0, 7])

    def test_goal_from_userdata(self):
        goal = TestGoal(8)
        outcome, _ = self.run_in_machine(self.state(goal_key="it"), {"it": goal})
        self.assertEqual(outcome, "succeeded")
        outcome, _ = self.run_in_machine(self.state(goal=TestGoal(1), goal_slots=["goal"]), {"goal": 9})
        self.assertEqual(outcome, "succeeded")
        self.assertEqual(self.server.goals, [8, 9])

    def test_goal_callback_changes_or_returns_the_goal(self):
        def change(userdata, goal):
            goal.goal += userdata.more

        @smach.cb_interface(input_keys=["more"])
        def make(userdata, goal, factor, plus=0):
            return TestGoal(goal.goal + userdata.more * factor + plus)

        kept = TestGoal(10)
        changing = self.state(goal_key="kept", goal_cb=change, input_keys=["more"])
        making = self.state(goal=kept, goal_cb=make, goal_cb_args=[100], goal_cb_kwargs={"plus": 5})
        for state in (changing, changing, making, making):
            self.assertEqual(self.run_in_machine(state, {"kept": kept, "more": 2})[0], "succeeded")
        self.assertEqual(self.server.goals, [12, 12, 215, 215])
        self.assertEqual(kept, TestGoal(10))

    def test_goal_that_is_none_of_the_action(self):
        for wrong in (TestRequestGoal(), 3, lambda userdata, goal: None):
            with self.assertRaises(smach.InvalidStateError):
                self.state(goal=wrong)
        with self.assertRaises(smach.InvalidStateError):
            self.state(goal_slots=["nothing"])
        with self.assertRaises(smach.InvalidStateError):
            self.state(result_slots=["nothing"])
        self.assertEqual(self.server.goals, [])

    def test_goal_that_cannot_be_made_aborts_the_state(self):
        for bad in (lambda userdata, goal: 3, lambda userdata, goal: 1 / 0):
            self.assertEqual(self.run_in_machine(self.state(goal_cb=bad))[0], "aborted")
        self.assertEqual(self.run_in_machine(self.state(goal_key="missing"))[0], "aborted")
        self.assertEqual(self.run_in_machine(self.state(goal_slots=["goal"]))[0], "aborted")
        self.assertEqual(self.server.goals, [])

    def test_outcomes_that_a_goal_callback_declares_are_none_of_the_state(self):
        make = smach.CBInterface(lambda userdata, goal: TestGoal(userdata.number), ["made"], ["number"], ["unused"])
        state = self.state(goal_cb=make)
        self.assertEqual(set(state.get_registered_outcomes()), {"succeeded", "aborted", "preempted"})
        self.assertEqual(set(state.get_registered_input_keys()), {"number"})
        self.assertEqual(self.run_in_machine(state, {"number": 7})[0], "succeeded")
        self.assertEqual(self.server.goals, [7])

    # Results

    def test_result_into_userdata(self):
        state = self.state(goal=TestGoal(ABORT), result_key="whole", result_slots=["result"])
        outcome, userdata = self.run_in_machine(state)
        self.assertEqual((outcome, userdata.whole, userdata.result), ("aborted", TestResult(101), 101))

    def test_result_callback_chooses_the_outcome(self):
        @smach.cb_interface(output_keys=["status"], outcomes=["odd"])
        def judge(userdata, status, result, *args, **kwargs):
            userdata.status = (status, args, kwargs)
            return "odd" if result.result % 2 else None

        for number, expected in ((7, "odd"), (8, "succeeded")):
            state = self.state(goal=TestGoal(number), result_cb=judge, result_cb_args=[1], result_cb_kwargs={"a": 2})
            outcome, userdata = self.run_in_machine(state, outcomes=("succeeded", "aborted", "preempted", "odd"))
            self.assertEqual((outcome, userdata.status), (expected, (GoalStatus.SUCCEEDED, (1,), {"a": 2})))
        for bad in (lambda userdata, status, result: "unknown", lambda userdata, status, result: 1 / 0):
            self.assertEqual(self.run_in_machine(self.state(goal=TestGoal(7), result_cb=bad))[0], "aborted")
        state = self.state(result_cb=lambda userdata, status, result: "given", outcomes=["given"])
        self.assertEqual(
            self.run_in_machine(state, outcomes=("succeeded", "aborted", "preempted", "given"))[0], "given"
        )

    def test_subclass_sees_acceptance_and_feedback(self):
        class Watching(smach_ros.SimpleActionState):
            def _goal_active_cb(self):
                seen.append("active")

            def _goal_feedback_cb(self, feedback):
                seen.append(feedback.feedback)

            def execute(self, userdata):
                outcome = smach_ros.SimpleActionState.execute(self, userdata)
                return outcome if self._status == self.COMPLETED else "aborted"

        seen = []
        state = Watching("act", TestAction, TestGoal(OBEY))
        thread, outcomes = self.start(state)
        # They come on two topics, in any order.
        wait_until(lambda: len(seen) == 2 and set(seen) == {"active", OBEY})
        state.request_preempt()
        thread.join(20.0)
        self.assertEqual(outcomes, ["preempted"])

    # Ends

    def test_goal_that_nobody_here_asked_to_stop_is_aborted(self):
        for end in (ABORT, PREEMPT_ITSELF):
            self.assertEqual(self.run_in_machine(self.state(goal=TestGoal(end)))[0], "aborted")

    def test_request_cancels_the_goal(self):
        state = self.state(goal=TestGoal(OBEY), result_slots=["result"])
        thread, outcomes = self.start(state)
        wait_until(lambda: self.server.goals == [OBEY])
        state.request_preempt()
        thread.join(20.0)
        self.assertEqual(outcomes, ["preempted"])
        self.assertTrue(self.server.cancelled.is_set())
        self.assertFalse(state.preempt_requested())
        self.assertEqual(self.run_in_machine(self.state(goal=TestGoal(7)))[0], "succeeded", "the server is free again")

    def test_goal_that_succeeds_in_spite_of_the_request(self):
        state = self.state(goal=TestGoal(STUBBORN))
        thread, outcomes = self.start(state)
        wait_until(lambda: self.server.goals == [STUBBORN])
        state.request_preempt()
        self.assertTrue(self.server.cancelled.wait(20.0))
        self.server.release.set()
        thread.join(20.0)
        self.assertEqual(outcomes, ["succeeded"])

    def test_goal_that_does_not_stop_is_given_up(self):
        state = self.state(goal=TestGoal(STUBBORN), preempt_timeout=rospy.Duration(0.3))
        thread, outcomes = self.start(state)
        wait_until(lambda: self.server.goals == [STUBBORN])
        state.request_preempt()
        thread.join(20.0)
        self.assertEqual(outcomes, ["aborted"])
        wait_until(self.server.cancelled.is_set)

    def test_goal_out_of_time_is_cancelled_and_aborted(self):
        state = self.state(goal=TestGoal(OBEY), exec_timeout=rospy.Duration(0.3))
        self.assertEqual(self.run_in_machine(state)[0], "aborted")
        self.assertTrue(self.server.cancelled.is_set())

    def test_execution_time_of_zero_is_no_limit(self):
        state = self.state(goal=TestGoal(STUBBORN), exec_timeout=rospy.Duration(0))
        thread, outcomes = self.start(state)
        wait_until(lambda: self.server.goals == [STUBBORN])
        # A goal that is cancelled is so within the poll of the state, so a second goal would come too late to see it.
        self.assertFalse(self.server.cancelled.wait(0.5))
        self.server.release.set()
        thread.join(20.0)
        self.assertEqual(outcomes, ["succeeded"])

    def test_missing_server(self):
        state = smach_ros.SimpleActionState("nobody", TestRequestAction, server_wait_timeout=rospy.Duration(0.3))
        self.assertEqual(self.run_in_machine(state)[0], "aborted")
        state = smach_ros.SimpleActionState("nobody", TestRequestAction)
        thread, outcomes = self.start(state)
        state.request_preempt()
        thread.join(20.0)
        self.assertEqual(outcomes, ["preempted"])

    def test_goal_that_the_server_forgets_has_no_result(self):
        accepted = threading.Event()

        def accept(goal):
            goal.set_accepted()
            accepted.set()

        server = actionlib.ActionServer("forgetful", TestAction, accept, auto_start=False)
        server.start()
        seen = []
        state = smach_ros.SimpleActionState(
            "forgetful",
            TestAction,
            result_key="whole",
            result_slots=["result"],
            result_cb=lambda userdata, status, result: seen.append((status, result)),
        )
        thread, outcomes = self.start(state)
        self.assertTrue(accepted.wait(20.0))
        with server.lock:
            del server.status_list[:]
        server.publish_status()
        thread.join(20.0)
        self.assertEqual((outcomes, seen), (["aborted"], [(GoalStatus.LOST, None)]))

    def test_concurrence_of_goals_is_preempted_from_above(self):
        other = Server("act_beside")
        both = smach.Concurrence(
            ["aborted", "preempted"], "aborted", outcome_map={"preempted": {"A": "preempted", "B": "preempted"}}
        )
        with both:
            smach.Concurrence.add("A", self.state(goal=TestGoal(OBEY)))
            smach.Concurrence.add("B", smach_ros.SimpleActionState("act_beside", TestAction, TestGoal(OBEY)))
        thread, outcomes = self.start(both)
        wait_until(lambda: self.server.goals == other.goals == [OBEY])
        both.request_preempt()
        thread.join(20.0)
        self.assertEqual(outcomes, ["preempted"])


if __name__ == "__main__":
    rospy.init_node("test_simple_action_state")
    rostest.rosrun("smach_ros", "simple_action_state", SimpleActionStateTest)
