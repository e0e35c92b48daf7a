"""What a pass is, and what it says when it cannot be certain."""

from dataclasses import dataclass
from enum import Enum
from typing import Callable, Optional, Sequence, Tuple

from utterance_passes.spelling import Spelling
from utterance_passes.tree import DependencyTree
from utterance_passes.tree_edits import WordAround
from utterance_passes.vocabulary import Verbs, Vocabulary


class Stage(Enum):
    """The node that runs a pass."""

    PARSER = "stanford_parser_ros"
    FRAMER = "semantic_framer"


@dataclass(frozen=True)
class Example:
    """What a pass does, as a test has it.

    Attributes:
        said: a text, words with their tags, or a tree (see ``conllu.from_short``)
        expected: the text, or the lines of the trace without the name of the pass
        vocabulary: what the lexicon knows
    """

    said: str
    expected: Tuple[str, ...]
    vocabulary: Verbs = Verbs()


@dataclass(frozen=True)
class Pass:
    """One step from text to tree.

    Attributes:
        name: by which it is traced and can be switched off
        what: one sentence on what it does
        example: which runs as a test
        stage: the node that runs it
    """

    name: str
    what: str
    example: Example
    stage: Stage


@dataclass(frozen=True)
class TextPass(Pass):
    """Rewrites the text; it remembers where each character came from."""

    run: Callable[[Spelling], Spelling]


@dataclass(frozen=True)
class Surroundings:
    """A command, and what is said around it.

    Attributes:
        command: the command alone, as a plain command is written
        verb: the form that its verb has in the utterance: "scrubbing" of "would you mind scrubbing"
        base: its base form
        words: what is said around it, in the order of the utterance
    """

    command: Spelling
    verb: str
    base: str
    words: Tuple[WordAround, ...]


@dataclass(frozen=True)
class SurroundingsPass(Pass):
    """Says what is said around a command; the parser parses the command alone.

    ``run`` returns None where nothing is said around it.
    """

    run: Callable[[Spelling, Vocabulary], Optional[Surroundings]]


@dataclass(frozen=True)
class CutPass(Pass):
    """Says where further commands begin; the parser parses each alone.

    ``run`` takes the words of the sentence, their universal tags, and the vocabulary; it returns positions of words,
    from 1.
    """

    run: Callable[[Sequence[str], Sequence[str], Vocabulary], Tuple[int, ...]]


@dataclass(frozen=True)
class Retag:
    """Tags that a word must have.

    Attributes:
        position: of the word, from 1
        upos: universal part of speech
        xpos: Penn tag
        feats: as in CoNLL-U; empty for none
    """

    position: int
    upos: str
    xpos: str
    feats: str = ""


@dataclass(frozen=True)
class TagPass(Pass):
    """Says which tags of a tagged sentence are wrong; the parser puts them right and parses again.

    ``run`` takes the words of the sentence, their universal tags, and the vocabulary.
    """

    run: Callable[[Sequence[str], Sequence[str], Vocabulary], Tuple[Retag, ...]]


@dataclass(frozen=True)
class TreePass(Pass):
    """Makes a tree of a tree: the same words in the same places.

    ``run`` raises ``Uncertain`` where a person must say what was meant, and ``NotATree`` where no tree comes of it:
    then the tree stays as it was.
    """

    run: Callable[[DependencyTree, Vocabulary], DependencyTree]


@dataclass(frozen=True)
class Choice:
    """One of several readings of a sentence that a person may choose from.

    Attributes:
        text: as it is offered
        tree: the sentence with the words that do not belong to the reading abandoned
    """

    text: str
    tree: DependencyTree


class Uncertain(Exception):
    """It is not certain what was meant; ``choices`` are what may be, none where all was taken back."""

    def __init__(self, *choices: Choice) -> None:
        super().__init__(" or ".join(choice.text for choice in choices))
        self.choices = choices
