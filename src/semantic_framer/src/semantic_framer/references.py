"""Resolves pronouns, and remembers what later pronouns may refer to."""

from dataclasses import replace
from typing import Iterable, Mapping, Union

from phrase_meanings.arguments import ONES, of_same_kind, resolved
from semantic_framer.dialogue import DEMONSTRATIVES, PLACE_PRONOUNS, PRONOUNS, Context
from semantic_framer.frame_roles import NO_THINGS, PLACES
from semantic_framer.reading import Reading
from semantic_framer.sentence import Sentence
from semantic_frames.frame import SemanticFrame
from typed_arguments import TypedArgument
from utterance_passes.clauses import Clause
from utterance_passes.persons import is_person
from word_classes import word_class

_PARTICIPANTS = word_class("participants")
_ROBOTS = word_class("robots")
#: FrameNet's names of elements for how something is.
_STATES = frozenset(["State", "Operational_state"])
_SOUND_SOURCE = "Sound_source"


def resolve(reading: Reading, context: Context) -> Union[Reading, TypedArgument]:
    """Resolve the pronouns of a reading; return the value of the first pronoun that cannot be resolved."""
    values = []
    for value in reading.arguments:
        word = value.text.lower()
        relation = next((relation for relation in reading.unit.relations if relation.name == value.name), None)
        # "This place" is meant literally. If a unit lists only pronouns, it asks for their referents. "Them" who get
        # something are persons, and only things and places are remembered.
        is_fixed = relation is not None and (bool(set(relation.words) - PRONOUNS) or relation.is_for_persons)
        if word in PRONOUNS - DEMONSTRATIVES and value.positions and not is_fixed:
            # "Go near the radio and switch it on": a place may also be a thing.
            if not context.thing and not context.place:
                return value
            value = resolved(value, context.thing or context.place)
        elif word in PLACE_PRONOUNS and not is_fixed and context.place:
            value = resolved(value, context.place)
        values.append(value)
    return reading if tuple(values) == reading.arguments else replace(reading, arguments=tuple(values))


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


def thing_told(sentence: Sentence, told: Iterable[Clause]) -> str:
    """Return the only thing that statements around a command are about, which a pronoun of the command stands for: "I
    can't reach *the biscuits*, get them for me". Empty if there is none, or more than one.

    Args:
        sentence: the sentence
        told: its clauses that ask for nothing
    """
    things = [
        word.index
        for clause in told
        for word in sentence.tree.children(clause.verb)
        if word.deprel.split(":")[0] in ("nsubj", "obj") and word.upos == "NOUN" and not is_person(word)
    ]
    return sentence.text(sorted(sentence.subtree(things[0]))) if len(things) == 1 else ""


def remember(reading: Reading, frames: Mapping[str, SemanticFrame], context: Context) -> Context:
    """Remember the thing and the place that a reading mentions."""
    frame = frames[reading.unit.frame_name]
    for value in reading.arguments:
        element = frame.element(value.name)
        if element is None or not value.positions or element.quantity is not None:
            continue
        if (element.framenet == "Category" and not value.quantifier) or element.framenet in _STATES:
            continue  # "The floor is dirty, clean it": dirty is no thing.
        if frame.is_condition and (value.semantic_type == "Human" or value.lemma in _ROBOTS):
            continue  # "If Bob is at the door, open it": Bob is no thing.
        # "When the bell rings, go to the door and open it": what is gone to counts for more.
        if element.framenet in PLACES or (frame.is_condition and element.framenet == _SOUND_SOURCE):
            context = replace(context, place=value.text)
        elif element.framenet not in NO_THINGS and value.text.lower() not in _PARTICIPANTS:
            context = replace(context, thing=value.text)
    return context
