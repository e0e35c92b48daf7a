"""Whether an utterance takes back the standing order to which the last reply was given."""

from collections import deque
from typing import Deque, FrozenSet

import rospy
from roboframenet_msgs.msg import Command, CommandStatus, Reply

from command_server.follow_ups import is_follow_up
from command_server.open_commands import OWN_STAGE, STOP_STAGE
from command_server.orders_back import may_take_order_back, takes_order_back
from command_server.spoken_words import words_of

#: What the command server has heard is what another node hears now, if it is not older, seconds.
_SAME_S = 2.0
_MOST_TOLD = 100


def takes_back(text: str, last: Reply, *, is_free: bool) -> bool:
    """See :func:`command_server.orders_back.takes_order_back`.

    Args:
        text: as it was said
        last: the last reply
        is_free: whether no command is open
    """
    return takes_order_back(text, is_free=is_free, stage=last.stage, outcome=last.outcome, age_s=_age_s(last.stamp))


def may_be_order_taken_back(command: Command) -> bool:
    """Whether a command may be an utterance that takes an order back, instead of a cry; what follows a cry is none."""
    return may_take_order_back(command.text) and not is_follow_up(command.id)


class OrdersTakenBack:
    """Follows the command server, which decides what "forget that" means, for a node that hears the same words.

    The command server may be behind this node: then its status is the one by which it will decide. It may be ahead, by
    one command or by several: then it has told of the utterance as a command, open or answered, and a cry is none. The
    messages of two topics come in any order. Any number of threads may call.
    """

    def __init__(self) -> None:
        self._status = CommandStatus()
        self._told: Deque[Command] = deque(maxlen=_MOST_TOLD)
        self._open_ids: FrozenSet[str] = frozenset()

    def hear_status(self, status: CommandStatus) -> None:
        """The command server tells which commands are open, and its last reply."""
        # Each status has all open commands: in a storm they are many, and most of them were in the last one.
        known, self._open_ids = self._open_ids, frozenset(command.id for command in status.active)
        for command in status.active:
            if command.id not in known:
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
        if any(_is_said_now(text, command) for command in tuple(self._told)):
            return True
        status = self._status
        return takes_back(text, status.last_reply, is_free=not status.active)

    def _note(self, command: Command) -> None:
        if may_be_order_taken_back(command) and all(told.id != command.id for told in tuple(self._told)):
            self._told.append(command)


def _is_said_now(text: str, command: Command) -> bool:
    return words_of(command.text) == words_of(text) and abs(_age_s(command.stamp)) <= _SAME_S


def _age_s(stamp: rospy.Time) -> float:
    return (rospy.Time.now() - stamp).to_sec()
