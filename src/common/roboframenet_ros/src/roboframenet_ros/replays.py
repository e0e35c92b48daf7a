"""Commands and goals that a recording repeats beside the robot: nobody says them now."""

import threading
from collections import OrderedDict
from typing import FrozenSet, Iterable

#: A stamp that is older is one of a recording, nanoseconds.
OLDEST_NS = 10_000_000_000
#: The same for a stage that is not told which commands are open: no stage has a command for so long.
OLDEST_OF_ALL_NS = 60_000_000_000
#: Why nothing is done.
AGAIN = "I have taken that before. A recording repeats it, so I do nothing."
#: How many are kept that were taken; the oldest is dropped first.
_MOST_TAKEN = 1000


def is_old(stamp_ns: int, now_ns: int, *, oldest_ns: int = OLDEST_NS) -> bool:
    """Whether a stamp is older than what is said now can have; one of zero says nothing.

    Args:
        stamp_ns: nanoseconds of ROS time
        now_ns: the same
        oldest_ns: how old it can be, nanoseconds
    """
    return 0 < stamp_ns < now_ns - oldest_ns


class Taken:
    """The ids that were taken; each is taken once."""

    def __init__(self) -> None:
        """Start with none."""
        self._ids: OrderedDict[str, None] = OrderedDict()

    def __contains__(self, name: str) -> bool:
        return name in self._ids

    def add(self, name: str) -> None:
        """Take an id; an empty one is no id."""
        if name:
            self._ids[name] = None
            if len(self._ids) > _MOST_TAKEN:
                self._ids.popitem(last=False)


class Replays:
    """Tells what a recording repeats from what is said now; any thread may call.

    A command may be old although it is new: where a stage is slow, or a simulator fast. It is open then, and the
    command server says so.
    """

    def __init__(self, *, oldest_ns: int = OLDEST_NS) -> None:
        """
        Args:
            oldest_ns: what is older is one of a recording, nanoseconds, unless it is open
        """
        self._oldest_ns = oldest_ns
        self._lock = threading.Lock()
        self._taken = Taken()
        self._open: FrozenSet[str] = frozenset()

    def hear_open(self, ids: Iterable[str], *, stamp_ns: int, now_ns: int) -> None:
        """The command server tells which commands have no reply yet; what a recording tells of that is ignored.

        Args:
            ids: of these commands
            stamp_ns: when it told so, nanoseconds of ROS time
            now_ns: the same, now
        """
        if not is_old(stamp_ns, now_ns):
            with self._lock:
                self._open = frozenset(ids)

    def refusal(self, command_id: str, *, stamp_ns: int, now_ns: int) -> str:
        """Take a command; return why it is not taken, a sentence, and empty when it is.

        Args:
            command_id: its id
            stamp_ns: when it was said, nanoseconds of ROS time
            now_ns: the same, now
        """
        with self._lock:
            if command_id in self._taken:
                return AGAIN
            if command_id not in self._open and is_old(stamp_ns, now_ns, oldest_ns=self._oldest_ns):
                age_s = (now_ns - stamp_ns) / 1e9
                return f"That was said {age_s:.0f} s ago. A recording repeats it, so I do nothing."
            self._taken.add(command_id)
            return ""
