"""Which robots take part: those that were heard of a short time ago."""

from dataclasses import dataclass
from typing import Dict, Generic, List, Tuple, TypeVar

Member = TypeVar("Member")


@dataclass(frozen=True)
class Changes:
    """Names of robots that have joined and left."""

    joined: Tuple[str, ...] = ()
    left: Tuple[str, ...] = ()

    def __bool__(self) -> bool:
        return bool(self.joined or self.left)


class Roster(Generic[Member]):
    """The robots, each with what it last told of itself."""

    def __init__(self, *, silence_s: float, most: int = 20_000) -> None:
        """
        Args:
            silence_s: a robot that is silent for longer has left
            most: further robots are not taken
        """
        self._silence_s = silence_s
        self._most = most
        self._members: Dict[str, Member] = {}
        self._heard_s: Dict[str, float] = {}
        self._absent: Dict[str, None] = {}

    def hear(self, name: str, member: Member, *, now_s: float) -> Changes:
        """A robot tells of itself."""
        is_new = name not in self._members
        if is_new and len(self._members) >= self._most:
            return Changes()
        self._members[name] = member
        self._heard_s[name] = now_s
        self._absent.pop(name, None)
        return Changes(joined=(name,) if is_new else ())

    def turn(self, *, now_s: float) -> Changes:
        """Remove the robots that are silent."""
        silent = [name for name, heard_s in self._heard_s.items() if now_s - heard_s > self._silence_s]
        return self._remove(silent)

    def leave(self, name: str) -> Changes:
        """A robot says that it leaves."""
        return self._remove([name] if name in self._members else [])

    def _remove(self, names: List[str]) -> Changes:
        for name in names:
            del self._members[name], self._heard_s[name]
            self._absent[name] = None
        while len(self._absent) > self._most:
            del self._absent[next(iter(self._absent))]
        return Changes(left=tuple(sorted(names)))

    @property
    def members(self) -> Tuple[Member, ...]:
        """What the robots last told, by name."""
        return tuple(self._members[name] for name in sorted(self._members))

    @property
    def absent(self) -> Tuple[str, ...]:
        """The names of robots that have left."""
        return tuple(sorted(self._absent))
