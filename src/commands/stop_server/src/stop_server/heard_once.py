"""One utterance comes on two ways: this node hears it, and the command server tells that it has heard it."""

import time
from collections import deque
from dataclasses import dataclass
from typing import Callable, Deque, FrozenSet, Tuple

#: A command server that hung tells late what this node has heard at once, seconds.
_REMEMBER_S = 60.0
_MOST_KEPT = 1000

#: Where it came from ("goal", "unnamed" for a goal without an id, "text"), and its id or its words.
_Key = Tuple[str, str]


@dataclass(frozen=True)
class _Entry:
    keys: FrozenSet[_Key]
    heard_s: float


class HeardOnce:
    """Finds out which cries have come on the other way already.

    A client connects to its listeners one after the other. What it says when it has connected to the command server
    alone, this node would miss. Not for several threads at once.
    """

    def __init__(self, *, now: Callable[[], float] = time.monotonic) -> None:
        """Start with none.

        Args:
            now: monotonic clock, seconds
        """
        self._now = now
        self._heard: Deque[_Entry] = deque(maxlen=_MOST_KEPT)
        self._told: Deque[_Entry] = deque(maxlen=_MOST_KEPT)

    def hears(self, text: str, *, is_goal: bool, command_id: str = "") -> bool:
        """A cry has arrived here; returns whether it is new.

        Args:
            text: as it was said
            is_goal: whether it came by action
            command_id: id of the goal; empty for a text, and for a goal that was sent without one
        """
        key = ("goal", command_id) if command_id else ("unnamed" if is_goal else "text", text)
        if self._take(self._told, frozenset([key])):
            return False
        self._heard.append(_Entry(frozenset([key]), self._now()))
        return True

    def is_told(self, text: str, *, is_goal: bool, command_id: str) -> bool:
        """The command server has heard a cry; returns whether it is new.

        Args:
            text: as it was said
            is_goal: whether it came by action
            command_id: that the command server has given to it, or that the goal has
        """
        keys = frozenset([("goal", command_id), ("unnamed", text)] if is_goal else [("text", text)])
        if self._take(self._heard, keys):
            return False
        self._told.append(_Entry(keys, self._now()))
        return True

    def forget(self) -> None:
        """The command server was started: it tells nothing of what was said before."""
        self._heard.clear()

    def _take(self, entries: Deque[_Entry], keys: FrozenSet[_Key]) -> bool:
        """Remove the oldest entry with one of the keys; returns whether there was one."""
        while entries and entries[0].heard_s < self._now() - _REMEMBER_S:
            entries.popleft()
        for entry in entries:
            if entry.keys & keys:
                entries.remove(entry)
                return True
        return False
