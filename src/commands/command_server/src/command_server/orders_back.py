"""Which cries take standing orders back: "forget that", right after an order, and "forget everything".

The first is no cry then. The command server decides it, and the stop server by what the command server tells: both
take it for a cry, or none does.
"""

from command_server.command_behind import command_behind
from command_server.cries import OBJECTS, Cry, Kind
from command_server.open_commands import Outcome
from command_server.spoken_words import plain_text, tokens_of
from command_server.stop_words import find_cry

ORDERS_STAGE = "standing_orders"
#: What the rest of the pipeline hears in the place of the words that a person uses.
FORGET_THAT = "Forget that."
FORGET_ALL = "Forget all standing orders."
#: A command that takes orders back counts as said so much later, nanoseconds. The stop server hears of the order's
#: reply over a topic of its own. If that comes a little behind these words, the words are a cry to it, and its stop
#: must not end the command.
SPARED_NS = 100_000_000
#: An order was just given if it was not longer ago, seconds.
_FRESH_S = 60.0
_PAUSES = frozenset(",.")
_ORDERS = frozenset(["orders"])
_ALL = frozenset(["everything"]) | _ORDERS
#: Words of a request that was said at a time, and of no other.
_OF_ONE = frozenset(["last", "previous", "current", "just"])


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
    return is_given and is_free and may_take_order_back(text)


def may_take_order_back(text: str) -> bool:
    """Whether an utterance takes an order back if one was given right before; otherwise it is a cry."""
    cry = find_cry(text)
    if cry is None or cry.kind not in (Kind.TAKE_BACK, Kind.FORGET):
        return False
    # "Forget it, stop!" stops, and "forget it, come back" is another command.
    return find_cry(cry.rest) is None and not command_behind(cry.rest)


def order_words(text: str) -> str:
    """Return what the rest of the pipeline hears in the place of a text that takes an order back, or all."""
    cry = find_cry(text)
    return FORGET_ALL if cry is not None and _names_all_orders(cry) else FORGET_THAT


def said_behind(cry: Cry) -> str:
    """Return what the robot is told to do after a cry; empty for nothing.

    The standing orders are taken back by a cry that names all of them: "forget everything", "cancel all orders". Who
    says "cancel everything" may mean what runs alone: the orders are suspended, as by any stop.
    """
    return command_behind(cry.rest) or (FORGET_ALL if _names_all_orders(cry) else "")


def _names_all_orders(cry: Cry) -> bool:
    words = [token.word for token in tokens_of(plain_text(cry.rest)[1])]
    end = next((place for place, word in enumerate(words) if word in _PAUSES or word not in OBJECTS), len(words))
    said = frozenset(words[:end])
    wanted = {Kind.FORGET: _ALL, Kind.TAKE_BACK: _ORDERS}.get(cry.kind, frozenset())
    return bool(said & wanted) and not said & _OF_ONE
