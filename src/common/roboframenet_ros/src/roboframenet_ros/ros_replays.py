"""Refuses commands that ``rosbag play`` repeats beside the robot."""

from typing import Optional

import actionlib
import rospy
from roboframenet_msgs.msg import Command, CommandStatus, Reply

from roboframenet_ros.command_ids import TextIds, TextSource
from roboframenet_ros.replays import AGAIN, OLDEST_NS, Replays, Taken
from roboframenet_ros.ros_stage import Stage

#: Code of the reply to a command that a recording repeats.
REPLAYED = "REPLAYED"


class GoalsOnce:
    """Takes each goal of an action once. One thread owns it."""

    def __init__(self) -> None:
        """Start with none."""
        self._taken = Taken()

    def refuses(self, handle: actionlib.ServerGoalHandle) -> bool:
        """Take a goal, or reject one that was taken; returns whether it is rejected."""
        goal_id = handle.get_goal_id().id
        if goal_id not in self._taken:
            self._taken.add(goal_id)
            return False
        handle.set_rejected(None, AGAIN)
        return True


class ReplayWatch:
    """Guards a stage. One whose commands begin to act is told which commands are open; subscribes then: ``status``."""

    def __init__(self, stage: Stage, *, oldest_ns: int = OLDEST_NS) -> None:
        """
        Args:
            stage: that refuses
            oldest_ns: what is older is one of a recording, nanoseconds, unless it is open
        """
        self._stage = stage
        self._replays = Replays(oldest_ns=oldest_ns)
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
            self._stage.ends(told, outcome=Reply.REFUSED, code=REPLAYED, sentence=why, is_kept=False)
        return bool(why)

    def _hear(self, status: CommandStatus) -> None:
        self._replays.hear_open(
            [command.id for command in status.active],
            stamp_ns=status.stamp.to_nsec(),
            now_ns=rospy.Time.now().to_nsec(),
        )
