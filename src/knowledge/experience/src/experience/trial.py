"""What was tried: one frame, one server, one goal."""

import enum
from dataclasses import dataclass
from typing import Iterable, Tuple

from typed_arguments import TypedArgument

#: Longer texts are cut: the store is bounded.
MOST_CHARACTERS = 300
#: A "kind" or "referents" names so many elements.
_MOST_NAMED = 6


class Outcome(enum.IntEnum):
    """How a trial ended; the numbers are those of the message ``TriedFrame``."""

    SUCCEEDED = 0
    FAILED = 1
    ENDED_BY_OTHERS = 2  # the command ended, or another client took the goal away: this says nothing of the server


class Judgement(enum.IntEnum):
    """What a person said of a deed."""

    NONE = 0
    RIGHT = 1
    WRONG = 2


@dataclass(frozen=True)
class Circumstances:
    """What a frame is about, and where.

    Attributes:
        kinds: what its arguments are, by element: "theme=cup"; empty for none
        referents: which things of the world they are: "theme=cup_1"; empty for unknown
        place: the room where the robot is; empty for unknown
        robot: which robot; empty for the only one
    """

    kinds: str = ""
    referents: str = ""
    place: str = ""
    robot: str = ""


@dataclass(frozen=True)
class Trial:
    """A frame that was sent to a server.

    Attributes:
        command_id: of the command
        said: its words
        began_s: ROS time
        frame: name of the frame
        server: name of the action server
        sequence: what the candidate did up to here, with the servers: "approaching by base, grasping by arm"
        circumstances: what it was about, and where
        took_s: from the beginning to the end
        outcome: how it ended
        reason: why it did not succeed; empty for success
        judgement: what a person said of it
    """

    command_id: str
    said: str
    began_s: float
    frame: str
    server: str
    sequence: str
    circumstances: Circumstances
    took_s: float
    outcome: Outcome
    reason: str = ""
    judgement: Judgement = Judgement.NONE

    @property
    def counts(self) -> bool:
        """Whether it says something of the server."""
        return self.judgement is not Judgement.NONE or self.outcome is not Outcome.ENDED_BY_OTHERS

    @property
    def is_success(self) -> bool:
        """Whether it went as the person wanted; what a person says counts more than what the server says."""
        if self.judgement is not Judgement.NONE:
            return self.judgement is Judgement.RIGHT
        return self.outcome is Outcome.SUCCEEDED


def kinds_of(arguments: Iterable[TypedArgument]) -> str:
    """Return what the arguments of a frame are: the noun, or its semantic type; amounts and times are left out."""
    named = ((one.name, one.lemma or one.semantic_type) for one in arguments if one.measure is None)
    return _joined((name, kind.lower()) for name, kind in named)


def referents_of(arguments: Iterable[TypedArgument]) -> str:
    """Return which things of the world the arguments of a frame are."""
    return _joined((one.name, "+".join(_meant(one))) for one in arguments)


def _meant(argument: TypedArgument) -> Tuple[str, ...]:
    count = argument.referent_count
    return argument.referents[: count if count > 0 else len(argument.referents)]


def _joined(named: Iterable[Tuple[str, str]]) -> str:
    found = sorted(f"{name}={value}" for name, value in named if value)
    return " ".join(found[:_MOST_NAMED])[:MOST_CHARACTERS]
