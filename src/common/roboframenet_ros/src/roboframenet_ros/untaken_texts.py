"""What was said while the node that takes texts did not run."""

import time
from collections import deque
from dataclasses import dataclass
from typing import Callable, Deque, Tuple

from roboframenet_ros.command_ids import came_by_action

#: So long after its start, the node hears what is said, and it has told what it took; seconds.
LISTENING_S = 3.0
TOLD_S = 6.0
#: A text, and the sign that it was taken, may differ in their times by this much at most, seconds.
_SKEW_S = 2.0
#: How long a text is kept; the node is started again within some seconds.
_REMEMBER_S = 60.0
#: A text is recognised by its beginning: a long one is cut.
_KEY_LENGTH = 200


@dataclass(frozen=True)
class Said:
    """A text that was said.

    Attributes:
        text: as it was said
        command_id: of a goal; empty for a text
        heard_s: when it was said, monotonic seconds
    """

    text: str
    command_id: str
    heard_s: float


@dataclass(frozen=True)
class Taken:
    """The sign that a text was taken.

    Attributes:
        command_id: of the command that it has become
        age_s: how long ago it was heard, seconds
        text: its beginning
    """

    command_id: str
    age_s: float
    text: str

    def line(self) -> str:
        """Return the sign as one string."""
        return f"{self.command_id} {self.age_s:.3f} {self.text[:_KEY_LENGTH]}"

    @classmethod
    def of_line(cls, line: str) -> "Taken":
        """Read a sign.

        Raises:
            ValueError: it is none
        """
        command_id, age_s, text = line.split(" ", 2)
        return cls(command_id, float(age_s), text)


class RosTimes:
    """Tells how long ago a ROS time was. Simulated time may run at another rate, stand still, or be set back.

    Pairs of both times are noted now and then; between two of them the rate counts as even. One thread at a time calls.
    """

    def __init__(self, *, now: Callable[[], float] = time.monotonic, most: int = 1000) -> None:
        """
        Args:
            now: monotonic clock, seconds
            most: most pairs that are kept
        """
        self._now = now
        self._pairs: Deque[Tuple[float, float]] = deque(maxlen=most)

    def note(self, ros_s: float) -> None:
        """It is this ROS time now."""
        self._pairs.append((ros_s, self._now()))

    def age_s(self, stamp_s: float, *, ros_s: float) -> float:
        """Return how long ago a ROS time was, monotonic seconds.

        Args:
            stamp_s: ROS time in the past
            ros_s: ROS time now
        """
        now_s = self._now()
        pairs = [*self._pairs, (ros_s, now_s)]
        # From the newest pair back: a clock that was set back has been at this time more than once.
        for (begin_ros_s, begin_s), (end_ros_s, end_s) in zip(pairs[-2::-1], pairs[:0:-1]):
            if begin_ros_s <= stamp_s:
                ran_s = end_ros_s - begin_ros_s
                share = min(1.0, (stamp_s - begin_ros_s) / ran_s) if ran_s > 0.0 else 0.0
                return now_s - begin_s - share * (end_s - begin_s)
        first_ros_s, first_s = pairs[0]
        ran_s = ros_s - first_ros_s
        rate = (now_s - first_s) / ran_s if ran_s > 0.0 else 1.0
        return now_s - first_s + (first_ros_s - stamp_s) * rate


class UntakenTexts:
    """Texts, until it is told that they are taken. One thread at a time calls.

    Equal texts are told apart by their times. Who takes a text gives it an id, and may tell again that it took it.
    """

    def __init__(self, *, now: Callable[[], float] = time.monotonic, most: int = 1000) -> None:
        """
        Args:
            now: monotonic clock, seconds
            most: most texts that are kept; the oldest is dropped first
        """
        self._now = now
        self._texts: Deque[Said] = deque(maxlen=most)
        self._early: Deque[Said] = deque(maxlen=most)
        self._taken: Deque[str] = deque(maxlen=most)
        self._ros_times = RosTimes(now=now, most=most)

    def hear(self, text: str, command_id: str = "", *, ros_s: float) -> None:
        """A text was said, or a goal with an id.

        Args:
            text: as it was said
            command_id: of a goal; empty for a text
            ros_s: ROS time now
        """
        self._ros_times.note(ros_s)
        self._forget()
        if command_id and command_id in self._taken:
            return  # a recording repeats it
        said = Said(text, command_id, self._now())
        for early in self._early:
            if _is_same(said, early):
                self._early.remove(early)
                return
        self._texts.append(said)

    def hear_taken(self, sign: Taken) -> None:
        """A text was taken."""
        self._forget()
        if sign.command_id in self._taken:
            return
        self._taken.append(sign.command_id)
        taken = Said(sign.text, sign.command_id, self._now() - sign.age_s)
        same = [said for said in self._texts if _is_same(said, taken)]
        if same:
            self._texts.remove(min(same, key=lambda said: abs(said.heard_s - taken.heard_s)))
        else:
            self._early.append(taken)

    def hear_answered(self, command_id: str, text: str, *, stamp_s: float, ros_s: float) -> None:
        """A text was answered, so it was taken.

        Args:
            command_id: of the command that it has become
            text: as it was said
            stamp_s: ROS time when it was heard
            ros_s: ROS time now
        """
        self.hear_taken(Taken(command_id, self._ros_times.age_s(stamp_s, ros_s=ros_s), text))

    def take(self, *, before_s: float) -> Tuple[Said, ...]:
        """Remove and return what was said before a time and nobody took, oldest first.

        Args:
            before_s: monotonic seconds
        """
        self._forget()
        found = tuple(said for said in self._texts if said.heard_s < before_s)
        for said in found:
            self._texts.remove(said)
        return found

    def _forget(self) -> None:
        now_s = self._now()
        while self._texts and now_s - self._texts[0].heard_s > _REMEMBER_S:
            self._texts.popleft()
        self._early = deque((one for one in self._early if now_s - one.heard_s <= _SKEW_S), self._early.maxlen)


def _is_same(heard: Said, taken: Said) -> bool:
    if heard.command_id or came_by_action(taken.command_id):
        return heard.command_id == taken.command_id
    is_near = abs(heard.heard_s - taken.heard_s) <= _SKEW_S
    return is_near and heard.text[:_KEY_LENGTH] == taken.text[:_KEY_LENGTH]
