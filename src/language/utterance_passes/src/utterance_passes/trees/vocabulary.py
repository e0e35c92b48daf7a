"""Defines what the passes need to know about the lexicon."""

from dataclasses import dataclass, field
from enum import Enum
from typing import FrozenSet, Mapping, NamedTuple, Optional, Protocol, Sequence, Tuple

from utterance_passes.trees.tree import Word
from word_classes import word_class

#: Words that can begin an object.
OBJECT_BEGINNINGS = (
    word_class("determiners_and_possessives")
    | word_class("determiners_of_all")
    | word_class("pronouns_of_things")
    | word_class("object_pronouns")
)


class Speech(Enum):
    """How a verb of saying names its addressee: "say hello *to Bob*", "tell *Bob* to come"."""

    SAID = "said"
    TOLD = "told"


class NamedWord(NamedTuple):
    """A word that a unit names with its verb, by positions in a sentence.

    Attributes:
        word: the preposition or the particle, its first word
        length: number of its words
        noun: of the preposition, or the object behind the particle; the head of its phrase; 0 for none
        verb: of the unit
        is_particle: whether the word is a particle, and no preposition
    """

    word: int
    length: int
    noun: int
    verb: int
    is_particle: bool


class Vocabulary(Protocol):
    """Verbs of the lexicon, in the base form and in lower case; a verb may have several words ("pick up")."""

    def verbs_beginning_with(self, word: str) -> Tuple[str, ...]:
        """Return the verbs whose first word is this one, verbs of more words first."""

    def length_of_verb(self, words: Sequence[str]) -> int:
        """Return the length, in words, of the longest verb at the front of some words; 0 if there is none."""

    def lists_of(self, verb: str) -> Tuple[Tuple[str, ...], ...]:
        """Return the words that units of a verb list for an element, one entry for each such element."""

    def speech_of(self, verb: str) -> Optional[Speech]:
        """Return how a verb of saying names its addressee; None for any other verb."""

    def takes_clause(self, verb: str, conjunction: str) -> bool:
        """Whether a unit of a verb asks for the clause behind a conjunction: "turn left *because I say so*"."""


def is_verb(vocabulary: Vocabulary, word: Word) -> bool:
    """Whether a word, as it stands or in its base form, begins a verb of the lexicon."""
    return any(vocabulary.verbs_beginning_with(spelling) for spelling in (word.said, word.lemma.lower()))


@dataclass(frozen=True)
class Verbs:
    """A vocabulary of verbs of one word; the parser knows only these.

    Attributes:
        words: the verbs
        lists: words that units of a verb list
        speech: verbs of saying
        spellings: words of the lexicon, whose typos are corrected; none to correct nothing
        names: words of the names that the robot knows, in lower case
    """

    words: FrozenSet[str] = frozenset()
    lists: Mapping[str, Tuple[Tuple[str, ...], ...]] = field(default_factory=dict)
    speech: Mapping[str, Speech] = field(default_factory=dict)
    spellings: FrozenSet[str] = frozenset()
    names: FrozenSet[str] = frozenset()

    def verbs_beginning_with(self, word: str) -> Tuple[str, ...]:
        """Return the word itself if it is a verb."""
        return (word,) if word in self.words else ()

    def length_of_verb(self, words: Sequence[str]) -> int:
        """Return 1 if the first word is a verb, else 0."""
        return int(bool(words) and words[0] in self.words)

    def lists_of(self, verb: str) -> Tuple[Tuple[str, ...], ...]:
        """Return the words that are listed for a verb."""
        return self.lists.get(verb, ())

    def speech_of(self, verb: str) -> Optional[Speech]:
        """Return how a verb of saying names its addressee; None for any other verb."""
        return self.speech.get(verb)

    def takes_clause(self, verb: str, conjunction: str) -> bool:
        """Return False: these verbs have no units."""
        return False
