#!/usr/bin/python3
"""The node: its services, a command in and candidates out, files that are wrong, and what is killed."""

import os
import signal
import tempfile
import threading
import unittest
from typing import List, Optional
from xmlrpc.client import ServerProxy

import actionlib
import rosgraph
import rospy
from actionlib.msg import TestAction
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
    Reply,
    StageEvent,
)
from roboframenet_msgs.msg import (
    ServerProfile as ServerProfileMessage,
)
from roboframenet_msgs.srv import AddFrame, GetEmptyFrame, RegisterServer, RegisterWithFrame

from roboframenet_testing import wait_until
from semantic_frames.ros_server_profile import profile_from_message, profile_to_message
from semantic_frames.server_profile import AS_IN_2012, ServerProfile
from semantic_frames.server_statement import stated_profile
from typed_arguments import TypedArgument
from typed_arguments.ros_messages import to_message


class FrameRegistrarTest(unittest.TestCase):
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

    def test_services_and_a_command_that_a_child_carries_out(self) -> None:
        frame = self.call("get_empty_frame", GetEmptyFrame, "moving").frame
        self.assertEqual(
            [(element.name, element.is_core, element.default) for element in frame.frame_elements],
            [("direction", True, "forward"), ("distance", True, "")],
        )
        self.assertEqual(self.call("get_empty_frame", GetEmptyFrame, "no_such_frame").frame.name, "")
        for server in ("steady", "second", "steady"):
            self.register("moving_forward", server)
        self.assertEqual(self.servers("moving", distance="3 feet"), [["steady"], ["second"]])

        def arguments_2012() -> List[str]:
            frames = [message.frame_lists[0].frames[0] for message in list(self.candidates_2012)]
            return [frame.frame_elements[0].argument for frame in frames if frame.name == "moving_forward"]

        wait_until(lambda: arguments_2012() == ["3 feet"], message=arguments_2012)
        wait_until(lambda: self.is_alive("second") is True)

    def test_plan_with_another_number_of_clauses_is_refused(self) -> None:
        self.assertTrue(self.add_frame("ringing.yaml", "name: ringing\n"))
        self.register("ringing", "steady")
        plan = Plan(nodes=[PlanNode(kind=PlanNode.REPEAT, children=[1], count=2, most=2), PlanNode(kind=PlanNode.DO)])
        event = self.send([self.clause("ringing", "ring"), self.clause("ringing", "ring")], plan)
        self.assertIsInstance(event, StageEvent)
        self.assertEqual((event.reply.outcome, event.reply.code), (Reply.FAILED, "STAGE_ERROR"))
        self.assertIn("the plan joins 1 clauses, and the command has 2", event.reply.sentence)

    def test_clauses_of_a_plan_get_their_candidates(self) -> None:
        self.assertTrue(self.add_frame("ringing.yaml", "name: ringing\n"))
        self.register("ringing", "steady")
        plan = Plan(nodes=[PlanNode(kind=PlanNode.REPEAT, children=[1], count=2, most=2), PlanNode(kind=PlanNode.DO)])
        message = self.send([self.clause("ringing", "ring")], plan)
        repeat, do = message.plan.nodes
        self.assertEqual((repeat.kind, repeat.count, list(repeat.children)), (PlanNode.REPEAT, 2, [1]))
        self.assertEqual(do.candidates[0].frames[0].action_server_topics, ["steady"])

    def test_condition_gets_the_servers_that_watch_and_nothing_moves_without(self) -> None:
        for name in ("rattling", "fleeing"):
            self.assertTrue(self.add_frame(f"{name}.yaml", f"name: {name}\nframe_elements: [{{name: theme}}]\n"))
            self.register(name, "steady")
        plan = Plan(
            nodes=[
                PlanNode(kind=PlanNode.UNTIL, children=[1, 2]),
                PlanNode(kind=PlanNode.CONDITION, trigger=PlanNode.BEGINS, is_negated=True),
                PlanNode(kind=PlanNode.DO, limit=rospy.Duration(9)),
            ]
        )
        clauses = [self.clause("rattling", "it rattles", theme="the lid"), self.clause("fleeing", "flee")]
        event = self.send(clauses, plan)
        self.assertEqual((event.reply.outcome, event.reply.code), (Reply.REFUSED, "NO_SERVER"))
        self.assertIn('whether "it rattles": no server watches "rattling"', event.reply.sentence)

        profile = ServerProfileMessage(purpose=ServerProfileMessage.WATCHES)
        self.assertTrue(self.call("register_server", RegisterServer, "rattling", "second", profile).success)
        until, condition, do = self.send(clauses, plan).plan.nodes
        self.assertEqual((until.kind, list(until.children)), (PlanNode.UNTIL, [1, 2]))
        self.assertEqual((condition.kind, condition.label), (PlanNode.CONDITION, "it rattles"))
        self.assertEqual((condition.trigger, condition.is_negated), (PlanNode.BEGINS, True))
        self.assertEqual((self.servers_of(condition), self.servers_of(do)), ([["second"]], [["steady"]]))
        self.assertEqual(do.limit, rospy.Duration(9))

        members = (TypedArgument(text="the lid"), TypedArgument(text="the pan"))
        listed = TypedArgument("theme", "the lid or the pan", members=members, conjunction="or")
        clauses[0].readings[0].arguments = [to_message(listed)]
        clauses[0].readings[0].lexical_unit.frame_elements[0].argument = listed.text
        nodes = self.send(clauses, plan).plan.nodes
        self.assertEqual((nodes[1].kind, list(nodes[1].children)), (PlanNode.ANY, [3, 4]))
        self.assertEqual((nodes[1].trigger, nodes[1].is_negated), (PlanNode.BEGINS, True))
        texts = [node.candidates[0].frames[0].frame_elements[0].argument for node in nodes[3:]]
        self.assertEqual(texts, ["the lid", "the pan"])

    def test_each_clause_of_a_command_has_its_own_candidates(self) -> None:
        for name in ("nodding", "humming"):
            self.assertTrue(self.add_frame(f"{name}.yaml", f"name: {name}\n"))
        for frame, server in (("nodding", "steady"), ("humming", "steady"), ("humming", "second")):
            self.register(frame, server)
        clauses = [self.clause("nodding", "nod"), self.clause("humming", "hum a tune")]
        nodes = self.send(clauses).plan.nodes
        self.assertEqual([node.kind for node in nodes], [PlanNode.SEQUENCE, PlanNode.DO, PlanNode.DO])
        self.assertEqual([node.label for node in nodes], ["do it", "nod", "hum a tune"])
        self.assertEqual([list(node.children) for node in nodes], [[1, 2], [], []])
        self.assertEqual([self.servers_of(node) for node in nodes], [[], [["steady"]], [["steady"], ["second"]]])

        def told_in_2012() -> List[List[str]]:
            sequences = [frames for message in list(self.candidates_2012) for frames in message.frame_lists]
            servers = [[frame.action_server_topics[0] for frame in frames.frames] for frames in sequences]
            return [names for names in servers if len(names) == 2]

        wait_until(lambda: told_in_2012() == [["steady", "steady"], ["steady", "second"]])

    def test_refusal_tells_the_limit(self) -> None:
        event = self.command("moving", distance="3 miles")
        self.assertEqual((event.reply.outcome, event.reply.code), (Reply.REFUSED, "LIMIT"))
        self.assertIn("20 metres", event.reply.sentence)

    def test_missing_element_is_a_question(self) -> None:
        event = self.command("moving")
        self.assertEqual((event.reply.outcome, event.reply.code), (Reply.NEEDS_INFORMATION, "MISSING_ELEMENT"))

    def test_question_that_no_node_answers_is_refused(self) -> None:
        self.assertTrue(self.add_frame("asking.yaml", "name: asking\nis_question: True\nframe_elements: []\n"))
        self.register("asking", "steady")
        rospy.sleep(6.0)  # Until then the node might still start.
        event = self.command("asking")
        self.assertEqual((event.reply.outcome, event.reply.code), (Reply.REFUSED, "QUESTION"))
        self.assertIn("do it", event.reply.sentence)

    def test_command_without_clauses_is_answered(self) -> None:
        self.units.publish(CommandLexicalUnits(command=Command(id="empty")))
        wait_until(lambda: any(event.command.id == "empty" for event in list(self.events)))
        event = next(event for event in self.events if event.command.id == "empty")
        self.assertEqual((event.is_final, event.reply.code), (True, "NO_READING"))

    def test_registration_that_makes_no_sense_is_refused_with_a_reason(self) -> None:
        for frame, server in (
            ("", "steady"),
            ("moving", ""),
            ("moving", "two words"),
            ("moving", "~private"),
            ("moving", "/"),
            ("moving", "two\nlines"),
            ("moving", "s" * 100_000),
            ("m" * 1_000_000, "steady"),
            ("two\nlines", "steady"),
        ):
            answer = self.call("register_with_frame", RegisterWithFrame, frame, server)
            self.assertFalse(answer.success)
            self.assertTrue(answer.error and answer.error[0])
            self.assertLess(len(answer.error[0]), 300)

    def test_profile_is_told_and_a_wrong_one_is_refused(self) -> None:
        self.assertTrue(
            self.add_frame("putting.yaml", "name: putting\nframe_elements: [{name: goal, is_core: true}]\n")
        )
        wait_until(lambda: any(file.path.endswith("putting.yaml") for file in self.catalogues[-1].files))
        stated = stated_profile({"heeds": {"Manner": ["slow"], "goal": {"relations": ["on"]}}, "occupies": ["arms"]})
        catalogue_count = len(self.catalogues)
        answer = self.call("register_server", RegisterServer, "putting", "steady", profile_to_message(stated))
        self.assertEqual((answer.success, list(answer.error)), (True, []))

        def profiles() -> List[ServerProfile]:
            callbacks = [each for each in self.known.callbacks if each.frame_name == "putting"]
            return [profile_from_message(callback.profile) for callback in callbacks]

        wait_until(lambda: profiles() == [stated], message=profiles)
        # The texts of the files have not changed, and are not sent again.
        self.assertEqual(len(self.catalogues), catalogue_count)
        wrong = [stated_profile({"heeds": ["Maner"]}), stated_profile({"heeds": {"goal": {"relations": ["nextto"]}}})]
        for profile, hint in zip(wrong, ("did you mean 'Manner'?", "did you mean 'next_to'?")):
            answer = self.call("register_server", RegisterServer, "putting", "steady", profile_to_message(profile))
            self.assertFalse(answer.success)
            self.assertIn(hint, answer.error[0])
        answer = self.call("register_server", RegisterServer, "putting", "steady", ServerProfileMessage(purpose=7))
        self.assertIn("purpose", answer.error[0])
        self.assertEqual(profiles(), [stated])
        self.register("putting", "steady")
        wait_until(lambda: profiles() == [AS_IN_2012], message=profiles)

    def test_registration_for_a_frame_that_no_file_describes_is_remarked(self) -> None:
        answer = self.call("register_with_frame", RegisterWithFrame, "movign", "steady")
        self.assertTrue(answer.success)
        self.assertEqual(list(answer.error), ["no file describes the frame 'movign' yet; did you mean 'moving'?"])

    def test_registration_that_repeats_itself_is_published_to_nobody(self) -> None:
        self.register("repeating", "steady")
        heard: List[FrameServers] = []
        subscriber = rospy.Subscriber("frame_servers", FrameServers, heard.append)
        wait_until(lambda: heard, message="nothing is latched")
        for _ in range(5):
            self.register("repeating", "steady")
        self.register("repeating", "other")
        wait_until(lambda: any(each.callback_topic == "other" for each in heard[-1].callbacks), message="no change")
        subscriber.unregister()
        self.assertFalse(any(before == after for before, after in zip(heard, heard[1:])))

    def test_wrong_file_at_start_is_told_by_line_and_key_to_who_comes_late(self) -> None:
        late = rospy.wait_for_message("file_problems", FileProblems, timeout=60.0)
        problem = next(problem for problem in late.problems if problem.path.endswith("mistyped.yaml"))
        self.assertEqual((problem.code, problem.line, problem.key), ("UNKNOWN_KEY", 2, "descripton"))
        self.assertIn("did you mean 'description'", problem.hint)
        self.assertEqual(self.call("get_empty_frame", GetEmptyFrame, "moving").frame.name, "moving")

    def test_cycle_is_refused_by_its_names_and_nothing_changes(self) -> None:
        self.assertTrue(self.add_frame("circle_a.yaml", "name: circle_a\nchildren:\n  - name: circle_b\n"))
        self.assertFalse(self.add_frame("circle_b.yaml", "name: circle_b\nchildren:\n  - name: circle_a\n"))

        def cycles() -> List[str]:
            return [problem.found for problem in self.problems.problems if problem.code == "CYCLE"]

        wait_until(lambda: cycles() == ["circle_b -> circle_a -> circle_b"], message=cycles)
        self.assertEqual(self.call("get_empty_frame", GetEmptyFrame, "circle_b").frame.name, "")
        self.assertTrue(self.add_frame("circle_b.yaml", "name: circle_b\n"))
        wait_until(lambda: not cycles(), message="the problem of a file that was mended stays")

    def test_server_may_register_before_the_file_comes(self) -> None:
        self.register("waving", "steady")
        self.assertEqual(self.command("waving").reply.code, "UNKNOWN_FRAME")
        self.assertTrue(self.add_frame("waving.yaml", "name: waving\n"))
        self.assertEqual(self.servers("waving"), [["steady"]])

    def test_changed_file_takes_the_place_of_the_old_one_even_under_another_name(self) -> None:
        self.register("bowing", "steady")
        self.register("nodding", "steady")
        for _ in range(2):
            self.assertTrue(self.add_frame("gesture.yaml", "name: bowing\n"))
        self.assertEqual(self.servers("bowing"), [["steady"]])
        self.assertTrue(self.add_frame("gesture.yaml", "name: nodding\n"))
        self.assertEqual(self.servers("nodding"), [["steady"]])
        self.assertEqual(self.command("bowing").reply.code, "UNKNOWN_FRAME")

    def test_server_of_another_type_is_not_offered(self) -> None:
        self.assertTrue(self.add_frame("counting.yaml", "name: counting\n"))
        other = actionlib.SimpleActionServer("counter", TestAction, execute_cb=lambda goal: None, auto_start=False)
        other.start()
        self.register("counting", "counter")
        wait_until(lambda: self.is_alive("counter") is False, message="a server of another type is offered")

    def test_killed_server_is_not_offered_until_it_is_back(self) -> None:
        self.assertTrue(self.add_frame("dying.yaml", "name: dying\n"))
        self.register("dying", "mortal")
        wait_until(lambda: self.servers("dying") == [["mortal"]])
        self.kill("mortal_servers")
        wait_until(lambda: self.is_alive("mortal") is False, message="a dead server is offered")
        event = self.command("dying")
        self.assertEqual((event.reply.outcome, event.reply.code), (Reply.REFUSED, "NO_SERVER"))
        self.assertIn('"dying"', event.reply.sentence)
        wait_until(lambda: self.is_alive("mortal") is True, message="a server that is back is not offered")
        self.assertEqual(self.servers("dying"), [["mortal"]])

    def test_killed_registrar_knows_what_was_added_to_it(self) -> None:
        names = [f"added_{index}" for index in range(6)]
        threads = [threading.Thread(target=self.add_frame, args=(f"{name}.yaml", f"name: {name}\n")) for name in names]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertTrue(self.add_frame("vanishing.yaml", "name: vanishing\n"))
        os.remove(os.path.join(self.folder, "vanishing.yaml"))
        old = self.known.registrar_id
        self.kill("frame_registrar")
        wait_until(lambda: self.known.registrar_id != old, message="no new registrar")
        wait_until(self.is_connected)
        for name in names:
            self.assertEqual(self.call("get_empty_frame", GetEmptyFrame, name).frame.name, name)
        wait_until(
            lambda: (
                [problem.code for problem in self.problems.problems if "vanishing" in problem.path] == ["UNREADABLE"]
            )
        )
        self.register(names[0], "steady")
        wait_until(lambda: self.servers(names[0]) == [["steady"]])


if __name__ == "__main__":
    import rostest

    rospy.init_node("test_frame_registrar_node")
    rostest.rosrun("frame_registrar", "frame_registrar_node", FrameRegistrarTest)
