"""Whether "forget that" takes back the standing order that was just given, instead of stopping the robot.

The stop server and the command server decide this by the same latched status: both take it for a cry, or none does.
"""

from command_server.command_behind import command_behind
from command_server.cries import Kind
from command_server.open_commands import Outcome
from command_server.stop_words import find_cry

ORDERS_STAGE = "standing_orders"
#: What the rest of the pipeline hears in the place of the words that a person uses.
FORGET_THAT = "Forget that."
#: An order was just given if it was not longer ago, seconds.
_FRESH_S = 60.0


def takes_order_back(text: str, *, is_free: bool, stage: str, outcome: int, age_s: float) -> bool:
    """Whether an utterance takes back the standing order that was given right before.

    Args:
        text: as it was said
        is_free: whether no command is open; whatever runs could be meant
        stage: of the last reply
        outcome: of the last reply
        age_s: of the last reply, seconds
    """
    is_given = stage == ORDERS_STAGE and outcome == Outcome.DONE and 0.0 <= age_s <= _FRESH_S
    if not (is_given and is_free):
        return False
    cry = find_cry(text)
    if cry is None or cry.kind not in (Kind.TAKE_BACK, Kind.FORGET):
        return False
    # "Forget it, stop!" stops, and "forget it, come back" is another command.
    return find_cry(cry.rest) is None and not command_behind(cry.rest)
