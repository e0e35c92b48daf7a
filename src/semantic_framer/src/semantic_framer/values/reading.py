"""A reading, which is one way to understand a clause, and its rank among the readings."""

from dataclasses import dataclass, replace
from typing import Dict, FrozenSet, Iterable, NamedTuple, Optional, Set, Tuple, cast

from semantic_frames.frame import FrameElement, SemanticFrame
from semantic_frames.lexical_unit import LexicalUnit
from typed_arguments import TypedArgument
from utterance_passes.phrases.measures import Amount
from word_classes import word_class

_HEARERS = word_class("hearers")


@dataclass(frozen=True)
class WrongType:
    """A value whose words have another semantic type than its element.

    Attributes:
        name: name of the element
        words: the words, as they were said
        found: their likeliest type
        accepted: the types that the element may have
    """

    name: str
    words: str
    found: str
    accepted: Tuple[str, ...]


@dataclass(frozen=True)
class Control:
    """How often and for how long a clause is to be carried out.

    Attributes:
        count: number of times; 0 if none was said
        duration_s: seconds; 0 if no time was said
        phrase: the words that say so
        is_kept_up: whether it goes on until something ends it: "keep visiting the hall"
        positions: of the words that say any of this
    """

    count: int = 0
    duration_s: float = 0.0
    phrase: str = ""
    is_kept_up: bool = False
    positions: FrozenSet[int] = frozenset()

    @property
    def is_said(self) -> bool:
        """Whether anything but "once" was said."""
        return self.count > 1 or self.duration_s > 0.0 or self.is_kept_up


@dataclass(frozen=True)
class Reading:
    """One way to understand a clause.

    Attributes:
        unit: the lexical unit
        verb: the verb as the unit spells it, "pick up"
        verb_positions: positions of the verb in the sentence; none if a fragment left it out
        arguments: of the elements, in the order of the frame
        missing: core elements without an argument
        left_over: positions of content words that the reading does not account for
        coverage: share of the content words that the reading accounts for, 0 to 1
        listed: positions of words that the unit lists for its elements: "low five"
        unlikely: number of words that are unlikely to be meant for the element that they fill
        clause_text: the words of the clause, as they were said
        extra: extra-thematic phrases among the left-over words, if they hold all of them; None if not
        unheeded: arguments that were taken out because they reach no server; their words are left over
        unread: amounts that elements ask for but that must not be acted on: "two or three metres"
        wrong_types: values of another semantic type than their frame element: "carry Anna"
        doubtful_types: number of values whose words have the type that the unit asks for in a rare sense, or no type
        control: how often and for how long
        is_wish: whether the speaker wishes for a thing, without a command: "I would like some tea"
    """

    unit: LexicalUnit
    verb: str
    verb_positions: Tuple[int, ...]
    arguments: Tuple[TypedArgument, ...]
    missing: Tuple[FrameElement, ...]
    left_over: Tuple[int, ...]
    coverage: float
    listed: FrozenSet[int] = frozenset()
    unlikely: int = 0
    clause_text: str = ""
    extra: Optional[Tuple[TypedArgument, ...]] = None
    unheeded: Tuple[TypedArgument, ...] = ()
    unread: Tuple[Amount, ...] = ()
    wrong_types: Tuple[WrongType, ...] = ()
    doubtful_types: int = 0
    control: Control = Control()
    is_wish: bool = False

    @property
    def said(self) -> FrozenSet[Tuple[str, str]]:
        """The names and arguments of the elements that words of the sentence fill."""
        return frozenset((argument.name, argument.text) for argument in self.arguments if argument.positions)

    @property
    def asked(self) -> Tuple[FrameElement, ...]:
        """The missing elements to ask a person for; unit elements are left out, because an amount includes its unit."""
        units = frozenset(element.unit_element for element in self.missing)
        return tuple(element for element in self.missing if element.name not in units)

    def argument_in_role(self, role: str, frame: SemanticFrame) -> Optional[TypedArgument]:
        """Return the argument that has a role of FrameNet in the frame; None if there is none."""
        found = (self.argument(element.name) for element in frame.frame_elements if element.framenet == role)
        return next((argument for argument in found if argument is not None), None)

    def argument(self, name: str) -> Optional[TypedArgument]:
        """Return the argument of an element; None if it has none."""
        return next((argument for argument in self.arguments if argument.name == name), None)

    def __str__(self) -> str:
        return f"{self.unit.frame_name}({', '.join(f'{one.name}={one.text}' for one in self.arguments)})"


class Rank(NamedTuple):
    """How likely a reading is: the smallest rank is the best, and earlier fields count more.

    Attributes:
        is_incomplete: a core element is missing
        wrong_types: number of elements whose words have another semantic type
        left_over: number of words that the reading does not account for
        unlikely: number of words that are unlikely to be meant for the element that they fill
        doubtful_types: number of elements whose words have the type that the unit asks for in a rare sense, or no type
        unfilled: minus the number of elements that were said, minus the number of relations that the unit requires
        asked: number of elements that the framer would ask a person for
        verb: minus the number of words of the verb
        is_secondary: the verb is not the first verb of its unit, which is the typical one ("take the box" means taking
            rather than bringing)
        empty: number of elements of the unit that stay empty
        verb_place: position of the verb among the verbs of the unit
        path: file of the unit; path and line make the order the same in every run
        line: line of the unit in its file
    """

    is_incomplete: bool
    wrong_types: int
    left_over: int
    unlikely: int
    doubtful_types: int
    unfilled: int
    asked: int
    verb: int
    is_secondary: bool
    empty: int
    verb_place: int
    path: str
    line: int

    @property
    def of_what_was_said(self) -> Tuple[int, ...]:
        """The fields that depend on the words of the sentence; the others depend on the unit."""
        return self._before("verb")

    @property
    def before_file(self) -> Tuple[int, ...]:
        """The fields without the path and line of the unit."""
        return self._before("path")

    def _before(self, field: str) -> Tuple[int, ...]:
        # The path is the only field of text, and callers ask only for the fields before it.
        return cast(Tuple[int, ...], self[: self._fields.index(field)])

    def __str__(self) -> str:
        """Return the fields that are not 0, without the path and line of the unit."""
        named = zip(self._fields, self.before_file)
        return ", ".join(f"{name} {int(value)}" for name, value in named if value) or "all 0"


def rank(reading: Reading) -> Rank:
    """Return the rank of a reading."""
    unit = reading.unit
    filled = frozenset(argument.name for argument in reading.arguments)
    # Who is asked to act tells nothing of what is done: "could *you* go around the hall".
    told = [text for _, text in reading.said if text.lower() not in _HEARERS]
    verb_place = unit.verbs.index(reading.verb) if reading.verb in unit.verbs else len(unit.verbs)
    return Rank(
        is_incomplete=bool(reading.missing),
        wrong_types=len(reading.wrong_types),
        left_over=len(reading.left_over),
        unlikely=reading.unlikely,
        doubtful_types=reading.doubtful_types,
        unfilled=-len(told) - sum(1 for relation in unit.relations if relation.is_required),
        asked=len(reading.asked),
        verb=-len(reading.verb.split()),
        is_secondary=verb_place > 0,
        empty=sum(1 for relation in unit.relations if relation.name not in filled),
        verb_place=verb_place,
        path=unit.path,
        line=unit.line,
    )


def heads_of(readings: Iterable[Reading]) -> FrozenSet[int]:
    """Return the positions of the verbs of readings, and of the heads of their arguments."""
    found: Set[int] = set()
    for reading in readings:
        found.update(reading.verb_positions)
        found.update(argument.head_position for argument in reading.arguments)
    return frozenset(found)


def without_duplicates(readings: Iterable[Reading]) -> Tuple[Reading, ...]:
    """Keep one reading for each frame with the same arguments: the best one, or the last of equally good ones."""
    best: Dict[object, Reading] = {}
    for reading in readings:
        meaning = (reading.unit.frame_name, frozenset((one.name, one.text) for one in reading.arguments))
        if meaning not in best or rank(reading).before_file <= rank(best[meaning]).before_file:
            best[meaning] = reading
    return tuple(best.values())


def with_argument(reading: Reading, argument: TypedArgument) -> Reading:
    """Return a reading with an argument for an element; it replaces an existing one."""
    kept = tuple(other for other in reading.arguments if other.name != argument.name)
    return replace(
        reading,
        arguments=kept + (argument,),
        missing=tuple(element for element in reading.missing if element.name != argument.name),
    )
