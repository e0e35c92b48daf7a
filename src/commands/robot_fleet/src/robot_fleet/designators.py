"""Finds the words that say which robots are meant: "Beta and Gamma", "everybody but Alpha", "the other one"."""

import enum
import re
from dataclasses import dataclass
from typing import Callable, FrozenSet, List, Optional, Sequence, Tuple

from robot_fleet.address_words import address_words
from robot_fleet.robot_names import Names, number_of, numbered_at, ordinal_at

_TOKEN = re.compile(r"\d+(?:[.,:]\d+)+|[^\W_]+(?:['’_-][^\W_]+)*|[,;:.!?…—–]")


class Kind(enum.Enum):
    """Whom a designator means."""

    NAME = "name"
    UNKNOWN = "unknown"
    EVERYBODY = "everybody"
    OTHERS = "others"
    OTHER_ONE = "other_one"
    BOTH = "both"
    SOMEBODY = "somebody"
    LAST = "last"


@dataclass(frozen=True)
class Token:
    """A word in lower case or a mark, with its place in the text."""

    word: str
    start: int
    end: int


@dataclass(frozen=True)
class Group:
    """Who is addressed.

    Attributes:
        kinds: of its designators
        names: of the robots that are named
        unknown: what is said of robots that no name here fits, in lower case: "robot four", "luna"
        excepted: names of those that are not meant
        is_any: one of them is enough: "Alpha or Beta", "somebody"
    """

    kinds: FrozenSet[Kind]
    names: Tuple[str, ...] = ()
    unknown: Tuple[str, ...] = ()
    excepted: Tuple[str, ...] = ()
    is_any: bool = False


@dataclass(frozen=True)
class _Found:
    kind: Kind
    end: int
    robot: str = ""
    unknown: str = ""


#: Whether a word can be the name of a robot that is not here.
IsName = Callable[[str], bool]


def tokens_of(text: str) -> Tuple[Token, ...]:
    """Split a text into words and marks."""
    return tuple(
        Token(match.group().lower().replace("’", "'"), match.start(), match.end()) for match in _TOKEN.finditer(text)
    )


def group_at(
    words: Sequence[str], position: int, names: Names, is_name: IsName = lambda word: False
) -> Tuple[Optional[Group], int]:
    """Return who is addressed at a position, and where the designators end; None for nobody.

    Args:
        words: of the utterance
        position: where the designators begin
        names: of the robots
        is_name: tells which words are taken for names of robots that are not here. "Robot four" needs no such word
    """
    known = address_words()
    found: List[_Found] = []
    is_any = False
    at = position
    while at < len(words):
        one = _designator_at(words, at, names, is_name) or (_number_at(words, at, names) if found else None)
        if one is None:
            break
        found.append(one)
        at = one.end + (one.end < len(words) and words[one.end] == ",")
        joiner = known.phrases["joiners"].length_at(words, at)
        choice = known.phrases["alternatives"].length_at(words, at)
        is_any = is_any or bool(choice and _designator_at(words, at + choice, names, is_name))
        at += joiner or choice
        if at == one.end:
            break
    if not found:
        return None, position
    end = found[-1].end
    kinds = frozenset(one.kind for one in found)
    unknown = [one.unknown for one in found if one.unknown]
    excepted: Tuple[str, ...] = ()
    skip = known.phrases["exceptions"].length_at(words, end)
    if skip and not kinds & {Kind.NAME, Kind.UNKNOWN}:
        inner, behind = group_at(words, end + skip, names, is_name)
        if inner is not None and inner.kinds <= {Kind.NAME, Kind.UNKNOWN}:
            excepted, end = inner.names, behind
            unknown += inner.unknown
    return (
        Group(
            kinds=kinds | ({Kind.UNKNOWN} if unknown else frozenset()),
            names=tuple(dict.fromkeys(one.robot for one in found if one.robot)),
            unknown=tuple(dict.fromkeys(unknown)),
            excepted=excepted,
            is_any=is_any or Kind.SOMEBODY in kinds,
        ),
        end,
    )


def _designator_at(words: Sequence[str], position: int, names: Names, is_name: IsName) -> Optional[_Found]:
    if position >= len(words):
        return None
    robot, end = names.at(words, position)
    if robot:
        return _Found(Kind.NAME, end, robot=robot)
    number, end = numbered_at(words, position)
    if number is not None:
        return _Found(Kind.UNKNOWN, end, unknown=_said(words, position, end))
    best, kind = 0, None
    for name, phrases in address_words().designators.items():
        length = phrases.length_at(words, position)
        if length > best:
            best, kind = length, Kind(name)
    titles = address_words().phrases["titles"].length_at(words, position)
    if titles >= best and is_name(_word(words, position + titles)):
        end = position + titles + 1
        return _Found(Kind.UNKNOWN, end, unknown=_said(words, position, end))
    return None if kind is None else _Found(kind, position + best)


def called_ordinal_at(words: Sequence[str], position: int, names: Names) -> Tuple[Optional[Group], int]:
    """Return who is addressed as "the fourth one", and where that ends; None for nobody."""
    number, end = ordinal_at(words, position)
    if number is None:
        return None, position
    robot = names.of_number(number)
    if robot:
        return Group(frozenset([Kind.NAME]), names=(robot,)), end
    return Group(frozenset([Kind.UNKNOWN]), unknown=(_said(words, position, end),)), end


def _number_at(words: Sequence[str], position: int, names: Names) -> Optional[_Found]:
    """Return the robot of a number behind another one: "robots two and three"."""
    number = number_of(words[position])
    joiners = address_words().words["joiners"]
    # "Beta, 3 metres forward" begins with an amount; "robots two, three and four" is a list.
    is_listed = _word(words, position - 1) == "," and _word(words, position + 1) in joiners | {","}
    if number is None or not (is_listed or _word(words, position - 1) in joiners):
        return None
    robot = names.of_number(number)
    if robot:
        return _Found(Kind.NAME, position + 1, robot=robot)
    return _Found(Kind.UNKNOWN, position + 1, unknown=f"robot {words[position]}")


def _word(words: Sequence[str], position: int) -> str:
    return words[position] if 0 <= position < len(words) else ""


def _said(words: Sequence[str], begin: int, end: int) -> str:
    return " ".join(word for word in words[begin:end] if word != "the")
