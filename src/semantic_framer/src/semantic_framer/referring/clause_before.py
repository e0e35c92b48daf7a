"""What a clause takes from the clause before it in the same sentence."""

from dataclasses import replace
from typing import Mapping

from phrase_meanings.arguments import of_same_kind, resolved
from phrase_meanings.head_words import ONES
from semantic_framer.units.frame_roles import PLACES, THINGS
from semantic_framer.values.dialogue import DEMONSTRATIVES, PRONOUNS, Context
from semantic_framer.values.reading import Reading
from semantic_frames.frame import SemanticFrame
from typed_arguments import Source, TypedArgument
from word_classes import word_class

#: Relations of a place to what is put into it.
_INSIDE = word_class("prepositions_of_containers")
#: Types of what something is put on or into.
_HOLDING = frozenset(["Container", "Cookware", "Furniture", "Location", "Room"])


def resolve_in_parallel(reading: Reading, before: Reading, frames: Mapping[str, SemanticFrame]) -> Reading:
    """Resolve words that refer to the same element of the clause before: "take the red cup and the blue *one*", and, if
    both clauses share one verb, places: "put the cup on the table and the bowl on *it*".
    """
    frame = frames[reading.unit.frame_name]
    values = []
    for value in reading.arguments:
        element, other = frame.element(value.name), before.argument(value.name)
        if other is None or not value.positions:
            values.append(value)
            continue
        is_place = element is not None and element.framenet in PLACES
        shares_verb = reading.verb_positions == before.verb_positions
        if value.head.lower() in ONES and value.text.lower() not in PRONOUNS:
            value = of_same_kind(value, other)
        elif shares_verb and is_place and value.text.lower() in PRONOUNS - DEMONSTRATIVES:
            value = resolved(value, other.text)
        values.append(value)
    return replace(reading, arguments=tuple(values))


def with_thing_taken(
    reading: Reading, before: Reading, context: Context, frames: Mapping[str, SemanticFrame]
) -> Reading:
    """Let a deed that only says where something is put have what the deed before took: "take the plate and put *in the
    sink*"."""
    frame, elements_before = frames[reading.unit.frame_name], frames[before.unit.frame_name].frame_elements
    taken = [one for one in elements_before if one.is_core and one.framenet in THINGS]
    places = {element.name for element in frame.frame_elements if element.framenet in PLACES}
    is_put = any(
        value.semantic_type in _HOLDING or (value.semantic_type == "Device" and value.relation in _INSIDE)
        for value in reading.arguments
        if value.name in places and value.positions
    )
    if len(reading.missing) != 1 or reading.missing[0].framenet not in THINGS or len(taken) != 1 or not is_put:
        return reading
    thing = before.argument(taken[0].name)
    if thing is None or not context.things or context.things[0].text != thing.text:
        return reading
    name = reading.missing[0].name
    it = TypedArgument(name, "it", Source.INFERRED, words="it", head="it", lemma="it")
    order = [element.name for element in frame.frame_elements]
    values = (*reading.arguments, resolved(it, thing.text, context.things[0].phrases))
    return replace(reading, arguments=tuple(sorted(values, key=lambda one: order.index(one.name))), missing=())
