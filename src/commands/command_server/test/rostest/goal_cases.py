"""Goals of the action: feedback, the reply as the result, and cancels."""

import actionlib
from actionlib_msgs.msg import GoalStatus
from command_server_case import CommandServerCase
from roboframenet_msgs.msg import ExecuteCommandGoal, Reply

from roboframenet_testing import wait_until


class GoalCases(CommandServerCase):
    """The action."""

    def test_goal_gets_feedback_and_the_reply(self):
        text = "hang in the executor until there is feedback"
        feedback, ends = [], []
        handle = self.client.send_goal(
            ExecuteCommandGoal(text=text),
            feedback_cb=lambda _, message: feedback.append(message.event),
            transition_cb=lambda goal: ends.append(goal) if goal.get_comm_state() == actionlib.CommState.DONE else None,
        )
        # A client hears no feedback any more once it has the result, which comes by another connection.
        wait_until(lambda: feedback)
        command = next(command for command in self.heard if command.text == text)
        self.send_event(command, "executor", is_final=True)
        wait_until(lambda: ends)
        self.assertEqual(GoalStatus.SUCCEEDED, handle.get_terminal_state())
        self.assertEqual(f"did {text}", handle.get_result().reply.sentence)
        self.assertEqual(handle.get_result().reply.command.id, self.wait_for_reply(text).command.id)

    def test_many_goals_in_flight(self):
        handles = [self.client.send_goal(ExecuteCommandGoal(text=f"goal {index}")) for index in range(8)]
        wait_until(lambda: all(handle.get_comm_state() == actionlib.CommState.DONE for handle in handles))
        self.assertEqual(
            [f"goal {index}" for index in range(8)], [handle.get_result().reply.command.text for handle in handles]
        )

    def test_cancelled_goal_stops_its_command(self):
        handle = self.client.send_goal(ExecuteCommandGoal(text="silent goal"))
        wait_until(lambda: [c for c in self.heard if c.text == "silent goal"])
        handle.cancel()
        wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE)
        self.assertEqual(GoalStatus.PREEMPTED, handle.get_terminal_state())
        self.assertEqual(
            (Reply.SUPERSEDED, "STOPPED"), (handle.get_result().reply.outcome, handle.get_result().reply.code)
        )
        wait_until(lambda: [c for c in self.cancelled if c.text == "silent goal"])

    def test_cancelled_goal_that_runs_waits_for_the_executor(self):
        handle = self.client.send_goal(ExecuteCommandGoal(text="hang in the executor"))
        wait_until(
            lambda: any(
                status.stage == "executor" and [c for c in status.active if c.text == "hang in the executor"]
                for status in self.statuses
            )
        )
        handle.cancel()
        wait_until(lambda: [c for c in self.cancelled if c.text == "hang in the executor"])
        self.assertFalse(self.replies_to("hang in the executor"))
        (command,) = [command for command in self.cancelled if command.text == "hang in the executor"]
        self.send_event(command, "executor", is_final=True)
        self.assertEqual(Reply.DONE, self.wait_for_reply("hang in the executor").outcome)

    def test_cancelled_goal_that_is_being_planned_waits_for_the_executor(self):
        text = "silent goal at the arbitrator"
        handle = self.client.send_goal(ExecuteCommandGoal(text=text))
        wait_until(lambda: [c for c in self.heard if c.text == text])
        command = next(command for command in self.heard if command.text == text)
        for stage in ("stanford_parser_ros", "semantic_framer", "frame_registrar"):
            self.send_event(command, stage)
        self.fence()
        handle.cancel()
        wait_until(lambda: [c for c in self.cancelled if c.id == command.id])
        self.fence()
        self.assertFalse(self.replies_to(text))
        self.end_in_executor(command)
        reply = self.wait_for_reply(text)
        self.assertEqual((Reply.SUPERSEDED, "Stopped."), (reply.outcome, reply.sentence))

    def test_goal_with_a_command_behind_a_stop_ends_with_that_command(self):
        text, behind = "Stop and hang in the executor, please.", "hang in the executor, please."
        feedback = []
        handle = self.client.send_goal(
            ExecuteCommandGoal(text=text), feedback_cb=lambda _, message: feedback.append(message.event)
        )
        goal_id = handle.comm_state_machine.action_goal.goal_id.id
        wait_until(lambda: behind in self.active_texts())
        self.report_stop(goal_id, text)
        # A client hears no feedback any more once it has the result, which comes by another connection.
        wait_until(lambda: [event for event in feedback if event.command.text == behind])
        command = next(command for command in self.heard if command.text == behind)
        self.send_event(command, "executor", is_final=True)
        wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE)
        reply = handle.get_result().reply
        self.assertEqual(
            (behind, f"did {behind}", GoalStatus.SUCCEEDED),
            (reply.command.text, reply.sentence, handle.get_terminal_state()),
        )
        self.assertNotEqual(goal_id, reply.command.id)

    def test_cancelled_goal_ends_the_command_behind_its_stop(self):
        handle = self.client.send_goal(ExecuteCommandGoal(text="Stop and silently go."))
        wait_until(lambda: "silently go." in self.active_texts())
        handle.cancel()
        wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE)
        self.assertEqual("silently go.", handle.get_result().reply.command.text)
        self.assertEqual(GoalStatus.PREEMPTED, handle.get_terminal_state())
        self.report_stop(handle.comm_state_machine.action_goal.goal_id.id, "Stop and silently go.")
        self.fence()
        self.assertFalse([command for command in self.heard if command.text == "silently go."])

    def test_stop_goal_takes_the_reply_of_the_report(self):
        handle = self.client.send_goal(ExecuteCommandGoal(text="Abort!"))
        self.report_stop(handle.comm_state_machine.action_goal.goal_id.id, "Abort!")
        wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE)
        self.assertEqual("Stopped by report.", handle.get_result().reply.sentence)
        self.assertEqual(GoalStatus.SUCCEEDED, handle.get_terminal_state())
