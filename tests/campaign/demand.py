"""What every demand of the campaign has in common: trials, and figures made from them."""

import math
import random
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from typing import Any, Dict, List, Mapping, Sequence

#: What one trial found: JSON values by name. The key "error" means that the trial itself broke.
Trial = Mapping[str, Any]

FORMS = ("short", "standard", "full")
#: Demands of a lane are tried one after the other, and the lanes beside each other: attacks, the suite of tests, and a
#: long day of a robot that is mostly idle. With more at once, two cores are too slow: a killed node is back late.
LANES = ATTACKS, SUITE, DAY = ("attacks", "suite", "day")


@dataclass(frozen=True)
class Figure:
    """One line of the table.

    Attributes:
        name: what was measured
        found: the figure, in words
        wanted: what was demanded, in words; empty for a figure that is only told
        holds: whether the one satisfies the other
    """

    name: str
    found: str
    wanted: str = ""
    holds: bool = True


class Demand:
    """A set of trials. A subclass sets the attributes and overrides :meth:`trial` and :meth:`figures`.

    Attributes:
        name: R1 to R18
        title: one line
        counts: number of trials in the forms short, standard and full
        lane: one of ``LANES``
        is_without_tests: whether it is tried before the lane of the tests begins, because it measures tenths of a
            second, or how soon a node starts, and tests start browsers and further robots
    """

    name = ""
    title = ""
    counts = (0, 0, 0)
    lane = ATTACKS
    is_without_tests = False

    def count(self, form: str) -> int:
        """Number of trials in a form of the campaign."""
        return self.counts[FORMS.index(form)]

    def running(self) -> "AbstractContextManager[object]":
        """A context in which trials can be made; it starts what they need."""
        return nullcontext()

    def trial(self, number: int, chance: random.Random) -> Dict[str, Any]:
        """Make one trial.

        Args:
            number: counted from zero
            chance: where everything random comes from
        """
        raise NotImplementedError

    def figures(self, trials: Sequence[Trial]) -> List[Figure]:
        """Return the lines of the table for trials that did not break."""
        raise NotImplementedError


def chance_of(seed: int, demand: str, number: int) -> random.Random:
    """Return the random generator of a trial."""
    return random.Random(f"{seed}/{demand}/{number}")


def values(trials: Sequence[Trial], key: str) -> List[float]:
    """Return the numbers that trials found under a key; trials without it are left out."""
    return [float(trial[key]) for trial in trials if trial.get(key) is not None]


def quantile(numbers: Sequence[float], share: float) -> float:
    """Return the smallest number that at least this share does not exceed; not a number for none."""
    ordered = sorted(numbers)
    return ordered[max(0, math.ceil(share * len(ordered)) - 1)] if ordered else math.nan


def none_of(name: str, trials: Sequence[Trial], key: str) -> Figure:
    """A figure that must be zero: the sum of what trials found under a key."""
    total = sum(int(trial.get(key) or 0) for trial in trials)
    return Figure(name, f"{total} in {len(trials)}", "0", total == 0)


def at_most(name: str, trials: Sequence[Trial], key: str, limit_s: float, *, share: float = 1.0) -> Figure:
    """A figure of time that must stay below a limit in this share of the trials that have it."""
    found = values(trials, key)
    if not found:
        return Figure(name, "nothing to measure", f"<= {limit_s:g} s")
    which = "max" if share >= 1.0 else f"p{100 * share:g}"
    at = quantile(found, share)
    text = f"p50 {quantile(found, 0.5):.3f} s, {which} {at:.3f} s, n={len(found)}"
    return Figure(name, text, f"{which} <= {limit_s:g} s", at <= limit_s)


def all_of(name: str, trials: Sequence[Trial], key: str) -> Figure:
    """A figure that must be true in every trial."""
    right = sum(bool(trial.get(key)) for trial in trials)
    return Figure(name, f"{right} of {len(trials)}", "all", right == len(trials))
