#!/usr/bin/python3
"""Sentences with control structure, live: when a condition became true at its source, and when the goal began or ended.

The parameter ``~cases`` names a file with sentences. Each has what happens meanwhile (``then``: seconds after the first
goal of the command, a topic, what is published), the outcome, and what the servers have to do, in this order. A table
of what was measured is printed, and written to ``~table`` if that is set.
"""

import json
import os
import sys
import threading
import time
import unittest
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any, Dict, List, Optional, Set, Tuple

import rospy
import rostest
import yaml
from nav_msgs.msg import Odometry
from roboframenet_msgs.msg import (
    CommandLexicalUnits,
    FilledSemanticFrameActionFeedback,
    FilledSemanticFrameActionGoal,
    FilledSemanticFrameActionResult,
    FrameServers,
    Reply,
    ServerProfile,
)
from std_msgs.msg import Float32, String

from command_server.stop_words import find_cry
from roboframenet_rostest import say, wait_for_pipeline
from roboframenet_testing.waiting import wait_until

#: What is published on each topic.
TYPES = {"battery/charge": Float32, "text": String, "person/act": String, "home/person": String, "home/weather": String}


@dataclass
class Seen:
    """What happened during a command; times in seconds of ROS time.

    Attributes:
        goals: frame, begin and end of each goal, in the order in which they began
        conditions: frame, whether it holds, and the stamp of its source, for each change
        frames: what the sentence was understood as, and the frames of all goals
    """

    goals: List[List[Any]] = field(default_factory=list)
    conditions: List[Tuple[str, bool, float]] = field(default_factory=list)
    frames: List[str] = field(default_factory=list)


class Recorder:
    """Listens to all servers of frames."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._servers: Dict[str, List[Any]] = {}
        self._goals: Dict[str, List[Any]] = {}
        self._values: Dict[str, bool] = {}
        self._frames: Dict[str, str] = {}
        self.seen = Seen()
        self._subscribers = [
            rospy.Subscriber("frame_servers", FrameServers, self._on_servers, queue_size=1),
            rospy.Subscriber("command_lexical_units", CommandLexicalUnits, self._on_units, queue_size=10),
        ]

    def begin(self) -> None:
        """Forget what was seen."""
        with self._lock:
            self.seen, self._goals, self._values = Seen(), {}, {}

    def is_connected(self) -> bool:
        """Whether all servers are heard."""
        with self._lock:
            return bool(self._servers) and all(
                one.get_num_connections() > 0 for subscribers in self._servers.values() for one in subscribers[1:]
            )

    def _on_servers(self, message: FrameServers) -> None:
        for callback in message.callbacks:
            with self._lock:
                is_known = callback.callback_topic in self._servers
                if callback.is_alive and not is_known:
                    is_watching = callback.profile.purpose == ServerProfile.WATCHES
                    self._servers[callback.callback_topic] = self._listen(callback.callback_topic, is_watching)

    def _listen(self, server: str, is_watching: bool) -> List[Any]:
        goal = rospy.Subscriber(f"{server}/goal", FilledSemanticFrameActionGoal, self._on_goal, (is_watching), 50)
        if is_watching:
            told = rospy.Subscriber(f"{server}/feedback", FilledSemanticFrameActionFeedback, self._on_feedback)
            return [goal, told]
        return [goal, rospy.Subscriber(f"{server}/result", FilledSemanticFrameActionResult, self._on_result)]

    def _on_units(self, message: CommandLexicalUnits) -> None:
        with self._lock:
            self.seen.frames += [
                clause.readings[0].lexical_unit.frame_name for clause in message.clauses if clause.readings
            ]

    def _on_goal(self, message: FilledSemanticFrameActionGoal, is_watching: bool) -> None:
        with self._lock:
            self._frames[message.goal_id.id] = message.goal.frame.name
            self.seen.frames.append(message.goal.frame.name)
            if not is_watching:
                entry = [message.goal.frame.name, message.goal_id.stamp.to_sec(), None]
                self._goals[message.goal_id.id] = entry
                self.seen.goals.append(entry)

    def _on_result(self, message: FilledSemanticFrameActionResult) -> None:
        with self._lock:
            entry = self._goals.get(message.status.goal_id.id)
            if entry is not None:
                entry[2] = message.header.stamp.to_sec()

    def _on_feedback(self, message: FilledSemanticFrameActionFeedback) -> None:
        ident, holds = message.status.goal_id.id, bool(message.feedback.is_succeeding)
        with self._lock:
            if self._values.get(ident) is holds:
                return
            self._values[ident] = holds
            name = self._frames.get(ident, "").replace("condition_of_", "")
            self.seen.conditions.append((name, holds, message.header.stamp.to_sec()))


class WatchingTest(unittest.TestCase):
    """The pipeline, a simulated robot and its watchers."""

    @classmethod
    def setUpClass(cls) -> None:
        with open(rospy.get_param("~cases"), encoding="utf-8") as file:
            cls.cases = yaml.safe_load(file)["cases"]
        wait_for_pipeline(rospy.get_param("~frames"))
        cls.publishers = {
            name: rospy.Publisher(name, TYPES[name], queue_size=10)
            for name in sorted(
                {step[1] for case in cls.cases for step in [*case.get("first", []), *case.get("then", [])]}
            )
        }
        cls.odometry: Tuple[float, ...] = ()
        cls.truth: Dict[str, Any] = {}
        cls.events: List[Dict[str, Any]] = []
        cls.rooms: Set[str] = set()
        cls.subscribers = [
            rospy.Subscriber("odom", Odometry, cls._on_odometry, queue_size=1),
            rospy.Subscriber("home/truth", String, cls._on_truth, queue_size=1),
        ]
        cls.recorder = Recorder()
        wait_until(cls.recorder.is_connected, 60.0, "the servers are not heard")
        wait_until(lambda: all(one.get_num_connections() for one in cls.publishers.values()), 60.0)

    @classmethod
    def _on_odometry(cls, message: Odometry) -> None:
        pose = message.pose.pose
        cls.odometry = tuple(
            round(value, 2) for value in (pose.position.x, pose.position.y, pose.orientation.z, pose.orientation.w)
        )

    @classmethod
    def _on_truth(cls, message: String) -> None:
        told = json.loads(message.data)
        cls.truth, cls.events = told["truth"], told["events"]
        cls.rooms.add(cls.truth.get("robot.room", ""))

    def _untrue(self, wanted: Dict[str, Any]) -> str:
        """Return what is not as wanted, after a second in which it may still become so."""
        try:
            wait_until(lambda: wanted.items() <= self.truth.items(), 3.0)
        except AssertionError:
            return f"{[(name, self.truth.get(name)) for name in wanted]}"
        return ""

    def _unheard(self, wanted: Dict[str, str], after_s: float) -> str:
        """Return what a person has not heard after a time of the home; who walks away afterwards has heard it."""

        def has_heard(person: str, words: str) -> bool:
            said = [event for event in self.events if event["kind"] == "said" and event["time_s"] > after_s]
            return any(person in event["to"] and words in event["what"] for event in said)

        try:
            wait_until(lambda: all(has_heard(*one) for one in wanted.items()), 3.0)
        except AssertionError:
            return f"not heard: {wanted}"
        return ""

    def _publish(self, topic: str, value: Any) -> None:
        self.publishers[topic].publish(value)

    def _play(self, steps: List[Any], is_over: threading.Event) -> None:
        """Publish what happens meanwhile; the seconds count from the first goal or condition."""
        seen = self.recorder.seen
        while not (seen.goals or seen.conditions) and not is_over.wait(0.01):
            pass
        begin_s = rospy.get_time()
        for seconds, topic, value in steps:
            while rospy.get_time() - begin_s < seconds and not is_over.wait(0.01):
                pass
            if is_over.is_set():
                return
            self._publish(topic, value)

    def _say(self, case: Dict[str, Any]) -> Tuple[Reply, Seen]:
        for step in case.get("first", []):
            self._publish(step[1], step[2])
        if case.get("first"):
            rospy.sleep(1.0)
        self.recorder.begin()
        is_over = threading.Event()
        player = threading.Thread(target=self._play, args=(case.get("then", []), is_over), daemon=True)
        player.start()
        try:
            return say(case["say"], timeout_s=case.get("within_s", 120.0)), self.recorder.seen
        finally:
            is_over.set()
            player.join(10.0)
            # Replies, goals and feedback come on connections of their own.
            with suppress(AssertionError):
                wait_until(lambda: len(self.recorder.seen.goals) >= len(case.get("goals", [])), 3.0)
            time.sleep(0.3)

    def test_sentences(self) -> None:
        table: List[str] = []
        failures: List[str] = []
        for case in self.cases:
            problem, line = self._check(case)
            table.append(line)
            print(line, flush=True)
            if problem:
                failures.append(f"{case['say']}: {problem}")
        path = rospy.get_param("~table", "")
        if path:
            with open(os.path.expanduser(path), "w", encoding="utf-8") as file:
                file.write("\n".join(table) + "\n")
        print(f"{len(self.cases) - len(failures)} of {len(self.cases)} sentences did what they should")
        self.assertEqual([], failures)

    def _check(self, case: Dict[str, Any]) -> Tuple[str, str]:
        """Say a sentence; return what is wrong, and the line of the table."""
        before = self.odometry
        before_s = max((event["time_s"] for event in self.events), default=-1.0)
        self.rooms.clear()
        self.rooms.add(self.truth.get("robot.room", ""))
        reply, seen = self._say(case)
        names = [goal[0] for goal in seen.goals]
        outcome = case.get("outcome", "DONE")
        problem = ""
        if reply.outcome != getattr(Reply, outcome):
            problem = f"{reply.code}: {reply.sentence}"
        elif ("goals" in case or "frame" not in case) and not _are_as_wanted(names, case):
            problem = f"did {names}; {reply.sentence}"
        elif case.get("says", "") not in reply.sentence:
            problem = f"said {reply.sentence}"
        elif "frame" in case and case["frame"] not in seen.frames and find_cry(case["say"]) is None:
            problem = f"no {case['frame']} in {seen.frames}"
        elif case.get("moved") and self.odometry == before:
            problem = "nothing moved"
        elif "rooms" in case and self.rooms - {""} != set(case["rooms"]):
            problem = f"was in {sorted(self.rooms)}"
        else:
            problem = self._untrue(case.get("truth", {})) or self._unheard(case.get("heard", {}), before_s)
        became, late_s = _lateness(seen, case)
        if not problem and case.get("by") and late_s is None:
            problem = f"no condition, or nothing {case['by']}: {seen.conditions}, {seen.goals}"
        shown = "" if became is None else became
        late = "" if late_s is None else f"{1000.0 * late_s:.0f} ms"
        return problem, f"| {case['say']} | {', '.join(names)} | {shown} | {late} | {reply.sentence} |"


def _are_as_wanted(names: List[str], case: Dict[str, Any]) -> bool:
    wanted = case.get("goals", [])
    if "least" in case:
        return len(names) >= case["least"] and set(names) == set(wanted)
    return sorted(names) == sorted(wanted) if case.get("any_order") else names == wanted


def _lateness(seen: Seen, case: Dict[str, Any]) -> Tuple[Optional[str], Optional[float]]:
    """Return the last change of a condition that counts, and how long after its stamp a goal began or ended."""
    how, place = case.get("by", ""), 1
    if not how:
        return None, None
    wanted = bool(case.get("holds", True))
    changes = [one for one in seen.conditions if one[1] is wanted]
    place = 2 if how == "ended" else 1
    moments = [goal[place] for goal in seen.goals if goal[place] is not None]
    if not changes or not moments:
        return None, None
    name, holds, stamp_s = changes[-1] if how == "ended" else changes[0]
    after = [moment for moment in moments if moment >= stamp_s - 0.05]
    if not after:
        return None, None
    return f"{name} {'held' if holds else 'did not hold'}, then {how}", after[0] - stamp_s


if __name__ == "__main__":
    rospy.init_node("watching_test")
    rostest.rosrun("roboframenet_tests", "watching", WatchingTest, sys.argv)
