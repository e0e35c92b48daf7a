"""Persons whom a later clause of a sentence only points at: "when Anna comes in, greet *her*"."""

from dataclasses import replace
from typing import List, Mapping, Optional, Tuple

from phrase_meanings.arguments import resolved
from semantic_framer.clause_plan import Clauses
from semantic_framer.linked_clauses import Open
from semantic_framer.reading import Reading
from semantic_frames.frame import SemanticFrame
from typed_arguments import TypedArgument
from word_classes import word_class

#: FrameNet's semantic type of persons.
_PERSON = "Human"
_PERSONAL = frozenset([_PERSON, "Sentient"])
_PERSONS = word_class("persons_of_the_sentence")
_ANYBODY = word_class("indefinite_persons") | word_class("indefinite_persons_asked")
_THEM = word_class("pronouns_of_anybody")
_NO_NAMES = _PERSONS | word_class("participants") | word_class("pronouns")


def with_persons(clauses: Clauses, frames: Mapping[str, SemanticFrame]) -> Clauses:
    """Return clauses in which "she" and "him" are the person who was named last: "follow Anna until she sits down".

    "They" and "them" are whoever is meant: "whenever somebody comes in, greet *them*".

    Raises:
        Open: a condition is about a person who was not named
    """
    named: Optional[TypedArgument] = None
    met: Optional[TypedArgument] = None
    done: List[Tuple[Reading, ...]] = []
    for readings in clauses:
        is_condition = frames[readings[0].unit.frame_name].is_condition
        made: List[Reading] = []
        for reading in readings:
            arguments: List[TypedArgument] = []
            for argument in reading.arguments:
                element = frames[reading.unit.frame_name].element(argument.name)
                is_person = element is not None and bool(_PERSONAL.intersection(element.semantic_types))
                if argument.text.lower() in _THEM and met is not None and is_person:
                    argument = resolved(argument, met.text)
                elif argument.text.lower() in _PERSONS and named is not None:
                    argument = resolved(argument, named.text)
                elif argument.text.lower() in _PERSONS and is_condition:
                    raise Open(f'Whom do you mean by "{argument.text}"?')
                arguments.append(argument)
            made.append(replace(reading, arguments=tuple(arguments)))
        done.append(tuple(made))
        persons = [argument for argument in made[0].arguments if argument.semantic_type == _PERSON]
        named = next((one for one in persons if one.text.lower() not in _NO_NAMES), named)
        met = next((one for one in made[0].arguments if one.text.lower() in _ANYBODY), met)
    return tuple(done)
