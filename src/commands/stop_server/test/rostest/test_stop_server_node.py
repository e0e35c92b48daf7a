#!/usr/bin/python3
"""The node, with the rest of the pipeline dead."""

import threading
import unittest

import actionlib
import rospy
import rostest
from actionlib.msg import TestAction, TestGoal
from actionlib_msgs.msg import GoalID, GoalStatus
from geometry_msgs.msg import Twist
from roboframenet_msgs.msg import (
    Command,
    ExecuteCommandActionGoal,
    FilledSemanticFrame,
    FilledSemanticFrameAction,
    FilledSemanticFrameGoal,
    FrameCallback,
    FrameServers,
    Reply,
    StopReport,
)
from std_msgs.msg import Duration, String

from roboframenet_testing import wait_until


class Mover:
    """An action server whose goals last until they are cancelled."""

    def __init__(self, name, action):
        self.name = rospy.resolve_name(name)
        self.server = actionlib.ActionServer(
            name, action, lambda handle: handle.set_accepted(), lambda handle: handle.set_canceled(), auto_start=False
        )
        self.server.start()
        rospy.on_shutdown(self.server.status_timer.shutdown)
        self.client = actionlib.ActionClient(name, action)
        assert self.client.wait_for_server(rospy.Duration(60.0))

    def start_goal(self, goal):
        handle = self.client.send_goal(goal)
        wait_until(lambda: handle.get_goal_status() == GoalStatus.ACTIVE)
        return handle


class StopServerNodeTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node("test_stop_server_node")
        cls.replies, cls.reports, cls.velocities, cls.other_velocities = [], [], [], []
        subscribers = [
            rospy.Subscriber("reply", Reply, cls.replies.append),
            rospy.Subscriber("stop_report", StopReport, cls.reports.append),
            rospy.Subscriber("cmd_vel", Twist, cls.velocities.append),
            rospy.Subscriber("other_cmd_vel", Twist, cls.other_velocities.append),
        ]
        cls.text = rospy.Publisher("text", String, queue_size=100)
        cls.goal = rospy.Publisher("command/goal", ExecuteCommandActionGoal, queue_size=10)
        cls.servers = rospy.Publisher("frame_servers", FrameServers, queue_size=1, latch=True)
        wait_until(lambda: all(entity.get_num_connections() == 1 for entity in subscribers + [cls.text, cls.goal]))
        cls.movers = [Mover("turn_server", FilledSemanticFrameAction), Mover("drive_server", FilledSemanticFrameAction)]
        cls.navigation = Mover("navigation_stack", TestAction)
        cls.registered = Mover("registered_server", TestAction)
        cls.stranger = Mover("stranger", TestAction)
        cls.servers.publish(FrameServers(callbacks=[FrameCallback(callback_topic="registered_server")]))

    def setUp(self):
        for known in (self.replies, self.reports, self.velocities, self.other_velocities):
            del known[:]

    def answer_to(self, text):
        """Wait for reply and report to what was just said: those to the stop of another test may come late."""

        def answers():
            return (
                [reply for reply in list(self.replies) if reply.command.text == text],
                [report for report in list(self.reports) if report.reply.command.text == text],
            )

        wait_until(lambda: all(answers()), message=answers)
        replies, reports = answers()
        return replies[0], reports[0]

    def wait_until_server_is_known(self, mover):
        # One cancel publisher is the client of this test, the other is the stop server's.
        wait_until(lambda: mover.server.cancel_sub.get_num_connections() == 2)

    def test_stop_cancels_every_goal_and_publishes_zero_velocity(self):
        expected = self.movers + [self.navigation, self.registered]
        for mover in expected:
            self.wait_until_server_is_known(mover)
        handles = [mover.start_goal(FilledSemanticFrameGoal()) for mover in self.movers]
        handles += [mover.start_goal(TestGoal()) for mover in (self.navigation, self.registered)]
        stranger = self.stranger.start_goal(TestGoal())
        self.text.publish("STOP!!")
        wait_until(lambda: all(handle.get_comm_state() == actionlib.CommState.DONE for handle in handles))
        self.assertEqual({GoalStatus.PREEMPTED}, {handle.get_terminal_state() for handle in handles})
        self.assertEqual(GoalStatus.ACTIVE, stranger.get_goal_status())
        stranger.cancel()
        wait_until(lambda: len(self.velocities) > 3 and len(self.other_velocities) > 3)
        self.assertTrue(all(velocity == Twist() for velocity in self.velocities + self.other_velocities))
        reply, report = self.answer_to("STOP!!")
        self.assertEqual((Reply.DONE, "stop_server"), (reply.outcome, reply.stage))
        self.assertEqual(reply, report.reply)
        self.assertTrue({mover.name for mover in expected} <= set(report.cancelled_servers))
        self.assertEqual(report.command.stamp, report.stop_stamp)

    def test_what_was_said_while_the_command_server_was_away_is_answered(self):
        taken = rospy.Publisher("text_taken", String, queue_size=10)
        started = rospy.Publisher("command_server_started", Duration, queue_size=10)
        wait_until(lambda: taken.get_num_connections() == 1 and started.get_num_connections() == 1)
        taken.publish("text-1 0.0 Turn left.")
        for text in ("Turn left.", "Ping.", "Stop."):
            self.text.publish(text)
        self.answer_to("Stop.")
        started.publish(Duration())

        def unheard():
            return [reply.command.text for reply in list(self.replies) if reply.code == "RESTARTED"]

        wait_until(lambda: "Ping." in unheard(), message=unheard)
        self.assertEqual(1, unheard().count("Ping."))
        self.assertFalse({"Turn left.", "Stop."} & set(unheard()))

    def test_goal_of_the_action_command_stops_under_its_own_id(self):
        message = ExecuteCommandActionGoal(goal_id=GoalID(id="goal_7"))
        message.goal.text = "please stop"
        self.goal.publish(message)
        self.assertEqual("goal_7", self.answer_to("please stop")[0].command.id)

    def test_a_cry_that_only_the_command_server_has_heard_stops_and_one_that_both_hear_stops_once(self):
        told = rospy.Publisher("cry_heard", Command, queue_size=10)
        wait_until(lambda: told.get_num_connections() == 1)
        told.publish(Command(id="goal_8", stamp=rospy.Time.now(), text="stop it"))
        self.assertEqual("goal_8", self.answer_to("stop it")[0].command.id)
        both = ExecuteCommandActionGoal(goal_id=GoalID(id="goal_9"))
        both.goal.text = "stop that"
        self.goal.publish(both)
        told.publish(Command(id="goal_9", stamp=rospy.Time.now(), text="stop that"))
        self.text.publish("halt now")
        told.publish(Command(id="text-1", stamp=rospy.Time.now(), text="halt now"))
        self.text.publish("Halt at last!")
        self.answer_to("Halt at last!")
        texts = [reply.command.text for reply in list(self.replies)]
        self.assertEqual([1, 1, 1], [texts.count(text) for text in ("stop it", "stop that", "halt now")], texts)

    def test_what_was_said_beside_a_stop_is_named(self):
        self.text.publish("Walk into the hall. Go past the sofa. Stop.")
        reply, _ = self.answer_to("Walk into the hall. Go past the sofa. Stop.")
        self.assertEqual((Reply.FAILED, "REST_NOT_DONE"), (reply.outcome, reply.code))
        self.assertIn('I did not do the rest: "Walk into the hall" and "Go past the sofa".', reply.sentence)

    def test_each_stop_of_a_flood_gets_its_reply_and_nothing_else_does(self):
        for _ in range(25):
            self.text.publish("stop")
            self.text.publish("stop at the kitchen")
        self.text.publish("halt")
        wait_until(lambda: any(reply.command.text == "halt" for reply in self.replies))
        replies = [reply for reply in self.replies if reply.command.text in ("stop", "stop at the kitchen", "halt")]
        self.assertEqual(["stop"] * 25 + ["halt"], [reply.command.text for reply in replies])
        self.assertEqual(26, len({reply.command.id for reply in replies}))

    def test_zero_velocity_ends(self):
        self.text.publish("stop")
        wait_until(lambda: self.velocities)
        quiet = threading.Event()

        def has_ended():
            count = len(self.velocities)
            quiet.wait(0.5)
            return count == len(self.velocities)

        wait_until(has_ended)

    def test_goal_that_was_on_its_way_is_cancelled_and_a_later_one_is_not(self):
        mover = self.movers[0]
        self.wait_until_server_is_known(mover)
        self.text.publish("Stop there!")
        late = self.client_goal_stamped(mover, self.answer_to("Stop there!")[1].stop_stamp - rospy.Duration(0.001))
        new = mover.client.send_goal(FilledSemanticFrameGoal())
        wait_until(lambda: late.get_comm_state() == actionlib.CommState.DONE)
        wait_until(lambda: new.get_goal_status() == GoalStatus.ACTIVE)
        new.cancel()
        wait_until(lambda: new.get_comm_state() == actionlib.CommState.DONE)

    def client_goal_stamped(self, mover, stamp):
        """Send a goal that was stamped before it arrives."""
        plain_id = mover.client.manager._generate_id
        mover.client.manager._generate_id = lambda: GoalID(id=plain_id().id, stamp=stamp)
        try:
            return mover.client.send_goal(FilledSemanticFrameGoal())
        finally:
            mover.client.manager._generate_id = plain_id

    def test_frame_of_stopping_succeeds_when_the_robot_stands_and_says_why_when_it_does_not(self):
        client = actionlib.ActionClient("stopping", FilledSemanticFrameAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(60.0)))
        mover = self.movers[1]
        self.wait_until_server_is_known(mover)
        moving = mover.start_goal(FilledSemanticFrameGoal())
        goal = FilledSemanticFrameGoal(frame=FilledSemanticFrame(name="stopping"))
        stopping = client.send_goal(goal)
        wait_until(lambda: stopping.get_comm_state() == actionlib.CommState.DONE)
        self.assertEqual(GoalStatus.SUCCEEDED, stopping.get_terminal_state(), stopping.get_goal_status_text())
        wait_until(lambda: moving.get_comm_state() == actionlib.CommState.DONE)
        self.assertEqual(GoalStatus.PREEMPTED, moving.get_terminal_state())
        twist = Twist()
        twist.angular.z = 0.3
        velocity = rospy.Publisher("other_cmd_vel", Twist, queue_size=1)
        driver = rospy.Timer(rospy.Duration(0.05), lambda _: velocity.publish(twist))
        try:
            wait_until(lambda: twist in self.other_velocities)
            stopping = client.send_goal(goal)
            wait_until(lambda: stopping.get_comm_state() == actionlib.CommState.DONE)
        finally:
            driver.shutdown()
            velocity.unregister()
        self.assertEqual(GoalStatus.ABORTED, stopping.get_terminal_state())
        self.assertIn(f"{rospy.get_name()} publishes velocities on /other_cmd_vel", stopping.get_goal_status_text())

    def test_server_whose_goal_does_not_end_is_named(self):
        stubborn = actionlib.ActionServer(
            "stubborn", FilledSemanticFrameAction, lambda handle: handle.set_accepted(), auto_start=False
        )
        stubborn.start()
        rospy.on_shutdown(stubborn.status_timer.shutdown)
        client = actionlib.ActionClient("stubborn", FilledSemanticFrameAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(60.0)))
        wait_until(lambda: stubborn.cancel_sub.get_num_connections() == 2)
        handle = client.send_goal(FilledSemanticFrameGoal())
        wait_until(lambda: handle.get_goal_status() == GoalStatus.ACTIVE)
        self.text.publish("Whoa!")
        reply, report = self.answer_to("Whoa!")
        self.assertEqual((Reply.FAILED, "NOT_STOPPED"), (reply.outcome, reply.code))
        self.assertIn("/stubborn has not ended its goal", reply.sentence)
        self.assertEqual(["/stubborn"], report.disobeying)
        # It ends late, which is said without a second reply.
        for tracker in stubborn.status_list:
            actionlib.ServerGoalHandle(tracker, stubborn).set_canceled()
        wait_until(
            lambda: any(
                report.sentence == "Stopped now: every node obeys." and report.command.text == "Whoa!"
                for report in list(self.reports)
            )
        )
        self.assertEqual(1, len([reply for reply in self.replies if reply.command.text == "Whoa!"]))

    def test_server_that_starts_later_is_found(self):
        late = Mover("late_server", FilledSemanticFrameAction)
        self.wait_until_server_is_known(late)
        handle = late.start_goal(FilledSemanticFrameGoal())
        self.text.publish("Freeze!")
        wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE)
        self.assertEqual(GoalStatus.PREEMPTED, handle.get_terminal_state())


if __name__ == "__main__":
    rostest.rosrun("stop_server", "stop_server_node", StopServerNodeTest)
