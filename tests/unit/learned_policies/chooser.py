"""What is compared: somebody who orders candidates, and hears what came of them."""

from typing import Sequence

from arbitrator.plan import Candidate
from typed_arguments import FilledFrame

from .simulation import Request


class Chooser:
    """Orders the candidates of a command, and hears what came of each frame."""

    def choose(self, request: Request, candidates: Sequence[Candidate]) -> Sequence[Candidate]:
        """Return the candidates in the order in which they are tried."""
        raise NotImplementedError

    def hear(self, request: Request, frame: FilledFrame, *, succeeded: bool, took_s: float) -> None:
        """A frame has ended."""
