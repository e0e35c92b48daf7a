"""Utterances of "Stop." and what the stop server says of them."""

import time
from collections import deque
from dataclasses import dataclass, replace
from typing import Callable, Deque, List, Optional, Tuple

#: The stop server takes some milliseconds; a stop of which it says nothing for so long is carried out here as well.
CONFIRMATION_S = 0.15
#: What the stop server says may come before the utterance, by so much at most.
_SKEW_S = 0.5
#: For so long a stop that was answered here is remembered: the stop server may answer it late.
_REMEMBER_S = 30.0


@dataclass(frozen=True)
class StopHeard:
    """A stop that this node heard and that the stop server must answer.

    Attributes:
        command_id: id that the stop has here
        text: as it was said
        stamp_ns: when it was said, nanoseconds of ROS time
        is_action: it came as a goal, so the stop server knows the same id; for texts it has an id of its own
        heard_s: when it was heard, monotonic seconds
        deadline_s: when the stop server counts as silent, monotonic seconds
        is_confirmed: the stop server has carried it out
        is_taken: it is carried out here
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
        """When it is to be carried out here, monotonic seconds."""
        if self.is_taken:
            return float("inf")
        return self.deadline_s if self.is_confirmed else min(self.deadline_s, self.heard_s + CONFIRMATION_S)


@dataclass(frozen=True)
class _Early:
    """What the stop server said of a stop that is still to come."""

    command_id: str
    text: str
    heard_s: float
    is_reply: bool


class PendingStops:
    """Matches stops with what the stop server says of them, whichever comes first. One thread owns it."""

    def __init__(self, *, timeout_s: float, now: Callable[[], float] = time.monotonic, max_kept: int = 1000) -> None:
        """Start empty.

        Args:
            timeout_s: how long the stop server may be silent
            now: monotonic clock, seconds
            max_kept: bound on everything that is kept
        """
        self._timeout_s = timeout_s
        self._now = now
        self._stops: Deque[StopHeard] = deque(maxlen=max_kept)
        self._early: Deque[_Early] = deque(maxlen=max_kept)
        self._overdue: Deque[StopHeard] = deque(maxlen=max_kept)

    def hear_stop(
        self, command_id: str, text: str, *, stamp_ns: int, is_action: bool, heard_s: Optional[float] = None
    ) -> Optional[str]:
        """Note a stop.

        Args:
            command_id: id that it has here
            text: as it was said
            stamp_ns: when it was said, nanoseconds of ROS time
            is_action: it came as a goal
            heard_s: when it was heard, monotonic seconds; now by default

        Returns:
            the id of a reply that it has already, or None: it waits
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
        """The stop server has carried a stop out, sees to it, and will reply.

        Returns:
            the stop, None when it is still to come
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
            the stop; None when it is still to come, or was answered here before
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
        """The stops to be carried out here: the stop server has said nothing, or no reply has followed; each once.

        Args:
            brake_s: how long that takes; they are not overdue before
        """
        now_s = self._now()
        found = [stop for stop in self._stops if now_s >= stop.taking_s]
        for stop in found:
            self._replace(stop, replace(stop, is_taken=True, deadline_s=max(stop.deadline_s, now_s + brake_s)))
        return found

    def take_overdue(self) -> List[StopHeard]:
        """Take out the stops that were carried out here and not answered meanwhile; forget what is old."""
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
        """This process did not run for a while: the stop server cannot be blamed for that time."""
        self._stops = deque(
            (
                replace(stop, heard_s=stop.heard_s + duration_s, deadline_s=stop.deadline_s + duration_s)
                for stop in self._stops
            ),
            maxlen=self._stops.maxlen,
        )

    def next_deadline_s(self) -> Optional[float]:
        """When a stop may be silent or overdue, monotonic seconds; None when none waits."""
        return min((min(stop.taking_s, stop.deadline_s) for stop in self._stops), default=None)

    @staticmethod
    def _meant_by(command_id: str, text: str, stops: List[StopHeard]) -> Optional[StopHeard]:
        """The oldest stop that is meant. The id counts most.

        What answers a text has an id of its own, and so has what answers a goal that was sent without any.
        """
        matches: Tuple[Callable[[StopHeard], bool], ...] = (
            lambda stop: stop.command_id == command_id,
            lambda stop: stop.text == text and not stop.is_action,
            lambda stop: stop.text == text,
        )
        return next((stop for is_match in matches for stop in stops if is_match(stop)), None)

    def _replace(self, old: StopHeard, new: StopHeard) -> None:
        self._stops = deque((new if stop is old else stop for stop in self._stops), maxlen=self._stops.maxlen)
