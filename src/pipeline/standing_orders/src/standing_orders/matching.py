"""Which standing orders a person means: "forget the bell", "forget that"."""

from typing import Sequence, Tuple

from standing_orders.order import StandingOrder
from word_classes import word_class

_THAT = word_class("pronouns")
_ALL = word_class("words_for_all")
_AROUND = word_class("around_orders")


def orders_meant(phrase: str, orders: Sequence[StandingOrder]) -> Tuple[StandingOrder, ...]:
    """Return the orders that a phrase means: all that have all of its words.

    Args:
        phrase: "the bell", "that", "everything", "the order at eight"; empty for the last order
        orders: that are kept, oldest first
    """
    words = [word.strip(".,!?\"'").lower() for word in phrase.split()]
    own = [word for word in words if word and _stem(word) not in _AROUND and word not in _AROUND]
    is_plural = any(word not in _AROUND and _stem(word) in _AROUND for word in words)
    if (own or is_plural) and all(word in _ALL for word in own):
        return tuple(orders)
    own = [word for word in own if word not in _ALL]
    if not own or all(word in _THAT for word in own):
        return tuple(orders[-1:])
    return tuple(order for order in orders if set(map(_stem, own)) <= set(map(_stem, _words(order))))


def _words(order: StandingOrder) -> Sequence[str]:
    return [word.strip(".,!?\"'").lower() for word in f"{order.text} {order.sentence}".split()]


def _stem(word: str) -> str:
    """Return a word without its ending: "bells" and "bell", "ringing" and "rings" are the same here."""
    for ending in ("ing", "s"):
        if word.endswith(ending) and len(word) > len(ending) + 2:
            return word[: -len(ending)]
    return word
