"""The commands that have no reply yet, what ends them, and the deadlines of the stages."""

import enum
import time
from dataclasses import dataclass, replace
from typing import AbstractSet, Callable, Dict, List, Mapping, Optional, Tuple

# In the order in which a command passes them.
STAGES: Tuple[str, ...] = ("stanford_parser_ros", "semantic_framer", "frame_registrar", "arbitrator", "executor")
OWN_STAGE = "command_server"
STOP_STAGE = "stop_server"
EXECUTOR_STAGE = STAGES[-1]


class Outcome(enum.IntEnum):
    """How a command ended; the numbers are those of the Reply message."""

    DONE = 0
    FAILED = 1
    REFUSED = 2
    NEEDS_INFORMATION = 3
    SUPERSEDED = 4


@dataclass(frozen=True)
class CommandText:
    """A sentence that somebody said.

    Attributes:
        command_id: unique
        stamp_ns: when it arrived, nanoseconds of ROS time
        text: as it was said
        order: the standing order that it carries out, as it was said; empty for none
    """

    command_id: str
    stamp_ns: int
    text: str
    order: str = ""


@dataclass(frozen=True)
class Ending:
    """The one final reply to a command.

    Attributes:
        command: what was said
        outcome: how it ended
        stage: where it ended
        code: stable name of the reason
        sentence: for the person
    """

    command: CommandText
    outcome: Outcome
    stage: str
    code: str
    sentence: str

    @property
    def reply(self) -> str:
        """The sentence, which names the standing order that the command carries out."""
        order = self.command.order
        return f'As you said, "{order}": {self.sentence}' if order else self.sentence


@dataclass(frozen=True)
class Verdict:
    """How a command will be answered when everything it started is cancelled."""

    outcome: Outcome
    stage: str
    code: str
    sentence: str


RESTARTED = Verdict(
    Outcome.FAILED, OWN_STAGE, "RESTARTED", "The command server was restarted. Say it again if you still want it."
)


@dataclass(frozen=True)
class OpenCommand:
    """A command without a reply.

    Attributes:
        command: what was said
        awaited_stage: the stage that must report next
        deadline_s: when that stage counts as silent, monotonic seconds
        is_with_executor: whether the executor has reported that it runs the command
        verdict: set while everything that the command started is being cancelled
    """

    command: CommandText
    awaited_stage: str
    deadline_s: float
    is_with_executor: bool = False
    verdict: Optional[Verdict] = None

    @property
    def may_have_started(self) -> bool:
        """Whether the executor may have sent goals for it."""
        return self.awaited_stage == EXECUTOR_STAGE

    @property
    def may_be_planned(self) -> bool:
        """Whether the executor may have its plan or get it soon: the arbitrator sends a plan before it tells of it."""
        return self.awaited_stage in STAGES[-2:]

    def ending(self, verdict: Verdict, remark: str) -> Ending:
        """Return its ending with a verdict; `remark` is a sentence that follows it, empty for none."""
        return Ending(
            command=self.command,
            outcome=verdict.outcome,
            stage=verdict.stage,
            code=verdict.code,
            sentence=f"{verdict.sentence} {remark}".strip(),
        )


def refusal_of_text(text: str, *, max_length: int) -> Optional[Tuple[str, str]]:
    """Return why a text is refused as a command.

    Returns:
        code and sentence; None when it is accepted
    """
    if not text.strip():
        return "EMPTY_TEXT", "Nothing was said."
    if len(text) > max_length:
        return "TEXT_TOO_LONG", f"The text has {len(text)} characters; I accept at most {max_length}."
    return None


def refusal_of_delay(delay_s: float, *, longest_s: float) -> Optional[Tuple[str, str]]:
    """Return why a command that was on its way for some seconds is refused: whoever sent it has given it up.

    Returns:
        code and sentence; None when it is accepted
    """
    if delay_s <= longest_s:
        return None
    return "LATE", f"That was said {delay_s:.0f} s ago. Say it again if you still want it."


def stamp_after(arrival_ns: int, last_ns: int, *, clock_reset_ns: int = 1_000_000_000) -> int:
    """Return the stamp of a command: its arrival, but later than the previous stamp, so that stamps order commands.

    Args:
        arrival_ns: when it arrived, nanoseconds of ROS time
        last_ns: stamp of the previous command
        clock_reset_ns: an arrival that is earlier than the last stamp by this much means that the clock was reset
    """
    if arrival_ns > last_ns or arrival_ns < last_ns - clock_reset_ns:
        return arrival_ns
    return last_ns + 1


def stage_after(stage: str) -> str:
    """Return the stage that must report after `stage` has passed a command on; the executor follows itself.

    Raises:
        ValueError: no such stage
    """
    return STAGES[min(STAGES.index(stage) + 1, len(STAGES) - 1)]


class OpenCommands:
    """Open commands, oldest first. Each is closed exactly once.

    One thread owns it.
    """

    def __init__(self, stage_timeouts_s: Mapping[str, float], *, now: Callable[[], float] = time.monotonic) -> None:
        """Start with no commands.

        Args:
            stage_timeouts_s: how long each stage of `STAGES` may be silent, seconds
            now: monotonic clock, seconds
        """
        self._timeouts_s = dict(stage_timeouts_s)
        self._now = now
        self._open: Dict[str, OpenCommand] = {}

    @property
    def open_commands(self) -> Tuple[OpenCommand, ...]:
        """All of them, oldest first."""
        return tuple(self._open.values())

    def get(self, command_id: str) -> Optional[OpenCommand]:
        """The open command with this id, or None."""
        return self._open.get(command_id)

    def open(self, command: CommandText, *, stage: str = STAGES[0]) -> None:
        """Add a command; its first stage must report before its deadline.

        Args:
            command: what was said
            stage: where it begins
        Raises:
            ValueError: a command with this id is open
        """
        if command.command_id in self._open:
            raise ValueError(f"command {command.command_id!r} is open already")
        self._open[command.command_id] = OpenCommand(
            command=command, awaited_stage=stage, deadline_s=self._now() + self._timeouts_s[stage]
        )

    def adopt(self, command: CommandText, *, timeout_s: float) -> None:
        """Add a command that the previous run left open; it will be answered as restarted.

        Args:
            command: what was said
            timeout_s: how long it may take to cancel what it has started

        Raises:
            ValueError: a command with this id is open
        """
        self.open(command)
        self._condemn(replace(self._open[command.command_id], awaited_stage=EXECUTOR_STAGE), RESTARTED, timeout_s)

    def progress(self, command_id: str, stage: str) -> bool:
        """A stage passed the command on, or the executor still runs it.

        The event of a stage before the awaited one is late, on another connection, and changes nothing.

        Returns:
            whether the command is open and the stage is one of the pipeline
        """
        entry = self._open.get(command_id)
        if entry is None or stage not in STAGES:
            return False
        if entry.verdict is not None:
            return True
        awaited = stage_after(stage)
        if STAGES.index(awaited) < STAGES.index(entry.awaited_stage):
            return True
        self._open[command_id] = replace(
            entry,
            awaited_stage=awaited,
            deadline_s=self._now() + self._timeouts_s[awaited],
            is_with_executor=entry.is_with_executor or stage == STAGES[-1],
        )
        return True

    def finish(self, ending: Ending) -> Optional[Ending]:
        """Close a command.

        Returns:
            the ending with the command as it was opened; None when the command has ended already, or is being cancelled
            and was not done: `finish_condemned` closes it then
        """
        entry = self._open.get(ending.command.command_id)
        if entry is None or (entry.verdict is not None and ending.outcome is not Outcome.DONE):
            return None
        del self._open[ending.command.command_id]
        return replace(ending, command=entry.command)

    def condemn_silent(self, *, timeout_s: float) -> List[OpenCommand]:
        """Find the commands whose stage missed its deadline; each is found once.

        Each must now be cancelled, and then closed by `finish_condemned`.

        Args:
            timeout_s: how long it may take to cancel what it has started
        """
        now_s = self._now()
        return [
            self._condemn(
                entry,
                Verdict(
                    Outcome.FAILED,
                    entry.awaited_stage,
                    "STAGE_SILENT",
                    f"{entry.awaited_stage} did not answer within {self._timeouts_s[entry.awaited_stage]:g} s.",
                ),
                timeout_s,
            )
            for entry in self.open_commands
            if entry.verdict is None and now_s >= entry.deadline_s
        ]

    def finish_condemned(self, command_id: str, remark: str = "") -> Optional[Ending]:
        """Close a command that has been cancelled.

        Args:
            command_id: its id
            remark: a sentence that follows the verdict; empty for none

        Returns:
            its ending; None when it is not open, or has no verdict
        """
        entry = self._open.get(command_id)
        if entry is None or entry.verdict is None:
            return None
        del self._open[command_id]
        return entry.ending(entry.verdict, remark)

    def overdue_condemned(self) -> List[str]:
        """Ids of the commands that should have been cancelled by now."""
        now_s = self._now()
        return [
            entry.command.command_id
            for entry in self.open_commands
            if entry.verdict is not None and now_s >= entry.deadline_s
        ]

    def postpone(self, duration_s: float) -> None:
        """Extend all deadlines by a time in which this process was suspended, seconds."""
        for command_id, entry in self._open.items():
            self._open[command_id] = replace(entry, deadline_s=entry.deadline_s + duration_s)

    def begin(self, command: CommandText) -> None:
        """Start a command that waited here: it has a new stamp, and the deadline of its first stage begins now."""
        entry = self._open.get(command.command_id)
        if entry is not None:
            self._open[command.command_id] = replace(
                entry, command=command, deadline_s=self._now() + self._timeouts_s[STAGES[0]]
            )

    def extend(self, command_id: str, *, timeout_s: float) -> None:
        """Set the deadline of a command that waits for something else than a stage, seconds from now."""
        entry = self._open.get(command_id)
        if entry is not None:
            self._open[command_id] = replace(entry, deadline_s=self._now() + timeout_s)

    def hold(self, command_id: str, *, timeout_s: float) -> None:
        """Wait for no stage any more: the command is answered when the commands that it takes back have ended."""
        entry = self._open.get(command_id)
        if entry is not None:
            self._open[command_id] = replace(entry, verdict=None, deadline_s=self._now() + timeout_s)

    def finish_stopped(
        self, stop_stamp_ns: int, *, stage: str = STOP_STAGE, spared: AbstractSet[str] = frozenset()
    ) -> List[Ending]:
        """Close every command that was said at or before a stop, except those with the ids in `spared`."""
        return [
            self._close(entry, Outcome.SUPERSEDED, stage=stage, code="STOPPED", sentence="A stop ended it.")
            for entry in self.open_commands
            if entry.command.stamp_ns <= stop_stamp_ns and entry.command.command_id not in spared
        ]

    def next_deadline_s(self) -> Optional[float]:
        """The next deadline, monotonic seconds; None when no command is open."""
        return min((entry.deadline_s for entry in self._open.values()), default=None)

    def _close(self, entry: OpenCommand, outcome: Outcome, *, stage: str, code: str, sentence: str) -> Ending:
        del self._open[entry.command.command_id]
        return Ending(command=entry.command, outcome=outcome, stage=stage, code=code, sentence=sentence)

    def _condemn(self, entry: OpenCommand, verdict: Verdict, timeout_s: float) -> OpenCommand:
        condemned = replace(entry, verdict=verdict, deadline_s=self._now() + timeout_s)
        self._open[entry.command.command_id] = condemned
        return condemned


def ending_of_missed(command: CommandText, why: str) -> Ending:
    """Return the ending of a standing order that is not carried out; `why` is a clause."""
    sentence = f"I did not do that: {why}."
    return Ending(command=command, outcome=Outcome.FAILED, stage="standing_orders", code="MISSED", sentence=sentence)


def ending_of_cancelled(command: CommandText) -> Ending:
    """Return the ending of a command that was cancelled before the executor got it."""
    sentence = "Cancelled before it began."
    return Ending(command=command, outcome=Outcome.SUPERSEDED, stage=OWN_STAGE, code="STOPPED", sentence=sentence)


def ending_if_stopped(command: CommandText, *, stop_stamp_ns: int) -> Optional[Ending]:
    """Return the ending of a command that is not newer than the last stop; None for one that may begin."""
    return ending_of_cancelled(command) if command.stamp_ns <= stop_stamp_ns else None


def ending_at_shutdown(command: CommandText) -> Ending:
    """Return the ending of an open command when the command server shuts down."""
    sentence = "The command server is shutting down and has cancelled the command."
    return Ending(command=command, outcome=Outcome.FAILED, stage=OWN_STAGE, code="RESTARTED", sentence=sentence)


def ending_of_silent_stop(stop: CommandText, *, timeout_s: float, standing: str) -> Ending:
    """Return the ending of a stop that the stop server did not answer.

    Args:
        stop: the stop
        timeout_s: how long the stop server had
        standing: a sentence that says whether every node obeys
    """
    sentence = f"{STOP_STAGE} did not answer within {timeout_s:g} s, so {OWN_STAGE} carried out the stop. {standing}"
    return Ending(command=stop, outcome=Outcome.FAILED, stage=STOP_STAGE, code="STAGE_SILENT", sentence=sentence)
