"""Stops that were said, and the reports and replies of the stop server to them."""

import time
from collections import deque
from dataclasses import dataclass, replace
from typing import Callable, Deque, List, Optional, Tuple

#: The stop server takes some milliseconds; after this time without its report a stop is carried out here as well.
CONFIRMATION_S = 0.15
#: A report may arrive before the utterance, by this much at most.
_SKEW_S = 0.5
#: How long a stop that was answered here is kept: the stop server may answer it late.
_REMEMBER_S = 30.0


@dataclass(frozen=True)
class StopHeard:
    """A stop that this node received, and that the stop server must answer.

    Attributes:
        command_id: id that the stop has here
        text: as it was said
        stamp_ns: when it was said, nanoseconds of ROS time
        is_action: it came as a goal, so the stop server uses the same id; it gives texts an id of its own
        heard_s: when it arrived, monotonic seconds
        deadline_s: when the stop server counts as silent, monotonic seconds
        is_confirmed: the stop server has carried it out
        is_taken: this node carries it out
    """

    command_id: str
    text: str
    stamp_ns: int
    is_action: bool
    heard_s: float
    deadline_s: float
    is_confirmed: bool = False
    is_taken: bool = False

    @property
    def taking_s(self) -> float:
        """When this node must carry it out, monotonic seconds."""
        if self.is_taken:
            return float("inf")
        return self.deadline_s if self.is_confirmed else min(self.deadline_s, self.heard_s + CONFIRMATION_S)


@dataclass(frozen=True)
class _Early:
    """A report or reply to a stop that has not arrived yet."""

    command_id: str
    text: str
    heard_s: float
    is_reply: bool


class PendingStops:
    """Matches stops with the reports and replies to them, whichever arrives first. One thread owns it."""

    def __init__(self, *, timeout_s: float, now: Callable[[], float] = time.monotonic, max_kept: int = 1000) -> None:
        """Start empty.

        Args:
            timeout_s: how long the stop server may be silent
            now: monotonic clock, seconds
            max_kept: most entries that are kept
        """
        self._timeout_s = timeout_s
        self._now = now
        self._stops: Deque[StopHeard] = deque(maxlen=max_kept)
        self._early: Deque[_Early] = deque(maxlen=max_kept)
        self._overdue: Deque[StopHeard] = deque(maxlen=max_kept)

    def hear_stop(
        self, command_id: str, text: str, *, stamp_ns: int, is_action: bool, heard_s: Optional[float] = None
    ) -> Optional[str]:
        """Add a stop.

        Args:
            command_id: id that it has here
            text: as it was said
            stamp_ns: when it was said, nanoseconds of ROS time
            is_action: it came as a goal
            heard_s: when it arrived, monotonic seconds; now by default

        Returns:
            the id of the reply that it has already; None when it waits for one
        """
        heard_s = self._now() if heard_s is None else heard_s
        stop = StopHeard(command_id, text, stamp_ns, is_action, heard_s, heard_s + self._timeout_s)
        for early in list(self._early):
            is_meant = early.command_id == command_id if is_action else early.text == text
            if not is_meant or heard_s - early.heard_s > _SKEW_S:
                continue
            self._early.remove(early)
            if early.is_reply:
                return early.command_id
            stop = replace(stop, is_confirmed=True, deadline_s=self._now() + self._timeout_s)
        self._stops.append(stop)
        return None

    def hear_report(self, command_id: str, text: str) -> Optional[StopHeard]:
        """The stop server has carried out a stop, and will reply.

        Returns:
            the stop; None when it has not arrived yet
        """
        stop = self._meant_by(command_id, text, [stop for stop in self._stops if not stop.is_confirmed]) or (
            self._meant_by(command_id, text, list(self._stops))
        )
        if stop is None:
            self._early.append(_Early(command_id, text, self._now(), is_reply=False))
            return None
        self._replace(stop, replace(stop, is_confirmed=True, is_taken=False, deadline_s=self._now() + self._timeout_s))
        return stop

    def hear_reply(self, command_id: str, text: str) -> Optional[StopHeard]:
        """The stop server has replied to a stop.

        Returns:
            the stop; None when it has not arrived yet, or was answered here
        """
        stop = self._meant_by(command_id, text, list(self._stops))
        if stop is not None:
            self._stops.remove(stop)
            return stop
        late = self._meant_by(command_id, text, list(self._overdue))
        if late is not None:
            # It must not count as the reply to the next stop.
            self._overdue.remove(late)
        else:
            self._early.append(_Early(command_id, text, self._now(), is_reply=True))
        return None

    def take_silent(self, *, brake_s: float) -> List[StopHeard]:
        """Return, once each, the stops that this node must carry out, for want of a report or a reply.

        Args:
            brake_s: how long that takes; they are not overdue before
        """
        now_s = self._now()
        found = [stop for stop in self._stops if now_s >= stop.taking_s]
        for stop in found:
            self._replace(stop, replace(stop, is_taken=True, deadline_s=max(stop.deadline_s, now_s + brake_s)))
        return found

    def take_overdue(self) -> List[StopHeard]:
        """Remove and return the stops that were carried out here and not answered meanwhile; drops old entries."""
        now_s = self._now()
        while self._early and now_s - self._early[0].heard_s > max(_SKEW_S, self._timeout_s):
            self._early.popleft()
        while self._overdue and now_s - self._overdue[0].deadline_s > _REMEMBER_S:
            self._overdue.popleft()
        overdue = [stop for stop in self._stops if stop.is_taken and stop.deadline_s <= now_s]
        for stop in overdue:
            self._stops.remove(stop)
            self._overdue.append(stop)
        return overdue

    def postpone(self, duration_s: float) -> None:
        """Extend all deadlines by a time in which this process was suspended, seconds."""
        self._stops = deque(
            (
                replace(stop, heard_s=stop.heard_s + duration_s, deadline_s=stop.deadline_s + duration_s)
                for stop in self._stops
            ),
            maxlen=self._stops.maxlen,
        )

    def next_deadline_s(self) -> Optional[float]:
        """The next deadline of a stop, monotonic seconds; None when none waits."""
        return min((min(stop.taking_s, stop.deadline_s) for stop in self._stops), default=None)

    @staticmethod
    def _meant_by(command_id: str, text: str, stops: List[StopHeard]) -> Optional[StopHeard]:
        """Return the oldest stop that a report or reply belongs to. The id counts most.

        Replies to texts, and to goals that were sent without an id, have an id of the stop server.
        """
        matches: Tuple[Callable[[StopHeard], bool], ...] = (
            lambda stop: stop.command_id == command_id,
            lambda stop: stop.text == text and not stop.is_action,
            lambda stop: stop.text == text,
        )
        return next((stop for is_match in matches for stop in stops if is_match(stop)), None)

    def _replace(self, old: StopHeard, new: StopHeard) -> None:
        self._stops = deque((new if stop is old else stop for stop in self._stops), maxlen=self._stops.maxlen)
