#!/usr/bin/python3
"""Wrong files are refused by file, line and key; killed nodes come back with everything that they knew."""

import os
import random
import signal
import tempfile
import unittest
from typing import List, Optional

import rosgraph
import rospy
from roboframenet_msgs.msg import FileProblem, FileProblems, Reply
from roboframenet_msgs.srv import AddFrame, AddLexicalUnit, GetEmptyFrame
from rosgraph_msgs.msg import Log
from std_msgs.msg import String

from roboframenet_demo.ros_pipeline import is_pipeline_complete
from roboframenet_rostest import can_do
from roboframenet_testing import comes_true, wait_until
from roboframenet_testing.ros_processes import process_of

NODES = ("frame_registrar", "semantic_framer", "greeting_server")
#: With ``compact``, these run in one process.
STAGES = ("command_server", "frame_registrar", "semantic_framer")


class FaultsTest(unittest.TestCase):
    """The pipeline and a server that may be killed; no server can move the robot."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.replies: List[Reply] = []
        cls.problems: List[FileProblem] = []
        cls.bad_callbacks: List[str] = []
        cls.subscribers = [
            rospy.Subscriber("reply", Reply, cls.replies.append, queue_size=100),
            rospy.Subscriber(
                "file_problems", FileProblems, lambda message: cls.problems.extend(message.problems), queue_size=10
            ),
        ]
        cls.subscribers.append(rospy.Subscriber("/rosout", Log, cls.on_log, queue_size=1000))
        cls.text = rospy.Publisher("text", String, queue_size=10)
        wait_until(lambda: cls.text.get_num_connections() >= 2, message="nobody listens to 'text'")
        wait_until(is_pipeline_complete, 120.0, "the pipeline did not come up")
        cls.folder = tempfile.mkdtemp()
        rospy.wait_for_service("add_frame", timeout=60.0)
        rospy.wait_for_service("add_lexical_unit", timeout=60.0)
        assert can_do(("greeting",), unit_files=("unit.yaml",)), "the server did not register"

    @classmethod
    def on_log(cls, message: Log) -> None:
        if "bad callback" in message.msg:
            cls.bad_callbacks.append(message.msg)

    def say(self, text: str, timeout_s: float = 60.0) -> Optional[Reply]:
        """Say a sentence; return its reply."""
        since = len(self.replies)
        self.text.publish(String(data=text))
        comes_true(lambda: any(reply.command.text == text for reply in self.replies[since:]), timeout_s)
        return next((reply for reply in self.replies[since:] if reply.command.text == text), None)

    def write(self, name: str, text: str) -> str:
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def pid(self, node: str) -> int:
        """Return the process id of a node, 0 while it does not run."""
        try:
            return process_of(node)
        except (OSError, rosgraph.MasterException):
            return 0

    def node_of(self, stage: str) -> str:
        """Return the node in which a stage runs."""
        return "stages" if stage in STAGES and rospy.get_param("~compact") else stage

    def kill(self, node: str) -> int:
        """Kill a node with SIGKILL; return its process id."""
        wait_until(lambda: self.pid(node) != 0, message=f"{node} is not there")
        pid = self.pid(node)
        os.kill(pid, signal.SIGKILL)
        return pid

    def test_1_wrong_files_are_refused_by_file_line_and_key(self) -> None:
        add_frame = rospy.ServiceProxy("add_frame", AddFrame)
        add_unit = rospy.ServiceProxy("add_lexical_unit", AddLexicalUnit)
        self.assertTrue(
            add_frame(
                absolute_file_path=self.write("circle.yaml", "name: circle_a\nchildren:\n  - name: circle_b\n")
            ).success
        )
        cases = [
            (add_frame, "mistyped.yaml", "name: x\ndescripton: y\n", "UNKNOWN_KEY", 2, "descripton"),
            (add_frame, "duplicate.yaml", "name: x\nname: y\n", "DUPLICATE_KEY", 2, "name"),
            (
                add_unit,
                "relation.yaml",
                (
                    "frame_name: turning\nverb: whirl\nframe_element_grammatical_relations:\n"
                    "  - name: angle\n    relation: dirobj\n"
                ),
                "UNKNOWN_RELATION",
                5,
                "frame_element_grammatical_relations[0].relation",
            ),
            (add_frame, "cycle.yaml", "name: circle_b\nchildren:\n  - name: circle_a\n", "CYCLE", 3, "children"),
        ]
        for service, name, text, code, line, key in cases:
            path = self.write(name, text)
            self.assertFalse(service(absolute_file_path=path).success, name)
            wait_until(lambda path=path: any(problem.path == path for problem in self.problems), message=name)
            problem = next(problem for problem in self.problems if problem.path == path)
            self.assertEqual((problem.code, problem.line, problem.key), (code, line, key))
            self.assertTrue(problem.expected)
        self.assertEqual(rospy.ServiceProxy("get_empty_frame", GetEmptyFrame)("circle_b").frame.name, "")
        reply = self.say("Greet.")
        self.assertIsNotNone(reply)
        self.assertEqual(reply.outcome, Reply.DONE, reply.sentence)

    def test_2_killed_nodes_come_back_with_all_that_they_knew(self) -> None:
        orders = rospy.get_param("~orders")
        seed = random.SystemRandom().randrange(10**6)
        print(f"seed of the orders: {seed}")
        chance = random.Random(seed)
        for number in range(orders):
            victims = sorted({self.node_of(node) for node in chance.sample(NODES, chance.randint(1, len(NODES)))})
            killed = {node: self.kill(node) for node in victims}
            wait_until(
                lambda killed=killed: all(self.pid(node) not in (0, old) for node, old in killed.items()),
                message=f"{victims} do not return",
            )
            replies: List[Optional[Reply]] = []

            def is_greeting_done(replies: List[Optional[Reply]] = replies) -> bool:
                replies.append(self.say("Greet.", timeout_s=3.0))
                return replies[-1] is not None and replies[-1].outcome == Reply.DONE

            wait_until(is_greeting_done, 90.0, f"not done after {victims} (order {number}, seed {seed})")

    def test_3_command_of_a_killed_stage_gets_one_reply(self) -> None:
        taken: List[str] = []
        subscriber = rospy.Subscriber("text_taken", String, lambda message: taken.append(message.data.split(" ", 2)[2]))

        def is_greeting_taken_and_done() -> bool:
            del taken[:]
            return getattr(self.say("Greet.", 3.0), "outcome", -1) == Reply.DONE and "Greet." in taken

        # A connection to a command server that was killed counts for a while; only what it tells shows that it is new.
        wait_until(is_greeting_taken_and_done, 90.0)
        for stage in STAGES:
            node = self.node_of(stage)
            # Nobody else says that, so every reply to it is counted. It takes a second, so its stage dies first.
            text = f"Greet the victim {stage}."
            old = self.pid(node)
            self.text.publish(String(data=text))
            wait_until(lambda text=text: text in taken, message=f"{text!r} was not taken")
            os.kill(old, signal.SIGKILL)
            wait_until(
                lambda text=text: any(reply.command.text == text for reply in self.replies),
                90.0,
                f"no reply to {text!r}",
            )
            wait_until(lambda node=node, old=old: self.pid(node) not in (0, old), message=f"{node} does not return")
            wait_until(is_pipeline_complete, 120.0, "the pipeline did not come back")
            wait_until(is_greeting_taken_and_done, 90.0)
            self.assertEqual([text], [reply.command.text for reply in self.replies if reply.command.text == text])
        subscriber.unregister()
        self.assertEqual([], self.bad_callbacks)


if __name__ == "__main__":
    import rostest

    rospy.init_node("faults_test")
    rostest.rosrun("roboframenet_tests", "faults", FaultsTest)
