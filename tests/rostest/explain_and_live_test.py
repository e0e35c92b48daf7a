#!/usr/bin/python3
"""``rfn explain`` agrees with the nodes of the running graph, rule by rule."""

import random
import sys
import threading
import unittest
from pathlib import Path
from typing import Dict, List

import rospy
from roboframenet_msgs.msg import CommandPlan, CommandSemanticFrames, FrameServers, PlanNode, Reply, StageEvent
from std_msgs.msg import String

from offline_pipeline.pipeline import Pipeline, Understanding
from rfnserver import RFNServer
from roboframenet_demo.ros_pipeline import is_pipeline_complete
from roboframenet_testing import comes_true, wait_until
from roboframenet_tools.ros_graph import live_knowledge, live_parameters
from semantic_framer.values.dialogue import Context

sys.path.insert(0, str(Path(__file__).resolve().parent))

SEED = 20120514
#: One frame in this many has no server, so that some commands find none.
WITHOUT_A_SERVER = 7
ODD = Path(__file__).resolve().parent / "odd_sentences.txt"
OUTCOMES = {
    Reply.DONE: "DONE",
    Reply.FAILED: "FAILED",
    Reply.REFUSED: "REFUSED",
    Reply.NEEDS_INFORMATION: "NEEDS_INFORMATION",
    Reply.SUPERSEDED: "SUPERSEDED",
}

#: Stages that write a trace.
STAGES = ("stanford_parser_ros", "semantic_framer")


class Ears:
    """Records what the graph publishes about each command."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self.replies: List[Reply] = []
        self.candidates: Dict[str, CommandSemanticFrames] = {}
        self.traces: Dict[str, Dict[str, List[str]]] = {}
        self.subscribers = [
            rospy.Subscriber("reply", Reply, self.replies.append),
            rospy.Subscriber("command_semantic_frames", CommandSemanticFrames, self._on_candidates),
            rospy.Subscriber("command_question", CommandPlan, self._on_candidates),
            rospy.Subscriber("stage_events", StageEvent, self._on_event),
        ]

    def _on_candidates(self, message: CommandSemanticFrames) -> None:
        self.candidates[message.command.id] = message

    def _on_event(self, event: StageEvent) -> None:
        if event.stage in STAGES:
            with self._lock:
                by_stage = self.traces.setdefault(event.command.id, {})
                by_stage.setdefault(event.stage, []).extend(event.trace.splitlines())

    def trace(self, command: str) -> List[str]:
        """Return the lines of a command in the order of the stages: their events come on separate connections."""
        with self._lock:
            by_stage = self.traces.get(command, {})
            return [line for stage in STAGES for line in by_stage.get(stage, [])]


#: The stop server carries out the first, which takes the minute that was said. Who gives a name is known to the robot
#: from then on; offline, there is no world.
LEFT_OUT = ("waiting", "being_named")


class ExplainAndLiveTest(unittest.TestCase):
    """The same sentences, explained offline and said to the running graph."""

    maxDiff = None

    def test_the_reply_and_the_rules_are_the_same(self) -> None:
        wait_until(is_pipeline_complete, 180.0, "the pipeline did not come up")
        ears = Ears()
        text = rospy.Publisher("text", String, queue_size=10)
        known: List[FrameServers] = []
        subscriber = rospy.Subscriber("frame_servers", FrameServers, known.append)
        wait_until(lambda: bool(known and known[-1].paths), 120.0, "no frames")
        server = RFNServer("obeying", lambda frame: None)
        knowledge = live_knowledge(timeout_s=60.0)
        frames = [name for number, name in enumerate(sorted(knowledge.frames)) if number % WITHOUT_A_SERVER]
        for name in frames:
            self.assertTrue(server.register_with_frame(name), name)
        server.start()
        wait_until(
            # One that is not alive yet counts for the nodes, but not for what is read from them below.
            lambda: (
                {callback.frame_name for callback in known[-1].callbacks} >= set(frames)
                and all(callback.is_alive for callback in known[-1].callbacks)
            ),
            message="not every registration arrived, or not every server is alive",
        )
        subscriber.unregister()
        everybody = [text] + ears.subscribers
        # Two nodes subscribe to the text: command_server and stop_server.
        wait_until(lambda: all(end.get_num_connections() for end in everybody) and text.get_num_connections() > 1)
        knowledge = live_knowledge(timeout_s=60.0)
        pipeline = Pipeline(knowledge, parameters=live_parameters(), is_traced=True)
        said = sentences([example.text for unit in knowledge.lexicon.units for example in unit.examples])
        print(f"seed {SEED}, {len(said)} sentences")
        context = Context()
        different = []
        for sentence in said:
            understanding = pipeline.understand(sentence, context)
            if any(reading.unit.frame_name in LEFT_OUT for reading in understanding.readings):
                continue
            context = understanding.context
            count = len(ears.replies)
            text.publish(sentence)
            wait_until(lambda before=count: len(ears.replies) > before, message=f"no reply to {sentence!r}")
            reply = ears.replies[count]
            offline = (understanding.reply.outcome, understanding.reply.code) + expected(understanding)
            # Events and candidates arrive on other connections than the reply.
            if not comes_true(lambda reply=reply, offline=offline: heard(ears, reply) == offline, 5.0):
                live = heard(ears, reply)
                different.append(f"{sentence!r}\n  live    {live}\n  offline {offline}")
        self.assertEqual(different, [])


def heard(ears: Ears, reply: Reply) -> tuple:
    """Return outcome and code, the sentence of a refusal, the candidates of a command that was done, and the rules."""
    nodes = ears.candidates[reply.command.id].plan.nodes if reply.command.id in ears.candidates else ()
    clauses = [
        [
            [
                (frame.name, [(element.name, element.argument) for element in frame.frame_elements])
                for frame in candidate.frames
            ]
            for candidate in node.candidates
        ]
        for node in nodes
        if node.kind == PlanNode.DO
    ]
    sentence = "" if reply.outcome == Reply.DONE else reply.sentence
    return OUTCOMES[reply.outcome], reply.code, sentence, clauses, ears.trace(reply.command.id)


def expected(understanding: Understanding) -> tuple:
    """Return the sentence of a refusal, the candidates and the rules of the offline pipeline."""
    clauses = [
        [[(frame.name, list(frame.texts)) for frame in candidate.frames] for candidate in candidates]
        for candidates in understanding.candidates
    ]
    sentence = "" if understanding.reply.outcome == "DONE" else understanding.reply.sentence
    # The rest is said by other nodes than the two that report their rules.
    trace = [str(line) for line in understanding.trace if line.rule not in ("registrar", "stop_words")]
    return sentence, clauses, trace


def sentences(examples: List[str]) -> List[str]:
    """Return odd sentences, examples of the units and the table of commands: always the same sample."""
    table = Path(rospy.get_param("~commands")).read_text(encoding="utf-8").splitlines()
    commands = [line.split("\t")[0] for line in table if line and not line.startswith("#")]
    odd = ODD.read_text(encoding="utf-8").split("\n")
    drawing = random.Random(SEED)
    others = sorted(set(examples + commands) - set(odd))
    count = int(rospy.get_param("~count"))
    found = odd if count >= 2 * len(odd) else drawing.sample(odd, count // 2)
    return found + drawing.sample(others, min(len(others), count - len(found)))


if __name__ == "__main__":
    import rostest

    rospy.init_node("explain_and_live_test")
    rostest.rosrun("roboframenet_tests", "explain_and_live", ExplainAndLiveTest)
