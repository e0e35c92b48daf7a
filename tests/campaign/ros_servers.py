"""Servers that hang, die or lose what they owe: R7, R8 and R9, on an executor with its default deadlines."""

import os
import random
import signal
import time
from contextlib import ExitStack
from pathlib import Path
from typing import Any, Dict, List, Sequence, Tuple

from roboframenet_testing import comes_true, wait_until

from .demand import Demand, Figure, Trial, at_most, none_of
from .ros_robot import Launched

_LAUNCH_FILE = str(Path(__file__).with_name("odd_servers.launch"))
_REPLY_S = 60.0


class OnExecutor(Demand):
    """A demand whose trials share one executor with odd servers."""

    arguments: Sequence[str] = ()

    def running(self) -> ExitStack:
        """Start them."""
        with ExitStack() as stack:
            launched = Launched([_LAUNCH_FILE, *self.arguments])
            stack.callback(launched.end)
            os.environ["ROS_MASTER_URI"] = launched.uri
            import rosgraph
            import rospy
            from roboframenet_msgs.msg import CommandPlan, StageEvent
            from std_msgs.msg import String

            wait_until(rosgraph.is_master_online, 60.0, "no master")
            rospy.init_node("reliability_campaign", disable_signals=True)
            self.log: List[Tuple[float, str]] = []
            self.events: List[Tuple[float, Any]] = []
            self._plans = rospy.Publisher("command_plan", CommandPlan, queue_size=100)
            self._subscribers = [
                rospy.Subscriber("server_log", String, lambda said: self.log.append((time.monotonic(), said.data))),
                rospy.Subscriber("stage_events", StageEvent, lambda one: self.events.append((time.monotonic(), one))),
            ]
            log = self._subscribers[0]
            wait_until(lambda: self._plans.get_num_connections() == 1 and log.get_num_connections() == 3, 60.0)
            wait_until(lambda: self._subscribers[1].get_num_connections() == 1, 60.0)
            self._number = 0
            self._rospy = rospy
            return stack.pop_all()

    def send(self, *ways: Sequence[Tuple[str, str]]) -> str:
        """Send a command of one clause; return its id.

        Args:
            ways: candidates, each some pairs of behaviour and server
        """
        from roboframenet_msgs.msg import (
            Command,
            CommandPlan,
            FilledFrameElement,
            FilledSemanticFrame,
            Plan,
            PlanCandidate,
            PlanNode,
        )

        self._number += 1
        command = Command(id=f"trial_{self._number}", text="do it", stamp=self._rospy.Time.now())
        candidates = [
            PlanCandidate(
                coverage=1.0,
                frames=[
                    FilledSemanticFrame(
                        name=behaviour,
                        action_server_topics=[server],
                        frame_elements=[FilledFrameElement("seconds", "30")],
                    )
                    for behaviour, server in way
                ],
            )
            for way in ways
        ]
        node = PlanNode(kind=PlanNode.DO, label="do it", candidates=candidates)
        self._plans.publish(CommandPlan(command=command, plan=Plan(nodes=[node])))
        return str(command.id)

    def reply_of(self, command_id: str) -> Tuple[float, Any]:
        """Return the final event of a command and when it came; raises AssertionError if there is none."""

        def finals() -> List[Tuple[float, Any]]:
            return [(at_s, one) for at_s, one in self.events if one.command.id == command_id and one.is_final]

        wait_until(lambda: bool(finals()), _REPLY_S, "no reply")
        return finals()[0]

    def logged_s(self, line: str, since_s: float) -> float:
        """Return when a line was logged; raises AssertionError if it is not."""

        def found() -> List[float]:
            return [at_s for at_s, text in self.log if text == line and at_s >= since_s]

        wait_until(lambda: bool(found()), _REPLY_S, line)
        return found()[0]


class HungServer(OnExecutor):
    """R7: a server never ends its goal."""

    name, title = "R7", "a server hangs: it ends no goal and obeys no cancel"
    counts = (3, 30, 100)

    def trial(self, number: int, chance: random.Random) -> Dict[str, Any]:
        """Ask it twice; the second time it must not be asked at all."""
        begin_s = time.monotonic()
        first = self.send([("ignore_cancel", "hanging")], [("succeed", "two")])
        first_at_s, first_end = self.reply_of(first)
        again_s = time.monotonic()
        second = self.send([("succeed", "hanging")], [("succeed", "two")])
        second_at_s, second_end = self.reply_of(second)
        was_asked = any(text == "hanging begins succeed" and at_s >= again_s for at_s, text in self.log)
        self._replace("hanging")
        return {
            "first_s": first_at_s - begin_s,
            "not_done": int(first_end.reply.code != "DONE") + int(second_end.reply.code != "DONE"),
            "unnamed": int("hanging" not in first_end.reply.sentence),
            "second_s": second_at_s - again_s,
            "asked_again": int(was_asked),
        }

    def _replace(self, node: str) -> None:
        """Kill a node, so that the next trial finds a new one."""
        from xmlrpc.client import ServerProxy

        import rosgraph

        master = rosgraph.Master(self._rospy.get_name())
        old = int(ServerProxy(master.lookupNode(f"/{node}")).getPid("/campaign")[2])
        os.kill(old, signal.SIGKILL)

        def is_new() -> bool:
            try:
                return int(ServerProxy(master.lookupNode(f"/{node}")).getPid("/campaign")[2]) != old
            except (OSError, rosgraph.MasterException):
                return False

        wait_until(is_new, 60.0, f"{node} does not come back")
        wait_until(lambda: self.reply_of(self.send([("succeed", node)]))[1].reply.code == "DONE", 60.0)

    def figures(self, trials: Sequence[Trial]) -> List[Figure]:
        """The limit of a goal is 4 s here, and a cancel may take 5 s."""
        return [
            at_most("reply (limit of a goal 4 s, of its end 5 s)", trials, "first_s", 10.5),
            at_most("the next command", trials, "second_s", 1.0),
            *(none_of(key, trials, key) for key in ("not_done", "unnamed", "asked_again")),
        ]


class DyingServer(OnExecutor):
    """R8: a server dies in its goal, and another one can do the same."""

    name, title = "R8", "a server dies in its goal; another one is tried"
    counts = (5, 50, 200)
    #: The server lives on for this long after it has accepted the goal.
    _LIFE_S = 1.0

    def trial(self, number: int, chance: random.Random) -> Dict[str, Any]:
        """Let it die."""
        wait_until(self._is_back, 60.0, "mortal does not come back")
        since_s = time.monotonic()
        command = self.send([("die", "mortal")], [("succeed", "two")])
        death_s = self.logged_s("mortal begins die", since_s) + self._LIFE_S
        other_s = self.logged_s("two begins succeed", since_s)
        _, end = self.reply_of(command)
        return {
            "detected_s": max(0.0, other_s - death_s),
            "not_done": int(end.reply.code != "DONE"),
            "unnamed": int("mortal" not in end.reply.sentence),
        }

    def _is_back(self) -> bool:
        """Whether it obeys, and what it logs arrives."""
        since_s = time.monotonic()
        is_done = self.reply_of(self.send([("succeed", "mortal")]))[1].reply.code == "DONE"
        return is_done and any(text == "mortal begins succeed" and at_s >= since_s for at_s, text in list(self.log))

    def figures(self, trials: Sequence[Trial]) -> List[Figure]:
        """From the death to the goal of the other server."""
        return [
            at_most("death to the next server", trials, "detected_s", 2.5),
            *(none_of(key, trials, key) for key in ("not_done", "unnamed")),
        ]


class LostWords(OnExecutor):
    """R9: acknowledgement or result are lost, or the end is an odd one."""

    name, title = "R9", "goals that are rejected, lost, recalled, or end without a result"
    counts = (10, 100, 500)
    # The same server is asked in every trial, whatever it did in the last one.
    arguments = ("quarantine:=0",)
    _WAYS = ("reject", "lose", "cancel_itself", "drop_result", "raise")

    def trial(self, number: int, chance: random.Random) -> Dict[str, Any]:
        """The second candidate must be tried, or, where somebody else cancelled, the reply must say so."""
        behaviour = self._WAYS[number % len(self._WAYS)]
        since_s = time.monotonic()
        at_s, end = self.reply_of(self.send([(behaviour, "one")], [("succeed", "three")]))
        was_tried = comes_true(
            lambda: any(text == "three ends succeed" and when_s >= since_s for when_s, text in self.log), 1.0
        )
        is_right = (
            end.reply.code == "STOPPED" if behaviour == "cancel_itself" else end.reply.code == "DONE" and was_tried
        )
        return {
            "behaviour": behaviour,
            "wrong": int(not is_right),
            "code": end.reply.code,
            "unnamed": int("one" not in end.reply.sentence),
            "reply_s": at_s - since_s,
        }

    def figures(self, trials: Sequence[Trial]) -> List[Figure]:
        """Each end is told for what it is."""
        wrong = sorted({f"{trial['behaviour']}: {trial['code']}" for trial in trials if trial["wrong"]})
        return [
            none_of("wrong", trials, "wrong"),
            none_of("unnamed", trials, "unnamed"),
            at_most("reply", trials, "reply_s", 11.0),
            *([Figure("wrong ones", ", ".join(wrong), "none", False)] if wrong else []),
        ]
