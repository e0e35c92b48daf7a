"""Learners that know what no learner can know: the law by which the servers are drawn, and even when they change.

They use Bayes' rule on every server that the law can draw. What they fail above the oracle is what trials cannot show
in time: in 30 commands each of the six frames is asked five times. `learned` is compared with them after a drift.
"""

from typing import Dict, List, Sequence, Tuple

import numpy as np
import numpy.typing as npt

from arbitrator.plan import Candidate
from experience.ordering import FAILURE_S
from typed_arguments import FilledFrame

from .chooser import Chooser
from .simulation import COMMANDS, DRIFTS, FRAMES, KINDS, MOST_BROKEN, PLACES, SERVERS, Request

Pair = Tuple[str, str]
Shares = npt.NDArray[np.float64]

_RATES = np.concatenate([np.linspace(0.05, 0.5, 10), np.linspace(0.5, 0.85, 10), np.linspace(0.85, 0.99, 10)])
_PLACES, _KINDS = (0.6, *[0.4 / len(PLACES)] * len(PLACES)), (0.7, *[0.3 / len(KINDS)] * len(KINDS))
_WEAK = 0.15
_CHANGED = np.concatenate([np.linspace(0.0, MOST_BROKEN, 4), np.linspace(0.9, 0.99, 4)])
#: At a drift, one server of each frame changes.
_CHANGES = len(FRAMES) / (SERVERS + 2)
_UNTRIED_S, _NEWEST = 10.0, 0.25


def _rates(place: str, kind: str) -> Shares:
    """Return how often each server of the law succeeds with a kind of thing at a place."""
    places = np.array([1.0, *(_WEAK if one == place else 1.0 for one in PLACES)])
    kinds = np.array([1.0, *(_WEAK if one == kind else 1.0 for one in KINDS)])
    return np.concatenate([(_RATES[:, None, None] * places[:, None] * kinds).ravel(), _CHANGED])


def _law() -> Tuple[Shares, Shares]:
    """Return how likely each server of the law is: one that was drawn, and one that has changed."""
    drawn = np.ones((len(_RATES), 1, 1)) / len(_RATES) * np.array(_PLACES)[:, None] * np.array(_KINDS)
    none = np.zeros(len(_CHANGED))
    changed = np.concatenate([np.zeros(drawn.size), np.ones(len(_CHANGED)) / len(_CHANGED)])
    return np.concatenate([drawn.ravel(), none]), changed


_DRAWN, _HAS_CHANGED = _law()
_SUCCEEDS = {(place, kind): _rates(place, kind) for place in PLACES for kind in KINDS}


class Ideal(Chooser):
    """Orders by expected success and time, as `learned` does, and learns by the law."""

    def __init__(self, *, is_told: bool) -> None:
        """
        Args:
            is_told: it knows when the drifts are; otherwise only how many there are
        """
        self._is_told = is_told
        self._shares: Dict[Pair, Shares] = {}
        self._took_s: Dict[Pair, float] = {}
        self._now = 0

    def choose(self, request: Request, candidates: Sequence[Candidate]) -> List[Candidate]:
        """Sort by success divided by cost."""
        passed = range(self._now + 1, request.number + 1)
        if self._is_told:
            changes = _CHANGES * any(drift in passed for drift in DRIFTS)
        else:
            changes = _CHANGES * len(passed) * len(DRIFTS) / COMMANDS
        self._now = request.number
        if changes:
            self._shares = {
                pair: (1.0 - changes) * shares + changes * _HAS_CHANGED for pair, shares in self._shares.items()
            }
        return sorted(candidates, key=lambda one: -self._worth(request, one))

    def _worth(self, request: Request, candidate: Candidate) -> float:
        success, took_s = 1.0, 0.0
        for frame in candidate.frames:
            pair = frame.name, frame.server
            took_s += success * self._took_s.get(pair, _UNTRIED_S)
            success *= float(self._shares.get(pair, _DRAWN) @ _SUCCEEDS[request.place, request.kind])
        return success / (took_s + FAILURE_S * (1.0 - success))

    def hear(self, request: Request, frame: FilledFrame, *, succeeded: bool, took_s: float) -> None:
        """Learn by Bayes' rule."""
        pair, rates = (frame.name, frame.server), _SUCCEEDS[request.place, request.kind]
        shares = self._shares.get(pair, _DRAWN) * (rates if succeeded else 1.0 - rates)
        self._shares[pair] = shares / shares.sum()
        known_s = self._took_s.get(pair, took_s)
        self._took_s[pair] = known_s + _NEWEST * (took_s - known_s)
