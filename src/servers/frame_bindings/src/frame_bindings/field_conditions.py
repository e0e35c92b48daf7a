"""Conditions on the fields of messages: a field is compared with a value, by one of a fixed list of comparisons."""

import enum
import math
from dataclasses import dataclass, field
from typing import Any, Callable, Iterator, Mapping, Optional, Tuple

from typed_arguments import TypedArgument
from typed_arguments.parts import PARTS
from word_classes import without_determiner


class NotComparable(ValueError):
    """A condition cannot be told of a message; the text is a clause: "I was not told a percentage"."""


@dataclass(frozen=True)
class Operand:
    """What a field is compared with.

    Attributes:
        value: always this; empty for an element
        element: the element of the frame whose argument counts, maybe with a part: "goal.relation"
        default: words that count when the element has no argument
        values: what the words of an argument stand for, in lower case and without a determiner; empty for no table
        factor: a number of the argument is multiplied by it
    """

    value: str = ""
    element: str = ""
    default: str = ""
    values: Mapping[str, str] = field(default_factory=dict)
    factor: float = 1.0

    def of(self, arguments: Mapping[str, TypedArgument]) -> str:
        """Return the text that counts for a filled frame.

        Raises:
            NotComparable: the element has no argument, or the table does not know its words
        """
        if not self.element:
            return self.value
        name, _, part = self.element.partition(".")
        argument = arguments.get(name) or TypedArgument()
        said = PARTS[part](argument) if part else (argument.text if argument.si is None else argument.si)
        if said in (None, ""):
            if not self.default:
                raise NotComparable(f"I was not told the {name}")
            said = self.default
        words = without_determiner(str(said)).lower()
        if self.values:
            known = [word for word in (words, argument.lemma.lower(), argument.head.lower()) if word in self.values]
            if not known:
                raise NotComparable(f'I know no {name} "{said}", only {", ".join(self.values)}')
            return self.values[known[0]]
        number = _number(words)
        return words if number is None else repr(number * self.factor)


def _number(text: object) -> Optional[float]:
    try:
        return float(str(text))
    except ValueError:
        return None


def _is_equal(value: Any, wanted: str) -> bool:
    if isinstance(value, bool):
        return str(value).lower() == wanted.lower()
    number = _number(wanted)
    if not isinstance(value, str) and number is not None:
        return bool(value == number)
    return str(value).strip().lower() == wanted.strip().lower()


def _ordered(is_so: Callable[[float, float], bool]) -> Callable[[Any, str], bool]:
    def compare(value: Any, wanted: str) -> bool:
        number, limit = _number(value), _number(wanted)
        if number is None or limit is None:
            raise NotComparable(f"{value!r} and {wanted!r} are no numbers")
        # A reading that is no number shows nothing.
        return not math.isnan(number) and is_so(number, limit)

    return compare


class Comparison(enum.Enum):
    """Comparisons of a field with a value."""

    EQUALS = "equals"
    DIFFERS = "differs"
    BELOW = "below"
    ABOVE = "above"
    AT_LEAST = "at_least"
    AT_MOST = "at_most"
    CONTAINS = "contains"


_COMPARE: Mapping[Comparison, Callable[[Any, str], bool]] = {
    Comparison.EQUALS: _is_equal,
    Comparison.DIFFERS: lambda value, wanted: not _is_equal(value, wanted),
    Comparison.BELOW: _ordered(lambda value, limit: value < limit),
    Comparison.ABOVE: _ordered(lambda value, limit: value > limit),
    Comparison.AT_LEAST: _ordered(lambda value, limit: value >= limit),
    Comparison.AT_MOST: _ordered(lambda value, limit: value <= limit),
    Comparison.CONTAINS: lambda value, wanted: wanted.strip().lower() in str(value).lower(),
}
#: Comparisons of numbers.
ORDERED = (Comparison.BELOW, Comparison.ABOVE, Comparison.AT_LEAST, Comparison.AT_MOST)


@dataclass(frozen=True)
class FieldCondition:
    """A condition on the messages of one topic.

    Attributes:
        entries: path of the list whose entries are looked at; empty for the message itself
        where: fields of an entry, and what they have to equal; other entries do not count
        field: path of the field, from the message or the entry; empty if every message counts
        comparison: of the field with the operand
        operand: what it is compared with
        is_all: whether all values of the field have to fit, or one
    """

    entries: str = ""
    where: Tuple[Tuple[str, Operand], ...] = ()
    field: str = ""
    comparison: Comparison = Comparison.EQUALS
    operand: Operand = Operand("true")
    is_all: bool = False

    def holds(self, message: Any, arguments: Mapping[str, TypedArgument]) -> bool:
        """Return whether it holds in a message.

        Args:
            message: with the fields
            arguments: of the filled frame, by name of the element
        Raises:
            NotComparable: it cannot be told; no entry is the one that is meant, for example
        """
        places = list(values_at(message, self.entries))
        for path, operand in self.where:
            wanted = operand.of(arguments)
            places = [place for place in places if any(_is_equal(value, wanted) for value in values_at(place, path))]
            if not places:
                raise NotComparable(f'there is no "{wanted}"')
        if not self.field:
            return bool(places)
        wanted = self.operand.of(arguments)
        values = [value for place in places for value in values_at(place, self.field)]
        found = (_COMPARE[self.comparison](value, wanted) for value in values)
        return bool(values) and (all(found) if self.is_all else any(found))


def values_at(place: Any, path: str) -> Iterator[Any]:
    """Yield the values at a path: one, or those of all entries of the lists on the way.

    Raises:
        AttributeError: there is no such field
    """
    if isinstance(place, (list, tuple)):
        for entry in place:
            yield from values_at(entry, path)
    elif not path:
        yield place
    else:
        name, _, rest = path.partition(".")
        yield from values_at(getattr(place, name), rest)
