"""Lexical units with the frames that they evoke: what the framer knows, and what the passes may ask."""

from dataclasses import dataclass
from typing import Mapping, Optional, Sequence, Tuple

from semantic_framer.frame_roles import ADDRESSEE, MESSAGE
from semantic_framer.lexicon import Lexicon
from semantic_frames.frame import SemanticFrame
from utterance_passes.vocabulary import Speech


@dataclass(frozen=True)
class FramedLexicon:
    """What the framer knows; a vocabulary for the passes.

    Attributes:
        lexicon: lexical units
        frames: by name; units of frames that are not there evoke nothing
    """

    lexicon: Lexicon
    frames: Mapping[str, SemanticFrame]

    def verbs_beginning_with(self, word: str) -> Tuple[str, ...]:
        """Verbs whose first word is this one, those of more words first."""
        return self.lexicon.verbs_beginning_with(word)

    def length_of_verb(self, words: Sequence[str]) -> int:
        """Of how many words the longest verb is that some words begin with; 0 for none."""
        return self.lexicon.length_of_verb(words)

    def lists_of(self, verb: str) -> Tuple[Tuple[str, ...], ...]:
        """The words that units of a verb list for an element, one entry for each such element."""
        return self.lexicon.lists_of(verb)

    def speech_of(self, verb: str) -> Optional[Speech]:
        """Whether a frame of a verb has a *Message*, and whether its addressee stands right behind the verb."""
        for unit in self.lexicon.units_of(verb):
            frame = self.frames.get(unit.frame_name)
            if frame is None or not any(element.framenet == MESSAGE for element in frame.frame_elements):
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
