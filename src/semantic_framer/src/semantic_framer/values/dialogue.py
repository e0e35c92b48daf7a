"""Memory from one utterance to the next: an open question, and the last thing and place mentioned."""

from dataclasses import dataclass, replace
from typing import FrozenSet, Optional, Tuple, Union

from semantic_framer.values.clause_plan import PlanPart
from semantic_framer.values.reading import Reading
from typed_arguments import TypedArgument
from utterance_passes.engine.utterance_pass import Choice
from utterance_passes.trees.tree import DependencyTree
from word_classes import agreement, word_class

PRONOUNS = word_class("pronouns")
#: The pronouns that may also be meant literally.
DEMONSTRATIVES = PRONOUNS - word_class("plural_pronouns") - {"it"}
PLACE_PRONOUNS = frozenset(["there"])
#: "It" is one of the things that were mentioned last.
MOST_THINGS = 5
_IGNORANCE = word_class("ignorance")
_INDIFFERENCE = word_class("indifference")


@dataclass(frozen=True)
class Lesson:
    """What the answer to a question teaches: that words mean a verb that is known, or that they do not.

    Attributes:
        said: words of the verb that was not known, "make your way"
        verb: the known verb, with its particles, or the sentence that was taught as the meaning, the noun of a kind, or
            the id of a place; empty when ``said`` is a whole sentence, and only a no is kept
        frame_name: the frame that it evokes; ``KIND`` or ``PLACE`` of :mod:`nearest_meaning.learned`
        sentence: in which the words were said
        text: of the lexical unit file; empty for that of the known verb
        is_agreed: whether a person said that they mean it
        is_forgotten: whether a person wants the words to mean nothing again
        told: what is taught, as a sentence; empty for words that mean others
    """

    said: str
    verb: str
    frame_name: str
    sentence: str
    text: str = ""
    is_agreed: bool = True
    is_forgotten: bool = False
    told: str = ""


@dataclass(frozen=True)
class Pending:
    """A question that the next utterance may answer.

    Attributes:
        clauses: the readings so far; the open clause has only the readings that the question is about
        clause: position of the open clause in ``clauses``
        elements: the element that the question asks for, for each reading of the open clause; empty for a yes-no
            question
        choices: the only allowed answers, as they were offered; empty if any answer is allowed
        expires_s: time on the caller's clock, seconds; the question is forgotten afterwards
        readings: the readings of the sentence that the person chooses from; ``clauses`` is empty then
        idioms: where each of ``readings`` is what a person taught as the meaning of a sentence, that deed
        lessons: what a yes to each of ``readings`` teaches, None for nothing; without ``readings``, what a person wants
            to teach in words
        offered: ids of the things that the person chooses from: "which mug"; empty for another question
        plan: how the clauses are joined; None if they are done one after the other
        is_about_words: whether a yes only agrees to go on without some words; a frame may want another yes
        beginning: what happens to the command that runs: REPLACE, FOLLOW or BESIDE
        unfinished: the sentence that lacks something behind its last word: "wait until"; None for none
        asked: id of the person who was asked; empty when anybody may answer
        open_time: words of the time that the question asks about, which stands at the root of the plan: "tomorrow"
        question: the words of the question
    """

    clauses: Tuple[Tuple[Reading, ...], ...]
    clause: int
    elements: Tuple[str, ...]
    expires_s: float
    choices: Tuple[str, ...] = ()
    readings: Tuple[Choice, ...] = ()
    idioms: Tuple[Reading, ...] = ()
    lessons: Tuple[Optional[Lesson], ...] = ()
    offered: Tuple[str, ...] = ()
    is_about_words: bool = False
    plan: Optional[PlanPart] = None
    beginning: str = "REPLACE"
    open_time: Tuple[str, ...] = ()
    unfinished: Optional[DependencyTree] = None
    asked: str = ""
    question: str = ""

    def lessons_of(self, choice: Choice) -> Tuple[Lesson, ...]:
        """Return what the choice of one of ``readings`` teaches."""
        return tuple(one for one, reading in zip(self.lessons, self.readings) if one and reading is choice)

    @property
    def taught(self) -> Tuple[Lesson, ...]:
        """What a yes teaches of each of ``lessons``."""
        return tuple(one for one in self.lessons if one is not None)

    def lessons_of_no(self) -> Tuple[Lesson, ...]:
        """Return what a no teaches."""
        return tuple(replace(one, is_agreed=False) for one in self.taught)

    def may_be_answered_by(self, speaker: str) -> bool:
        """Whether the answer of a person counts; that of somebody who is not known does."""
        return not self.asked or not speaker or self.asked == speaker


@dataclass(frozen=True)
class LastCommand:
    """The last command that the framer passed on; a fragment ("ten feet", "again") changes or repeats it.

    Attributes:
        clauses: its readings, best first, with pronouns resolved
        stamp_s: when it was said, seconds; the stamp of the command
        tree: of the sentence; None if it was no sentence, but an answer or a fragment
    """

    clauses: Tuple[Tuple[Reading, ...], ...]
    stamp_s: float
    tree: Optional[DependencyTree] = None


@dataclass(frozen=True)
class LastQuestion:
    """The question that a person asked last; what is said next may hold in one case only: "if so, close it".

    Attributes:
        tree: of the sentence
        stamp_s: when it was said, seconds; the stamp of the command
    """

    tree: DependencyTree
    stamp_s: float


@dataclass(frozen=True)
class Mention:
    """Something that was spoken of.

    Attributes:
        id: of the object; empty while it is not known which one is meant
        phrase: what was said of it, to be looked up again when the robot knows more; None if the id is known
    """

    id: str = ""
    phrase: Optional[TypedArgument] = None


@dataclass(frozen=True)
class Thing:
    """A thing that was mentioned.

    Attributes:
        text: as it was said, "the red mug"
        noun: the dictionary form of its head, "mug"
        role: the part that it had in what was last done with it; see ``frame_roles.part_of``
        is_plural: whether it is more than one: "the cups", "the cup and the plate"
        phrases: what named it, one for each item of a list; empty if it filled no element
        is_only_told_of: whether it was only part of what was to be said: "tell Bob that the mug is dirty"
        is_asked_about: whether it was asked what is there: "what is on the table?"
    """

    text: str
    noun: str
    role: str = ""
    is_plural: bool = False
    phrases: Tuple[TypedArgument, ...] = ()
    is_only_told_of: bool = False
    is_asked_about: bool = False


@dataclass(frozen=True)
class Context:
    """What the framer remembers.

    Attributes:
        pending: the open question; None if there is none
        last: the last command; None if there is none, or if it may not be repeated
        question: the question that the person asked right before; None if the last utterance was none
        things: the things mentioned, the last one first; at most ``MOST_THINGS``
        place: the last place mentioned, "the kitchen"; None if there is none
        spoken_of: the things that were mentioned, the last one first
        persons: the persons mentioned in the last utterance that mentions one, the last one first
        are_persons_of_before: whether that was an earlier utterance
        agreed_verbs: verbs from the lexicon, each with its frame, that a person agreed to: "obtain" is getting
    """

    pending: Optional[Pending] = None
    last: Optional[LastCommand] = None
    question: Optional[LastQuestion] = None
    things: Tuple[Thing, ...] = ()
    place: Optional[Thing] = None
    spoken_of: Tuple[Mention, ...] = ()
    persons: Tuple[TypedArgument, ...] = ()
    are_persons_of_before: bool = False
    agreed_verbs: FrozenSet[Tuple[str, str]] = frozenset()

    @property
    def ids_spoken_of(self) -> Tuple[str, ...]:
        """The ids of what was spoken of, the last one first; empty ones stand for what is not known."""
        return tuple(mention.id for mention in self.spoken_of)

    def with_thing(self, thing: Thing) -> "Context":
        """Return the context after a thing was mentioned; one that was mentioned before keeps its noun."""
        nouns = [one.noun for one in self.things if one.text == thing.text]
        others = [one for one in self.things if one.text != thing.text]
        return replace(self, things=(replace(thing, noun=[*nouns, thing.noun][0]), *others)[:MOST_THINGS])

    def with_persons(self, persons: Tuple[TypedArgument, ...]) -> "Context":
        """Return the context after persons were mentioned, the last one first."""
        if not persons:
            return self
        before = () if self.are_persons_of_before else self.persons
        return replace(self, persons=(*persons, *before), are_persons_of_before=False)

    def at(self, now_s: float) -> "Context":
        """Return the context at a time: without a question that has expired."""
        if self.pending is not None and now_s > self.pending.expires_s:
            return replace(self, pending=None)
        return self

    def fresh(self, said_s: float, timeout_s: float) -> "Context":
        """Return the context for a new utterance: without a last command or question said too long before it.

        Args:
            said_s: when the utterance was said, seconds; the stamp of its command
            timeout_s: how long a command may be repeated, and a question be spoken of
        """

        def is_old(one: Union[LastCommand, LastQuestion]) -> bool:
            return not 0.0 <= said_s - one.stamp_s <= timeout_s

        if self.last is None and self.question is None and self.are_persons_of_before:
            return self
        last = None if self.last is None or is_old(self.last) else self.last
        question = None if self.question is None or is_old(self.question) else self.question
        return replace(self, last=last, question=question, are_persons_of_before=True)

    def stopped(self) -> "Context":
        """Return the context after a stop: nothing answers a question from before it, and nothing repeats a command
        that it ended.
        """
        return replace(self, pending=None, last=None, question=None)


def is_yes(text: str) -> bool:
    """Whether an utterance agrees."""
    return agreement(text) is True


def is_no(text: str) -> bool:
    """Whether an utterance declines."""
    return agreement(text) is False


def is_indifferent(text: str) -> bool:
    """Whether an utterance leaves a choice to the robot: "any of them", "I don't care"."""
    return _bare(text) in _INDIFFERENCE


def is_ignorant(text: str) -> bool:
    """Whether an utterance says nothing but that there is no answer: "I don't know"."""
    return _bare(text) in _IGNORANCE


def _bare(text: str) -> str:
    return " ".join(text.lower().replace("\u2019", "'").replace(",", " ").strip(" .!?").split())
