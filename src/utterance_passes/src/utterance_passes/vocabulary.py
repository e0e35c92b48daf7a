"""What the passes must know of the lexicon."""

from dataclasses import dataclass, field
from enum import Enum
from typing import FrozenSet, Mapping, Optional, Protocol, Sequence, Tuple

from utterance_passes.tree import Word


class Speech(Enum):
    """How a verb of saying names who is told: "say hello *to Bob*", "tell *Bob* to come"."""

    SAID = "said"
    TOLD = "told"


class Vocabulary(Protocol):
    """Verbs of the lexicon; a verb is of one word or of several ("pick up"), in its base form, in lower case."""

    def verbs_beginning_with(self, word: str) -> Tuple[str, ...]:
        """Verbs whose first word is this one, those of more words first."""

    def length_of_verb(self, words: Sequence[str]) -> int:
        """Of how many words the longest verb is that some words begin with; 0 for none."""

    def lists_of(self, verb: str) -> Tuple[Tuple[str, ...], ...]:
        """The words that units of a verb list for an element, one entry for each such element."""

    def speech_of(self, verb: str) -> Optional[Speech]:
        """Whether a verb takes a message, and how it names who is told; None for a verb that is none of saying."""


def is_verb(vocabulary: Vocabulary, word: Word) -> bool:
    """Whether a word, as it stands or in its base form, begins a verb of the lexicon."""
    return any(vocabulary.verbs_beginning_with(spelling) for spelling in (word.form.lower(), word.lemma.lower()))


@dataclass(frozen=True)
class Verbs:
    """A vocabulary of verbs of one word: the verbs alone are what the parser knows.

    Attributes:
        words: the verbs
        lists: words that units of a verb list
        speech: verbs of saying
    """

    words: FrozenSet[str] = frozenset()
    lists: Mapping[str, Tuple[Tuple[str, ...], ...]] = field(default_factory=dict)
    speech: Mapping[str, Speech] = field(default_factory=dict)

    def verbs_beginning_with(self, word: str) -> Tuple[str, ...]:
        """The word itself if it is a verb."""
        return (word,) if word in self.words else ()

    def length_of_verb(self, words: Sequence[str]) -> int:
        """1 where the first word is a verb."""
        return int(bool(words) and words[0] in self.words)

    def lists_of(self, verb: str) -> Tuple[Tuple[str, ...], ...]:
        """The words that are listed for a verb."""
        return self.lists.get(verb, ())

    def speech_of(self, verb: str) -> Optional[Speech]:
        """How a verb of saying names who is told."""
        return self.speech.get(verb)
