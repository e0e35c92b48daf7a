"""Semantic frames as values: the checked content of a frame file."""

from dataclasses import dataclass
from enum import Enum
from functools import cached_property
from typing import FrozenSet, Mapping, Optional, Tuple, Union


class Quantity(Enum):
    """What the number in a frame element measures. Inside the system the units are those of REP 103."""

    NUMBER = "number"
    LENGTH = "length"  # metres
    ANGLE = "angle"  # radians
    DURATION = "duration"  # seconds


@dataclass(frozen=True)
class FrameElement:
    """One participant or prop of the scene that a frame describes.

    Attributes:
        name: unique in its frame
        is_core: whether the scene cannot be understood without it (FrameNet's coreness)
        default: argument when nothing fills it; empty for none
        quantity: what the number measures; None for an element of words
        unit_element: name of the element of the same frame that holds the unit of the number; empty when the
            unit is part of the argument ("3 feet")
        minimum: smallest amount allowed, in SI units; None for no limit
        maximum: largest amount allowed, in SI units; None for no limit
        values: the only arguments allowed; empty for any
        relations: the only relations of an argument that can be expressed ("on", "in"); empty for any
        counts: the only numbers of things that can be expressed (1, 2); empty for any
        quantifiers: the only quantifiers of an argument that can be expressed ("the", "all"); empty for any
        question: asks a person for the element ("How far should I move?"); empty for a question made of the name
        answer: an example of an answer ("three feet"); empty for none
        framenet: name of the frame element in FrameNet; empty when FrameNet has none
        semantic_types: what may fill it: something of one of these types, or of a type below them; empty for anything
        confirmed_values: texts, nouns or semantic types of an argument with which a person must say yes before the
            frame is carried out, in lower case
    """

    name: str
    is_core: bool = False
    default: str = ""
    quantity: Optional[Quantity] = None
    unit_element: str = ""
    minimum: Optional[float] = None
    maximum: Optional[float] = None
    values: Tuple[str, ...] = ()
    relations: Tuple[str, ...] = ()
    counts: Tuple[int, ...] = ()
    quantifiers: Tuple[str, ...] = ()
    question: str = ""
    answer: str = ""
    framenet: str = ""
    semantic_types: Tuple[str, ...] = ()
    confirmed_values: Tuple[str, ...] = ()


@dataclass(frozen=True)
class ElementMapping:
    """The child's element takes the argument of the parent's element.

    Attributes:
        parent_name: element of the parent
        child_name: element of the child
        relation: relation that the argument has for the child; empty for that of the parent. To put something *on* the
            table, the robot goes *to* the table.
    """

    parent_name: str
    child_name: str
    relation: str = ""


@dataclass(frozen=True)
class ValueCondition:
    """The child stands for the parent only if the parent's argument is one of the values (case is ignored)."""

    parent_name: str
    child_values: Tuple[str, ...]


@dataclass(frozen=True)
class ConstantArgument:
    """The child's element takes a value that the frame file gives."""

    parent_value: str
    child_name: str


FrameElementRelation = Union[ElementMapping, ValueCondition, ConstantArgument]


@dataclass(frozen=True)
class RelatedFrame:
    """A child of a frame.

    Attributes:
        name: the child frame
        frame_element_relations: how the child is filled from the parent
        line: where the file names it, from 1
    """

    name: str
    frame_element_relations: Tuple[FrameElementRelation, ...] = ()
    line: int = 0


class ListPolicy(Enum):
    """What a list ("the mug and the plate") in one of its elements means for a frame."""

    TOGETHER = "together"  # one frame whose argument is the list
    REPEAT = "repeat"  # the frame once for each item


class UnknownPolicy(Enum):
    """What happens when somebody speaks of a thing, person or place of which the robot does not know."""

    ACT = "act"  # the words alone count: the server may find it
    ASK = "ask"  # the person must say yes first
    REFUSE = "refuse"


@dataclass(frozen=True)
class Result:
    """What holds when a frame has been carried out: closing results in a state, placing in a place.

    Attributes:
        frame: the condition frame that says so
        elements: of that frame, each with the element of the frame that fills it, or with what is true of it ("closed")
        own_elements: names of the elements of the frame itself
    """

    frame: str
    elements: Tuple[Tuple[str, str], ...]
    own_elements: FrozenSet[str] = frozenset()


@dataclass(frozen=True)
class SemanticFrame:
    """A scene, its elements, and the frames that can stand for it.

    Attributes:
        name: unique among all frames
        description: one sentence for people
        frame_elements: in the order of the file
        children: each entry is a sequence of frames that together do what this frame does. A sequence of one
            frame is specificity, a longer one sequentiality (Thomas and Jenkins, ICRA 2012).
        framenet: name of the frame in FrameNet 1.7; empty when FrameNet has none
        on_list: what a list in an element means
        is_confirmed: whether a person must say yes before the frame is carried out
        on_unknown: what happens when the robot knows some world, and not what is spoken of
        is_question: whether the frame is a question, which is answered and changes nothing
        is_condition: whether the frame says how things are; it is watched, and never carried out
        results_in: what holds when it has been carried out; None if the frame does not say
        path: the file it came from
        line: where it begins, from 1
    """

    name: str
    description: str = ""
    frame_elements: Tuple[FrameElement, ...] = ()
    children: Tuple[Tuple[RelatedFrame, ...], ...] = ()
    framenet: str = ""
    on_list: ListPolicy = ListPolicy.REPEAT
    is_confirmed: bool = False
    on_unknown: UnknownPolicy = UnknownPolicy.ACT
    is_question: bool = False
    is_condition: bool = False
    results_in: Optional[Result] = None
    path: str = ""
    line: int = 0

    def element(self, name: str) -> Optional[FrameElement]:
        """Return the element of that name, or None."""
        return self._by_name.get(name)

    @property
    def acts(self) -> bool:
        """Whether the frame is carried out, and neither asks something nor says how things are."""
        return not (self.is_question or self.is_condition)

    @cached_property
    def roles(self) -> FrozenSet[str]:
        """FrameNet's names of its elements."""
        return frozenset(element.framenet for element in self.frame_elements)

    @cached_property
    def _by_name(self) -> Mapping[str, FrameElement]:
        return {element.name: element for element in self.frame_elements}

    def wants_yes(self, arguments: Mapping[str, Tuple[str, ...]]) -> bool:
        """Return whether a person must say yes first.

        Args:
            arguments: text, noun and semantic type by the name of the element
        """
        return self.is_confirmed or any(
            part.lower() in element.confirmed_values
            for element in self.frame_elements
            for part in arguments.get(element.name, ())
        )
