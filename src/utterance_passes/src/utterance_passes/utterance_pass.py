"""Defines the kinds of passes, and the exception of a pass that is not certain."""

from dataclasses import dataclass
from enum import Enum
from typing import Callable, ClassVar, Optional, Sequence, Tuple

from utterance_passes.spelling import Spelling
from utterance_passes.tree import DependencyTree
from utterance_passes.tree_edits import WordAround
from utterance_passes.vocabulary import Verbs, Vocabulary


class Stage(Enum):
    """The node that runs a pass."""

    PARSER = "stanford_parser_ros"
    FRAMER = "semantic_framer"


class Kind(Enum):
    """What a pass is for; it decides what its failure means."""

    SPELLING = "writes what is said as the parser knows it"
    DISFLUENCY = "removes what the speaker took back"
    MEANING = "finds what a construction means"
    POLICY = "decides what the robot makes of a sentence"
    REPAIR = "corrects the parser; one that fails is skipped"


@dataclass(frozen=True)
class Example:
    """An example of the effect of a pass; a test runs it.

    Attributes:
        said: a text, words with their tags, or a tree (see ``conllu.from_short``)
        expected: the resulting text, or the lines of the trace without the name of the pass
        vocabulary: the verbs of the lexicon
    """

    said: str
    expected: Tuple[str, ...]
    vocabulary: Verbs = Verbs()


@dataclass(frozen=True)
class Pass:
    """One step from text to tree.

    Attributes:
        name: its name, in traces and for switching it off
        what: one sentence that says what it does
        example: an example; a test runs it
        stage: the node that runs it
        kind: what it is for; each row of the tables declares it by its class
    """

    name: str
    what: str
    example: Example
    stage: Stage
    kind: ClassVar[Kind] = Kind.MEANING


@dataclass(frozen=True)
class TextPass(Pass):
    """Rewrites the text, and keeps the origin of each character."""

    run: Callable[[Spelling], Spelling]
    kind: ClassVar[Kind] = Kind.SPELLING


class TextDisfluency(TextPass):
    """Removes what the speaker took back from the text."""

    kind = Kind.DISFLUENCY


class TextMeaning(TextPass):
    """Writes what a construction means."""

    kind = Kind.MEANING


@dataclass(frozen=True)
class WordPass(Pass):
    """Rewrites words of the text by the words that the robot knows, and keeps the origin of each character."""

    run: Callable[[Spelling, Verbs], Spelling]
    kind: ClassVar[Kind] = Kind.SPELLING


class WordDisfluency(WordPass):
    """Removes what the speaker took back from words that the robot knows."""

    kind = Kind.DISFLUENCY


@dataclass(frozen=True)
class Surroundings:
    """A command and the words around it.

    Attributes:
        command: the command alone, written as a plain command
        verb: the form of its verb in the utterance: "scrubbing" in "would you mind scrubbing"
        base: the base form of the verb
        words: the words around the command, in the order of the utterance
    """

    command: Spelling
    verb: str
    base: str
    words: Tuple[WordAround, ...]


@dataclass(frozen=True)
class SurroundingsPass(Pass):
    """Finds the words around a command; the parser parses the command alone.

    ``run`` returns None if there are no such words.
    """

    run: Callable[[Spelling, Vocabulary], Optional[Surroundings]]
    kind: ClassVar[Kind] = Kind.REPAIR


@dataclass(frozen=True)
class CutPass(Pass):
    """Finds the start of further commands; the parser parses each alone.

    ``run`` takes the words of the sentence, their universal tags, and the vocabulary; it returns positions of words,
    from 1.
    """

    run: Callable[[Sequence[str], Sequence[str], Vocabulary], Tuple[int, ...]]
    kind: ClassVar[Kind] = Kind.REPAIR


@dataclass(frozen=True)
class TreePass(Pass):
    """Turns a tree into another one with the same words in the same places.

    ``run`` raises ``Uncertain`` if a person must say what the sentence means, and ``NotATree`` if the result is not a
    tree; then the tree stays as it was.
    """

    run: Callable[[DependencyTree, Vocabulary], DependencyTree]


class TreeMeaning(TreePass):
    """Gives a construction the tree of what it means."""

    kind = Kind.MEANING


class TreeRepair(TreePass):
    """Corrects what the parser attached or tagged wrongly."""

    kind = Kind.REPAIR


class TreeDisfluency(TreePass):
    """Sets aside what the speaker took back."""

    kind = Kind.DISFLUENCY


class TreePolicy(TreePass):
    """Decides what the robot makes of a sentence."""

    kind = Kind.POLICY


@dataclass(frozen=True)
class Choice:
    """One of several readings of a sentence that a person can choose.

    Attributes:
        text: the words offered to the person
        tree: the sentence; the words that do not belong to the reading are abandoned
    """

    text: str
    tree: DependencyTree


class PassFailed(RuntimeError):
    """A pass raised an error that no sentence may cause; the message names the pass."""

    def __init__(self, name: str, error: Exception) -> None:
        super().__init__(f'the pass "{name}" failed: {type(error).__name__}: {error}')


class Uncertain(Exception):
    """The meaning is not certain; ``choices`` are the possible readings, none if the speaker took everything back."""

    def __init__(self, *choices: Choice) -> None:
        super().__init__(" or ".join(choice.text for choice in choices))
        self.choices = choices
