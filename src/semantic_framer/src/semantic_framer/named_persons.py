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
_PERSONS = word_class("persons_of_the_sentence")
_NO_NAMES = _PERSONS | word_class("participants") | word_class("pronouns")


def with_persons(clauses: Clauses, frames: Mapping[str, SemanticFrame]) -> Clauses:
    """Return clauses in which "she" and "him" are the person who was named last: "follow Anna until she sits down".

    Raises:
        Open: a condition is about a person who was not named
    """
    named: Optional[TypedArgument] = None
    done: List[Tuple[Reading, ...]] = []
    for readings in clauses:
        is_condition = frames[readings[0].unit.frame_name].is_condition
        made: List[Reading] = []
        for reading in readings:
            arguments: List[TypedArgument] = []
            for argument in reading.arguments:
                if argument.text.lower() in _PERSONS and named is not None:
                    argument = resolved(argument, named.text)
                elif argument.text.lower() in _PERSONS and is_condition:
                    raise Open(f'Whom do you mean by "{argument.text}"?')
                arguments.append(argument)
            made.append(replace(reading, arguments=tuple(arguments)))
        done.append(tuple(made))
        persons = [argument for argument in made[0].arguments if argument.semantic_type == _PERSON]
        named = next((one for one in persons if one.text.lower() not in _NO_NAMES), named)
    return tuple(done)
