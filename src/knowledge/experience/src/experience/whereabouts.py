"""Where the robot was, so that a trial that has ended knows where it began; and what a candidate did before it."""

from collections import deque
from typing import Deque, Dict, List, Tuple

#: Rooms that are remembered: a robot changes its room a few times in a minute.
_MOST_PLACES = 200
#: Clauses of which a candidate is followed.
_MOST_CLAUSES = 100


class Whereabouts:
    """The rooms of the robot, by time."""

    def __init__(self) -> None:
        self._places: Deque[Tuple[float, str]] = deque(maxlen=_MOST_PLACES)

    @property
    def now(self) -> str:
        """The room where it is; empty when unknown."""
        return self._places[-1][1] if self._places else ""

    def hear(self, place: str, now_s: float) -> bool:
        """The robot is in a room; returns whether that is new."""
        if place == self.now:
            return False
        self._places.append((now_s, place))
        return True

    def at(self, time_s: float) -> str:
        """Return the room where it was; the first known one for earlier times."""
        found = [place for since_s, place in self._places if since_s <= time_s]
        return found[-1] if found else self._places[0][1] if self._places else ""


class Sequences:
    """What the candidate of each clause has done so far."""

    def __init__(self) -> None:
        self._done: Dict[Tuple[str, int], List[str]] = {}

    def hear(self, command_id: str, clause: int, frame: str, server: str, *, succeeded: bool) -> str:
        """A frame has ended; returns what the candidate did up to it: "approaching by base, grasping by arm"."""
        key = command_id, clause
        steps = [*self._done.pop(key, ()), f"{frame} by {server}"]
        if succeeded:
            # A candidate that fails is followed by another one, which begins anew.
            self._done[key] = steps
            if len(self._done) > _MOST_CLAUSES:
                del self._done[next(iter(self._done))]
        return ", ".join(steps)
