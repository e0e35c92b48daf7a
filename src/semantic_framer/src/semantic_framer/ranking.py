"""Which of several readings of a clause is meant: their order, and what is no reading beside another one."""

from typing import Dict, Iterable, NamedTuple, Tuple

from semantic_framer.matching import Reading


class Rank(NamedTuple):
    """How likely a reading is meant: the smallest is the best, and the fields count in this order.

    Attributes:
        is_incomplete: a core element is missing
        left_over: words that nothing accounts for
        unlikely: words that fill an element which they are hardly meant for
        unfilled: minus the number of elements that were said, and of those that the unit requires
        asked: elements that a person would be asked for
        verb: minus the number of words of the verb
        is_secondary: the verb is not the first of its unit; the first is what the unit is about ("take the box" takes
            it, and may bring it somewhere)
        empty: elements of the unit that stay empty
        verb_place: of the verb among those of the unit
        path: file of the unit; with the line, it makes the order the same in every run
        line: of the unit
    """

    is_incomplete: bool
    left_over: int
    unlikely: int
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
        """The fields that look at the words; the others look at the unit."""
        return self[: self._fields.index("verb")]

    @property
    def before_file(self) -> Tuple[int, ...]:
        """The fields without the place of the unit."""
        return self[: self._fields.index("path")]


def rank(reading: Reading) -> Rank:
    """Return how likely a reading is meant."""
    unit = reading.unit
    filled = frozenset(value.name for value in reading.values)
    verb_place = unit.verbs.index(reading.verb) if reading.verb in unit.verbs else len(unit.verbs)
    return Rank(
        is_incomplete=bool(reading.missing),
        left_over=len(reading.left_over),
        unlikely=reading.unlikely,
        unfilled=-len(reading.said) - sum(1 for relation in unit.relations if relation.is_required),
        asked=len(reading.asked),
        verb=-len(reading.verb.split()),
        is_secondary=verb_place > 0,
        empty=sum(1 for relation in unit.relations if relation.name not in filled),
        verb_place=verb_place,
        path=unit.path,
        line=unit.line,
    )


def without_duplicates(readings: Iterable[Reading]) -> Tuple[Reading, ...]:
    """Keep one of those readings that have the same frame and arguments: the best one, of equal ones the last."""
    best: Dict[object, Reading] = {}
    for reading in readings:
        meaning = (reading.unit.frame_name, frozenset((value.name, value.argument) for value in reading.values))
        if meaning not in best or rank(reading).before_file <= rank(best[meaning]).before_file:
            best[meaning] = reading
    return tuple(best.values())


def without_dominated(readings: Iterable[Reading]) -> Tuple[Reading, ...]:
    """Drop those readings of which another one of the same frame says all that they do and more: "turn off the light",
    of which a unit without the state would turn the light.
    """
    all_readings = tuple(readings)
    return tuple(
        reading for reading in all_readings if not any(_says_less(reading, other) for other in all_readings)
    )


def _says_less(reading: Reading, other: Reading) -> bool:
    return (
        reading.unit.frame_name == other.unit.frame_name
        and reading.said < other.said
        and frozenset(other.left_over) <= frozenset(reading.left_over)
    )
