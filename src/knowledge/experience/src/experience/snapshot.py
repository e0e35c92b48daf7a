"""What the arbitrator is told: what is known of servers, the rules, and where the robot is."""

from dataclasses import dataclass, field
from typing import FrozenSet, Mapping, Tuple

from experience.known import Experience
from experience.rules import Rule


@dataclass(frozen=True)
class Snapshot:
    """What is known at a time; the default knows nothing.

    Attributes:
        experience: what is known of servers
        rules: what people said of servers, oldest first
        explorable: frames of which another server may be tried than the likeliest
        place: where the robot is; empty when unknown
        robots: by server: which robot it belongs to; those of the only robot are left out
    """

    experience: Experience = field(default_factory=Experience)
    rules: Tuple[Rule, ...] = ()
    explorable: FrozenSet[str] = frozenset()
    place: str = ""
    robots: Mapping[str, str] = field(default_factory=dict)
