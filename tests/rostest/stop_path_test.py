#!/usr/bin/python3
"""Nodes hang and die while the robot drives: a stop still works, and the replies are true."""

import math
import os
import signal
import threading
import time
import unittest
from contextlib import contextmanager
from typing import Iterator, List

import actionlib
import rosgraph
import rospy
from actionlib_msgs.msg import GoalID, GoalStatus, GoalStatusArray
from actionlib_tutorials.msg import FibonacciAction, FibonacciGoal
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from roboframenet_msgs.msg import (
    Command,
    CommandPlan,
    CommandSemanticFrames,
    CommandStatus,
    FilledFrameElement,
    FilledSemanticFrame,
    Plan,
    PlanCandidate,
    PlanNode,
    Reply,
    StageEvent,
    StopReport,
)
from roboframenet_msgs.srv import (
    AddFrame,
    AddFrameResponse,
    AddLexicalUnit,
    AddLexicalUnitResponse,
    GetEmptyFrame,
    GetEmptyFrameResponse,
    RegisterWithFrame,
    RegisterWithFrameResponse,
)
from std_msgs.msg import String

from roboframenet_testing import wait_until
from roboframenet_testing.ros_connections import is_connected
from roboframenet_testing.ros_processes import process_of

STAGES = ("stanford_parser_ros", "semantic_framer", "frame_registrar")
DRIVE = "moving_forward distance=15,distance_unit=metres"
#: Publishers of velocities: stop server, command server, motion server, patrol and test.
VELOCITY_PUBLISHERS = 5
LISTENERS = (
    ("/arbitrator", "command_plan", "/executor"),
    ("/command_server", "command_cancel", "/executor"),
    ("/executor", "stage_events", "/command_server"),
    ("/stop_server", "stop_report", "/executor"),
    ("/stop_server", "stop_report", "/command_server"),
    ("/command_server", "reply", "/stop_server"),
    ("/stop_server", "moving_forward/cancel", "/move_action_server"),
    ("/move_action_server", "moving_forward/status", "/stop_server"),
    ("/command_server", "moving_forward/cancel", "/move_action_server"),
    ("/move_action_server", "moving_forward/status", "/command_server"),
    ("/stop_server", "fibonacci/cancel", "/fibonacci"),
    ("/fibonacci", "fibonacci/status", "/stop_server"),
    ("/patrol", "patrolling/status", "/stop_server"),
    ("/stop_server", "cmd_vel", "/turtlebot_sim"),
    ("/command_server", "cmd_vel", "/turtlebot_sim"),
)


class StopPathTest(unittest.TestCase):
    """One robot; after each test it stands, and every node is alive."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.lock = threading.Lock()
        cls.replies: List[Reply] = []
        cls.reports: List[StopReport] = []
        cls.velocities: List[Twist] = []
        cls.events: List[StageEvent] = []
        cls.status = CommandStatus()
        cls.position, cls.speed = (0.0, 0.0), math.inf
        cls.motion: List[int] = []
        cls.is_parser_hung = False
        cls.unparsed: List[Command] = []
        cls.services = [
            rospy.Service("add_frame", AddFrame, lambda _: AddFrameResponse(success=True)),
            rospy.Service("add_lexical_unit", AddLexicalUnit, lambda _: AddLexicalUnitResponse(success=True)),
            rospy.Service("get_empty_frame", GetEmptyFrame, lambda _: GetEmptyFrameResponse()),
            rospy.Service("register_with_frame", RegisterWithFrame, lambda _: RegisterWithFrameResponse(success=True)),
        ]
        cls.frames = rospy.Publisher("command_semantic_frames", CommandSemanticFrames, queue_size=100)
        cls.said = rospy.Publisher("stage_events", StageEvent, queue_size=100)
        cls.text = rospy.Publisher("text", String, queue_size=100)
        cls.velocity = rospy.Publisher("cmd_vel", Twist, queue_size=1)
        cls.subscribers = [
            rospy.Subscriber("command_text", Command, cls.on_command),
            rospy.Subscriber("stage_events", StageEvent, cls.events.append),
            rospy.Subscriber("reply", Reply, cls.replies.append),
            rospy.Subscriber("stop_report", StopReport, cls.reports.append),
            rospy.Subscriber("status", CommandStatus, lambda message: setattr(cls, "status", message)),
            rospy.Subscriber("odom", Odometry, cls.on_odometry),
            rospy.Subscriber("moving_forward/status", GoalStatusArray, cls.on_motion),
        ]
        velocities = rospy.Subscriber("cmd_vel", Twist, cls.velocities.append)
        wait_until(lambda: velocities.get_num_connections() == VELOCITY_PUBLISHERS, 120.0)
        cls.wait_for_graph()

    @classmethod
    def wait_for_graph(cls) -> None:
        """Wait for all connections: messages published before a subscriber has connected are lost."""
        wait_until(lambda: cls.text.get_num_connections() == 2 and cls.frames.get_num_connections() == 1, 120.0)
        wait_until(lambda: cls.said.get_num_connections() == 2, 120.0)
        for connection in LISTENERS:
            wait_until(lambda connection=connection: is_connected(*connection), 120.0, str(connection))

    @classmethod
    def on_odometry(cls, message: Odometry) -> None:
        with cls.lock:
            cls.position = (message.pose.pose.position.x, message.pose.pose.position.y)
            cls.speed = max(abs(message.twist.twist.linear.x), abs(message.twist.twist.angular.z))

    @classmethod
    def on_motion(cls, message: GoalStatusArray) -> None:
        cls.motion = [status.status for status in message.status_list]

    @classmethod
    def on_command(cls, command: Command) -> None:
        """Stand in for parser, framer and registrar; " / " separates candidates "SERVER ELEMENT=VALUE,..."."""
        if cls.is_parser_hung:
            cls.unparsed.append(command)
            return
        cls.pass_on(command)

    @classmethod
    def pass_on(cls, command: Command) -> None:
        for stage in STAGES:
            cls.said.publish(StageEvent(command=command, stage=stage, stamp=rospy.Time.now(), sentence="at it"))
        candidates = []
        for candidate in command.text.split(" / "):
            server, _, words = candidate.partition(" ")
            elements = [FilledFrameElement(*word.split("=")) for word in words.split(",") if word]
            frame = FilledSemanticFrame(name=server, action_server_topics=[server], frame_elements=elements)
            candidates.append(PlanCandidate(coverage=1.0, frames=[frame]))
        plan = Plan(nodes=[PlanNode(kind=PlanNode.DO, label=command.text, candidates=candidates)])
        cls.frames.publish(CommandSemanticFrames(command=command, plan=plan))

    def setUp(self) -> None:
        type(self).is_parser_hung = False
        self.wait_for_rest()
        for known in (self.replies, self.reports, self.velocities, self.events, self.unparsed):
            del known[:]

    def say(self, text: str) -> None:
        self.text.publish(String(data=text))

    def replies_to(self, text: str) -> List[Reply]:
        return [reply for reply in list(self.replies) if reply.command.text == text]

    def reply_to(self, text: str, number: int = 1) -> Reply:
        wait_until(lambda: len(self.replies_to(text)) >= number, message=f"no reply to {text!r}")
        return self.replies_to(text)[number - 1]

    def begin_to_drive(self) -> None:
        self.say(DRIVE)
        wait_until(lambda: self.speed > 0.2, message="the robot does not move")

    def wait_for_rest(self) -> None:
        wait_until(lambda: self.speed < 0.001, message="the robot does not stand")

    def assert_stays(self, duration_s: float = 2.0) -> None:
        """Assert that the robot stands and does not start again."""
        self.wait_for_rest()
        with self.lock:
            before = self.position
        time.sleep(duration_s)
        with self.lock:
            way = math.dist(before, self.position)
        self.assertLess(way, 0.02)

    def assert_works(self) -> None:
        """Assert that commands are carried out again."""
        text = f"turning angle=10,angle_unit=degrees,direction=left,number={time.monotonic()}"
        self.say(text)
        reply = self.reply_to(text)
        self.assertEqual(Reply.DONE, reply.outcome, reply.sentence)

    def kill(self, node: str) -> None:
        """Kill a node with SIGKILL and wait until it is back."""
        old = process_of(node)
        os.kill(old, signal.SIGKILL)

        def is_back() -> bool:
            try:
                return process_of(node) != old
            except (rosgraph.MasterException, OSError):
                return False

        wait_until(is_back, message=f"{node} does not come back")

    @contextmanager
    def hung(self, *nodes: str) -> Iterator[None]:
        """Suspend nodes for the length of a block."""
        pids = [process_of(node) for node in nodes]
        for pid in pids:
            os.kill(pid, signal.SIGSTOP)
        try:
            yield
        finally:
            for pid in pids:
                os.kill(pid, signal.SIGCONT)

    def test_01_robot_stands_before_the_reply_says_so(self) -> None:
        self.begin_to_drive()
        self.say("Stop.")
        reply = self.reply_to("Stop.")
        self.assertEqual((Reply.DONE, "DONE"), (reply.outcome, reply.code), reply.sentence)
        self.assertEqual(Reply.SUPERSEDED, self.reply_to(DRIVE).outcome)
        self.assert_stays()
        # The first report comes before it is known which nodes obey.
        self.assertFalse(self.reports[0].reply.command.id)
        self.assertTrue(any(report.reply.command.id for report in self.reports))

    def test_02_goal_of_an_ordinary_client_on_a_ported_server(self) -> None:
        client = actionlib.ActionClient("fibonacci", FibonacciAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(60.0)))
        handle = client.send_goal(FibonacciGoal(order=100_000))
        wait_until(lambda: handle.get_goal_status() == GoalStatus.ACTIVE)
        self.say("Stop.")
        reply = self.reply_to("Stop.")
        self.assertEqual(Reply.DONE, reply.outcome, reply.sentence)
        wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE)
        self.assertEqual(GoalStatus.PREEMPTED, handle.get_terminal_state())
        client.stop()

    def test_03_node_that_drives_against_the_stop_is_named(self) -> None:
        twist = Twist()
        twist.linear.x = 0.2
        driver = rospy.Timer(rospy.Duration(0.02), lambda _: self.velocity.publish(twist))
        try:
            wait_until(lambda: self.speed > 0.1)
            del self.velocities[:]
            self.say("Stop.")
            reply = self.reply_to("Stop.")
            self.assertEqual((Reply.FAILED, "NOT_STOPPED"), (reply.outcome, reply.code), reply.sentence)
            self.assertIn(f"{rospy.get_name()} publishes velocities on /cmd_vel", reply.sentence)
            # About as many zeros as velocities: the base is held although the driver publishes faster.
            wait_until(lambda: len(self.velocities) > 200)
            zeros = sum(velocity == Twist() for velocity in self.velocities[:200])
            self.assertGreater(zeros, 60)
            # It ends, and the status says so.
            wait_until(lambda: "Zero velocity has ended after 3 s" in self.status.sentence)
        finally:
            driver.shutdown()
        self.velocity.publish(Twist())
        self.assertEqual(1, len(self.replies_to("Stop.")))
        self.wait_for_rest()
        self.say("Halt.")
        self.assertEqual(Reply.DONE, self.reply_to("Halt.").outcome)

    def test_04_server_that_obeys_no_cancel_is_named_until_it_ends(self) -> None:
        self.say("patrolling duration=5")
        wait_until(lambda: self.speed > 0.05)
        self.say("Stop.")
        reply = self.reply_to("Stop.")
        self.assertEqual((Reply.FAILED, "NOT_STOPPED"), (reply.outcome, reply.code), reply.sentence)
        self.assertIn("/patrol publishes velocities", reply.sentence)
        self.assertIn("/patrolling has not ended its goal", reply.sentence)
        wait_until(lambda: "/patrolling" in self.status.sentence)
        wait_until(lambda: {"/patrol", "/patrolling"} <= set(self.reports[-1].disobeying))
        self.wait_for_rest()
        self.assert_works()

    def test_05_killed_command_server_stops_its_commands_before_it_answers(self) -> None:
        self.begin_to_drive()
        self.kill("/command_server")
        reply = self.reply_to(DRIVE)
        self.assertLess(self.speed, 0.05)
        self.assertEqual((Reply.FAILED, "RESTARTED"), (reply.outcome, reply.code), reply.sentence)
        self.assert_stays()
        self.assertEqual(1, len(self.replies_to(DRIVE)))
        self.wait_for_graph()
        self.assert_works()

    def test_06_silent_executor_is_named_and_the_robot_does_not_start_again(self) -> None:
        self.begin_to_drive()
        with self.hung("/executor"):
            reply = self.reply_to(DRIVE)
            self.assertLess(self.speed, 0.05)
            self.assertEqual((Reply.FAILED, "STAGE_SILENT", "executor"), (reply.outcome, reply.code, reply.stage))
            self.assertIn("is stopped", reply.sentence)
            self.assert_stays()
        self.assert_stays()
        self.assertEqual(1, len(self.replies_to(DRIVE)))
        self.assert_works()

    def test_07_hung_executor_does_not_try_the_next_candidate_when_it_wakes(self) -> None:
        text = f"{DRIVE} / moving_backward distance=15,distance_unit=metres"
        self.say(text)
        wait_until(lambda: self.speed > 0.2, message="the robot does not move")
        with self.hung("/executor"):
            # Meanwhile the server fails: it loses the odometry.
            with self.hung("/turtlebot_sim"):
                wait_until(lambda: GoalStatus.ABORTED in self.motion)
            self.assertEqual("STAGE_SILENT", self.reply_to(text).code)
        self.assert_stays()
        self.assert_works()

    def test_08_stop_server_and_executor_hung(self) -> None:
        self.begin_to_drive()
        with self.hung("/executor", "/stop_server"):
            self.say("Stop.")
            self.wait_for_rest()
            reply = self.reply_to("Stop.")
            self.assertEqual((Reply.FAILED, "STAGE_SILENT", "stop_server"), (reply.outcome, reply.code, reply.stage))
            self.assertIn("Stopped: zero velocity", reply.sentence)
            self.assert_stays()
        self.assert_stays()
        self.assertEqual(1, len(self.replies_to("Stop.")))
        self.assertEqual(1, len(self.replies_to(DRIVE)))
        self.assert_works()

    def test_09_each_stop_has_one_reply_when_the_stop_server_hangs_or_dies_near_it(self) -> None:
        with self.hung("/stop_server"):
            self.say("Stop.")
            self.reply_to("Stop.")
            self.say("Stop.")
        # One stop answered while it hung, one that still waited, and one from afterwards.
        self.say("Stop.")
        self.reply_to("Stop.", 3)
        self.kill("/stop_server")
        self.say("Stop.")
        self.reply_to("Stop.", 4)
        self.wait_for_graph()
        self.say("Stop.")
        self.reply_to("Stop.", 5)
        self.assert_works()
        self.assertEqual(5, len(self.replies_to("Stop.")))
        self.assertEqual(5, len({reply.command.id for reply in self.replies_to("Stop.")}))

    def test_10_hung_command_server_blames_nobody_when_it_wakes(self) -> None:
        self.begin_to_drive()
        with self.hung("/command_server"):
            self.say("Stop.")
            self.assertEqual(Reply.DONE, self.reply_to("Stop.").outcome)
            self.wait_for_rest()
            time.sleep(6.0)  # longer than the deadline of any stage
        self.assertEqual("STOPPED", self.reply_to(DRIVE).code)
        self.assert_works()
        self.assertEqual(1, len(self.replies_to("Stop.")))

    def test_11_command_that_was_closed_while_the_parser_hung_is_not_carried_out(self) -> None:
        type(self).is_parser_hung = True
        self.say(DRIVE)
        reply = self.reply_to(DRIVE)
        self.assertEqual(("STAGE_SILENT", "stanford_parser_ros"), (reply.code, reply.stage))
        # A new executor has started by then, and must know too.
        self.kill("/executor")
        self.wait_for_graph()
        for command in self.unparsed:
            self.pass_on(command)
        wait_until(
            lambda: any(
                event.is_final and event.stage == "executor" and event.reply.code == "STOPPED" for event in self.events
            )
        )
        self.assert_stays()

    def test_12_plan_waits_for_an_executor_that_is_restarted_although_others_listen(self) -> None:
        observer = rospy.Subscriber("command_plan", CommandPlan, lambda _: None)
        self.addCleanup(observer.unregister)
        wait_until(lambda: is_connected("/arbitrator", "command_plan", rospy.get_name()))

        def is_done() -> bool:
            type(self).is_parser_hung = True
            text = f"turning angle=10,angle_unit=degrees,direction=left,number={time.monotonic()}"
            self.say(text)
            wait_until(lambda: [command for command in self.unparsed if command.text == text])
            executor = process_of("/executor")
            os.kill(executor, signal.SIGKILL)
            # Until it is dead, what is sent to it counts as heard.
            wait_until(lambda: not os.path.exists(f"/proc/{executor}"), message="the executor does not die")
            type(self).is_parser_hung = False
            self.pass_on(self.unparsed[-1])
            reply = self.reply_to(text)
            self.wait_for_graph()
            return reply.outcome == Reply.DONE

        # On a busy machine, the executor may come back too late.
        wait_until(is_done, 120.0)

    def test_99_stops_and_commands_with_a_hung_master(self) -> None:
        self.begin_to_drive()
        pid = int(rosgraph.Master(rospy.get_name()).getPid())
        cancels: List[GoalID] = []
        subscriber = rospy.Subscriber("moving_forward/cancel", GoalID, cancels.append)
        stopping = ("/stop_server", "/command_server", "/executor")
        wait_until(lambda: all(is_connected(node, subscriber.name, rospy.get_name()) for node in stopping))
        os.kill(pid, signal.SIGSTOP)
        try:
            for number in (1, 2):
                if number > 1:
                    # The repetitions of the previous stop have ended.
                    wait_until(self.is_quiet)
                for known in (self.velocities, cancels, self.reports):
                    del known[:]
                self.say("Stop.")
                self.assertEqual(Reply.DONE, self.reply_to("Stop.", number).outcome)
                self.wait_for_rest()
                wait_until(lambda: Twist() in self.velocities and GoalID() in cancels)
                wait_until(lambda: any(report.reply.command.id for report in self.reports))
            self.assertEqual("STOPPED", self.reply_to(DRIVE).code)
            self.say(DRIVE)
            self.reply_to(DRIVE, 2)
        finally:
            os.kill(pid, signal.SIGCONT)
        self.wait_for_rest()

    def is_quiet(self) -> bool:
        count = len(self.velocities)
        time.sleep(0.3)
        return count == len(self.velocities)


if __name__ == "__main__":
    import rostest

    rospy.init_node("stop_path_test")
    rostest.rosrun("roboframenet_tests", "stop_path", StopPathTest)
