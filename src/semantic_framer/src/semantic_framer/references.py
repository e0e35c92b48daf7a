"""What pronouns stand for, and what later ones may stand for."""

from dataclasses import replace
from typing import Mapping, Union

from semantic_framer.dialogue import DEMONSTRATIVES, PLACE_PRONOUNS, PRONOUNS, Context
from semantic_framer.frame_roles import NO_THINGS, PLACES
from semantic_framer.reading import ElementValue, Reading
from semantic_framer.values import resolved
from semantic_frames.frame import SemanticFrame
from word_classes import word_class

_PARTICIPANTS = word_class("participants")


def resolve(reading: Reading, context: Context) -> Union[Reading, ElementValue]:
    """Put what pronouns stand for in their place; return the value of one that stands for nothing known."""
    values = []
    for value in reading.values:
        word = value.argument.lower()
        relation = next((relation for relation in reading.unit.relations if relation.name == value.name), None)
        # "This place" is what was said; a unit that lists nothing but pronouns wants what they stand for.
        is_fixed = relation is not None and bool(set(relation.words) - PRONOUNS)
        if word in PRONOUNS - DEMONSTRATIVES and value.positions and not is_fixed:
            # "Go near the radio and switch it on": a place is a thing too.
            if not context.thing and not context.place:
                return value
            value = resolved(value, context.thing or context.place)
        elif word in PLACE_PRONOUNS and not is_fixed and context.place:
            value = resolved(value, context.place)
        values.append(value)
    return replace(reading, values=tuple(values))


def remember(reading: Reading, frames: Mapping[str, SemanticFrame], context: Context) -> Context:
    """Remember the thing and the place that a reading speaks of."""
    frame = frames[reading.unit.frame_name]
    for value in reading.values:
        element = frame.element(value.name)
        if element is None or not value.positions or element.quantity is not None:
            continue
        if element.framenet in PLACES:
            context = replace(context, place=value.argument)
        elif element.framenet not in NO_THINGS and value.argument.lower() not in _PARTICIPANTS:
            context = replace(context, thing=value.argument)
    return context
