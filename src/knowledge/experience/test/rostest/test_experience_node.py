#!/usr/bin/python3
"""Experience in the graph: the server that works is asked first, no command waits for a killed node, rules hold."""

import os
import signal
import unittest
from typing import Dict, List
from xmlrpc.client import ServerProxy

import actionlib
import rosgraph
import rospy
from roboframenet_msgs.msg import (
    Command,
    CommandSemanticFrames,
    Experience,
    FilledFrameElement,
    FilledSemanticFrame,
    FilledSemanticFrameAction,
    FilledSemanticFrameGoal,
    FilledSemanticFrameResult,
    FrameCallback,
    FrameServers,
    Plan,
    PlanCandidate,
    PlanNode,
    Reply,
    ServerProfile,
    StageEvent,
)
from roboframenet_msgs.srv import RegisterWithFrame, RegisterWithFrameResponse

from rfnserver import RFNServer
from roboframenet_testing import wait_until

NAMES = ["arm_a", "arm_b"]


def candidate(server: str) -> PlanCandidate:
    frame = FilledSemanticFrame(name="waving", action_server_topics=[server])
    return PlanCandidate(frames=[frame], coverage=1.0)


class ExperienceTest(unittest.TestCase):
    """The methods run in the order of their names."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.asked: List[str] = []
        cls.replies: Dict[str, Reply] = {}
        cls.traces: List[str] = []
        cls.snapshots: List[Experience] = []
        cls.count = 0
        # The test is the registrar too: without one, each registration would be waited for.
        cls.registrar = rospy.Service(
            "register_with_frame", RegisterWithFrame, lambda _: RegisterWithFrameResponse(success=True)
        )
        cls.servers = [RFNServer(name, cls.callback(name)) for name in NAMES]
        for server in cls.servers:
            server.start()
        cls.commands = rospy.Publisher("command_semantic_frames", CommandSemanticFrames, queue_size=100)
        cls.registered = rospy.Publisher("frame_servers", FrameServers, queue_size=1, latch=True)
        cls.subscribers = [
            rospy.Subscriber("stage_events", StageEvent, cls.hear),
            rospy.Subscriber("experience", Experience, cls.snapshots.append),
        ]
        cls.meet_teacher()
        # The arbitrator and the executor publish events; so the executor listens to plans by then.
        wait_until(lambda: cls.commands.get_num_connections() and cls.subscribers[0].get_num_connections() > 1)
        wait_until(lambda: cls.snapshots)

    @classmethod
    def meet_teacher(cls) -> None:
        """Connect to the node's server; a client that has seen its server die loses goals while it reconnects."""
        cls.teacher = actionlib.ActionClient("experience_server", FilledSemanticFrameAction)
        assert cls.teacher.wait_for_server(rospy.Duration(60.0))

    @classmethod
    def callback(cls, name: str):
        def carry_out(_frame: FilledSemanticFrame) -> None:
            cls.asked.append(name)
            server = cls.servers[NAMES.index(name)]
            if name == "arm_a":
                server.set_aborted(FilledSemanticFrameResult(success=False), "it slipped")
            else:
                server.set_succeeded(FilledSemanticFrameResult(success=True), "")

        return carry_out

    @classmethod
    def hear(cls, event: StageEvent) -> None:
        if event.is_final:
            cls.replies[event.command.id] = event.reply
        elif event.stage == "arbitrator":
            cls.traces.append(event.trace)

    def send(self) -> str:
        type(self).count += 1
        command = Command(id=f"c{self.count}", text="Wave.", stamp=rospy.Time.now())
        clause = PlanNode(kind=PlanNode.DO, label="Wave", candidates=[candidate("arm_a"), candidate("arm_b")])
        self.commands.publish(CommandSemanticFrames(command=command, plan=Plan(nodes=[clause])))
        return command.id

    def carry_out(self) -> Reply:
        """Send a command, and wait for its end and for what is known of it."""
        del self.asked[:]
        name = self.send()
        wait_until(lambda: name in self.replies)
        return self.replies[name]

    def comes_to(self, outcome: int, code: str, asked: List[str]) -> None:
        """Carry out commands until one ends so: the arbitrator may hear a snapshot later than this test."""

        def comes() -> bool:
            reply = self.carry_out()
            return (reply.outcome, reply.code, self.asked) == (outcome, code, asked)

        wait_until(comes)

    def teach(self, frame: str, **elements: str) -> str:
        filled = [FilledFrameElement(name, text) for name, text in elements.items()]
        goal = FilledSemanticFrameGoal(frame=FilledSemanticFrame(name=frame, frame_elements=filled))
        handle = self.teacher.send_goal(goal)
        wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE)
        self.assertEqual(handle.get_goal_status(), actionlib.GoalStatus.SUCCEEDED)
        return handle.get_goal_status_text()

    def known(self, server: str) -> int:
        """Trials of a server that the last snapshot knows, at most 20."""
        found = [one for one in self.snapshots[-1].servers if one.server == server]
        return len(found[0].cells[0].recent) if found else 0

    def test_1_server_that_works_is_asked_first_after_a_few_commands(self) -> None:
        for number in range(1, 6):
            self.assertEqual(self.carry_out().outcome, Reply.DONE)
            if self.asked[0] == "arm_b":
                break
            wait_until(lambda count=number: self.known("arm_b") >= count)
        self.assertEqual(self.asked, ["arm_b"])
        self.traces.clear()
        self.carry_out()
        # The arbitrator tells it when the executor works already: the reply may be there before.
        wait_until(lambda: any("policy: I asked arm_b first" in trace for trace in self.traces))

    def test_2_no_command_waits_or_fails_when_the_node_is_killed(self) -> None:
        wait_until(lambda: self.known("arm_b") >= 3)
        before = len(self.snapshots)
        uri = rosgraph.Master("/test_experience").lookupNode("/experience")
        pid = ServerProxy(uri).getPid("/test_experience")[2]
        first = [self.carry_out() for _ in range(3)]
        os.kill(pid, signal.SIGKILL)
        during = [self.carry_out() for _ in range(10)]
        self.assertEqual([reply.outcome for reply in first + during], [Reply.DONE] * 13)
        # What was known stays known to the arbitrator.
        self.assertEqual(self.asked, ["arm_b"])
        wait_until(lambda: len(self.snapshots) > before and self.known("arm_a") >= 1)
        self.assertEqual(self.carry_out().outcome, Reply.DONE)
        self.assertEqual(self.asked, ["arm_b"])

    def test_3_people_ask_and_teach(self) -> None:
        self.meet_teacher()
        self.carry_out()
        wait_until(lambda: "I asked arm_b first" in self.teach("question_of_choice", server="arm_b"))
        self.assertIn("I remember that arm_b", self.teach("praising_a_deed"))
        self.assertEqual(self.teach("avoiding_a_server", server="arm_b"), 'I have no server that is called "arm_b".')
        self.registered.publish(
            FrameServers(callbacks=[FrameCallback("waving", name, True, ServerProfile()) for name in NAMES])
        )
        wait_until(lambda: self.teach("avoiding_a_server", server="arm_b") == "All right: never arm_b.")
        wait_until(lambda: len(self.snapshots[-1].rules) == 1)
        self.comes_to(Reply.FAILED, "ALL_CANDIDATES_FAILED", ["arm_a"])
        self.teach("avoiding_a_server", server="arm_a")
        wait_until(lambda: len(self.snapshots[-1].rules) == 2)
        self.comes_to(Reply.REFUSED, "FORBIDDEN", [])
        for name in NAMES:
            self.teach("taking_back_a_rule", server=name)
        self.assertEqual(self.teach("question_of_rules"), "I have no rules about my parts.")
        wait_until(lambda: not self.snapshots[-1].rules)
        wait_until(lambda: self.carry_out().outcome == Reply.DONE)


if __name__ == "__main__":
    import rostest

    rospy.init_node("test_experience_node")
    rostest.rosrun("experience", "experience_node", ExperienceTest)
