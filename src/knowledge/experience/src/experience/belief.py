"""How often something succeeds, as a belief that forgets.

The rate is unknown and may jump at any time: a server breaks, or is mended. Bayes' rule on a few rates is exact for
that: each trial multiplies the belief by its likelihood, and each step of time moves a share of it to what servers are
like that have changed: they work, or they do not. Many trials make it sharp, a few that contradict it overturn it, and
without trials it becomes open again.
"""

from typing import Tuple

#: The rates that are told apart.
RATES = (0.02, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.98)
Belief = Tuple[float, ...]
#: Nothing is known: every rate is as likely.
OPEN: Belief = (1.0 / len(RATES),) * len(RATES)
_WEIGHTS_OF_CHANGED = (20, 5, 1, 1, 1, 1, 1, 1, 1, 10, 20)
#: Of a server that has changed: what breaks nearly always fails, and what is mended nearly always succeeds.
CHANGED: Belief = tuple([weight / sum(_WEIGHTS_OF_CHANGED) for weight in _WEIGHTS_OF_CHANGED])


def aged(belief: Belief, steps: int, *, hazard: float) -> Belief:
    """Return a belief after some steps without a trial.

    Args:
        belief: before
        steps: 0 or more
        hazard: probability that the rate jumps in a step
    """
    if steps <= 0:
        return belief
    kept = (1.0 - hazard) ** steps
    return tuple([kept * share + (1.0 - kept) * changed for share, changed in zip(belief, CHANGED)])


def mean(belief: Belief) -> float:
    """Return the expected rate."""
    return sum([share * rate for share, rate in zip(belief, RATES)])
