"""A finding of ``rfn doctor``."""

from dataclasses import dataclass
from typing import Collection


@dataclass(frozen=True)
class Finding:
    """The result of one check; ``advice`` is empty when there is no problem."""

    subject: str
    found: str
    advice: str = ""

    def __str__(self) -> str:
        text = f"{'problem' if self.advice else 'ok':<8} {self.subject:<14} {self.found}"
        return f"{text}\n{'':<24}-> {self.advice}" if self.advice else text


def clock_finding(publishers: Collection[str]) -> Finding:
    """Say whether a simulated clock that arrives is the only one.

    Args:
        publishers: names of the nodes that publish ``/clock``
    """
    if len(publishers) < 2:
        return Finding("time", "simulated, the clock runs")
    return Finding(
        "time",
        f"{len(publishers)} nodes publish /clock, and time jumps between them: {', '.join(sorted(publishers))}",
        "let one of them do it; the simulated robots have the parameter ~publish_clock",
    )
