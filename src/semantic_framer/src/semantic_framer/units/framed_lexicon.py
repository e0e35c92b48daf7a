"""Lexical units and the frames that they evoke: the knowledge of the framer, and the vocabulary of the passes."""

from dataclasses import dataclass, field
from typing import FrozenSet, Mapping, Optional, Sequence, Tuple

from nearest_meaning.likeness import Likeness
from referring_expressions import Situation
from referring_expressions.deeds import DeedsDone
from semantic_framer.units.frame_roles import ADDRESSEE, MESSAGE
from semantic_framer.units.heeding import FrameHeeding
from semantic_framer.units.lexicon import Lexicon
from semantic_framer.units.taught_names import TaughtNames
from semantic_frames.frame import SemanticFrame
from semantic_frames.lexical_unit import LexicalUnit
from semantic_types import WordTypes, shipped_types
from utterance_passes.trees.vocabulary import Speech
from world_model import World

#: Relations of clauses behind any conjunction.
_CLAUSES = frozenset(["advcl", "purpcl"])


@dataclass(frozen=True)
class FramedLexicon:
    """The lexical units and frames that the framer knows; the passes use it as their vocabulary.

    Attributes:
        lexicon: lexical units
        frames: frames by name; a unit whose frame is missing evokes nothing
        types: semantic types of words
        heeded: elements of each frame that reach a server; a frame that is missing cannot be carried out, which the
            registrar says
        world: what the robot knows of things, persons and places
        speaker: id of the person who speaks; empty when unknown
        deeds: what the robot has done; None while nobody tells that
        likeness: compares sentences with examples; None if nothing does
        declined: words of verbs, each with a frame that a person said is not meant by them
        without: names of passes and :data:`.rules.RULES` that are switched off, which shows what a rule does
    """

    lexicon: Lexicon
    frames: Mapping[str, SemanticFrame]
    types: WordTypes = field(default_factory=shipped_types)
    heeded: Mapping[str, FrameHeeding] = field(default_factory=dict)
    world: World = field(default_factory=World)
    speaker: str = ""
    deeds: Optional[DeedsDone] = None
    likeness: Optional[Likeness] = None
    declined: FrozenSet[Tuple[str, str]] = frozenset()
    taught: TaughtNames = field(default_factory=TaughtNames)
    without: FrozenSet[str] = frozenset()

    def situation(self, spoken_of: Tuple[str, ...] = ()) -> Situation:
        """Return what is known when somebody speaks.

        Args:
            spoken_of: ids of what was spoken of, the last one first
        """
        return Situation(self.world, spoken_of, speaker=self.speaker, deeds=self.deeds or DeedsDone())

    def units_of(self, verb: str) -> Tuple[LexicalUnit, ...]:
        """Return the units of a verb, with the relations that they inherit."""
        return self.lexicon.units_of(verb, self.frames)

    def verbs_beginning_with(self, word: str) -> Tuple[str, ...]:
        """Return the verbs whose first word is this one, those with more words first."""
        return self.lexicon.verbs_beginning_with(word)

    def length_of_verb(self, words: Sequence[str]) -> int:
        """Return the number of words of the longest verb that some words begin with; 0 if they begin with none."""
        return self.lexicon.length_of_verb(words)

    def lists_of(self, verb: str) -> Tuple[Tuple[str, ...], ...]:
        """Return the words that units of a verb list for an element, one entry for each such element."""
        return self.lexicon.lists_of(verb, self.frames)

    def speech_of(self, verb: str) -> Optional[Speech]:
        """Return whether the addressee of a verb of speech directly follows it; None if no frame has a *Message*."""
        for unit in self.units_of(verb):
            frame = self.frames.get(unit.frame_name)
            if frame is None or MESSAGE not in frame.roles:
                continue
            told = [element.name for element in frame.frame_elements if element.framenet == ADDRESSEE]
            is_told = any(
                path.steps == ("iobj",)
                for relation in unit.relations
                if relation.name in told
                for path in relation.relations
            )
            return Speech.TOLD if is_told else Speech.SAID
        return None

    def takes_clause(self, verb: str, conjunction: str) -> bool:
        """Whether a unit of a verb asks for the clause behind a conjunction, as those of 2012 may."""
        asked = _CLAUSES | {f"prepc_{conjunction}"}
        return any(
            path.steps[0] in asked
            for unit in self.units_of(verb)
            for relation in unit.relations
            for path in relation.relations
        )
