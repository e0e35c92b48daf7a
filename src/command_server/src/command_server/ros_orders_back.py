"""Whether an utterance takes back the standing order to which the last reply was given."""

import time
from collections import deque
from dataclasses import dataclass
from typing import Callable, Deque

import rospy
from roboframenet_msgs.msg import Command, CommandStatus, Reply

from command_server.follow_ups import is_follow_up
from command_server.open_commands import OWN_STAGE, STOP_STAGE
from command_server.orders_back import may_take_order_back, takes_order_back
from command_server.spoken_words import words_of

#: What the command server told of an utterance is true of the one that is heard here, if it was not told longer ago,
#: seconds.
_SAME_S = 2.0
_MOST_TOLD = 100


def takes_back(text: str, last: Reply, *, is_free: bool) -> bool:
    """See :func:`command_server.orders_back.takes_order_back`.

    Args:
        text: as it was said
        last: the last reply
        is_free: whether no command is open
    """
    age_s = (rospy.Time.now() - last.stamp).to_sec()
    return takes_order_back(text, is_free=is_free, stage=last.stage, outcome=last.outcome, age_s=age_s)


def may_be_order_taken_back(command: Command) -> bool:
    """Whether a command may be an utterance that takes an order back, instead of a cry; what follows a cry is none."""
    return may_take_order_back(command.text) and not is_follow_up(command.id)


@dataclass(frozen=True)
class _Told:
    command_id: str
    words: str
    told_s: float


class OrdersTakenBack:
    """Follows the command server, which decides what "forget that" means, for a node that hears the same words.

    The command server may be behind this node: then its status is the one by which it will decide. It may be ahead, by
    one command or by several: then it has told of the utterance as a command, open or answered, and a cry is none. The
    messages of two topics come in any order. Any number of threads may call.
    """

    def __init__(self, *, now: Callable[[], float] = time.monotonic) -> None:
        """Start with nothing told.

        Args:
            now: monotonic clock, seconds
        """
        self._now = now
        self._status = CommandStatus()
        self._told: Deque[_Told] = deque(maxlen=_MOST_TOLD)

    def hear_status(self, status: CommandStatus) -> None:
        """The command server tells which commands are open, and its last reply."""
        for command in status.active:
            self._note(command)
        self.hear_reply(status.last_reply)
        self._status = status

    def hear_reply(self, reply: Reply) -> None:
        """The command server, or a node that stops the robot, has replied."""
        if reply.stage not in (STOP_STAGE, OWN_STAGE):
            self._note(reply.command)

    def is_meant(self, text: str) -> bool:
        """Whether the command server takes an utterance that is heard now for one that takes an order back.

        Args:
            text: as it was said, or the part that is for this robot
        """
        if not may_take_order_back(text):
            return False
        said = words_of(text)
        since_s = self._now() - _SAME_S
        if any(told.words == said and told.told_s >= since_s for told in tuple(self._told)):
            return True
        status = self._status
        return takes_back(text, status.last_reply, is_free=not status.active)

    def _note(self, command: Command) -> None:
        if may_be_order_taken_back(command) and all(told.command_id != command.id for told in tuple(self._told)):
            self._told.append(_Told(command.id, words_of(command.text), self._now()))
