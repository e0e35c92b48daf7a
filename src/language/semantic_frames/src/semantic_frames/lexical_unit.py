"""Lexical units as values: a verb, the frame it evokes, and which grammatical relation fills which element."""

import re
from dataclasses import dataclass, field, replace
from enum import Enum
from functools import cached_property
from typing import FrozenSet, Iterable, Mapping, Optional, Pattern, Tuple

from semantic_frames.clause_shape import ClauseShape
from semantic_frames.semantic_type import with_parents


class ArgumentForm(Enum):
    """Which words of a matched phrase become the argument."""

    HEAD = "head"  # the head word alone, as in 2012
    PHRASE = "phrase"  # every word of the phrase, without a preposition at its front


@dataclass(frozen=True)
class RelationPath:
    """A chain of grammatical relations that starts at the verb.

    Attributes:
        steps: names of relations, Universal ("obj", "obl:to", "nmod:poss") or Stanford ("dobj", "prep_to",
            "poss"); ("dobj", "poss") is the possessive of the direct object
    """

    steps: Tuple[str, ...]

    @cached_property
    def preposition(self) -> str:
        """The preposition of its first step: "to" of "prep_to" or "obl:to", "next_to"; empty if it has none."""
        first = self.steps[0]
        return next((first[len(front) :] for front in ("prep_", "obl:") if first.startswith(front)), "")

    def __str__(self) -> str:
        return "/".join(self.steps)


@dataclass(frozen=True)
class ElementRelation:
    """Which grammatical relations fill a frame element.

    Attributes:
        name: frame element
        relations: alternatives, the first that matches fills the element
        argument: which words become the argument
        words: the only head words (lemmas or forms, lower case) that may fill it; empty for any
        semantic_types: what may fill it, besides the listed words: something that usually has one of these types, or a
            type below them, or something of no known type; empty for anything
        is_required: whether the unit fits only when this relation matches, even if the element is not core or has a
            default ("Give me 5" is a high five because of the 5)
        is_wanted: whether a phrase fills the element that the parser attached to the object, as it does for a core or
            required element: "count the chairs *in the hall*"
        after_place: prepositions; a phrase of place fills the element only when it follows a phrase with one of these:
            the couch in "the box on the table on the couch"; empty for any position
        line: line of the file, from 1
    """

    name: str
    relations: Tuple[RelationPath, ...]
    argument: ArgumentForm = ArgumentForm.HEAD
    words: Tuple[str, ...] = ()
    is_required: bool = False
    is_wanted: bool = False
    after_place: Tuple[str, ...] = ()
    line: int = 0
    semantic_types: Tuple[str, ...] = ()

    @property
    def is_limited(self) -> bool:
        """Whether only some words may fill the element."""
        return bool(self.words or self.semantic_types)

    @property
    def is_for_persons(self) -> bool:
        """Whether only persons, and other living beings, may fill the element."""
        return bool(self.semantic_types) and all("Sentient" in with_parents(name) for name in self.semantic_types)


@dataclass(frozen=True)
class ElementChange:
    """What a lexical unit says of an element that it otherwise inherits.

    Attributes:
        relation: what it says; without relations, those of the element's role stay
        keys: the attributes of the relation that the unit gives; none if the unit does not fill the element
    """

    relation: ElementRelation
    keys: FrozenSet[str] = frozenset()

    def of(self, usual: Iterable[ElementRelation]) -> Tuple[ElementRelation, ...]:
        """Return how the element is filled, given how it is usually filled."""
        if self.relation.relations:
            return (self.relation,)
        given = {key: getattr(self.relation, key) for key in self.keys}
        return tuple(replace(one, **given) for one in usual) if given else ()


@dataclass(frozen=True)
class Example:
    """An utterance that the unit must understand, run as a test.

    Attributes:
        text: the utterance
        frame_elements: expected argument by element name
        line: line of the file, from 1
    """

    text: str
    frame_elements: Mapping[str, str] = field(default_factory=dict)
    line: int = 0


#: What may fill an element in a pattern: any words; a place, which begins with a preposition; one word.
SLOT_KINDS = ("", "place", "word")
_SLOT = re.compile(r"<(\w+)(?::(\w+))?>")


@dataclass(frozen=True)
class WordPattern:
    """The words of a question or a remark.

    Attributes:
        text: as the file has it: "where (is|are) <theme>", "(is|are) <theme> <location:place>"
        line: line of the file, from 1
    """

    text: str
    line: int = 0

    @property
    def slots(self) -> Tuple[Tuple[str, str], ...]:
        """The elements that words of it fill, each with the kind of the words."""
        return tuple((match[1], match[2] or "") for match in _SLOT.finditer(self.text))

    @property
    def elements(self) -> Tuple[str, ...]:
        """The names of these elements."""
        return tuple(name for name, _ in self.slots)

    def compile(self, words: Mapping[str, str]) -> Pattern[str]:
        """Return a pattern that matches the whole: its words in lower case, with single blanks between them.

        Args:
            words: a regular expression for each kind of `SLOT_KINDS`
        Raises:
            re.error: it is no regular expression
            KeyError: the kind of an element is unknown
        """
        return re.compile(_SLOT.sub(lambda match: f"(?P<{match[1]}>{words[match[2] or '']})", self.text))


@dataclass(frozen=True)
class HeldState:
    """A state that a condition is said in: "the battery is low" is being in a state.

    Attributes:
        frame: of the state, "being_in_state"
        elements: of the state, each with the element of the unit's frame that it fills; None if elements have the same
            names in both
        words: of elements of the state, each with the only phrases that it may be, in lower case and without their
            preposition; these need not fill an element
    """

    frame: str
    elements: Optional[Tuple[Tuple[str, str], ...]] = None
    words: Tuple[Tuple[str, Tuple[str, ...]], ...] = ()


@dataclass(frozen=True)
class LexicalUnit:
    """Verbs, states, or words of questions or remarks that evoke a frame in the same way.

    Attributes:
        frame_name: the frame that is evoked
        verbs: lemmas, a particle included ("pick up"), lower case; empty when it has patterns
        relations: how the elements are filled
        changes: what is special about elements that the unit inherits; None if it inherits nothing
        examples: utterances that the unit understands
        questions: patterns of whole questions, which are tried in this order
        remarks: patterns of whole sentences of any kind, which are tried in this order: "well done"
        clauses: the grammar of clauses about the robot: "what can you do", "never use the left arm"
        asks: what questions ask for, each a frame of state and what is asked of it: "being_located.location"
        holds: the states that a condition may be said in: being located
        events: verbs of what happens, in conditions alone, with their particles: "show up"
        subjects: what the subject of such a verb must be if it fills no element, in lower case: "it" for "it rains"
        values: arguments that the words of a pattern, or the verbs by themselves, stand for, by element: "open" for
            "the door opens", "in the fridge" for "refrigerate"
        class_verbs: those of the verbs that come from WordNet and not from a programmer, each with the sense of another
            verb of the unit that it has, or is a way of: "obtain" with "get.v.01"
        is_learned: whether a person has taught it to the robot by an answer
        path: the file that it came from
        line: where it begins, from 1
    """

    frame_name: str
    verbs: Tuple[str, ...]
    relations: Tuple[ElementRelation, ...] = ()
    changes: Optional[Tuple[ElementChange, ...]] = None
    examples: Tuple[Example, ...] = ()
    questions: Tuple[WordPattern, ...] = ()
    remarks: Tuple[WordPattern, ...] = ()
    clauses: Tuple[ClauseShape, ...] = ()
    asks: Tuple[str, ...] = ()
    holds: Tuple[HeldState, ...] = ()
    events: Tuple[str, ...] = ()
    subjects: Tuple[str, ...] = ()
    values: Mapping[str, str] = field(default_factory=dict)
    class_verbs: Mapping[str, str] = field(default_factory=dict)
    is_learned: bool = False
    path: str = ""
    line: int = 0

    def stands_for(self, verb: str) -> str:
        """Return the programmer's verb in whose place a verb from the lexicon stands; none for any other verb."""
        return self.class_verbs.get(verb, "").rsplit(".", 2)[0].replace("_", " ")
