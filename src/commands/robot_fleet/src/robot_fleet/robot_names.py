"""The names of robots as people say them: "robot_1" is "robot one", "number 1" and "the first robot"."""

import re
from typing import Dict, List, Mapping, Optional, Sequence, Tuple

from robot_fleet.address_words import address_words

_PIECE = re.compile(r"\d+|[^\W\d_]+")
_ORDINAL = re.compile(r"(\d+)(?:st|nd|rd|th)")
#: The number of a robot: at the end of its name, and the only one in it.
_NUMBER = re.compile(r"[^\W\d_]*[\s_-]*(\d+)|.*[\s_-](\d+)")
#: "Robot number three".
_MOST_TITLES = 2
#: More digits than these are no number of a robot.
_MOST_DIGITS = 4


def spoken_names(name: str) -> Tuple[str, ...]:
    """Return how people say the name of a robot: "robot_1" is "robot 1"."""
    spaced = " ".join(re.sub(r"[_\-]+", " ", name).lower().split())
    return tuple(dict.fromkeys((name.lower(), spaced)))


def number_of(word: str) -> Optional[int]:
    """Return the number that a word in lower case is: 3 for "three" and "3"; None for other words."""
    if word.isdecimal() and len(word) <= _MOST_DIGITS:
        return int(word)
    return address_words().numbers.get(word)


def is_titled(words: Sequence[str], position: int) -> bool:
    """Whether a title stands right before a position: "robot four"."""
    return position > 0 and address_words().phrases["titles"].length_at(words, position - 1) == 1


class Names:
    """The names of robots, as people say them."""

    def __init__(self, names: Mapping[str, Sequence[str]]) -> None:
        """
        Args:
            names: other spoken names of each robot, by its name
        """
        self._robot_of: Dict[str, str] = {}
        self._numbered: Dict[int, List[str]] = {}
        self._longest = 1
        for robot, others in names.items():
            for spoken in (robot.lower(), *(other.lower() for other in others)):
                pieces = _pieces(spoken)
                if pieces:
                    self._robot_of.setdefault("".join(pieces), robot)
                    self._longest = max(self._longest, len(pieces))
            number = _NUMBER.fullmatch(" ".join(_pieces(robot.lower())))
            if number is not None:
                self._numbered.setdefault(int(number.group(1) or number.group(2)), []).append(robot)

    def at(self, words: Sequence[str], position: int) -> Tuple[str, int]:
        """Return the robot that is named at a position, and where its name ends; an empty name for none."""
        behind_titles = _behind_titles(words, position)
        for begin in dict.fromkeys((position, *behind_titles)):
            for end in range(min(begin + self._longest, len(words)), begin, -1):
                robot = self._robot_of.get("".join(_key(words, begin, end)))
                if robot is not None:
                    return robot, end
        number, end = numbered_at(words, position)
        robot = self.of_number(number)
        return (robot, end) if robot else ("", position)

    def of_number(self, number: Optional[int]) -> str:
        """Return the one robot with a number in its name; empty for none, or for several."""
        robots = self._numbered.get(number, []) if number is not None else []
        return robots[0] if len(robots) == 1 else ""


def numbered_at(words: Sequence[str], position: int) -> Tuple[Optional[int], int]:
    """Return the number of the robot that is called by its number at a position, and where that ends; None for none.

    "Robot four", "number 4", "the fourth robot"; what recognisers write for it, too: "robot for".
    """
    for begin in reversed(_behind_titles(words, position)):
        number = number_of(_sounding(words, begin)) if begin < len(words) else None
        if number is not None:
            return number, begin + 1
    begin = position + (words[position : position + 1] == ["the"])
    number = _ordinal(words[begin]) if begin < len(words) else None
    if number is not None and words[begin + 1 : begin + 2] and words[begin + 1] in address_words().words["titles"]:
        return number, begin + 2
    return None, position


def ordinal_at(words: Sequence[str], position: int) -> Tuple[Optional[int], int]:
    """Return the same for "the fourth one", which may be a thing: it is a robot only where somebody is called."""
    begin = position + (words[position : position + 1] == ["the"])
    number = _ordinal(words[begin]) if begin < len(words) else None
    return (number, begin + 2) if number is not None and words[begin + 1 : begin + 2] == ["one"] else (None, position)


def _ordinal(word: str) -> Optional[int]:
    digits = _ORDINAL.fullmatch(word)
    return int(digits.group(1)[:_MOST_DIGITS]) if digits else address_words().ordinals.get(word)


def _behind_titles(words: Sequence[str], position: int) -> List[int]:
    """Return where the words behind one title and behind the next begin: "robot number three"."""
    titles, found = address_words().phrases["titles"], [position]
    while len(found) <= _MOST_TITLES and titles.length_at(words, found[-1]):
        found.append(found[-1] + titles.length_at(words, found[-1]))
    return found[1:]


def _sounding(words: Sequence[str], position: int) -> str:
    """Return a word; behind a title the number that it sounds like."""
    word = words[position]
    return address_words().sounds_like.get(word, word) if is_titled(words, position) else word


def _key(words: Sequence[str], begin: int, end: int) -> List[str]:
    return [piece for at in range(begin, end) for piece in _pieces(_sounding(words, at)) or [words[at]]]


def _pieces(spoken: str) -> List[str]:
    """Return the words and numbers of a name, numbers in digits: "robot1" and "robot one" have the same."""
    pieces = _PIECE.findall(spoken)
    return [piece if number_of(piece) is None else str(number_of(piece)) for piece in pieces]
