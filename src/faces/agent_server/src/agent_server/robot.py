"""What the server for agents knows of the robot, and may ask of it."""

from dataclasses import dataclass
from typing import Mapping, Optional, Protocol

from agent_server.deeds import DeedLog
from agent_server.filled_call import FilledCall
from agent_server.frame_tool import FrameTool
from agent_server.words import OpenQuestion
from world_model import World

DONE, REFUSED, NEEDS_INFORMATION = "DONE", "REFUSED", "NEEDS_INFORMATION"


@dataclass(frozen=True)
class Progress:
    """A stage reports about a command."""

    command_id: str
    stage: str
    sentence: str


@dataclass(frozen=True)
class Answer:
    """The one reply to a command.

    Attributes:
        command_id: of the command
        outcome: DONE, FAILED, REFUSED, NEEDS_INFORMATION or SUPERSEDED
        stage: where it ended
        code: stable name of the reason
        sentence: for the person
    """

    command_id: str
    outcome: str
    stage: str
    code: str
    sentence: str


class Robot(Protocol):
    """The robot, for the thread of the event loop."""

    @property
    def tools(self) -> Mapping[str, FrameTool]:
        """What living servers carry out now, by the name of the tool."""

    @property
    def world(self) -> World:
        """What the robot knows."""

    @property
    def question(self) -> Optional[OpenQuestion]:
        """The question that was the last reply; None when the last reply was none."""

    @property
    def emergency(self) -> str:
        """Why the emergency stop holds, a sentence; empty when it does not."""

    @property
    def deeds(self) -> DeedLog:
        """The log of deeds."""

    def call(self, command_id: str, call: FilledCall, *, asked_by: str) -> bool:
        """Call a frame; return whether somebody listens."""

    def say(self, command_id: str, text: str) -> bool:
        """Say a sentence, as programs do; return whether somebody listens."""

    def cancel(self, command_id: str) -> None:
        """Cancel a command that this server gave."""

    def note(self, asked_by: str, what: str) -> None:
        """Write a line about a call into the log of the node."""
