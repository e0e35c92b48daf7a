"""Defines what a pass is, the decorators that make one of a function, and the exception of one that is not certain."""

import re
from dataclasses import dataclass
from enum import Enum
from typing import Callable, FrozenSet, Iterable, Optional, Sequence, Tuple

from utterance_passes.engine.pass_needs import TreeRun, only_with
from utterance_passes.trees.spelling import Spelling
from utterance_passes.trees.tree import RELATIONS, DependencyTree
from utterance_passes.trees.tree_edits import WordAround
from utterance_passes.trees.vocabulary import Verbs, Vocabulary

#: A sentence goes on behind the dots of "if you ... please".
_SENTENCE = re.compile(r".+?(?<!\.\.)\.(?!\S)")


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
    """One step from text to tree; the decorators below make it of a function.

    Attributes:
        name: the name of the function, in traces and for switching the pass off
        what: the first sentence of its docstring
        example: an example; a test runs it
        kind: what it is for
    """

    name: str
    what: str
    example: Example
    kind: Kind


@dataclass(frozen=True)
class TextPass(Pass):
    """Rewrites the text, and keeps the origin of each character."""

    run: Callable[[Spelling], Spelling]


@dataclass(frozen=True)
class WordPass(Pass):
    """Rewrites words of the text by the words that the robot knows, and keeps the origin of each character."""

    run: Callable[[Spelling, Verbs], Spelling]


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


@dataclass(frozen=True)
class CutPass(Pass):
    """Finds the start of further commands; the parser parses each alone.

    ``run`` takes the words of the sentence, their universal tags, and the vocabulary; it returns positions of words,
    from 1.
    """

    run: Callable[[Sequence[str], Sequence[str], Vocabulary], Tuple[int, ...]]


@dataclass(frozen=True)
class TreePass(Pass):
    """Turns a tree into another one with the same words in the same places.

    ``run`` raises ``Uncertain`` if a person must say what the sentence means, and ``NotATree`` if the result is not a
    tree; then the tree stays as it was.

    Attributes:
        requires: relations of which a sentence must have one, or the pass does not look at it; none for any sentence
        assigns: relations that it gives to words; one word may also take over the relation of another
    """

    run: TreeRun
    requires: FrozenSet[str] = frozenset()
    assigns: FrozenSet[str] = frozenset()


def text_pass(kind: Kind, example: Example) -> Callable[[Callable[[Spelling], Spelling]], TextPass]:
    """Make a pass of a function that rewrites the text."""
    return lambda run: TextPass(run.__name__, _what(run), example, kind, run)


def word_pass(kind: Kind, example: Example) -> Callable[[Callable[[Spelling, Verbs], Spelling]], WordPass]:
    """Make a pass of a function that rewrites words by the words that the robot knows."""
    return lambda run: WordPass(run.__name__, _what(run), example, kind, run)


def surroundings_pass(
    kind: Kind, example: Example
) -> Callable[[Callable[[Spelling, Vocabulary], Optional[Surroundings]]], SurroundingsPass]:
    """Make a pass of a function that finds the words around a command."""
    return lambda run: SurroundingsPass(run.__name__, _what(run), example, kind, run)


def cut_pass(
    kind: Kind, example: Example
) -> Callable[[Callable[[Sequence[str], Sequence[str], Vocabulary], Tuple[int, ...]]], CutPass]:
    """Make a pass of a function that finds the start of further commands."""
    return lambda run: CutPass(run.__name__, _what(run), example, kind, run)


def tree_pass(
    kind: Kind, example: Example, *, requires: Iterable[str] = (), assigns: Iterable[str] = ()
) -> Callable[[TreeRun], TreePass]:
    """Make a pass of a function that turns a tree into another one; see ``TreePass``.

    Raises:
        ValueError: a relation is none of Universal Dependencies
    """

    def made_of(run: TreeRun) -> TreePass:
        required, assigned = frozenset(requires), frozenset(assigns)
        unknown = [one for one in sorted(required | assigned) if one.split(":")[0] not in RELATIONS]
        if unknown:
            raise ValueError(f"{run.__name__} names relations that do not exist: {', '.join(unknown)}")
        gated = only_with(required)(run) if required else run
        return TreePass(run.__name__, _what(run), example, kind, gated, required, assigned)

    return made_of


def _what(run: Callable[..., object]) -> str:
    """Return the first sentence of a function's docstring, without the marks of emphasis."""
    sentence = _SENTENCE.match(" ".join((run.__doc__ or "").split()))
    if sentence is None:
        raise ValueError(f"the docstring of {run.__name__} begins with no sentence")
    return sentence.group().replace("*", "")


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
