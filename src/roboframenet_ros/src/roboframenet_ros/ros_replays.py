"""Refuses commands that ``rosbag play`` repeats beside the robot."""

from typing import Optional

import rospy
from roboframenet_msgs.msg import Command, CommandStatus, Reply

from roboframenet_ros.command_ids import TextIds, TextSource
from roboframenet_ros.replays import Replays
from roboframenet_ros.ros_stage import Stage

#: Code of the reply to a command that a recording repeats.
REPLAYED = "REPLAYED"


class ReplayWatch:
    """Guards a stage whose commands begin to act. Subscribes: ``status``."""

    def __init__(self, stage: Stage) -> None:
        """
        Args:
            stage: that refuses
        """
        self._stage = stage
        self._replays = Replays()
        self._ids = TextIds(TextSource.REPLAYED)
        self._subscriber: Optional[rospy.Subscriber] = None

    def start(self) -> None:
        """Listen to the command server."""
        self._subscriber = rospy.Subscriber("status", CommandStatus, self._hear, queue_size=10)

    def refuses(self, command: Command) -> bool:
        """Take a command, or refuse one that a recording repeats; returns whether it is refused.

        The refusal has an id of its own: the command may have had its one reply, or may run just now.
        """
        now_ns = rospy.Time.now().to_nsec()
        why = self._replays.refusal(command.id, stamp_ns=command.stamp.to_nsec(), now_ns=now_ns)
        if why:
            rospy.logwarn("cmd=%s is refused: %s", command.id, why)
            told = Command(id=self._ids.next_id(), stamp=command.stamp, text=command.text, robot=command.robot)
            self._stage.ends(told, outcome=Reply.REFUSED, code=REPLAYED, sentence=why)
        return bool(why)

    def _hear(self, status: CommandStatus) -> None:
        self._replays.hear_open(
            [command.id for command in status.active],
            stamp_ns=status.stamp.to_nsec(),
            now_ns=rospy.Time.now().to_nsec(),
        )
