"""The output of ``rfn say``, and its exit status."""

import json
import re
from dataclasses import asdict, dataclass
from enum import IntEnum
from typing import Optional


class Outcome(IntEnum):
    """Outcome of a reply; the numbers are those of ``roboframenet_msgs/Reply``."""

    DONE = 0
    FAILED = 1
    REFUSED = 2
    NEEDS_INFORMATION = 3
    SUPERSEDED = 4


#: Exit status of ``rfn say``: 0 only when the robot did it.
EXIT_STATUS = {
    Outcome.DONE: 0,
    Outcome.FAILED: 1,
    Outcome.REFUSED: 3,
    Outcome.NEEDS_INFORMATION: 4,
    Outcome.SUPERSEDED: 5,
}
#: The code of a reply to thanks, a greeting and the like.
_TALK = "TALK"
#: Exit status when no reply came.
NO_REPLY = 6


@dataclass(frozen=True)
class Stage:
    """An event of a stage about the command."""

    stage: str
    sentence: str


@dataclass(frozen=True)
class Answer:
    """The reply to a sentence."""

    id: str
    text: str
    outcome: Outcome
    stage: str
    code: str
    sentence: str


def is_news(stage: Stage, before: Optional[Stage]) -> bool:
    """Whether an event says more than the time that has passed since the one before."""
    return before is None or stage.stage != before.stage or _without_numbers(stage) != _without_numbers(before)


def _without_numbers(stage: Stage) -> str:
    return re.sub(r"\d+(\.\d+)?", "", stage.sentence)


def format_stage(stage: Stage, *, as_json: bool) -> str:
    """Return the line for an event of a stage."""
    if as_json:
        return json.dumps({"event": asdict(stage)})
    return f"  {stage.stage:<20} {stage.sentence}"


def format_answer(answer: Answer, *, as_json: bool) -> str:
    """Return the line for the reply."""
    if as_json:
        return json.dumps({"reply": {**asdict(answer), "outcome": answer.outcome.name}})
    # "Thank you" asks for nothing, so nothing of it can be done; a person who hears "refused" would wonder what.
    name = "heard" if answer.code == _TALK else answer.outcome.name.lower().replace("_", " ")
    return f"{name}: {answer.sentence}" + (
        f" [{answer.code} in {answer.stage}]" if answer.outcome is not Outcome.DONE else ""
    )
