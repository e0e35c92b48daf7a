"""Persons whom a later clause of a sentence only points at: "when Anna comes in, greet *her*"."""

from dataclasses import replace
from typing import List, Mapping, Optional, Sequence, Tuple

from phrase_meanings.arguments import resolved
from semantic_framer.linking.joints import Joints
from semantic_framer.linking.link_words import ANYBODY
from semantic_framer.linking.linked_clauses import Open, which_of_it
from semantic_framer.referring.persons_spoken_of import (
    PERSONAL_PRONOUNS,
    persons_meant,
    persons_mentioned,
    whom_is_meant,
)
from semantic_framer.units.frame_roles import ADDRESSEE, MESSAGE
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.clause_plan import Clauses
from semantic_framer.values.outcome import Question
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from semantic_frames.frame import SemanticFrame
from typed_arguments import Source, TypedArgument
from word_classes import word_class

#: FrameNet's semantic types of persons.
_PERSONAL = frozenset(["Human", "Sentient"])
_THEM = word_class("plural_pronouns")


def with_persons(
    clauses: Clauses, sentence: Sentence, frames: Mapping[str, SemanticFrame], persons: Sequence[TypedArgument]
) -> Clauses:
    """Return clauses in which "she" and "him" are the person who was named: "follow Anna until she sits down".

    "They" and "them" are whoever is meant: "whenever somebody comes in, greet *them*".

    Args:
        clauses: of a sentence with conditions
        sentence: that has them
        frames: by name
        persons: who were mentioned before
    Raises:
        Open: a condition is about a person who was not named, or may be about several
    """
    spoken_of = tuple(persons)
    is_of_sentence = False
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
                meant = persons_meant(argument, spoken_of, may_be_described=True)
                if argument.text.lower() in _THEM and met is not None and is_person:
                    argument = resolved(argument, met.text)
                elif len(meant) == 1:
                    argument = meant[0]
                elif argument.text.lower() in PERSONAL_PRONOUNS and is_condition:
                    raise Open(whom_is_meant(argument.text))
                arguments.append(argument)
            made.append(replace(reading, arguments=tuple(arguments)))
        done.append(tuple(made))
        mentioned = persons_mentioned(made[0].arguments, sentence)
        spoken_of = (*mentioned, *(spoken_of if is_of_sentence else ())) if mentioned else spoken_of
        is_of_sentence = is_of_sentence or bool(mentioned)
        met = next((one for one in made[0].arguments if one.text.lower() in ANYBODY), met)
    return tuple(done)


def asked_of_hearer(sentence: Sentence, joints: Joints, clauses: Clauses, known: FramedLexicon) -> Optional[Question]:
    """Return a question about a condition behind a message that is about its hearer; None if there is none.

    "Tell Bob to call me *when he is done*": the robot may tell him then, or he may call then.
    """
    for reading in (readings[0] for readings in clauses):
        frame = known.frames[reading.unit.frame_name]
        message, hearer = (reading.argument_in_role(role, frame) for role in (MESSAGE, ADDRESSEE))
        if message is None or hearer is None or not message.positions:
            continue
        for joint in joints.found:
            about = [one for each in clauses for one in each[0].arguments if set(one.positions) & joint.positions]
            is_behind = joint.condition is not None and joint.first > max(message.positions)
            if is_behind and any(one.source is Source.INFERRED and one.text == hearer.text for one in about):
                return Question("AMBIGUOUS", which_of_it(sentence.text(sorted(joint.positions)).strip(" ,.!?")))
    return None
