"""Events of the worker besides messages: texts and goals, cancelled goals, and the state of its brake."""

import re
import time
from dataclasses import dataclass, field
from typing import Any, Optional

import actionlib
import rospy
from std_msgs.msg import String

from command_server.beside_cries import words_not_done
from robot_stop.braking import Finding
from robot_stop.ros_brake import Braked
from robot_stop.sentences import sentence_of, sentence_of_rest

# The name that rosbag play gives itself.
_PLAYER = re.compile(r"/play_\d+$")


@dataclass(frozen=True)
class Said:
    """A text or a goal.

    Attributes:
        text: as it was said
        arrival_ns: nanoseconds of ROS time
        handle: of the goal; None for a text
        delay_s: how long the goal was on its way, by the clocks of both ends; 0 for one without a stamp
        arrival_s: monotonic seconds
        is_played: whether it comes from a bag that is played, and not from a person
    """

    text: str
    arrival_ns: int
    handle: Optional[actionlib.ServerGoalHandle] = None
    delay_s: float = 0.0
    arrival_s: float = field(default_factory=time.monotonic)
    is_played: bool = False


def said_by_goal(handle: actionlib.ServerGoalHandle) -> Said:
    """Return what a goal says."""
    now, sent = rospy.Time.now(), handle.get_goal_id().stamp
    delay_s = (now - sent).to_sec() if sent else 0.0
    return Said(handle.get_goal().text, now.to_nsec(), handle, delay_s, is_played=is_played(handle.goal))


def said_by_text(message: String) -> Said:
    """Return what a text says."""
    return Said(message.data, rospy.Time.now().to_nsec(), is_played=is_played(message))


def is_played(message: Any) -> bool:
    """Whether a message comes from ``rosbag play``."""
    return _PLAYER.search((getattr(message, "_connection_header", None) or {}).get("callerid", "")) is not None


@dataclass(frozen=True)
class GoalCancelled:
    """The client of a goal cancelled it."""

    command_id: str


@dataclass(frozen=True)
class Braking:
    """The stop that the brake carried out, and who obeyed it."""

    braked: Optional[Braked] = None
    finding: Optional[Finding] = None

    def standing(self, text: str, *, limit_s: float) -> str:
        """Say whether the robot stands still, and what is not done of the utterance that stopped it.

        Args:
            text: the utterance
            limit_s: longest time for which zero velocity is repeated, seconds
        """
        standing = "I do not know whether the robot still moves."
        if self.braked is not None and self.finding is not None:
            standing = sentence_of(self.finding, server_count=len(self.braked.cancelled), limit_s=limit_s)
        return f"{standing} {sentence_of_rest(words_not_done(text))}".strip()
