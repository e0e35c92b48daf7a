#!/usr/bin/python3
"""Settings of another node: applied for the step, restored however it ends."""

import os
import signal
import time
import unittest

import rospy
import rostest
from dynamic_reconfigure.msg import Config
from dynamic_reconfigure.srv import Reconfigure
from roboframenet_msgs.msg import (
    Command,
    CommandPlan,
    FilledSemanticFrame,
    FrameCallback,
    FrameServers,
    Plan,
    PlanCandidate,
    PlanNode,
    Reply,
    ServerProfile,
    ServerSetting,
    StageEvent,
)
from std_msgs.msg import String

from roboframenet_testing import wait_until
from roboframenet_testing.ros_processes import process_of

BEFORE = {"exposure": 10, "gain": 1.0, "auto_gain": True}


class ServerSettingsTest(unittest.TestCase):
    count = 0

    @classmethod
    def setUpClass(cls):
        rospy.init_node("test_server_settings")
        cls.replies, cls.log = [], []
        cls.plans = rospy.Publisher("command_plan", CommandPlan, queue_size=10)
        cls.cancels = rospy.Publisher("command_cancel", Command, queue_size=10)
        cls.events = rospy.Subscriber(
            "stage_events", StageEvent, lambda event: cls.replies.append(event.reply) if event.is_final else None
        )
        log = rospy.Subscriber("server_log", String, lambda message: cls.log.append(message.data))
        cls.cameras = []
        for camera in ("camera", "other_camera"):
            rospy.wait_for_service(f"{camera}/set_parameters", timeout=60.0)
            cls.cameras.append(rospy.ServiceProxy(f"{camera}/set_parameters", Reconfigure))
        wait_until(
            lambda: (
                all(entity.get_num_connections() == 1 for entity in (cls.plans, cls.cancels, cls.events))
                and log.get_num_connections() == 2
            )
        )

    def setUp(self):
        del self.log[:]
        self.assert_cameras(BEFORE, BEFORE)

    def settings(self, camera):
        # No change asked for: the answer holds what is.
        config = self.cameras[camera](Config()).config
        return {entry.name: entry.value for entry in config.ints + config.doubles + config.bools}

    def assert_cameras(self, *expected):
        wait_until(
            lambda: [self.settings(0), self.settings(1)] == list(expected),
            message=lambda: [self.settings(0), self.settings(1)],
        )

    def send(self, *steps):
        type(self).count += 1
        command = Command(id=f"{self.id()}_{self.count}", stamp=rospy.Time.now(), text="photograph it")
        node = PlanNode(
            kind=PlanNode.DO,
            label=command.text,
            candidates=[
                PlanCandidate(coverage=1.0, frames=[FilledSemanticFrame(name=behaviour, action_server_topics=[server])])
                for behaviour, server in steps
            ],
        )
        self.plans.publish(CommandPlan(command=command, plan=Plan(nodes=[node])))
        return command

    def wait_for_reply(self, command):
        wait_until(lambda: [r for r in self.replies if r.command.id == command.id])
        return next(reply for reply in self.replies if reply.command.id == command.id)

    def run_photo(self):
        command = self.send(("run", "photo"))
        wait_until(lambda: "photo begins run" in self.log)
        self.assert_cameras({"exposure": 20, "gain": 2.0, "auto_gain": False}, dict(BEFORE, exposure=30))
        return command

    def test_restored_on_preemption(self):
        command = self.run_photo()
        self.cancels.publish(command)
        self.assertEqual("STOPPED", self.wait_for_reply(command).code)
        self.assert_cameras(BEFORE, BEFORE)

    def test_restored_on_success_and_abort(self):
        for behaviour, outcome in (("succeed", Reply.DONE), ("abort", Reply.FAILED)):
            self.assertEqual(outcome, self.wait_for_reply(self.send((behaviour, "photo"))).outcome)
            wait_until(lambda begun=f"photo begins {behaviour}": begun in self.log)
            self.assert_cameras(BEFORE, BEFORE)

    def test_step_whose_settings_cannot_be_had_fails_and_the_next_runs(self):
        for server, part in (
            ("greedy", "/camera took 100 for exposure, not 1000"),
            ("mistyped", "/camera has no setting expsure; it has auto_gain, exposure, gain"),
            ("wrong", "expected node and a mapping settings"),
            ("homeless", "/nowhere"),
        ):
            with self.subTest(server=server):
                reply = self.wait_for_reply(self.send(("succeed", server), ("succeed", "plain")))
                self.assertEqual(Reply.DONE, reply.outcome)
                self.assertIn(part, reply.sentence)
                self.assertNotIn(f"{server} begins succeed", self.log)
                self.assert_cameras(BEFORE, BEFORE)

    def test_what_a_server_stated_counts_like_its_parameter(self):
        settings = [ServerSetting(node="/camera", name="exposure", value="42")]
        profile = ServerProfile(settings=settings, longest_goal=rospy.Duration(4.0))
        servers = FrameServers(callbacks=[FrameCallback("run", "plain", True, profile)])
        publisher = rospy.Publisher("frame_servers", FrameServers, queue_size=1, latch=True)
        publisher.publish(servers)
        wait_until(lambda: publisher.get_num_connections() == 1)
        # Nothing tells that the executor has read it; a command on another topic may overtake it.
        time.sleep(1.0)
        command = self.send(("run", "plain"))
        self.assert_cameras(dict(BEFORE, exposure=42), BEFORE)
        self.assertIn("did not end within 4 s", self.wait_for_reply(command).sentence)
        self.assert_cameras(BEFORE, BEFORE)
        publisher.unregister()

    def test_restored_when_the_server_dies(self):
        reply = self.wait_for_reply(self.send(("die", "mortal"), ("succeed", "plain")))
        self.assertEqual(Reply.DONE, reply.outcome)
        self.assertIn("has died", reply.sentence)
        self.assert_cameras(BEFORE, BEFORE)

    def test_z_killed_executor_restores_and_cancels_when_it_is_back(self):
        self.run_photo()
        os.kill(process_of("executor"), signal.SIGKILL)
        wait_until(lambda: "photo preempted run" in self.log)
        self.assert_cameras(BEFORE, BEFORE)


if __name__ == "__main__":
    rostest.rosrun("executor", "server_settings", ServerSettingsTest)
