"""Joins a wish for a thing to the command for the same thing: "I would like some tea, can you get it for me?" asks for
one tea."""

from typing import Mapping, Optional, Tuple

from phrase_meanings.arguments import referring_to
from semantic_framer.units.frame_roles import THEME
from semantic_framer.values.reading import Reading, with_argument
from semantic_frames.frame import SemanticFrame
from typed_arguments import TypedArgument
from word_classes import word_class

#: What stands for a thing of the kind that was wished for: "bring me *one*".
_ANY_OF_THEM = word_class("indefinite_articles") | word_class("noun_standins")

Clauses = Tuple[Tuple[Reading, ...], ...]


def without_granted_wishes(clauses: Clauses, frames: Mapping[str, SemanticFrame]) -> Clauses:
    """Remove each wish for a thing that a later clause of the utterance is a command for.

    Args:
        clauses: the readings of each clause, best first, with their pronouns resolved
        frames: by name
    """
    kept = list(clauses)
    for position in reversed(range(len(clauses) - 1)):
        wish = kept[position][0]
        thing = next((one for one in wish.arguments if one.positions and _is_theme(wish, one, frames)), None)
        if not wish.is_wish or thing is None:
            continue
        for later in range(position + 1, len(kept)):
            granting = [_granting(reading, wish, thing) for reading in kept[later]]
            if granting[0] is not None:
                kept[later] = tuple(reading for reading in granting if reading is not None)
                del kept[position]
                break
    return tuple(kept)


def _is_theme(reading: Reading, argument: TypedArgument, frames: Mapping[str, SemanticFrame]) -> bool:
    element = frames[reading.unit.frame_name].element(argument.name)
    return element is not None and element.framenet == THEME


def _granting(reading: Reading, wish: Reading, thing: TypedArgument) -> Optional[Reading]:
    """Return a command with all that was said in the wish for its thing; None if it is no command for that thing."""
    same = next((one for one in reading.arguments if one.positions and _is_same(one, thing)), None)
    if same is None or reading.is_wish:
        return None
    if same.text.lower() in _ANY_OF_THEM:
        reading = with_argument(reading, referring_to(same, thing))
    for other in wish.arguments:
        if other.positions and other is not thing and reading.argument(other.name) is None:
            if reading.unit.frame_name != wish.unit.frame_name:
                return None
            reading = with_argument(reading, other)
    return reading


def _is_same(argument: TypedArgument, thing: TypedArgument) -> bool:
    is_resolved = argument.text.lower() == thing.text.lower()
    return is_resolved or argument.head.lower() == thing.head.lower() or argument.text.lower() in _ANY_OF_THEM
