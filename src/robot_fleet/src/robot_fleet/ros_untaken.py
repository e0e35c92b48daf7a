"""A robot answers what was said to all robots while the node ``fleet`` did not run."""

import threading
import time
from typing import Optional, Tuple

import rospy
from roboframenet_msgs.msg import Command, ExecuteCommandActionGoal, Fleet, Reply
from std_msgs.msg import Empty, String

from roboframenet_ros.command_ids import TextIds, TextSource
from robot_fleet.addressing import listed
from robot_fleet.robot_names import Names
from robot_fleet.stops import stopped_by
from robot_fleet.untaken_texts import Untaken, UntakenTexts

STAGE = "robot_fleet"
#: Until then after its start, the node hears what is said, and has told what it took; seconds.
_LISTENING_S = 3.0
_TAKEN_S = 6.0
_RESTARTED = "Nobody took that: fleet was being restarted."


class UntakenOfFleet:
    """Follows what is said to all robots, as each robot does; the first of those that are there answers.

    Subscribes: ``fleet_text``, ``fleet_command/goal``, ``fleet_text_taken``, ``fleet_started``, ``fleet``. Publishes:
    ``fleet_reply``.
    """

    def __init__(self, robot: str) -> None:
        """
        Args:
            robot: the name of this one
        """
        self._robot = robot
        self._lock = threading.Lock()
        self._texts = UntakenTexts()
        self._names, self._there = Names({robot: ()}), (robot,)
        self._started_s: Optional[float] = None
        self._ids = TextIds(TextSource.UNHEARD)
        self._reply = rospy.Publisher("fleet_reply", Reply, queue_size=100)

    def start(self) -> None:
        """Listen."""
        self._subscribers = [
            rospy.Subscriber("fleet", Fleet, self._hear_fleet, queue_size=1),
            rospy.Subscriber("fleet_text", String, lambda message: self._hear(message.data), queue_size=100),
            rospy.Subscriber(
                "fleet_command/goal",
                ExecuteCommandActionGoal,
                lambda message: self._hear(message.goal.text, message.goal_id.id),
                queue_size=100,
            ),
            rospy.Subscriber("fleet_text_taken", String, self._hear_taken, queue_size=1000),
            rospy.Subscriber("fleet_started", Empty, self._hear_start, queue_size=1),
        ]

    def turn(self) -> None:
        """Answer what nobody took, some time after the node was started."""
        with self._lock:
            if self._started_s is None or time.monotonic() < self._started_s + _TAKEN_S:
                return
            untaken = self._texts.take(before_s=self._started_s + _LISTENING_S)
            self._started_s = None
        for said in untaken if self._there[:1] == (self._robot,) else ():
            self._answer(said)

    def _answer(self, said: Untaken) -> None:
        stopped = stopped_by(said.text, self._there, self._names)
        are = "Say it again if you still want it."
        if stopped:
            are = f"{listed(stopped)} heard the stop, but I do not know whether {_they(stopped)} still."
        now = rospy.Time.now()
        command = Command(id=said.command_id or self._ids.next_id(), stamp=now, text=said.text)
        sentence = f"{_RESTARTED} {are}"
        rospy.logwarn("cmd=%s %r: %s", command.id, said.text, sentence)
        self._reply.publish(
            Reply(command=command, outcome=Reply.FAILED, stage=STAGE, code="RESTARTED", sentence=sentence, stamp=now)
        )

    def _hear(self, text: str, command_id: str = "") -> None:
        with self._lock:
            self._texts.hear(text, command_id)

    def _hear_taken(self, message: String) -> None:
        command_id, _, text = message.data.partition(" ")
        with self._lock:
            self._texts.hear_taken(command_id, text)

    def _hear_start(self, _message: Empty) -> None:
        with self._lock:
            self._started_s = time.monotonic()

    def _hear_fleet(self, fleet: Fleet) -> None:
        there = {robot.name: robot.spoken_names for robot in fleet.robots}
        self._names = Names({**dict.fromkeys(fleet.absent, ()), **there})
        self._there = tuple(sorted(there))


def _they(robots: Tuple[str, ...]) -> str:
    return "they stand" if len(robots) > 1 else "it stands"
