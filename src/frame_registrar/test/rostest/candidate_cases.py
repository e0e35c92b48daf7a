"""A command in, and candidates, a question or a refusal out."""

from typing import List

import rospy
from frame_registrar_case import FrameRegistrarCase
from roboframenet_msgs.msg import Command, CommandLexicalUnits, Plan, PlanNode, Reply, StageEvent
from roboframenet_msgs.msg import ServerProfile as ServerProfileMessage
from roboframenet_msgs.srv import GetEmptyFrame, RegisterServer

from roboframenet_testing import wait_until
from typed_arguments import TypedArgument
from typed_arguments.ros_messages import to_message


class CandidateCases(FrameRegistrarCase):
    """What the registrar answers to commands."""

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
