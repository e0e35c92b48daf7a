"""Finds the words that say which robots are meant: "Beta and Gamma", "everybody but Alpha", "the other one"."""

import enum
import re
from dataclasses import dataclass
from typing import Dict, FrozenSet, List, Mapping, Optional, Sequence, Tuple

from robot_fleet.address_words import Phrases, address_words

_TOKEN = re.compile(r"[^\W_]+(?:['’_-][^\W_]+)*|[,;:.!?…—–]")


class Kind(enum.Enum):
    """Whom a designator means."""

    NAME = "name"
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
        excepted: names of those that are not meant
        is_any: one of them is enough: "Alpha or Beta", "somebody"
    """

    kinds: FrozenSet[Kind]
    names: Tuple[str, ...] = ()
    excepted: Tuple[str, ...] = ()
    is_any: bool = False


def tokens_of(text: str) -> Tuple[Token, ...]:
    """Split a text into words and marks."""
    return tuple(
        Token(match.group().lower().replace("’", "'"), match.start(), match.end()) for match in _TOKEN.finditer(text)
    )


def spoken_names(name: str) -> Tuple[str, ...]:
    """Return how people say the name of a robot: "robot_1" is "robot 1"."""
    spaced = " ".join(re.sub(r"[_\-]+", " ", name).lower().split())
    return tuple(dict.fromkeys((name.lower(), spaced)))


class Names:
    """The names of robots, as people say them."""

    def __init__(self, names: Mapping[str, Sequence[str]]) -> None:
        """
        Args:
            names: other spoken names of each robot, by its name
        """
        self._robot_of: Dict[Tuple[str, ...], str] = {}
        for robot, others in names.items():
            for spoken in (*spoken_names(robot), *(other.lower() for other in others)):
                if spoken.split():
                    self._robot_of.setdefault(tuple(spoken.split()), robot)
        self._phrases = Phrases(" ".join(words) for words in self._robot_of)

    def at(self, words: Sequence[str], position: int) -> Tuple[str, int]:
        """Return the robot that is named at a position, and where its name ends; an empty name for none."""
        titles = address_words().phrases["titles"]
        for begin in (position, position + titles.length_at(words, position)):
            length = self._phrases.length_at(words, begin)
            if length:
                return self._robot_of[tuple(words[begin : begin + length])], begin + length
        return "", position


def group_at(words: Sequence[str], position: int, names: Names) -> Tuple[Optional[Group], int]:
    """Return who is addressed at a position, and where the designators end; None for nobody."""
    known = address_words()
    kinds: List[Kind] = []
    named: List[str] = []
    is_any = False
    end = at = position
    while at < len(words):
        kind, robot, after = _designator_at(words, at, names)
        if kind is None:
            break
        kinds.append(kind)
        named += [robot] if robot else []
        end = after
        at = after + (after < len(words) and words[after] == ",")
        joiner = known.phrases["joiners"].length_at(words, at)
        choice = known.phrases["alternatives"].length_at(words, at)
        is_any = is_any or bool(choice and _designator_at(words, at + choice, names)[0])
        at += joiner or choice
        if at == after:
            break
    if not kinds:
        return None, position
    excepted: List[str] = []
    if Kind.NAME not in kinds:
        skip = known.phrases["exceptions"].length_at(words, end)
        if skip:
            inner, behind = group_at(words, end + skip, names)
            if inner is not None and inner.kinds == {Kind.NAME}:
                excepted, end = list(inner.names), behind
    group = Group(frozenset(kinds), tuple(dict.fromkeys(named)), tuple(excepted), is_any or Kind.SOMEBODY in kinds)
    return group, end


def _designator_at(words: Sequence[str], position: int, names: Names) -> Tuple[Optional[Kind], str, int]:
    robot, end = names.at(words, position)
    if robot:
        return Kind.NAME, robot, end
    best, kind = 0, None
    for name, phrases in address_words().designators.items():
        length = phrases.length_at(words, position)
        if length > best:
            best, kind = length, Kind(name)
    return kind, "", position + best
