"""The whole graph started and ended: R10, R11 and R13. Each trial is a process of its own with a master of its own."""

import json
import math
import os
import random
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any, Dict, FrozenSet, List, Mapping, Sequence

from roboframenet_testing import comes_true

from .demand import Demand, Figure, Trial, at_most, none_of
from .ros_robot import MOTION, Launched, Robot, running_robot

_TIMEOUT_S = 500.0
_REPLY_S = 40.0
_SIMULATED_TIME = Path(__file__).with_name("simulated_time.launch")


def in_own_process(*arguments: str) -> Dict[str, Any]:
    """Run this module with arguments; return what it found."""
    command = [sys.executable, "-m", "campaign.ros_launches", *arguments]
    done = subprocess.run(command, stdout=subprocess.PIPE, timeout=_TIMEOUT_S, check=True)
    found: Dict[str, Any] = json.loads(done.stdout.splitlines()[-1])
    return found


class StartOrders(Demand):
    """R10: the nodes are started in a random order."""

    name, title = "R10", "nodes started in any order"
    counts = (3, 20, 100)

    def trial(self, number: int, chance: random.Random) -> Dict[str, Any]:
        """Start all nodes in one order."""
        return in_own_process("order", str(chance.randrange(10**6)))

    def figures(self, trials: Sequence[Trial]) -> List[Figure]:
        """Each order comes up."""
        return [
            none_of("not ready", trials, "not_ready"),
            at_most("start to the first command done", trials, "ready_s", 60.0),
        ]


class UpAndDown(Demand):
    """R13: up and down."""

    name, title = "R13", "the whole graph up and down"
    counts = (3, 40, 200)

    def trial(self, number: int, chance: random.Random) -> Dict[str, Any]:
        """Start, do something, end."""
        return in_own_process("launch")

    def figures(self, trials: Sequence[Trial]) -> List[Figure]:
        """It ends quickly, and leaves nothing."""
        return [
            none_of("not ready", trials, "not_ready"),
            none_of("exit status other than 0", trials, "bad_exit"),
            none_of("processes left over", trials, "orphans"),
            at_most("interrupt to the end", trials, "exit_s", 10.0),
        ]


class Clocks(Demand):
    """R11: simulated time that is absent, stands still, or jumps."""

    name, title = "R11", "simulated time: absent, paused, an hour ahead, 100 s back"
    counts = (4, 8, 40)
    _WAYS = ("absent", "paused", "ahead", "back")

    def trial(self, number: int, chance: random.Random) -> Dict[str, Any]:
        """Drive under an odd clock."""
        return in_own_process("clock", self._WAYS[number % len(self._WAYS)])

    def figures(self, trials: Sequence[Trial]) -> List[Figure]:
        """Everything is answered, and works when time is right again."""
        return [none_of(key, trials, key) for key in ("unanswered", "not_done", "deaths")]


def launch(*arguments: str, program: Sequence[str] = ("roslaunch",)) -> Mapping[str, Any]:
    """Start the robot, do something, and end it."""
    launched = Launched(["roboframenet_bringup", "robot.launch", "world:=false", *arguments], program=program)
    os.environ["ROS_MASTER_URI"] = launched.uri
    ready_s = None
    try:
        import rosgraph
        import rospy

        comes_true(rosgraph.is_master_online, 60.0)
        rospy.init_node("reliability_campaign", disable_signals=True)
        try:
            ready_s = Robot(launched).wait_until_ready()
        except AssertionError:
            ready_s = None
    finally:
        ended = launched.end()
    return {
        "ready_s": ready_s,
        "not_ready": int(ready_s is None),
        "bad_exit": int(ended["exit_status"] != 0),
        **ended,
    }


class _Clock:
    """Publishes simulated time, a little faster than a hundred times a second."""

    def __init__(self) -> None:
        import rospy
        from rosgraph_msgs.msg import Clock

        self._rospy, self._message = rospy, Clock
        self._publisher = rospy.Publisher("/clock", Clock, queue_size=1)
        self.now_s, self.rate = 1000.0, 1.0
        threading.Thread(target=self._run, daemon=True).start()

    def _run(self) -> None:
        while True:
            time.sleep(0.01)
            self.now_s += 0.01 * self.rate
            self._publisher.publish(self._message(clock=self._rospy.Time.from_sec(self.now_s)))


def _other_clocks() -> FrozenSet[str]:
    """Return the names of the other nodes that publish time."""
    import rospy

    from roboframenet_ros.ros_master import TimedMaster

    return TimedMaster(timeout_s=10.0).system_state().publishers.get("/clock", frozenset()) - {rospy.get_name()}


def odd_clock(way: str) -> Mapping[str, Any]:
    """Drive while simulated time does something odd.

    Args:
        way: "absent", "paused", "ahead" or "back"
    """
    with running_robot(file=str(_SIMULATED_TIME)) as robot:
        clock = None if way == "absent" else _Clock()
        robot.wait_until_ready()
        stray = _other_clocks()
        if stray:
            raise AssertionError(f"time has another source: {', '.join(sorted(stray))}")
        before = robot.pids()
        robot.forget()
        text = "Move forward 1 metre."
        if clock is None:
            robot.reply_to(text, _REPLY_S)
            clock = _Clock()
            # A robot whose odometry has not come yet refuses to move, and is right.
            comes_true(lambda: robot.speed < math.inf, _REPLY_S)
        else:
            robot.say(text)
            comes_true(lambda: robot.speed > MOTION, 20.0)
            if way == "paused":
                clock.rate = 0.0
                robot.reply_to("Ping.", _REPLY_S)
                time.sleep(5.0)
                clock.rate = 1.0
            else:
                clock.now_s += {"ahead": 3600.0, "back": -100.0}[way]
            comes_true(lambda: bool(robot.replies(text=text)), _REPLY_S)
        outcomes = [robot.outcome_of("Turn left 20 degrees.", _REPLY_S), robot.outcome_of("Ping.", _REPLY_S)]
        after = robot.pids()
        return {
            "way": way,
            "unanswered": int(not robot.replies(text=text)) + outcomes.count(""),
            "not_done": sum(outcome != "DONE" for outcome in outcomes),
            "deaths": sum(after.get(node) != pid for node, pid in before.items()),
        }


def main() -> None:
    """Make the trial that the arguments name, and print what it found."""
    kind, *rest = sys.argv[1:]
    if kind == "launch":
        found = launch()
    elif kind == "order":
        found = launch(program=(sys.executable, "-m", "campaign.shuffled_launch", rest[0]))
    else:
        found = odd_clock(rest[0])
    print(json.dumps(found), flush=True)
    os._exit(0)


if __name__ == "__main__":
    main()
