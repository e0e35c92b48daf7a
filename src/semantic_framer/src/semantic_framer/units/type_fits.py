"""Compares the semantic types of words with those that lexical units and frames ask for."""

from dataclasses import replace
from typing import FrozenSet, Iterable, List, NamedTuple, Tuple

from phrase_meanings.phrase_types import PhraseTypes
from semantic_framer.values.reading import Reading, WrongType
from semantic_frames.frame import SemanticFrame
from semantic_frames.lexical_unit import ElementRelation
from semantic_types import Fit
from typed_arguments import TypedArgument
from word_classes import word_class

_PERSONS_OR_THINGS = word_class("pronouns_of_persons_or_things")
_THINGS = word_class("pronouns_of_things")


class TypedArguments(NamedTuple):
    """The arguments of a reading, with their semantic types.

    Attributes:
        arguments: of several types of its words, each has the likeliest one that its frame element accepts
        wrong: arguments whose words have none of the types of their frame element, or, as a person's name, a rare one
        doubtful: elements whose words have one of the types in a rare sense only
    """

    arguments: Tuple[TypedArgument, ...]
    wrong: Tuple[WrongType, ...]
    doubtful: FrozenSet[str]


def fit_of_relation(types: PhraseTypes, head: int, relation: ElementRelation) -> Fit:
    """Return how well words that a relation does not list fit it: the types that it asks for must be their usual ones.

    Words without a type, and pronouns that may have it, fit only a required relation, because otherwise the unit has a
    better place for them.
    """
    if relation.is_for_persons and types.word(head).lower() in _THINGS:
        return Fit.WRONG
    if not relation.semantic_types:
        return Fit.WRONG if relation.words else Fit.LIKELY
    fit = types.fit(head, relation.semantic_types)
    # "Take them to the hall" is guiding or carrying.
    is_open = fit is Fit.UNKNOWN or (fit is Fit.POSSIBLE and types.word(head).lower() in _PERSONS_OR_THINGS)
    return fit if fit is Fit.LIKELY or (is_open and relation.is_required) else Fit.WRONG


def accepted_types(reading: Reading, name: str, frame: SemanticFrame) -> Tuple[str, ...]:
    """Return the semantic types that the unit of a reading, or else its frame, accepts for an element; none if it
    accepts anything."""
    relation = next((relation for relation in reading.unit.relations if relation.name == name), None)
    element = frame.element(name)
    return (relation.semantic_types if relation else ()) or (element.semantic_types if element else ())


def with_types(arguments: Iterable[TypedArgument], frame: SemanticFrame, types: PhraseTypes) -> TypedArguments:
    """Compare arguments with the semantic types that their frame elements accept."""
    typed: List[TypedArgument] = []
    wrong: List[WrongType] = []
    doubtful: List[str] = []
    for argument in arguments:
        element = frame.element(argument.name)
        accepted = element.semantic_types if element is not None else ()
        if accepted and argument.head_position and argument.measure is None:
            head = argument.head_position
            likeliest = types.of(head).likeliest(accepted)
            if likeliest != argument.semantic_type:
                argument = replace(argument, semantic_type=likeliest)
            fit = types.fit(head, accepted)
            # The saint's name is a place, too, but who says "open Peter" means the person.
            if fit is Fit.WRONG or (fit is Fit.POSSIBLE and any(map(types.is_name_of_being, types.items(head)))):
                items = types.items(head)
                worst = max(items, key=lambda item: types.of(item).fit(accepted))
                words = argument.text if len(items) == 1 else types.word(worst)
                wrong.append(WrongType(argument.name, words, types.likeliest(worst), accepted))
            elif fit is Fit.POSSIBLE:
                doubtful.append(argument.name)
        typed.append(argument)
    return TypedArguments(tuple(typed), tuple(wrong), frozenset(doubtful))
