"""The ids of commands, and what they tell of how a command came.

A command that came by action has the id of its goal. Nodes name what came as text, and what a fleet sends on.
"""

import itertools
import uuid
from enum import Enum


class TextSource(Enum):
    """Who names a command that came as text; the value begins its id."""

    #: A command of the topic `text`.
    TEXT = "text-"
    #: A stop of the topic `text` that the stop server answers.
    STOP = "stop-"
    #: A text that no command server has taken.
    UNHEARD = "unheard-"
    #: What a recording repeats, and a stage refuses.
    REPLAYED = "replayed-"


#: Ids of commands of agents begin with this.
AGENT = "agent-"
#: What a fleet puts before the id of a command that it sends on to a robot.
_FLEET = "fleet-"


class TextIds:
    """The ids of what one run of a node gets as text; no other run gives the same ones."""

    def __init__(self, source: TextSource) -> None:
        self._prefix = f"{source.value}{uuid.uuid4().hex[:8]}"
        self._numbers = itertools.count(1)

    def next_id(self) -> str:
        """Return an id that was not given before; any thread may ask."""
        return f"{self._prefix}-{next(self._numbers)}"


def sent_on_id(command_id: str, number: int) -> str:
    """Return the id that a fleet gives to its command to one robot.

    Args:
        command_id: of what was said to the fleet
        number: of what the fleet has sent
    """
    return f"{_FLEET}{command_id}-{number}"


def is_spoken(command_id: str) -> bool:
    """Whether a command came on the topic `text`, of a robot or of its fleet; others come from pages and programs."""
    return _without_fleet(command_id).startswith(TextSource.TEXT.value)


def is_of_agent(command_id: str) -> bool:
    """Whether an agent gave a command, to a robot or to its fleet."""
    return _without_fleet(command_id).startswith(AGENT)


def _without_fleet(command_id: str) -> str:
    return command_id[len(_FLEET) :] if command_id.startswith(_FLEET) else command_id


def came_by_action(command_id: str) -> bool:
    """Whether a command is a goal of the action `command`, which can be cancelled by its id."""
    return not command_id.startswith(tuple(source.value for source in TextSource))
