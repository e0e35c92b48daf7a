"""Statements of servers: their profile, by keys and simple values of a program or a file."""

import json
from typing import Any, Callable, Dict, List, Mapping, Sequence, Tuple

from semantic_frames.server_profile import (
    HeededElement,
    Purpose,
    ServerProfile,
    ServerSetting,
    is_json_scalar,
    unknown_names,
)

#: Keys of a statement, see :func:`stated_profile`.
STATEMENT_KEYS = (
    "purpose",
    "heeds",
    "unheeded",
    "occupies",
    "settings",
    "longest_goal_s",
    "longest_silence_s",
    "robot",
)
_HEEDED_KEYS = ("relations", "values", "semantic_types", "most")


class ProfileError(ValueError):
    """A statement of a server is wrong; the message names every mistake."""

    def __init__(self, problems: Sequence[str]) -> None:
        super().__init__("; ".join(problems))
        self.problems: Tuple[str, ...] = tuple(problems)


def stated_profile(statement: Mapping[str, Any]) -> ServerProfile:
    """Return the profile that a program or a file states by keys and simple values::

        purpose: watches                         # or acts
        heeds:
          Manner: [slow, quick]                  # these values
          Degree:                                # all values
          goal: {relations: [on], semantic_types: [Furniture], most: 1}
        unheeded: [speed]
        occupies: [base, arms]                   # or nothing
        settings: [{node: planner, name: max_vel_x, value: 0.2}]
        longest_goal_s: 60
        longest_silence_s: 5
        robot: pr2

    Args:
        statement: keys of :data:`STATEMENT_KEYS`; ``heeds`` may also be a list of names
    Raises:
        ProfileError: unknown keys, or values of the wrong kind; names are checked by :func:`profile_problems`
    """
    problems = list(unknown_names("key", statement, STATEMENT_KEYS))
    read = _StatementReader(statement, problems)
    profile = ServerProfile(
        purpose=read.purpose(),
        robot=read.text("robot"),
        heeds=read.heeds(),
        unheeded=read.texts("unheeded"),
        occupies=read.texts("occupies"),
        settings=read.settings(),
        longest_goal_s=read.seconds("longest_goal_s"),
        longest_silence_s=read.seconds("longest_silence_s"),
    )
    if problems:
        raise ProfileError(problems)
    return profile


class _StatementReader:
    """Reads the values of a statement, and collects what is wrong with them."""

    def __init__(self, statement: Mapping[str, Any], problems: List[str]) -> None:
        self._statement = statement
        self._problems = problems

    def _of_kind(self, key: str, value: Any, kinds: Tuple[type, ...], expected: str) -> bool:
        is_right = isinstance(value, kinds) and not isinstance(value, bool)
        if not is_right:
            self._problems.append(f"{key}: expected {expected}, found {value!r}")
        return is_right

    def text(self, key: str) -> str:
        value = self._statement.get(key, "")
        return value if self._of_kind(key, value, (str,), "a text") else ""

    def texts(self, key: str) -> Tuple[str, ...]:
        return self._texts(key, self._statement.get(key, ()))

    def _texts(self, key: str, value: Any) -> Tuple[str, ...]:
        if value is None:
            return ()
        if isinstance(value, str):
            return (value,)
        if not self._of_kind(key, value, (list, tuple, set, frozenset), "a list of texts"):
            return ()
        return tuple(one for one in value if self._of_kind(key, one, (str,), "texts"))

    def seconds(self, key: str) -> float:
        return float(self._number(key, self._statement.get(key, 0.0), float, "seconds, 0 or more"))

    def _number(self, key: str, value: Any, kind: Callable[[Any], Any], expected: str) -> Any:
        try:
            number = kind(value)
            if number >= 0:
                return number
        except (TypeError, ValueError):
            pass
        self._problems.append(f"{key}: expected {expected}, found {value!r}")
        return kind(0)

    def purpose(self) -> Purpose:
        value = self._statement.get("purpose", Purpose.ACTS)
        if isinstance(value, Purpose):
            return value
        names = {purpose.name.lower(): purpose for purpose in Purpose}
        if str(value) not in names:
            self._problems.append(f"purpose: expected {' or '.join(names)}, found {value!r}")
        return names.get(str(value), Purpose.ACTS)

    def heeds(self) -> Tuple[HeededElement, ...]:
        value = self._statement.get("heeds", {})
        if not isinstance(value, Mapping):
            return tuple(HeededElement(name) for name in self._texts("heeds", value))
        return tuple(self._heeded(str(name), details) for name, details in value.items())

    def _heeded(self, name: str, details: Any) -> HeededElement:
        if not isinstance(details, Mapping):
            return HeededElement(name, values=self._texts(f"heeds.{name}", details))
        self._problems += unknown_names(f"heeds.{name}: key", details, _HEEDED_KEYS)
        lists: Dict[str, Tuple[str, ...]] = {
            key: self._texts(f"heeds.{name}.{key}", details.get(key)) for key in _HEEDED_KEYS if key != "most"
        }
        most = self._number(f"heeds.{name}.most", details.get("most", 0), int, "a number of things, 0 for any")
        return HeededElement(name, most=most, **lists)

    def settings(self) -> Tuple[ServerSetting, ...]:
        found = []
        value = self._statement.get("settings", ())
        for entry in value if self._of_kind("settings", value, (list, tuple), "a list") else ():
            if not isinstance(entry, Mapping) or set(entry) != {"node", "name", "value"}:
                self._problems.append(f"settings: expected node, name and value, found {entry!r}")
                continue
            text = entry["value"]
            is_json = isinstance(text, str) and is_json_scalar(text)
            found.append(ServerSetting(entry["node"], entry["name"], text if is_json else json.dumps(text)))
        return tuple(found)
