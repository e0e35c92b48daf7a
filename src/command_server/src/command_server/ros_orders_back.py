"""Whether an utterance takes back the standing order to which the last reply was given."""

import rospy
from roboframenet_msgs.msg import Command, CommandStatus, Reply

from command_server.follow_ups import is_follow_up
from command_server.open_commands import OWN_STAGE, STOP_STAGE
from command_server.orders_back import may_take_order_back, takes_order_back
from command_server.spoken_words import words_of

#: What the command server has heard is what another node hears now, if it is not older, seconds.
_SAME_S = 2.0


def takes_back(text: str, last: Reply, *, is_free: bool) -> bool:
    """See :func:`command_server.orders_back.takes_order_back`.

    Args:
        text: as it was said
        last: the last reply
        is_free: whether no command is open
    """
    return takes_order_back(text, is_free=is_free, stage=last.stage, outcome=last.outcome, age_s=_age_s(last.stamp))


def is_taken_back(text: str, status: CommandStatus) -> bool:
    """Whether the command server takes an utterance for one that takes an order back, by the status that it tells.

    It may be ahead: the status may show the utterance as a command, open or answered, and a cry is none.

    Args:
        text: as it was said, or the part that is for this robot
        status: the last one
    """
    last = status.last_reply
    if status.active:
        return may_take_order_back(text) and len(status.active) == 1 and _is_said_now(text, status.active[0])
    if last.stage not in (STOP_STAGE, OWN_STAGE) and may_take_order_back(text) and _is_said_now(text, last.command):
        return True
    return takes_back(text, last, is_free=True)


def _is_said_now(text: str, command: Command) -> bool:
    is_same = words_of(command.text) == words_of(text) and not is_follow_up(command.id)
    return is_same and abs(_age_s(command.stamp)) <= _SAME_S


def _age_s(stamp: rospy.Time) -> float:
    return (rospy.Time.now() - stamp).to_sec()
