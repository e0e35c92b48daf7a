"""The log of deeds: what was asked of the robot, by whom, and how it ended."""

from collections import deque
from dataclasses import asdict, dataclass
from typing import Any, Deque, Dict, List, Tuple

#: Deeds that are remembered.
MOST_DEEDS = 500


@dataclass(frozen=True)
class Deed:
    """A command or a call that has ended.

    Attributes:
        asked_by: "agent claude", "a person"
        what: the sentence, or the called frame in words
        outcome: DONE, FAILED, REFUSED, NEEDS_INFORMATION or SUPERSEDED
        code: stable name of the reason
        sentence: the reply
        time_s: when it ended, seconds since 1970
        frames: what was given to servers: the frame, its server, and whether it succeeded
    """

    asked_by: str
    what: str
    outcome: str
    code: str
    sentence: str
    time_s: float
    frames: Tuple[str, ...] = ()


class DeedLog:
    """Remembers the last deeds. One thread owns it."""

    def __init__(self, most: int = MOST_DEEDS) -> None:
        """
        Args:
            most: number of deeds that are remembered
        """
        self._deeds: Deque[Deed] = deque(maxlen=most)
        self._tried: Dict[str, List[str]] = {}
        self._most = most

    def add_tried(self, command_id: str, told: str) -> None:
        """A frame of a command was given to a server, and has ended."""
        self._tried.setdefault(command_id, []).append(told)
        while len(self._tried) > self._most:
            del self._tried[next(iter(self._tried))]

    def take_tried(self, command_id: str) -> Tuple[str, ...]:
        """Return what was tried for a command, and forget it."""
        return tuple(self._tried.pop(command_id, ()))

    def add(self, deed: Deed) -> None:
        """A command has ended, or a call was refused."""
        self._deeds.append(deed)

    def last(self, count: int) -> List[Dict[str, Any]]:
        """Return the last deeds, the newest first, as values of JSON."""
        return [asdict(deed) for deed in list(self._deeds)[: -count - 1 : -1]]
