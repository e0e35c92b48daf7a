"""A procedure as values: the same shape as the Procedure message, without ROS."""
from dataclasses import dataclass
from typing import Tuple


@dataclass(frozen=True)
class FilledElement:
    """A frame element and its argument, in the words of the speaker."""

    name: str
    argument: str


@dataclass(frozen=True)
class FilledFrame:
    """A filled semantic frame and the action server that carries it out.

    Attributes:
        name: name of the frame, not empty
        frame_elements: filled elements, in the order of the message
        server: name of the one action server of this step, not empty

    Raises:
        ValueError: an empty name or server
    """

    name: str
    frame_elements: Tuple[FilledElement, ...]
    server: str

    def __post_init__(self) -> None:
        if not self.name:
            raise ValueError("a frame of the procedure has no name")
        if not self.server:
            raise ValueError(f"frame {self.name!r} of the procedure names no action server")


@dataclass(frozen=True)
class Sequence:
    """Frames to carry out in this order: one candidate.

    Raises:
        ValueError: no frame at all; such a sequence would succeed by doing nothing
    """

    frames: Tuple[FilledFrame, ...]

    def __post_init__(self) -> None:
        if not self.frames:
            raise ValueError("a sequence of the procedure has no frames")


@dataclass(frozen=True)
class Procedure:
    """Sequences to try in this order until one succeeds.

    Raises:
        ValueError: no sequence at all
    """

    sequences: Tuple[Sequence, ...]

    def __post_init__(self) -> None:
        if not self.sequences:
            raise ValueError("the procedure has no sequences")
