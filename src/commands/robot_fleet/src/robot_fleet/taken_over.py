"""What a fleet had sent to robots before it was started again: how that ended, as far as the robots can tell."""

import math
from dataclasses import dataclass
from typing import Dict, List, Sequence, Set, Tuple

from command_server.follow_ups import is_follow_up

#: A robot that has not told what it does after this time is not there, seconds.
_ROBOT_TIMEOUT_S = 10.0
#: The result of a command may arrive after the status without it, by this much at most, seconds.
_RESULT_DELAY_S = 1.0


@dataclass
class _Sent:
    robot: str
    until_s: float


class TakenOver:
    """The commands whose end is not known. One thread owns it; times are monotonic seconds."""

    def __init__(self) -> None:
        self._sent: Dict[str, _Sent] = {}
        self._watched: Set[str] = set()

    def add(self, sent_id: str, robot: str, *, now_s: float) -> None:
        """A command was sent to a robot before the start."""
        self._sent[sent_id] = _Sent(robot, now_s + _ROBOT_TIMEOUT_S)
        self._watched.add(robot)

    def hear(self, robot: str, active: Sequence[str], last_id: str, *, now_s: float) -> Tuple[str, ...]:
        """A robot tells which commands it carries out, and to which one it replied last; return those of the reply."""
        replied: List[str] = []
        for sent_id, sent in self._sent.items():
            if sent.robot != robot:
                continue
            if any(_is_of(command_id, sent_id) for command_id in active):
                sent.until_s = math.inf
            elif _is_of(last_id, sent_id):
                replied.append(sent_id)
            else:
                sent.until_s = min(sent.until_s, now_s + _RESULT_DELAY_S)
        return tuple(replied)

    def drop(self, sent_id: str) -> None:
        """A command is answered."""
        self._sent.pop(sent_id, None)

    def take_overdue(self, *, now_s: float) -> Tuple[str, ...]:
        """Remove and return the commands of which nobody can say how they ended."""
        overdue = tuple(sent_id for sent_id, sent in self._sent.items() if now_s >= sent.until_s)
        for sent_id in overdue:
            del self._sent[sent_id]
        return overdue

    def take_known(self) -> Tuple[str, ...]:
        """Return, once, the robots of which nothing is open any more."""
        known = self._watched - {sent.robot for sent in self._sent.values()}
        self._watched -= known
        return tuple(sorted(known))


def _is_of(command_id: str, sent_id: str) -> bool:
    """Whether a command is the one that was sent, or what was said behind its stop."""
    return command_id == sent_id or (is_follow_up(command_id) and command_id.startswith(sent_id))
