"""Things of a kind that was spoken of: "one", "the red one", "two", "some"."""

from dataclasses import replace
from typing import Optional

from phrase_meanings.arguments import of_same_kind
from phrase_meanings.head_words import ONES
from referring_expressions.describing import plural_of
from semantic_framer.values.dialogue import DEMONSTRATIVES
from spoken_quantities.numbers import find_whole_number
from typed_arguments import TypedArgument
from word_classes import word_class

_ORDINALS = word_class("ordinals") | word_class("last_ordinals")
#: Behind a number of further things.
_MORE = " more"
#: Without a noun, they name an amount of what was spoken of.
_SOME = word_class("quantifiers_of_some")


def is_one_more(value: TypedArgument) -> bool:
    """Whether a phrase names another thing of a kind: "one", "the red one"; "this one" is shown, not named."""
    is_one = value.head.lower() in ONES and bool(value.positions) and value.measure is None
    return is_one and value.quantifier not in DEMONSTRATIVES


def is_one_in_order(value: TypedArgument) -> bool:
    """Whether a phrase chooses by order: "take the cup", "take the plate", "put *the first one* on the table"."""
    return any(modifier.word.lower() in _ORDINALS for modifier in value.modifiers)


def number_alone(value: TypedArgument) -> int:
    """Return how many things a phrase names without their noun: "bring me *two*", "*two more*"; 0 for none."""
    text = value.text.lower()
    number = find_whole_number(text[: -len(_MORE)] if text.endswith(_MORE) else text)
    return number if number is not None and number > 0 and value.positions and value.measure is None else 0


def so_many(value: TypedArgument, count: Optional[int], thing: TypedArgument) -> TypedArgument:
    """Return so many things of the kind that was spoken of: "are there apples?", "bring me two", "bring me some".

    Args:
        value: the number or the amount alone
        count: its value; None for an amount that is no number
        thing: what was spoken of
    """
    kind = of_same_kind(value, thing)
    is_counted = thing.is_plural or thing.quantifier == "a" or thing.count is not None
    is_plural = is_counted if count is None else count > 1
    noun = plural_of(kind.lemma) if is_plural else kind.lemma
    return replace(kind, text=f"{value.text} {noun}", count=count, is_plural=is_plural)


def of_the_same_kind(value: TypedArgument, kind: TypedArgument) -> TypedArgument:
    """Return a thing of the kind that was spoken of: "one", "the red one".

    Args:
        value: the phrase without its noun
        kind: what was spoken of
    """
    made = of_same_kind(value, kind)
    if value.text.lower() != "one":
        return made
    return replace(made, text=kind.text if kind.quantifier == "a" else f"one {made.text}", count=1)


def is_some(value: TypedArgument) -> bool:
    """Whether a phrase names an amount without its noun: "bring me *some*"."""
    words = frozenset(value.text.lower().split())
    return bool(words & _SOME) and words <= _SOME | {"a", "more"} and bool(value.positions)
