"""How a node is: what it says of itself on ``/diagnostics`` (REP 107)."""

from dataclasses import dataclass, field
from enum import IntEnum
from typing import Mapping, Protocol, runtime_checkable


class Level(IntEnum):
    """The levels of diagnostic_msgs/DiagnosticStatus that a node gives itself."""

    OK = 0
    WARN = 1
    ERROR = 2


@dataclass(frozen=True)
class Health:
    """The state of a node.

    Attributes:
        level: WARN when a person should look, ERROR when the node cannot do its work
        message: a sentence
        values: facts by name
    """

    level: Level = Level.OK
    message: str = "Runs."
    values: Mapping[str, object] = field(default_factory=dict)


@runtime_checkable
class SelfDiagnosing(Protocol):
    """A node that says how it is. All others are well as long as they run."""

    def health(self) -> Health:
        """Return the state of the node, at once; any thread may call."""
