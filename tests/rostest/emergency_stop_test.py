#!/usr/bin/python3
"""The emergency stop holds, whatever is said, sent, played, killed or damaged, until a person releases it."""

import asyncio
import contextlib
import copy
import json
import math
import os
import signal
import subprocess
import tempfile
import threading
import time
import unittest
import uuid
from pathlib import Path
from typing import Iterator, List, Optional, Tuple

import actionlib
import rosbag
import rosgraph
import rospy
from actionlib_msgs.msg import GoalStatus
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from roboframenet_msgs.msg import (
    Command,
    CommandPlan,
    EmergencyStop,
    FilledFrameElement,
    FilledSemanticFrame,
    FilledSemanticFrameAction,
    FilledSemanticFrameGoal,
    OrderDue,
    Reply,
    StageEvent,
)
from std_msgs.msg import Bool, String
from std_srvs.srv import Trigger, TriggerResponse
from tornado.websocket import websocket_connect

from roboframenet_rostest import say, wait_for_pipeline
from roboframenet_testing import wait_until
from roboframenet_testing.ros_connections import is_connected
from roboframenet_testing.ros_processes import process_of

DRIVE = "Move forward 20 metres."
TURN = "Turn left 30 degrees."
RELEASE = "Release the emergency stop."
#: How far a robot may be pushed by a goal, or by velocities, until they are answered with zero: metres, radians.
PUSHED = 0.05
#: Longer than every server needs to begin, seconds.
WHILE_S = 2.0


class EmergencyStopTest(unittest.TestCase):
    """One robot; each test begins and ends released and at rest."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.pose: Optional[Tuple[float, float, float]] = None
        cls.speed = math.inf
        cls.replies: List[Reply] = []
        cls.events: List[StageEvent] = []
        cls.plans: List[CommandPlan] = []
        cls.parsed: List[Command] = []
        cls.states: List[EmergencyStop] = []
        cls.subscribers = [
            rospy.Subscriber("odom", Odometry, cls.on_odometry, queue_size=1),
            rospy.Subscriber("reply", Reply, cls.replies.append, queue_size=100),
            rospy.Subscriber("stage_events", StageEvent, cls.events.append, queue_size=1000),
            rospy.Subscriber("command_plan", CommandPlan, cls.plans.append, queue_size=100),
            rospy.Subscriber("command_text", Command, cls.parsed.append, queue_size=100),
            rospy.Subscriber("emergency_stop", EmergencyStop, cls.on_state, queue_size=100),
        ]
        cls.text = rospy.Publisher("text", String, queue_size=10)
        cls.lock = rospy.Publisher("emergency_stop/lock", Bool, queue_size=10)
        cls.state = rospy.Publisher("emergency_stop", EmergencyStop, queue_size=10)
        cls.velocity = rospy.Publisher("cmd_vel", Twist, queue_size=1)
        cls.plan = rospy.Publisher("command_plan", CommandPlan, queue_size=10)
        cls.command_text = rospy.Publisher("command_text", Command, queue_size=10)
        cls.order_due = rospy.Publisher("order_due", OrderDue, queue_size=10)
        wait_for_pipeline(("turning", "moving_forward", "saying"))
        wait_until(lambda: rospy.has_param("web_console/url") and cls.pose is not None)
        for topic in ("moving_forward/cancel", "turning/cancel"):
            for node in ("/stop_server", "/command_server"):
                wait_until(lambda topic=topic, node=node: is_connected(node, topic, "/move_action_server"))
        # What later tests send again.
        assert say(TURN).outcome == Reply.DONE
        wait_until(lambda: any(plan.command.text == TURN for plan in cls.plans))
        cls.turn_plan = next(plan for plan in cls.plans if plan.command.text == TURN)

    @classmethod
    def tearDownClass(cls) -> None:
        cls.velocity.publish(Twist())

    @classmethod
    def on_odometry(cls, message: Odometry) -> None:
        at, turned = message.pose.pose.position, message.pose.pose.orientation
        cls.pose = (at.x, at.y, 2.0 * math.atan2(turned.z, turned.w))
        cls.speed = max(abs(message.twist.twist.linear.x), abs(message.twist.twist.angular.z))

    @classmethod
    def on_state(cls, message: EmergencyStop) -> None:
        if message._connection_header["callerid"] == rospy.resolve_name("stop_server"):
            cls.states.append(message)

    def setUp(self) -> None:
        wait_until(lambda: self.states and not self.states[-1].is_engaged, message="the test before left it engaged")
        self.wait_for_rest()

    def tearDown(self) -> None:
        # Also behind a test that failed.
        if self.states[-1].is_engaged:
            self.call("emergency_stop/release")
        say("Stop.")

    # What the tests do and look at.

    def say_text(self, text: str) -> Reply:
        """Say a text, and return its reply."""
        since = len(self.replies)
        self.text.publish(String(data=text))
        wait_until(lambda: self.replies_to(text, since), message=f"no reply to {text!r}")
        return self.replies_to(text, since)[0]

    def replies_to(self, text: str, since: int = 0) -> List[Reply]:
        return [reply for reply in self.replies[since:] if reply.command.text == text]

    def call(self, name: str) -> TriggerResponse:
        rospy.wait_for_service(name, timeout=60.0)
        return rospy.ServiceProxy(name, Trigger)()

    def engage(self) -> None:
        reply = say("Emergency stop.")
        self.assertEqual((Reply.DONE, "DONE", "stop_server"), (reply.outcome, reply.code, reply.stage), reply.sentence)
        self.assertIn("has held since", reply.sentence)

    def release(self) -> None:
        reply = say(RELEASE)
        self.assertEqual((Reply.DONE, "DONE"), (reply.outcome, reply.code), reply.sentence)
        self.assert_works()

    def begin_to_drive(self) -> None:
        self.text.publish(String(data=DRIVE))
        wait_until(lambda: self.speed > 0.1, message="the robot does not move")

    def wait_for_rest(self) -> None:
        wait_until(lambda: self.speed < 0.001, message="the robot does not stand")

    @contextlib.contextmanager
    def unmoved(self, pushed: float = 0.001) -> Iterator[None]:
        """Assert that the robot does not move during a block and for a while behind it."""
        self.wait_for_rest()
        before = self.pose
        yield
        end_s, way = time.monotonic() + WHILE_S, 0.0
        while time.monotonic() < end_s:
            time.sleep(0.05)
            turned = math.remainder(self.pose[2] - before[2], math.tau)
            way = max(way, math.dist(before[:2], self.pose[:2]), abs(turned))
        self.assertLess(way, pushed)
        self.wait_for_rest()

    def assert_refused(self, reply: Reply) -> None:
        self.assertEqual((Reply.REFUSED, "EMERGENCY_STOP"), (reply.outcome, reply.code), reply.sentence)
        self.assertIn("has held since", reply.sentence)
        self.assertIn('say "release the emergency stop"', reply.sentence)

    def assert_holds(self) -> None:
        """Assert that it holds: what is said is answered with why, once, and nothing moves."""
        with self.unmoved():
            self.assert_refused(say(TURN))
            since = len(self.replies)
            self.assert_refused(self.say_text("Go home."))
        self.assertEqual(1, len(self.replies_to("Go home.", since)))

    def assert_works(self) -> None:
        """Assert that the robot is free: it carries out what is said."""
        wait_until(lambda: not self.states[-1].is_engaged)
        before = self.pose
        reply = say(TURN)
        self.assertEqual(Reply.DONE, reply.outcome, reply.sentence)
        wait_until(lambda: abs(math.remainder(self.pose[2] - before[2], math.tau)) > 0.4)

    def kill(self, node: str) -> None:
        """Kill a node with SIGKILL, and wait until it is back."""
        old = process_of(node)
        os.kill(old, signal.SIGKILL)
        self.wait_for_return(node, old)

    def wait_for_return(self, node: str, old: int) -> None:
        def is_back() -> bool:
            try:
                return process_of(node) != old
            except (rosgraph.MasterException, OSError):
                return False

        wait_until(is_back, 120.0, message=f"{node} does not come back")

    @contextlib.contextmanager
    def hung(self, node: str) -> Iterator[None]:
        """Suspend a node for the length of a block."""
        pid = process_of(node)
        os.kill(pid, signal.SIGSTOP)
        try:
            yield
        finally:
            os.kill(pid, signal.SIGCONT)

    @contextlib.contextmanager
    def driven(self) -> Iterator[None]:
        """Let this node drive the robot, as a joystick does, for the length of a block."""
        twist, is_over = Twist(), threading.Event()
        twist.linear.x = 0.2

        def drive() -> None:
            while not is_over.wait(0.05):
                self.velocity.publish(twist)

        driver = threading.Thread(target=drive)
        driver.start()
        try:
            yield
        finally:
            is_over.set()
            driver.join()
            self.velocity.publish(Twist())

    def ask_page(self, **request: str) -> dict:
        """Ask for something as the page does, and return what the page shows of the emergency stop a while later."""

        async def ask() -> dict:
            page = await websocket_connect(rospy.get_param("web_console/url").replace("http", "ws") + "live")
            await page.write_message(json.dumps(request))
            shown, end_s = {}, time.monotonic() + WHILE_S
            with contextlib.suppress(asyncio.TimeoutError):
                while time.monotonic() < end_s:
                    message = json.loads(await asyncio.wait_for(page.read_message(), end_s - time.monotonic()))
                    if message["view"] == "emergency":
                        shown = message["value"]
            page.close()
            return shown

        return asyncio.run(ask())

    # Engaged, by each way.

    def test_01_words_engage_it_while_the_robot_drives(self) -> None:
        self.begin_to_drive()
        self.engage()
        self.assertEqual(Reply.SUPERSEDED, self.replies_to(DRIVE)[-1].outcome)
        self.wait_for_rest()
        self.assert_holds()
        self.release()

    def test_02_service_engages_it_and_service_releases_it(self) -> None:
        self.begin_to_drive()
        answer = self.call("emergency_stop/engage")
        self.assertTrue(answer.success, answer.message)
        self.wait_for_rest()
        self.assert_holds()
        answer = self.call("emergency_stop/release")
        self.assertTrue(answer.success, answer.message)
        self.assert_works()

    def test_03_true_on_the_lock_engages_it_and_false_never_releases_it(self) -> None:
        wait_until(lambda: self.lock.get_num_connections() > 0)
        self.begin_to_drive()
        self.lock.publish(Bool(data=True))
        wait_until(lambda: self.states[-1].is_engaged)
        self.wait_for_rest()
        for _ in range(20):
            self.lock.publish(Bool(data=False))
            time.sleep(0.05)
        self.assert_holds()
        self.release()

    def test_04_page_engages_it_and_page_releases_it(self) -> None:
        self.begin_to_drive()
        shown = self.ask_page(verb="emergency_stop")
        self.assertTrue(shown["is_engaged"])
        self.assertIn("has held since", shown["sentence"])
        self.assert_holds()
        with self.unmoved():
            self.ask_page(verb="say", text=TURN)
        self.assert_refused(self.replies_to(TURN)[-1])
        self.assertFalse(self.ask_page(verb="say", text=RELEASE)["is_engaged"])
        self.assert_works()

    # What does not set the robot in motion.

    def test_05_what_passes_the_command_server_by_is_refused_by_the_executor(self) -> None:
        self.engage()
        plan = copy.deepcopy(self.turn_plan)
        plan.command = Command(id=uuid.uuid4().hex, stamp=rospy.Time.now(), text=TURN)
        again = Command(id=uuid.uuid4().hex, stamp=rospy.Time.now(), text=TURN)
        wait_until(lambda: self.plan.get_num_connections() > 0 and self.command_text.get_num_connections() > 0)
        with self.unmoved():
            self.plan.publish(plan)
            self.command_text.publish(again)
        for command in (plan.command, again):
            wait_until(lambda command=command: self.ends_of(command.id), message=command.id)
            self.assert_refused(self.ends_of(command.id)[0].reply)
        self.release()

    def ends_of(self, command_id: str) -> List[StageEvent]:
        return [event for event in self.events if event.command.id == command_id and event.is_final]

    def test_06_standing_orders_wait_and_those_that_are_due_are_refused(self) -> None:
        wait_until(lambda: self.order_due.get_num_connections() > 0)
        reply = say("Turn left 40 degrees in four seconds.")
        self.assertEqual(Reply.DONE, reply.outcome, reply.sentence)
        self.engage()
        due = OrderDue(order="In four seconds, turn left.", plan=self.turn_plan.plan)
        due.command = Command(id=uuid.uuid4().hex, stamp=rospy.Time.now() + rospy.Duration(1.0), text=TURN)
        since = len(self.replies)
        with self.unmoved():
            self.order_due.publish(due)
            time.sleep(5.0)
        reply = next(reply for reply in self.replies[since:] if reply.command.id == due.command.id)
        self.assertEqual((Reply.REFUSED, "EMERGENCY_STOP"), (reply.outcome, reply.code), reply.sentence)
        self.assertIn("As you said", reply.sentence)
        self.assert_holds()
        self.release()
        say("Forget all orders.")

    def test_07_goal_of_an_ordinary_client_is_cancelled(self) -> None:
        client = actionlib.ActionClient("moving_forward", FilledSemanticFrameAction)
        self.assertTrue(client.wait_for_server(rospy.Duration(60.0)))
        self.engage()
        elements = [FilledFrameElement("distance", "3"), FilledFrameElement("distance_unit", "metres")]
        frame = FilledSemanticFrame(
            name="moving_forward", action_server_topics=["moving_forward"], frame_elements=elements
        )
        with self.unmoved(PUSHED):
            handle = client.send_goal(FilledSemanticFrameGoal(frame=frame))
            wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE)
        self.assertIn(handle.get_terminal_state(), (GoalStatus.PREEMPTED, GoalStatus.RECALLED))
        client.stop()
        self.assert_holds()
        self.release()

    def test_08_driver_is_held_and_keeps_it_from_being_released(self) -> None:
        self.engage()
        before = self.pose
        with self.driven():
            time.sleep(WHILE_S)
            # Alone, it would have driven 0.4 m.
            self.assertLess(math.dist(before[:2], self.pose[:2]), 0.2)
            answers = [self.call("emergency_stop/release"), say(RELEASE)]
        self.assertFalse(answers[0].success)
        self.assertIn(f"{rospy.get_name()} publishes velocities on /cmd_vel", answers[0].message)
        self.assertEqual((Reply.REFUSED, "EMERGENCY_STOP"), (answers[1].outcome, answers[1].code), answers[1].sentence)
        self.assertIn(f"{rospy.get_name()} publishes velocities on /cmd_vel", answers[1].sentence)
        self.assert_holds()
        self.release()

    def test_09_other_stops_change_nothing_and_say_that_it_holds(self) -> None:
        self.engage()
        number = self.states[-1].number
        for text in ("Stop.", "Halt!", "Emergency stop.", "Cancel."):
            reply = say(text)
            self.assertEqual((Reply.DONE, "DONE"), (reply.outcome, reply.code), reply.sentence)
            self.assertIn("has held since", reply.sentence)
        self.assertTrue(self.call("emergency_stop/engage").success)
        self.assertEqual(number, self.states[-1].number)
        reply = say("Stop and turn left.")
        self.assert_refused(reply)
        self.assert_holds()
        self.release()
        self.assertIn("does not hold", say(RELEASE).sentence)
        self.assertNotIn("has held since", say("Stop.").sentence)
        self.assert_works()

    def test_10_other_programs_do_not_release_it(self) -> None:
        self.engage()
        wait_until(lambda: self.state.get_num_connections() > 2)
        self.state.publish(EmergencyStop(number=self.states[-1].number + 100, by="a program"))
        time.sleep(0.5)
        self.assert_holds()
        for text in ("Go on.", "Release the emergency stop in two seconds.", "Should I release the emergency stop?"):
            self.assert_refused(say(text))
        self.assert_holds()
        self.release()

    def test_11_bag_that_is_played_does_not_release_it(self) -> None:
        self.engage()
        number = self.states[-1].number
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "run.bag")
            with rosbag.Bag(path, "w") as bag:
                for second in range(3):
                    at = rospy.Time.now() + rospy.Duration(0.3 * second)
                    bag.write("/text", String(data=RELEASE), at)
                    bag.write("/emergency_stop/lock", Bool(data=False), at)
                    bag.write("/emergency_stop", EmergencyStop(number=number + 100), at)
                    bag.write("/command_plan", self.turn_plan, at)
            with self.unmoved():
                played = subprocess.run(
                    ["rosbag", "play", "--delay=2", "--wait-for-subscribers", path], timeout=120, check=False
                )
        self.assertEqual(0, played.returncode)
        wait_until(lambda: self.replies_to(RELEASE))
        reply = self.replies_to(RELEASE)[-1]
        self.assertEqual((Reply.REFUSED, "EMERGENCY_STOP"), (reply.outcome, reply.code), reply.sentence)
        self.assertIn("Only what a person says now", reply.sentence)
        self.assert_holds()
        self.release()

    # What dies or hangs.

    def test_12_it_survives_the_death_of_each_node(self) -> None:
        self.engage()
        number = self.states[-1].number
        for node in ("stop_server", "command_server", "executor", "semantic_framer", "stanford_parser_ros"):
            with self.subTest(node=node):
                before, hearers = self.pose, self.text.get_num_connections()
                with self.driven():
                    self.kill(node)
                # A text that is said before a hearer is connected again is lost to it.
                wait_until(lambda n=hearers: self.text.get_num_connections() >= n, message=f"{node} hears no texts")
                self.assertLess(math.dist(before[:2], self.pose[:2]), 0.5)
                self.assert_holds()
                self.assertEqual((True, number), (self.states[-1].is_engaged, self.states[-1].number))
        wait_for_pipeline(("turning", "moving_forward"))
        self.release()

    def test_13_it_survives_the_death_of_both_that_hold_it(self) -> None:
        self.engage()
        number = self.states[-1].number
        nodes = ("stop_server", "command_server", "executor")
        pids = {node: process_of(node) for node in nodes}
        for pid in pids.values():
            os.kill(pid, signal.SIGKILL)
        for node, pid in pids.items():
            self.wait_for_return(node, pid)
        # Both that hear a text were dead: what is said before one is connected is lost to all.
        wait_until(lambda: self.text.get_num_connections() > 0, message="nobody hears texts")
        self.assert_holds()
        self.assertEqual((True, number), (self.states[-1].is_engaged, self.states[-1].number))
        wait_for_pipeline(("turning", "moving_forward"))
        self.release()

    def test_14_words_engage_it_while_the_stop_server_hangs(self) -> None:
        self.begin_to_drive()
        with self.hung("stop_server"):
            reply = say("Emergency stop.")
            self.assertEqual((Reply.FAILED, "STAGE_SILENT"), (reply.outcome, reply.code), reply.sentence)
            self.assertIn("has held since", reply.sentence)
            self.assert_holds()
            reply = say(RELEASE)
            self.assertEqual((Reply.FAILED, "STAGE_SILENT"), (reply.outcome, reply.code), reply.sentence)
        # It wakes with the words and the release of before; only the words count.
        wait_until(lambda: self.states[-1].is_engaged)
        self.assert_holds()
        self.release()

    def test_15_words_engage_it_while_the_stop_server_is_dead(self) -> None:
        pid = process_of("stop_server")
        with self.hung("stop_server"):
            say("Emergency stop.")
            os.kill(pid, signal.SIGKILL)
        self.wait_for_return("stop_server", pid)
        wait_until(lambda: self.states[-1].is_engaged)
        self.assert_holds()
        self.release()

    def test_16_damaged_file_engages_it_and_says_so(self) -> None:
        path = Path(os.environ["ROS_HOME"]) / "emergency_stop.json"
        self.assertFalse(json.loads(path.read_text())["is_engaged"])
        path.write_text('{"number": ')
        self.kill("stop_server")
        wait_until(lambda: self.states[-1].is_engaged)
        # This test may have heard it before the node that refuses commands.
        wait_until(lambda: is_connected("/stop_server", "emergency_stop", "/command_server"))
        self.assertIn("cannot be read", self.states[-1].sentence)
        self.assert_holds()
        self.assertIn("cannot be read", say(TURN).sentence)
        self.release()
        self.kill("stop_server")
        time.sleep(WHILE_S)
        self.assert_works()


if __name__ == "__main__":
    import rostest

    rospy.init_node("emergency_stop_test")
    rostest.rosrun("roboframenet_tests", "emergency_stop_test", EmergencyStopTest)
