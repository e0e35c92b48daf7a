#!/usr/bin/python3
"""Many robots and one language service: each command is answered once, and goals are not late. Prints the figures."""

import itertools
import os
import re
import threading
import time
import unittest
from collections import Counter
from pathlib import Path
from typing import Dict, List, Sequence

import rospy
from roboframenet_msgs.msg import FilledSemanticFrameActionGoal, Fleet, FleetService, FrameServers, Reply
from std_msgs.msg import String

from roboframenet_testing import comes_true, wait_until
from roboframenet_testing.ros_processes import process_of

TEXT = "Turn left 2 degrees."
#: Nodes of the language service.
SERVICE = ("/stanford_parser_ros", "/stages", "/fleet")
_READY_S = 300.0
_LAST_REPLY_S = 60.0


def share(values: Sequence[float], part: float) -> float:
    """Return the value below which a share of the values lies."""
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(part * len(ordered)))]


def memory_mb(node: str) -> float:
    """Return the memory of the process of a node: its own, and its part of what it shares (PSS)."""
    (size,) = re.findall(
        r"^Pss: +(\d+) kB$", Path(f"/proc/{process_of(node)}/smaps_rollup").read_text(encoding="ascii"), re.MULTILINE
    )
    return int(size) / 1024.0


class Robot:
    """What is said to a robot, and when its server got the goal."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.latencies_s: List[float] = []
        self.replies: List[Reply] = []
        self.said = 0
        self._said_s = 0.0
        self._lock = threading.Lock()
        self._text = rospy.Publisher(f"/{name}/text", String, queue_size=100)
        self._subscribers = [
            rospy.Subscriber(f"/{name}/turning/goal", FilledSemanticFrameActionGoal, self._hear_goal),
            rospy.Subscriber(f"/{name}/reply", Reply, self.replies.append),
        ]

    def is_connected(self) -> bool:
        """Whether command_server and stop_server hear what is said, and replies are heard."""
        return self._text.get_num_connections() >= 2 and self._subscribers[1].get_num_connections() > 0

    def hears_goals(self) -> bool:
        """Whether goals are heard: nobody sends them before the first command."""
        return self._subscribers[0].get_num_connections() > 0

    def is_free(self) -> bool:
        """Whether all that was said is answered."""
        return len(self.replies) >= self.said

    def say(self) -> None:
        """Say the sentence."""
        with self._lock:
            self.said += 1
            self._said_s = time.monotonic()
        self._text.publish(String(data=TEXT))

    def _hear_goal(self, _: FilledSemanticFrameActionGoal) -> None:
        with self._lock:
            if self._said_s:
                self.latencies_s.append(time.monotonic() - self._said_s)
            self._said_s = 0.0


class FleetLoadTest(unittest.TestCase):
    """One robot alone, then all of them."""

    @classmethod
    def setUpClass(cls) -> None:
        rospy.init_node("fleet_load_test")
        names = rospy.get_param("~robots").split(",")
        cls.robots = [Robot(name) for name in names]
        cls.fleet, cls.service, cls.servers = Fleet(), FleetService(), FrameServers()
        cls.subscribers = [
            rospy.Subscriber("/fleet", Fleet, cls.hear_fleet),
            rospy.Subscriber("/fleet_service", FleetService, cls.hear_service),
            rospy.Subscriber("/frame_servers", FrameServers, cls.hear_servers),
        ]
        wait_until(lambda: len(cls.fleet.robots) == len(names) and cls.service.is_up, _READY_S)
        wait_until(lambda: set(names) <= cls.turning(), _READY_S)
        wait_until(lambda: all(robot.is_connected() for robot in cls.robots), _READY_S)
        for robot in cls.robots:
            robot.say()
            wait_until(lambda robot=robot: robot.is_free() and robot.hears_goals(), _READY_S)

    @classmethod
    def hear_fleet(cls, message: Fleet) -> None:
        cls.fleet = message

    @classmethod
    def hear_service(cls, message: FleetService) -> None:
        cls.service = message

    @classmethod
    def hear_servers(cls, message: FrameServers) -> None:
        cls.servers = message

    @classmethod
    def turning(cls) -> set:
        return {one.profile.robot for one in cls.servers.callbacks if one.frame_name == "turning"}

    def run_load(self, robots: Sequence[Robot], *, per_s: float, seconds: float) -> Dict[str, float]:
        """Talk to robots in turn; return what was measured.

        A robot that has not answered yet is passed over: what it does now would be replaced.
        """
        for robot in robots:
            del robot.latencies_s[:], robot.replies[:]
            robot.said = 0
        begin_s, passed_over = time.monotonic(), 0
        for number, robot in zip(range(int(seconds * per_s)), itertools.cycle(robots)):
            time.sleep(max(0.0, begin_s + number / per_s - time.monotonic()))
            if robot.is_free():
                robot.say()
            else:
                passed_over += 1
        comes_true(lambda: all(robot.is_free() for robot in robots), _LAST_REPLY_S)
        replies = [reply for robot in robots for reply in robot.replies]
        per_command = Counter(reply.command.id for reply in replies)
        latencies_s = [latency_s for robot in robots for latency_s in robot.latencies_s]
        return {
            "said": sum(robot.said for robot in robots),
            "answered": len(per_command),
            "answered twice": sum(count > 1 for count in per_command.values()),
            "not done": sum(reply.outcome != Reply.DONE for reply in replies),
            "passed over": passed_over,
            "p50_s": share(latencies_s, 0.5),
            "p99_s": share(latencies_s, 0.99),
            "took_s": time.monotonic() - begin_s,
        }

    def test_many_robots(self) -> None:
        per_s, seconds = rospy.get_param("~per_s"), rospy.get_param("~seconds")
        before = sum(map(memory_mb, SERVICE))
        alone = self.run_load(self.robots[:1], per_s=per_s / len(self.robots), seconds=rospy.get_param("~alone_s"))
        together = self.run_load(self.robots, per_s=per_s, seconds=seconds)
        after = sum(map(memory_mb, SERVICE))
        for name, figures in (("one robot", alone), (f"{len(self.robots)} robots", together)):
            print(f"{name}: " + ", ".join(f"{key} {value:.4g}" for key, value in figures.items()))
        print(f"memory of the service, MB: {before:.0f} before, {after:.0f} after")
        robot = sum(memory_mb(f"/{self.robots[0].name}/{node}") for node in ("robot", "stop_server"))
        print(f"memory of one robot and its stop_server, MB: {robot:.0f}")
        print(f"load of the machine: {os.getloadavg()[0]:.1f}")
        print(f"text to goal, p99: {together['p99_s'] / alone['p99_s']:.2f} times that of one robot")
        for figures in (alone, together):
            self.assertEqual((figures["answered"], figures["answered twice"]), (figures["said"], 0))
        self.assertEqual(together["not done"], 0)


if __name__ == "__main__":
    import rostest

    rostest.rosrun("roboframenet_tests", "fleet_load_test", FleetLoadTest)
