"""Commands after a stop ("Stop and come back."): they start when the robot stands still."""

import time
from dataclasses import dataclass, replace
from typing import Callable, Dict, FrozenSet, List, Optional

from command_server.open_commands import OWN_STAGE, CommandText, Ending, Outcome, stamp_after
from command_server.spoken_words import words_of

#: Behind the id of a stop, it makes that of the command after it.
_SUFFIX = "-then"


@dataclass(frozen=True)
class _FollowUp:
    """A command that waits; `begin_s` (monotonic seconds) is set when its stop is confirmed."""

    command: CommandText
    stop: CommandText
    begin_s: Optional[float] = None


class FollowUps:
    """Commands that wait for the end of a stop. One thread owns it."""

    def __init__(self, *, pause_s: float, now: Callable[[], float] = time.monotonic) -> None:
        """Start empty.

        Args:
            pause_s: from the confirmation of a stop to the start of the command after it: the robot comes to rest
            now: monotonic clock, seconds
        """
        self._pause_s = pause_s
        self._now = now
        self._waiting: Dict[str, _FollowUp] = {}

    def add(self, text: str, *, stop: CommandText, stop_stamp_ns: int) -> CommandText:
        """Add the command after a stop.

        Args:
            text: of the command
            stop: the whole utterance
            stop_stamp_ns: stamp of the last stop that was reported, which may be this one
        Returns:
            the command, with an id of its own and a stamp after the stop
        """
        stamp_ns = stamp_after(stop.stamp_ns, stop_stamp_ns) + 1
        command = CommandText(command_id=f"{stop.command_id}{_SUFFIX}", stamp_ns=stamp_ns, text=text)
        self._waiting[command.command_id] = _FollowUp(command, stop)
        return command

    def spared_by(self, stop_text: str, stop_stamp_ns: int) -> FrozenSet[str]:
        """Ids of the commands that the stop with this text and stamp does not end: they were said after it.

        A robot of a fleet hears "Everybody, stop and come back" twice: with all others, and the part that is for it.
        """
        said = words_of(stop_text)
        spared = {
            command_id: waiting
            for command_id, waiting in self._waiting.items()
            if f" {words_of(waiting.stop.text)} " in f" {said} "
        }
        for command_id, waiting in spared.items():
            stamp_ns = stamp_after(waiting.command.stamp_ns, stop_stamp_ns)
            self._waiting[command_id] = replace(waiting, command=replace(waiting.command, stamp_ns=stamp_ns))
        return frozenset(spared)

    def hear_answer(self, stop_id: str, *, is_stopped: bool, reason: str = "") -> List[Ending]:
        """A stop was answered: its command starts soon, or never.

        Args:
            stop_id: of the stop
            is_stopped: whether the robot obeyed
            reason: the reply to the stop
        Returns:
            the endings of the commands that never start
        """
        endings = []
        for command_id, waiting in list(self._waiting.items()):
            if waiting.stop.command_id != stop_id or waiting.begin_s is not None:
                continue
            if is_stopped:
                self._waiting[command_id] = replace(waiting, begin_s=self._now() + self._pause_s)
                continue
            del self._waiting[command_id]
            endings.append(
                Ending(
                    command=waiting.command,
                    outcome=Outcome.FAILED,
                    stage=OWN_STAGE,
                    code="NOT_STOPPED",
                    sentence=f"I did not start, because the robot has not stopped. {reason}".strip(),
                )
            )
        return endings

    def forget(self, command_id: str) -> None:
        """Drop a command that is answered already."""
        self._waiting.pop(command_id, None)

    def take_due(self) -> List[CommandText]:
        """Remove and return the commands that may start now."""
        now_s = self._now()
        due = [
            waiting.command
            for waiting in self._waiting.values()
            if waiting.begin_s is not None and waiting.begin_s <= now_s
        ]
        for command in due:
            del self._waiting[command.command_id]
        return due

    def next_due_s(self) -> Optional[float]:
        """When the next command may start, monotonic seconds; None for no command."""
        return min((waiting.begin_s for waiting in self._waiting.values() if waiting.begin_s is not None), default=None)


def is_follow_up(command_id: str) -> bool:
    """Whether a command was said behind a stop."""
    return command_id.endswith(_SUFFIX)
