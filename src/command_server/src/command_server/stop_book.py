"""Utterances of "Stop." and the reports that answer them."""
import time
from collections import deque
from dataclasses import dataclass
from typing import Callable, Deque, List, Optional


@dataclass(frozen=True)
class StopHeard:
    """A stop that this node heard and that a report of the stop server must answer.

    Attributes:
        command_id: id that the stop has here
        text: as it was said
        is_action: it came as a goal, so the report carries the same id; for texts the report has an id of its own
        deadline_s: monotonic seconds
    """

    command_id: str
    text: str
    is_action: bool
    deadline_s: float


@dataclass(frozen=True)
class ReportHeard:
    """A report that came before its utterance; `deadline_s` is when it is forgotten, monotonic seconds."""

    command_id: str
    text: str
    deadline_s: float


class StopBook:
    """Matches stops with reports, whichever comes first. One thread owns it."""

    def __init__(self, *, timeout_s: float, now: Callable[[], float] = time.monotonic, max_kept: int = 1000) -> None:
        """Start empty.

        Args:
            timeout_s: how long a stop waits for its report, and a report for its stop
            now: monotonic clock, seconds
            max_kept: bound on stops and reports that wait
        """
        self._timeout_s = timeout_s
        self._now = now
        self._stops: Deque[StopHeard] = deque(maxlen=max_kept)
        self._reports: Deque[ReportHeard] = deque(maxlen=max_kept)

    def hear_stop(self, command_id: str, text: str, *, is_action: bool) -> Optional[str]:
        """Note a stop.

        Returns:
            the id of a report that answers it already, or None: it waits
        """
        for report in self._reports:
            if (report.command_id == command_id) if is_action else (report.text == text):
                self._reports.remove(report)
                return report.command_id
        self._stops.append(StopHeard(command_id, text, is_action, self._now() + self._timeout_s))
        return None

    def hear_report(self, command_id: str, text: str) -> Optional[StopHeard]:
        """Note a report; returns the stop that it answers, None when that is still to come.

        The id counts most. A report to a text has an id of its own, and so has one to a goal that was sent without any.
        """
        matches = (
            lambda stop: stop.command_id == command_id,
            lambda stop: stop.text == text and not stop.is_action,
            lambda stop: stop.text == text)
        for is_match in matches:
            for stop in self._stops:
                if is_match(stop):
                    self._stops.remove(stop)
                    return stop
        self._reports.append(ReportHeard(command_id, text, self._now() + self._timeout_s))
        return None

    def take_overdue(self) -> List[StopHeard]:
        """Take out the stops that no report has answered in time; forget reports as old."""
        now_s = self._now()
        while self._reports and self._reports[0].deadline_s <= now_s:
            self._reports.popleft()
        overdue = [stop for stop in self._stops if stop.deadline_s <= now_s]
        for stop in overdue:
            self._stops.remove(stop)
        return overdue
