"""What ends a command from outside: a stop, and a cancel by another client."""

import rospy
from actionlib_msgs.msg import GoalID
from executor_case import ExecutorCase, frame
from roboframenet_msgs.msg import Reply, StoppedPlan, StopReport

from roboframenet_testing import wait_until


class StopCases(ExecutorCase):
    """Stops and cancels."""

    def test_goal_cancelled_by_somebody_else_ends_the_command(self):
        command = self.send([[frame("run", "one")], [frame("succeed", "two")]])
        self.wait_for_log("one begins run")
        wait_until(lambda: self.events_of(command, False))
        self.server_cancel.publish(GoalID())
        self.assert_reply(command, Reply.SUPERSEDED, "STOPPED", "Another client cancelled it: one was preempted")
        self.assertNotIn("two begins succeed", self.log)

    def test_stop_whose_cancel_comes_before_its_report_is_the_reason(self):
        offered = []
        subscriber = rospy.Subscriber("stopped_plan", StoppedPlan, offered.append)
        wait_until(lambda: subscriber.get_num_connections() == 1)
        self.addCleanup(subscriber.unregister)
        command = self.send([[frame("run", "one")], [frame("succeed", "two")]])
        self.wait_for_log("one begins run")
        wait_until(lambda: self.events_of(command, False))
        stamp = rospy.Time.now()
        self.server_cancel.publish(GoalID())
        self.wait_for_log("one preempted run")
        wait_until(lambda: any("was preempted" in event.sentence for event in self.events_of(command, False)))
        self.stops.publish(StopReport(stop_stamp=stamp))
        self.assert_reply(command, Reply.SUPERSEDED, "STOPPED", "Stopped.")
        wait_until(lambda: [one for one in offered if one.command.id == command.id])

    def test_stop_ends_the_command_and_refuses_what_was_said_before(self):
        before = rospy.Time.now()
        command = self.send([[frame("run", "one")], [frame("succeed", "two")]])
        self.wait_for_log("one begins run")
        self.stops.publish(StopReport(stop_stamp=rospy.Time.now()))
        self.assert_reply(command, Reply.SUPERSEDED, "STOPPED")
        self.wait_for_log("one preempted run")
        late = self.send([[frame("succeed", "two")]], stamp=before)
        self.assert_reply(late, Reply.SUPERSEDED, "STOPPED")
        self.assertNotIn("two begins succeed", self.log)
        after = self.send([[frame("succeed", "two")]])
        self.assert_reply(after, Reply.DONE, "DONE")

    def test_stop_tells_what_is_left(self):
        offered = []
        subscriber = rospy.Subscriber("stopped_plan", StoppedPlan, offered.append)
        wait_until(lambda: subscriber.get_num_connections() == 1)
        self.addCleanup(subscriber.unregister)
        clauses = [
            ("ping", [[frame("succeed", "one")]]),
            ("run", [[frame("run", "one")]]),
            ("wave", [[frame("succeed", "two")]]),
        ]
        command = self.send_clauses(*clauses)
        self.wait_for_log("one begins run")
        self.stops.publish(StopReport(stop_stamp=rospy.Time.now()))
        self.assert_reply(command, Reply.SUPERSEDED, "STOPPED", 'I did "ping"')
        wait_until(lambda: [one for one in offered if one.command.id == command.id])
        (left,) = [one for one in offered if one.command.id == command.id]
        self.assertEqual(left.said, '"run" and "wave"')
        self.assertEqual([node.label for node in left.plan.nodes], ["do it all", "run", "wave"])
        # What a newer command ends is over.
        replaced = self.send([[frame("run", "one")]])
        self.assert_reply(self.send([[frame("succeed", "two")]]), Reply.DONE, "DONE")
        self.assertFalse([one for one in offered if one.command.id == replaced.id])

    def test_stop_while_the_server_does_not_accept(self):
        command = self.send([[frame("accept_late", "one", "60")]])
        self.wait_for_log("one begins accept_late")
        self.stops.publish(StopReport(stop_stamp=rospy.Time.now()))
        self.assert_reply(command, Reply.SUPERSEDED, "STOPPED")
