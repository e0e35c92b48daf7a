#!/usr/bin/python3
"""Sentences are published as by 'rostopic pub'; odometry shows what the robot did."""

import math
import os
import signal
import tempfile
import threading
import unittest
from typing import Dict, List

import rospy
from actionlib_msgs.msg import GoalStatus, GoalStatusArray
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from nav_msgs.msg import Odometry
from roboframenet_msgs.msg import Reply
from std_msgs.msg import String

from rfnserver import RFNServer
from roboframenet_demo.ros_pipeline import is_pipeline_complete
from roboframenet_rostest import can_do
from roboframenet_testing import wait_until
from roboframenet_testing.ros_processes import process_of
from typed_arguments import TypedArgument

PIPELINE = ("stanford_parser_ros", "semantic_framer", "frame_registrar", "arbitrator", "executor")


class FullGraphTest(unittest.TestCase):
    """One robot and one conversation; the methods run in the order of their names."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.lock = threading.Lock()
        cls.replies: List[Reply] = []
        cls.statuses: List[int] = []
        cls.waves: List[Dict[str, str]] = []
        cls.meant: List[TypedArgument] = []
        cls.bows: List[str] = []
        cls.heading = None
        cls.turned = cls.farthest_left = 0.0
        cls.position = (0.0, 0.0)
        cls.speed = 0.0
        cls.subscribers = [
            rospy.Subscriber("reply", Reply, cls.replies.append, queue_size=100),
            rospy.Subscriber("odom", Odometry, cls.on_odometry, queue_size=200),
            rospy.Subscriber("turning/status", GoalStatusArray, cls.on_status, queue_size=100),
        ]
        # The test's own queue must not drop messages of a burst.
        cls.text = rospy.Publisher("text", String, queue_size=100)
        wait_until(lambda: cls.text.get_num_connections() >= 2, message="nobody listens to 'text'")
        wait_until(is_pipeline_complete, 120.0, "the pipeline did not come up")
        assert can_do(("turning", "moving_forward", "moving_backward")), "the robot did not register"
        wait_until(lambda: cls.heading is not None, message="no odometry")
        cls.folder = tempfile.mkdtemp()

    @classmethod
    def on_odometry(cls, message: Odometry) -> None:
        heading = 2.0 * math.atan2(message.pose.pose.orientation.z, message.pose.pose.orientation.w)
        with cls.lock:
            if cls.heading is not None:
                turn = heading - cls.heading
                cls.turned += math.atan2(math.sin(turn), math.cos(turn))
                cls.farthest_left = max(cls.farthest_left, cls.turned)
            cls.heading = heading
            cls.position = (message.pose.pose.position.x, message.pose.pose.position.y)
            cls.speed = max(abs(message.twist.twist.linear.x), abs(message.twist.twist.angular.z))

    @classmethod
    def on_status(cls, message: GoalStatusArray) -> None:
        cls.statuses.extend(status.status for status in message.status_list)

    def setUp(self) -> None:
        self.wait_for_rest()

    def say(self, text: str) -> None:
        self.text.publish(String(data=text))

    def replies_to(self, text: str, since: int) -> List[Reply]:
        return [reply for reply in self.replies[since:] if reply.command.text == text]

    def say_and_wait(self, text: str, timeout_s: float = 60.0) -> Reply:
        since = len(self.replies)
        self.say(text)
        wait_until(lambda: bool(self.replies_to(text, since)), timeout_s, f"no reply to {text!r}")
        return self.replies_to(text, since)[0]

    def wait_for_rest(self) -> None:
        """Wait until the robot stands: odometry and replies arrive on separate connections."""
        wait_until(lambda: self.speed < 0.001, message="still moving")

    def wait_for_motion(self) -> None:
        wait_until(lambda: self.speed > 0.05, message="the robot does not move")

    def write(self, name: str, text: str) -> str:
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def test_00_every_node_is_well(self) -> None:
        levels: Dict[str, int] = {}

        def hear(message: DiagnosticArray) -> None:
            levels.update((status.name.partition(":")[0], status.level) for status in message.status)

        subscriber = rospy.Subscriber("/diagnostics", DiagnosticArray, hear)
        nodes = {*PIPELINE, "command_server", "stop_server", "move_action_server", "turtlebot_sim"}
        wait_until(lambda: nodes <= {name for name, level in levels.items() if level == DiagnosticStatus.OK})
        subscriber.unregister()

    def test_01_turns_by_what_was_said(self) -> None:
        for text, expected in (("Turn left 120 degrees.", math.radians(120)), ("Turn right 2 radians.", -2.0)):
            start = self.turned
            reply = self.say_and_wait(text)
            self.assertEqual(reply.outcome, Reply.DONE, reply.sentence)
            self.wait_for_rest()
            self.assertLessEqual(abs(self.turned - start - expected), 0.02 * abs(expected))

    def test_02_moves_by_what_was_said(self) -> None:
        for text, expected in (("Move forward 3 feet.", 0.9144), ("move backwards one metre", -1.0)):
            x, y = self.position
            heading = self.heading
            reply = self.say_and_wait(text)
            self.assertEqual(reply.outcome, Reply.DONE, reply.sentence)
            self.wait_for_rest()
            moved = (self.position[0] - x) * math.cos(heading) + (self.position[1] - y) * math.sin(heading)
            self.assertLessEqual(abs(moved - expected), 0.02 * abs(expected))

    def test_03_refuses_what_it_does_not_understand(self) -> None:
        position = self.position
        for text in (
            "Colorless green ideas sleep furiously.",
            "",
            "Move forward 3 kilometres.",
            "Turn left 1e400 degrees.",
        ):
            reply = self.say_and_wait(text)
            self.assertEqual(reply.outcome, Reply.REFUSED, f"{text!r}: {reply.sentence}")
            self.assertTrue(reply.sentence)
        self.assertEqual(position, self.position)

    def test_04_new_command_preempts_the_running_one(self) -> None:
        since = len(self.replies)
        del self.statuses[:]
        self.say("Turn left 6 radians.")
        self.wait_for_motion()
        with self.lock:
            type(self).farthest_left = self.turned
        reply = self.say_and_wait("Turn right 1 radian.")
        self.assertEqual(reply.outcome, Reply.DONE, reply.sentence)
        wait_until(lambda: bool(self.replies_to("Turn left 6 radians.", since)))
        self.assertEqual(self.replies_to("Turn left 6 radians.", since)[0].outcome, Reply.SUPERSEDED)
        wait_until(lambda: GoalStatus.PREEMPTED in self.statuses)
        self.wait_for_rest()
        self.assertLess(self.turned, self.farthest_left - 0.95)

    def test_05_stop_in_mid_motion(self) -> None:
        since = len(self.replies)
        self.say("Move forward 10 metres.")
        self.wait_for_motion()
        self.assertEqual(self.say_and_wait("Stop.").outcome, Reply.DONE)
        self.wait_for_rest()
        wait_until(lambda: bool(self.replies_to("Move forward 10 metres.", since)))
        self.assertEqual(self.replies_to("Move forward 10 metres.", since)[0].outcome, Reply.SUPERSEDED)

    def test_06_ability_added_while_everything_runs(self) -> None:
        server = RFNServer(
            "test_waving",
            lambda frame: (
                self.waves.append({e.name: e.argument for e in frame.frame_elements}),
                self.meant.append(frame["addressee"]),
            ),
            heeds={"Manner": ["happy"]},
        )
        self.assertTrue(
            server.add_semantic_frame(
                self.write(
                    "waving.yaml",
                    (
                        "name: waving\ndescription: The robot waves at somebody.\n"
                        "frame_elements:\n  - name: addressee\n    is_core: True\n"
                    ),
                )
            )
        )
        self.assertTrue(
            server.add_lexical_unit(
                self.write(
                    "waving_unit.yaml",
                    (
                        "frame_name: waving\nverb: wave\nframe_element_grammatical_relations:\n"
                        "  - name: addressee\n    relation: prep_at\n"
                    ),
                )
            )
        )
        self.assertTrue(server.register_with_frame("waving"))
        server.start()
        reply = self.say_and_wait("Wave at Alice.")
        self.assertEqual(reply.outcome, Reply.DONE, reply.sentence)
        self.assertEqual(self.waves, [{"addressee": "Alice"}])
        reply = self.say_and_wait("Wave at Alice's two red boxes under the table.")
        self.assertEqual(reply.outcome, Reply.DONE, reply.sentence)
        meant = self.meant[-1]
        self.assertEqual(
            (meant.text, meant.words, meant.relation),
            ("boxes", "at Alice's two red boxes under the table", "at"),
        )
        self.assertEqual((meant.head, meant.count, meant.possessor.text), ("boxes", 2, "Alice"))
        self.assertEqual([modifier.word for modifier in meant.modifiers], ["red"])
        (place,) = meant.frames[0].frame_elements
        self.assertEqual((meant.frames[0].frame_name, place.relation), ("being_located", "under"))
        reply = self.say_and_wait("Wave at Alice happily.")
        self.assertEqual(reply.outcome, Reply.DONE, reply.sentence)
        self.assertEqual(self.waves[-1], {"addressee": "Alice", "manner": "happily"})
        reply = self.say_and_wait("Wave at Alice slowly.")
        self.assertEqual((reply.outcome, reply.code), (Reply.NEEDS_INFORMATION, "LEFT_OVER_WORDS"), reply.sentence)
        self.assertIn('"slowly"', reply.sentence)
        self.assertEqual(len(self.waves), 3)

    def test_07_second_server_of_a_frame_runs_when_the_first_fails(self) -> None:
        ran = self.bows
        servers = []

        def make(name: str, is_failing: bool) -> None:
            def callback(_frame: object) -> None:
                ran.append(name)
                if is_failing:
                    server.set_aborted(None, "cannot do it")

            server = RFNServer(name, callback)
            servers.append(server)
            if not is_failing:
                self.assertTrue(
                    server.add_semantic_frame(self.write("bowing.yaml", "name: bowing\ndescription: Bow.\n"))
                )
                self.assertTrue(
                    server.add_lexical_unit(self.write("bowing_unit.yaml", "frame_name: bowing\nverb: bow\n"))
                )
            self.assertTrue(server.register_with_frame("bowing"))
            server.start()

        make("test_bowing_well", False)
        make("test_bowing_badly", True)
        # The order is random. The command succeeds in either order, and a few tries show both.
        for _ in range(12):
            reply = self.say_and_wait("Bow.")
            self.assertEqual(reply.outcome, Reply.DONE, reply.sentence)
            self.assertEqual(ran[-1], "test_bowing_well")
            if "test_bowing_badly" in ran:
                break
        self.assertIn("test_bowing_badly", ran)

    def test_08_clause_that_was_done_is_not_done_again(self) -> None:
        # "Bow." has two servers by now, one of which fails; lots decide which is tried first.
        text = "Wave at Alice, then bow."
        for _ in range(12):
            del self.waves[:]
            bows = len(self.bows)
            reply = self.say_and_wait(text)
            self.assertEqual(reply.outcome, Reply.DONE, reply.sentence)
            self.assertEqual(self.waves, [{"addressee": "Alice"}])
            if len(self.bows) == bows + 2:
                break
        self.assertEqual(self.bows[bows:], ["test_bowing_badly", "test_bowing_well"])

    def test_09_each_sentence_of_a_burst_gets_one_reply(self) -> None:
        since = len(self.replies)
        texts = [f"Fly to planet {number}." for number in range(20)]
        for text in texts:
            self.say(text)
        wait_until(lambda: len(self.replies) - since >= len(texts), 60.0)
        self.assertEqual(sorted(reply.command.text for reply in self.replies[since:]), sorted(texts))

    def test_99_stop_works_while_the_whole_pipeline_is_dead(self) -> None:
        self.say("Move forward 10 metres.")
        self.wait_for_motion()
        # With ``compact``, all of them but the parser are one process, with the command server.
        for name in ("stanford_parser_ros", "stages") if rospy.get_param("~compact", False) else PIPELINE:
            os.kill(process_of(name), signal.SIGKILL)
        self.assertEqual(self.say_and_wait("Stop.").outcome, Reply.DONE)
        self.wait_for_rest()


if __name__ == "__main__":
    import rostest

    rospy.init_node("full_graph_test")
    rostest.rosrun("roboframenet_tests", "full_graph", FullGraphTest)
