"""Prohibitions and corrections: what they are against is ended first, and their reply says so."""

import time
from dataclasses import dataclass, field, replace
from typing import Callable, Dict, FrozenSet, Iterable, List, Optional, Tuple

from command_server.open_commands import CommandText, Ending, Outcome
from command_server.taking_back import takes_back, tells_to_go_on

#: Codes of the framer for a prohibition and a correction. The framer does not know what runs.
PROHIBITION = "NEGATED"
CORRECTION = "CORRECTION"
_AGAINST_WHAT_RUNS: FrozenSet[str] = frozenset([PROHIBITION, CORRECTION])
_FRAMER = "semantic_framer"
#: Its codes for a "no" to a question, and for what asks for nothing: "it is not hot" forbids nothing.
_AGAINST_NOTHING: FrozenSet[str] = frozenset(["DECLINED", "QUESTION", "REPORT", "WISH", "TALK"])
_REFUSED: FrozenSet[Outcome] = frozenset([Outcome.REFUSED, Outcome.NEEDS_INFORMATION, Outcome.FAILED])
#: Sentences for commands that ended as expected; the reply need not repeat them.
_PLAIN_ENDS = ("Stopped.", "A stop ended it.", "A newer command took its place.", "Cancelled before it began.")


def is_against_what_runs(ending: Ending) -> bool:
    """Whether the commands that were said before must end with this one.

    The framer knows prohibitions ("don't go there") and corrections that it does not understand. A correction that any
    stage refuses, asks about or does not answer is against what runs too: "no, go to the garage" with no server for it.
    "No, keep going" is against nothing, although the framer takes it for a correction.
    """
    if ending.outcome not in _REFUSED or tells_to_go_on(ending.command.text):
        return False
    if ending.code in _AGAINST_WHAT_RUNS:
        return True
    is_harmless = ending.stage == _FRAMER and ending.code in _AGAINST_NOTHING
    return not is_harmless and takes_back(ending.command.text)


@dataclass
class _Withdrawal:
    """A prohibition or a correction, the commands that it ends, and how they ended."""

    ending: Ending
    deadline_s: float
    awaited: Dict[str, CommandText]
    ended: List[Ending] = field(default_factory=list)


class Withdrawals:
    """Prohibitions and corrections that wait for the commands they end. One thread owns it."""

    def __init__(self, *, timeout_s: float, now: Callable[[], float] = time.monotonic) -> None:
        """Start empty.

        Args:
            timeout_s: deadline for the end of the running commands
            now: monotonic clock, seconds
        """
        self._timeout_s = timeout_s
        self._now = now
        self._open: Dict[str, _Withdrawal] = {}

    def begin(self, ending: Ending, commands: Iterable[CommandText]) -> Tuple[CommandText, ...]:
        """Hold back an ending until the commands that were said before its command have ended.

        Args:
            ending: of the prohibition or correction
            commands: all open commands

        Returns:
            the commands that must be cancelled; empty when there is nothing to wait for
        """
        older = {
            command.command_id: command
            for command in commands
            if command.stamp_ns < ending.command.stamp_ns and not self.is_waiting(command.command_id)
        }
        if older:
            self._open[ending.command.command_id] = _Withdrawal(ending, self._now() + self._timeout_s, older)
        # A copy: commands that end are removed from the dictionary.
        return tuple(older.values())

    def is_waiting(self, command_id: str) -> bool:
        """Whether this command waits for others to end."""
        return command_id in self._open

    def hear_end(self, ending: Ending) -> List[Ending]:
        """A command has ended.

        Returns:
            the endings of the prohibitions and corrections that waited only for it
        """
        self._open.pop(ending.command.command_id, None)
        complete = []
        for command_id, withdrawal in list(self._open.items()):
            if withdrawal.awaited.pop(ending.command.command_id, None) is not None:
                withdrawal.ended.append(ending)
                if not withdrawal.awaited:
                    del self._open[command_id]
                    complete.append(_complete(withdrawal))
        return complete

    def take_overdue(self) -> List[Ending]:
        """Remove and return the endings of those whose deadline is over."""
        now_s = self._now()
        overdue = [withdrawal for withdrawal in self._open.values() if withdrawal.deadline_s <= now_s]
        for withdrawal in overdue:
            del self._open[withdrawal.ending.command.command_id]
        return [_incomplete(withdrawal, self._timeout_s) for withdrawal in overdue]

    def next_deadline_s(self) -> Optional[float]:
        """The next deadline, monotonic seconds; None when none waits."""
        return min((withdrawal.deadline_s for withdrawal in self._open.values()), default=None)


def _complete(withdrawal: _Withdrawal) -> Ending:
    ending = withdrawal.ending
    said = "You said not to." if ending.code == PROHIBITION else ending.sentence
    return replace(ending, sentence=" ".join([_how(ended) for ended in withdrawal.ended] + [said]))


def _incomplete(withdrawal: _Withdrawal, timeout_s: float) -> Ending:
    names = " and ".join(_quoted(command) for command in withdrawal.awaited.values())
    return replace(
        withdrawal.ending,
        outcome=Outcome.FAILED,
        code="NOT_STOPPED",
        sentence=" ".join(
            [_how(ended) for ended in withdrawal.ended]
            + [
                (
                    f"I cancelled {names}, but the end was not confirmed within {timeout_s:g} s. "
                    "The robot may still move."
                )
            ]
        ),
    )


def _how(ended: Ending) -> str:
    """Return a sentence that says how a cancelled command ended."""
    if ended.outcome is Outcome.DONE:
        return f"{_quoted(ended.command)} was already done."
    if ended.outcome is not Outcome.SUPERSEDED:
        return f"{_quoted(ended.command)} has ended: {ended.sentence}"
    if ended.sentence == "Cancelled before it began.":
        return f"I did not start {_quoted(ended.command)}."
    remark = next(
        (ended.sentence[len(plain) :].strip() for plain in _PLAIN_ENDS if ended.sentence.startswith(plain)),
        ended.sentence,
    )
    return f"I stopped {_quoted(ended.command)}. {remark}".strip()


def _quoted(command: CommandText) -> str:
    text = command.text.strip().rstrip(".!")
    return f'"{text}"'
