"""A robot answers what was said to all robots while the node ``fleet`` did not run."""

from typing import Tuple

import rospy
from roboframenet_msgs.msg import Command, ExecuteCommandActionGoal, Fleet, Reply
from std_msgs.msg import String

from roboframenet_ros.command_ids import TextIds, TextSource
from roboframenet_ros.ros_taken_texts import UntakenWatch
from roboframenet_ros.untaken_texts import Said
from robot_fleet.addressing import listed
from robot_fleet.robot_names import Names
from robot_fleet.stops import stopped_by

STAGE = "robot_fleet"
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
        self._watch = UntakenWatch(self._answer)
        self._names, self._there = Names({robot: ()}), (robot,)
        self._ids = TextIds(TextSource.UNHEARD)
        self._reply = rospy.Publisher("fleet_reply", Reply, queue_size=100)

    def start(self) -> None:
        """Listen."""
        self._watch.start(taken="fleet_text_taken", started="fleet_started")
        self._subscribers = [
            rospy.Subscriber("fleet", Fleet, self._hear_fleet, queue_size=1),
            rospy.Subscriber("fleet_text", String, lambda message: self._watch.hear(message.data), queue_size=100),
            rospy.Subscriber(
                "fleet_command/goal",
                ExecuteCommandActionGoal,
                lambda message: self._watch.hear(message.goal.text, message.goal_id.id),
                queue_size=100,
            ),
        ]

    def close(self) -> None:
        """Answer nothing more."""
        self._watch.close()

    def _answer(self, said: Said) -> None:
        if self._there[:1] != (self._robot,):
            return
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

    def _hear_fleet(self, fleet: Fleet) -> None:
        there = {robot.name: robot.spoken_names for robot in fleet.robots}
        self._names = Names({**dict.fromkeys(fleet.absent, ()), **there})
        self._there = tuple(sorted(there))


def _they(robots: Tuple[str, ...]) -> str:
    return "they stand" if len(robots) > 1 else "it stands"
