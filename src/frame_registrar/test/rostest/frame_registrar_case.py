"""Sends commands, registrations and files to the registrar, for tests by subject."""

import os
import signal
import tempfile
import unittest
from typing import List, Optional
from xmlrpc.client import ServerProxy

import rosgraph
import rospy
from actionlib_msgs.msg import GoalStatusArray
from roboframenet_msgs.msg import (
    Clause,
    Command,
    CommandLexicalUnits,
    CommandSemanticFrames,
    FileProblems,
    FilledFrameElement,
    FilledLexicalUnit,
    FilledSemanticFrameListList,
    FrameCatalogue,
    FrameServers,
    LexicalUnitReading,
    Plan,
    PlanNode,
    StageEvent,
)
from roboframenet_msgs.srv import AddFrame, RegisterWithFrame

from roboframenet_testing import wait_until


class FrameRegistrarCase(unittest.TestCase):
    """A registrar that may be killed, two action servers that stay and one that is killed."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.candidates: List[CommandSemanticFrames] = []
        cls.candidates_2012: List[FilledSemanticFrameListList] = []
        cls.events: List[StageEvent] = []
        cls.catalogues: List[FrameCatalogue] = []
        cls.known: Optional[FrameServers] = None
        cls.problems: Optional[FileProblems] = None
        cls.number = 0
        cls.folder = tempfile.mkdtemp()
        cls.subscribers = [
            rospy.Subscriber("command_semantic_frames", CommandSemanticFrames, cls.candidates.append, queue_size=10),
            rospy.Subscriber(
                "filled_semantic_frames", FilledSemanticFrameListList, cls.candidates_2012.append, queue_size=10
            ),
            rospy.Subscriber("stage_events", StageEvent, cls.events.append, queue_size=10),
            rospy.Subscriber("frame_catalogue", FrameCatalogue, cls.catalogues.append),
            rospy.Subscriber("frame_servers", FrameServers, lambda message: setattr(cls, "known", message)),
            rospy.Subscriber("file_problems", FileProblems, lambda message: setattr(cls, "problems", message)),
        ]
        cls.units = rospy.Publisher("command_lexical_units", CommandLexicalUnits, queue_size=10)
        for server in ("steady", "second", "mortal"):
            rospy.wait_for_message(f"{server}/status", GoalStatusArray, timeout=60.0)

    def setUp(self) -> None:
        wait_until(self.is_connected, message="the registrar is not there")

    def is_connected(self) -> bool:
        """Whether commands reach the registrar, and all that it says comes back."""
        return (
            self.units.get_num_connections() > 0
            and self.catalogues
            and self.known is not None
            and all(subscriber.get_num_connections() > 0 for subscriber in self.subscribers)
        )

    def call(self, name: str, service_type: type, *arguments: str) -> object:
        rospy.wait_for_service(name, timeout=60.0)
        return rospy.ServiceProxy(name, service_type)(*arguments)

    def add_frame(self, name: str, text: str) -> bool:
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return self.call("add_frame", AddFrame, path).success

    def register(self, frame: str, server: str) -> None:
        answer = self.call("register_with_frame", RegisterWithFrame, frame, server)
        self.assertTrue(answer.success, answer.error)

    def clause(self, frame: str, words: str = "", **arguments: str) -> Clause:
        elements = [FilledFrameElement(name=name, argument=argument) for name, argument in arguments.items()]
        unit = FilledLexicalUnit(frame_name=frame, verb="do", frame_elements=elements)
        return Clause(words=words, readings=[LexicalUnitReading(lexical_unit=unit, coverage=1.0)])

    def command(self, frame: str, **arguments: str) -> object:
        """Send a command of one clause; return its candidates, or its final event."""
        return self.send([self.clause(frame, **arguments)])

    def send(self, clauses: List[Clause], plan: Optional[Plan] = None) -> object:
        """Send a command; return its candidates, or its final event."""
        type(self).number += 1
        command_id = f"command_{self.number}"
        command = Command(id=command_id, text="do it")
        self.units.publish(CommandLexicalUnits(command=command, clauses=clauses, plan=plan or Plan()))
        answers: List[object] = []

        def is_answered() -> bool:
            answers[:] = [message for message in list(self.candidates) if message.command.id == command_id]
            answers.extend(event for event in list(self.events) if event.command.id == command_id and event.is_final)
            return bool(answers)

        wait_until(is_answered, message=f"no answer to {command_id}")
        self.assertEqual(len(answers), 1)
        return answers[0]

    def servers(self, frame: str, **arguments: str) -> List[List[str]]:
        """Servers of each candidate for a command; a refusal has none."""
        answer = self.command(frame, **arguments)
        if isinstance(answer, StageEvent):
            return []
        (node,) = answer.plan.nodes
        self.assertEqual((node.kind, node.label, list(node.children)), (PlanNode.DO, "do it", []))
        return self.servers_of(node)

    def servers_of(self, node: PlanNode) -> List[List[str]]:
        for candidate in node.candidates:
            for filled in candidate.frames:
                self.assertEqual(len(filled.action_server_topics), 1)
        return [[filled.action_server_topics[0] for filled in candidate.frames] for candidate in node.candidates]

    def is_alive(self, server: str) -> Optional[bool]:
        """What the registrar tells of a server, None for one that it does not have."""
        callbacks = self.known.callbacks
        return next((callback.is_alive for callback in callbacks if callback.callback_topic == server), None)

    def kill(self, node: str) -> None:
        """Kill a node the hard way."""
        uri = rosgraph.Master(rospy.get_name()).lookupNode(rospy.resolve_name(node))
        os.kill(ServerProxy(uri).getPid(rospy.get_name())[2], signal.SIGKILL)
