"""A typed argument of a frame element: its words and their meaning.

The attributes are those of the messages ``TypedArgument``, ``Phrase``, ``Modifier``, ``Measure``, ``TimeExpression``
and ``EmbeddedFrame`` of roboframenet_msgs, which define each of them. NaN, -1, 0 or an empty kind in a message is None
here, and parts are values instead of positions. Times and durations are in seconds.
"""

import enum
import math
import re
from dataclasses import dataclass, fields, replace
from typing import Dict, Iterable, Optional, Tuple, Type, Union

from typed_arguments.attribute_names import RELATIONS_TO_ALL

#: Number of phrases of an argument: the argument and its parts.
MOST_PHRASES = 64
#: Levels of nested parts.
MOST_LEVELS = 8
#: ROS times are seconds in 32 bits without a sign; durations are signed.
_LATEST_S = 2.0**32
_LONGEST_S = 2.0**31


class Source(enum.IntEnum):
    """The origin of an argument; the numbers are those of the message."""

    SAID = 0
    DEFAULT = 1
    INFERRED = 2


@dataclass(frozen=True)
class Modifier:
    """A property of the head of a phrase.

    Raises:
        ValueError: there is no kind, or a number does not fit into the message
    """

    kind: str
    word: str = ""
    lemma: str = ""
    degree: str = ""
    number: int = 0
    position: int = 0

    def __post_init__(self) -> None:
        _check(self)
        _refuse_if(not self.kind, "a modifier has no kind")
        _refuse_if(self.position < 0, f"the position {self.position} of a modifier is less than 0")


@dataclass(frozen=True)
class Measure:
    """An amount that can be measured.

    Attributes:
        amount: the spoken number, finite; None when no number was said
        si: metres, radians, seconds, ..., finite; None when unknown

    Raises:
        ValueError: there is no kind, or a number does not fit into the message
    """

    kind: str
    words: str = ""
    amount: Optional[float] = None
    unit: str = ""
    si: Optional[float] = None
    bound: str = ""
    change: str = ""
    is_assumed: bool = False

    def __post_init__(self) -> None:
        _check(self)
        _refuse_if(not self.kind, "a measure has no kind")


@dataclass(frozen=True)
class TimeExpression:
    """A point in time or a duration.

    Attributes:
        begin_s: ROS time, more than 0; None, like end_s, when the time is relative or unknown
        end_s: ROS time, not before begin_s
        offset_s: from the stamp of the command, not 0
        length_s: more than 0
        period_s: more than 0

    Raises:
        ValueError: there is no kind, a time is impossible, or a number does not fit into the message
    """

    kind: str
    words: str = ""
    relation: str = ""
    value: str = ""
    time_zone: str = ""
    begin_s: Optional[float] = None
    end_s: Optional[float] = None
    offset_s: Optional[float] = None
    length_s: Optional[float] = None
    period_s: Optional[float] = None

    def __post_init__(self) -> None:
        _check(self)
        _refuse_if(not self.kind, "a time expression has no kind")
        _refuse_if((self.begin_s is None) != (self.end_s is None), "a time has a begin and an end, or neither")
        if self.begin_s is not None and self.end_s is not None:
            is_span = 0.0 < self.begin_s <= self.end_s < _LATEST_S
            _refuse_if(not is_span, f"no time begins at {self.begin_s} s and ends at {self.end_s} s")
        _refuse_if(self.offset_s == 0.0 or abs(self.offset_s or 0.0) >= _LONGEST_S, f"no offset is {self.offset_s} s")
        for length_s in (self.length_s, self.period_s):
            _refuse_if(length_s is not None and not 0.0 < length_s < _LONGEST_S, f"no time takes {length_s} s")


@dataclass(frozen=True)
class EmbeddedFrame:
    """A clause inside a phrase.

    Attributes:
        frame_elements: filled elements of the frame, each with its name

    Raises:
        ValueError: there is no role, an element has no name, or a number does not fit into the message
    """

    role: str
    frame_name: str = ""
    words: str = ""
    positions: Tuple[int, ...] = ()
    head_element: str = ""
    mood: str = ""
    is_negated: bool = False
    frame_elements: Tuple["TypedArgument", ...] = ()

    def __post_init__(self) -> None:
        _check(self)
        _refuse_if(not self.role, "an embedded frame has no role")
        _check_positions(self.positions)
        for element in self.frame_elements:
            _refuse_if(not element.name, "an element of an embedded frame has no name")


@dataclass(frozen=True)
class TypedArgument:
    """The argument of a frame element, or a part of it.

    A value with only name and text is equivalent to the string of 2012.

    Attributes:
        name: name of the frame element; empty for a part that fills none
        text: the string of 2012
        count: 0 or more; None for none
        referent_count: -1 for all

    Raises:
        ValueError: a count, position or list is impossible, there are too many parts, or a number does not fit into the
            message
    """

    name: str = ""
    text: str = ""
    source: Source = Source.SAID
    words: str = ""
    positions: Tuple[int, ...] = ()
    head: str = ""
    lemma: str = ""
    head_position: int = 0
    is_plural: bool = False
    relation: str = ""
    quantifier: str = ""
    count: Optional[int] = None
    count_bound: str = ""
    is_negated: bool = False
    is_asked: bool = False
    direction: str = ""
    measure: Optional[Measure] = None
    time: Optional[TimeExpression] = None
    modifiers: Tuple[Modifier, ...] = ()
    possessor: Optional["TypedArgument"] = None
    complement: Optional["TypedArgument"] = None
    members: Tuple["TypedArgument", ...] = ()
    conjunction: str = ""
    exceptions: Tuple["TypedArgument", ...] = ()
    frames: Tuple[EmbeddedFrame, ...] = ()
    semantic_type: str = ""
    referents: Tuple[str, ...] = ()
    referent_count: int = 0
    world_version: str = ""

    def __post_init__(self) -> None:
        _check(self)
        _check_positions(self.positions)
        if self.head_position < 0:
            raise ValueError(f"the head position {self.head_position} is less than 0")
        if self.count is not None and self.count < 0:
            raise ValueError(f"the count {self.count} is less than 0")
        if self.referent_count < -1:
            raise ValueError(f"the count of referents {self.referent_count} is less than -1")
        if self.possessor or self.complement or self.members or self.exceptions or self.frames:
            self._check_parts()

    def _check_parts(self) -> None:
        _refuse_if(len(self.members) == 1, "a list has one member")
        for part in (*(one for one in (self.possessor, self.complement) if one), *self.members, *self.exceptions):
            _refuse_if(bool(part.name), f"a part fills the frame element {part.name!r}")
        _refuse_if(self.size > MOST_PHRASES, f"an argument has more than {MOST_PHRASES} phrases")
        _refuse_if(self.levels > MOST_LEVELS, f"an argument has more than {MOST_LEVELS} levels")

    @property
    def si(self) -> Optional[float]:
        """The measure in SI units; None when there is none."""
        return self.measure.si if self.measure else None

    @property
    def separate_members(self) -> Tuple["TypedArgument", ...]:
        """The members of a list, each as an argument that fills the element by itself, with the relation that was said
        once for all of them. "Between the lamp and the vase" is one place, and has none.
        """
        if self.relation in RELATIONS_TO_ALL:
            return ()
        return tuple(
            replace(
                member,
                name=self.name,
                relation=member.relation or self.relation,
                semantic_type=member.semantic_type or self.semantic_type,
            )
            for member in self.members
        )

    @property
    def parts(self) -> Tuple["TypedArgument", ...]:
        """The phrases that are parts of this one, without their own parts."""
        alone = tuple(part for part in (self.possessor, self.complement) if part is not None)
        elements = tuple(element for frame in self.frames for element in frame.frame_elements)
        return alone + self.members + self.exceptions + elements

    @property
    def size(self) -> int:
        """Number of phrases: this one and its parts."""
        return 1 + sum(part.size for part in self.parts)

    @property
    def levels(self) -> int:
        """Number of levels of nested phrases."""
        return 1 + max((part.levels for part in self.parts), default=0)


_Value = Union[Modifier, Measure, TimeExpression, EmbeddedFrame, TypedArgument]
#: Attributes of each class that hold numbers; the framer makes many arguments, and most attributes hold none.
_NUMBERS: Dict[Type[_Value], Tuple[str, ...]] = {}


def _refuse_if(is_wrong: bool, reason: str) -> None:
    if is_wrong:
        raise ValueError(reason)


def _check(value: _Value) -> None:
    """Refuse numbers that do not fit into the message: those that are not finite, or need more than 32 bits."""
    kind = type(value)
    for name in _NUMBERS.get(kind) or _numbers_of(kind):
        part = getattr(value, name)
        for number in part if isinstance(part, tuple) else (part,):
            if isinstance(number, float):
                _refuse_if(not math.isfinite(number), f"{name} is {number}")
            elif isinstance(number, int):
                _refuse_if(not -(2**31) <= number < 2**31, f"{name} does not fit in 32 bits")


def _numbers_of(kind: Type[_Value]) -> Tuple[str, ...]:
    """Return the attributes of a class that hold numbers."""
    names = tuple(field.name for field in fields(kind) if re.search(r"\b(int|float)\b", str(field.type)))
    _NUMBERS[kind] = names
    return names


def _check_positions(positions: Iterable[int]) -> None:
    before = 0
    for position in positions:
        _refuse_if(position <= before, f"positions {tuple(positions)} do not ascend from 1")
        before = position
