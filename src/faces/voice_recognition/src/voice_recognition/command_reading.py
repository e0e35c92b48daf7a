"""What the robot makes of a text that may have been said: read by the stages of the pipeline, and not carried out."""

import enum
import re
from dataclasses import dataclass, replace
from typing import FrozenSet, List, Optional

from command_server.stop_words import is_stop
from offline_pipeline.knowledge import Knowledge
from offline_pipeline.pipeline import Pipeline, Understanding
from typed_arguments import TypedArgument
from voice_recognition.calling import Calls
from voice_recognition.offers import Offer, OfferFinder, of_other_person, without_politeness
from voice_recognition.spoken_language import Words, spoken_words
from voice_recognition.voice_words import voice_words
from world_model import World

#: No name by which a robot is called.
NOBODY = Calls()
_FIRST_PERSON = frozenset(["I", "I'm", "I'd", "I'll", "I've"])
_WORD = re.compile(r"[a-z]+(?:['-][a-z]+)*")
#: What the pipeline would reply to a text that it carries out, and to one that it asks about first.
_DONE, _ASKED = "DONE", "NEEDS_INFORMATION"


class Sense(enum.IntEnum):
    """What a text is to the robot."""

    NONE = 0  # talk, or words that it does not know
    REFUSED = 1  # a command or question, but none that it can carry out
    ASKED = 2  # it would ask something first: "How far?"
    COMMAND = 3  # it would carry it out, or answer it
    STOP = 4  # it would stop


@dataclass(frozen=True)
class Meaning:
    """What the robot makes of a text.

    Attributes:
        sense: what it is to the robot
        offer: the command; None for a stop, and where there is none
        unknown: words that the robot knows nothing of
    """

    sense: Sense
    offer: Optional[Offer] = None
    unknown: Words = ()


class CommandReader:
    """Reads texts with the frames, units, servers, names and things of one robot."""

    def __init__(
        self,
        pipeline: Pipeline,
        finder: OfferFinder,
        known: FrozenSet[str],
        calls: Calls = NOBODY,
        *,
        are_several: bool = False,
    ) -> None:
        """
        Args:
            pipeline: the stages
            finder: knows in which words the robot speaks of its frames
            known: the words that the robot knows, in lower case
            calls: by which names it is called
            are_several: whether these are names of several robots: who is called is a part of the command
        """
        self._pipeline = pipeline
        self._finder = finder
        self.known = known
        self.calls = calls
        self._are_several = are_several

    def read(self, text: str) -> Meaning:
        """Return what the robot makes of a text."""
        behind = self.calls.behind(text)
        said = text if behind is None else f"{behind[:1].upper()}{behind[1:]}"
        if is_stop(text) or is_stop(said):
            return Meaning(Sense.STOP)
        meaning = self._read(said)
        if behind is None or meaning.offer is None or not self._are_several:
            return meaning
        called = text[: len(text) - len(behind)].strip(" ,.!?").lower()
        offer = meaning.offer
        elements = tuple(sorted((*offer.elements, ("robot", called))))
        return replace(meaning, offer=replace(offer, elements=elements, text=text.strip().rstrip(".!?"), deed=""))

    def _read(self, text: str) -> Meaning:
        words = spoken_words(text)
        unknown = tuple(word for word in words if word not in self.known and not word.isdigit())
        understood = self._pipeline.understand_safely(text)
        sense = {_DONE: Sense.COMMAND, _ASKED: Sense.ASKED}.get(understood.reply.outcome, Sense.REFUSED)
        if understood.behind is not None:
            return Meaning(Sense.STOP)
        if not understood.readings:
            return Meaning(Sense.NONE, unknown=unknown)
        return Meaning(sense, self._offer(text, words, understood), unknown)

    def in_world(self, world: World, *, has_new_names: bool) -> "CommandReader":
        """Return a reader that differs in what the robot knows of things, persons and places.

        Args:
            world: what it knows
            has_new_names: whether their names differ, too
        """
        known = words_known(self._pipeline.knowledge, world) | self.calls.words if has_new_names else self.known
        pipeline = self._pipeline.in_world(world)
        return CommandReader(pipeline, self._finder, known, self.calls, are_several=self._are_several)

    def _offer(self, text: str, words: Words, understood: Understanding) -> Offer:
        frames = [self._pipeline.knowledge.frames.get(one.unit.frame_name) for one in understood.readings]
        deeds = [one for one in frames if one is not None and not one.is_question]
        still = voice_words().frames_without_motion
        moving = next((one.name for one in deeds if one.name not in still), "")
        elements = [
            (f"{number}.{argument.name}" if number else argument.name, _value(argument))
            for number, reading in enumerate(understood.readings)
            for argument in reading.arguments
        ]
        elements += [("frame", one.unit.frame_name) for one in understood.readings[1:]]
        written = text.strip().rstrip(".!?")
        deed = self._deed(written, understood)
        found = self._finder.find(words) if not deed else None
        return Offer(
            moving or understood.readings[0].unit.frame_name,
            tuple(sorted(elements)),
            written,
            deed or (found.deed if found is not None else ""),
            is_question=not deeds,
        )

    @staticmethod
    def _deed(written: str, understood: Understanding) -> str:
        """Return a command in the words of the robot; empty if it does not begin with its verb."""
        words = tuple(written.split())
        said = without_politeness(tuple(word.lower().strip(",") for word in words))
        command = words[len(words) - len(said) :] if words[-1:] and said[-1:] == (words[-1].lower(),) else ()
        verb = understood.readings[0].verb.split()[0]
        if not command or command[0].lower() != verb:
            return ""
        return of_other_person(" ".join((command[0].lower(), *command[1:])))


def _value(argument: TypedArgument) -> str:
    """Return an argument as it is compared: "20 centimeters" and "twenty centimetres" are the same."""
    measure = argument.measure
    return argument.text if measure is None or measure.si is None else f"{measure.si:.6g} {measure.kind}"


def words_known(knowledge: Knowledge, world: World) -> FrozenSet[str]:
    """Return the words that a robot knows, in lower case: those of its units, their examples, its names and things."""
    texts: List[str] = []
    for unit in knowledge.lexicon.units:
        texts += [*unit.verbs, *(_without_names(example.text) for example in unit.examples)]
    texts += knowledge.types.names
    texts += [name for one in world.objects for name in (*one.names, one.category, one.id)]
    words = voice_words()
    texts += [*words.other_words, *words.small_numbers, *words.tens, words.hundred]
    texts += [unit for units in words.measures.values() for names in units for unit in names]
    texts += [word for phrase in (*words.polite_before, *words.polite_after) for word in phrase]
    return frozenset(word for text in texts for word in _WORD.findall(text.lower().replace("_", " ")))


def _without_names(example: str) -> str:
    """Return an example without its names: they are those of nobody whom the robot knows."""
    first, *rest = example.split()
    return " ".join([first, *(word for word in rest if not word[:1].isupper() or word in _FIRST_PERSON)])


def make_reader(
    pipeline: Pipeline, finder: OfferFinder, world: World, calls: Calls = NOBODY, *, are_several: bool = False
) -> CommandReader:
    """Make a reader for what a robot knows.

    Args:
        pipeline: with its frames, units and servers
        finder: of the templates of its language
        world: its things, persons and places
        calls: by which names it is called
        are_several: whether these are names of several robots
    """
    known = words_known(pipeline.knowledge, world) | calls.words
    return CommandReader(pipeline.in_world(world), finder, known, calls, are_several=are_several)
