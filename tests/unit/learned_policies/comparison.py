"""Runs policies on the simulated servers, and says what they cost."""

import random
import statistics
import time
from collections import Counter
from dataclasses import dataclass, field
from typing import Callable, Dict, FrozenSet, List, Optional, Sequence, Tuple

from arbitrator.plan import Candidate
from arbitrator.policy import LearnedPolicy, Policy, load_policy, order
from experience.known import Experience
from experience.snapshot import Snapshot
from experience.trial import Circumstances, Outcome, Trial, kinds_of
from typed_arguments import FilledFrame

from .chooser import Chooser
from .ideal import Ideal
from .simulation import COMMANDS, DRIFTS, Home, Request

#: Commands after a drift that are counted apart.
RECOVERY = 30
#: Commands before a drift with which those after it are compared.
BEFORE_DRIFT = 100
#: Commands after a drift in which failures are counted together; the first three are the window of recovery.
AFTER_DRIFT = ((0, 10), (10, 20), (20, RECOVERY), (RECOVERY, 60), (60, 150), (150, 300))
#: The first command that counts for the comparison; before, everybody learns.
LEARNED_FROM = 300
#: Frames of the simulation of which another server may be tried than the likeliest.
EXPLORABLE = frozenset(["pointing", "waving", "approaching"])


class Named(Chooser):
    """A policy of the arbitrator that does not learn."""

    def __init__(self, policy: Policy) -> None:
        self._policy = policy

    def choose(self, request: Request, candidates: Sequence[Candidate]) -> Sequence[Candidate]:
        """Ask the policy."""
        return order(candidates, self._policy)


class Oracle(Chooser):
    """Knows how often each server succeeds now: the likeliest candidate first."""

    def __init__(self, home: Home) -> None:
        self._home = home

    def choose(self, request: Request, candidates: Sequence[Candidate]) -> Sequence[Candidate]:
        """Sort by the rates."""
        return sorted(candidates, key=lambda one: -self._rate(request, one))

    def _rate(self, request: Request, candidate: Candidate) -> float:
        rate = 1.0
        for frame in candidate.frames:
            rate *= self._home.rate(request, (frame.name, frame.server))
        return rate


class Counting(Chooser):
    """The share of successes of each server and frame, since ever and everywhere; (1 + successes) / (2 + trials)."""

    def __init__(self) -> None:
        self._successes: Dict[Tuple[str, str], int] = Counter()
        self._trials: Dict[Tuple[str, str], int] = Counter()

    def choose(self, request: Request, candidates: Sequence[Candidate]) -> Sequence[Candidate]:
        """Sort by the shares."""
        return sorted(candidates, key=lambda one: -self._rate(one))

    def _rate(self, candidate: Candidate) -> float:
        rate = 1.0
        for frame in candidate.frames:
            key = frame.name, frame.server
            rate *= (1 + self._successes[key]) / (2 + self._trials[key])
        return rate

    def hear(self, request: Request, frame: FilledFrame, *, succeeded: bool, took_s: float) -> None:
        """Count."""
        self._trials[frame.name, frame.server] += 1
        self._successes[frame.name, frame.server] += succeeded


class Learned(Chooser):
    """The policy ``learned``, with what the experience node would tell it after each command."""

    def __init__(self, policy: Optional[LearnedPolicy] = None) -> None:
        self._policy = policy or LearnedPolicy()
        self._experience = Experience()

    def choose(self, request: Request, candidates: Sequence[Candidate]) -> Sequence[Candidate]:
        """Ask the policy."""
        self._policy.learn(Snapshot(self._experience, (), EXPLORABLE, request.place))
        return order(candidates, self._policy)

    def hear(self, request: Request, frame: FilledFrame, *, succeeded: bool, took_s: float) -> None:
        """Remember the trial."""
        about = Circumstances(kinds_of(frame.arguments), "", request.place)
        outcome = Outcome.SUCCEEDED if succeeded else Outcome.FAILED
        self._experience.hear(Trial("", "", 0.0, frame.name, frame.server, "", about, took_s, outcome))


@dataclass
class Result:
    """What a policy cost with one seed.

    Attributes:
        failures: of each command: goals that failed
        seconds: of each command
        ordering_s: processor time of each ordering
        first: what was tried first: frames with their servers
        broken: by drift: the frames with the servers that broke
    """

    failures: List[int] = field(default_factory=list)
    seconds: List[float] = field(default_factory=list)
    ordering_s: List[float] = field(default_factory=list)
    first: List[Tuple[Tuple[str, str], ...]] = field(default_factory=list)
    broken: Dict[int, FrozenSet[Tuple[str, str]]] = field(default_factory=dict)

    @property
    def steady(self) -> int:
        """Failures over the commands 301 to 1,000 without the windows after each drift."""
        return sum(
            self.failures[number]
            for number in range(LEARNED_FROM, len(self.failures))
            if not any(drift <= number < drift + RECOVERY for drift in DRIFTS)
        )

    def between(self, first: int, end: int) -> int:
        """Failures of the commands of an interval."""
        return sum(self.failures[first:end])


def run(home: Home, chooser: Chooser, *, commands: int = COMMANDS) -> Result:
    """Carry out the commands of a home by a policy: a candidate that fails is followed by the next."""
    result = Result(broken={drift: home.broken(drift) for drift in DRIFTS})
    for request in home.requests[:commands]:
        candidates = home.candidates(request)
        began_s = time.thread_time()
        ordered = chooser.choose(request, candidates)
        result.ordering_s.append(time.thread_time() - began_s)
        result.first.append(tuple((frame.name, frame.server) for frame in ordered[0].frames))
        failures, seconds = 0, 0.0
        tries: Dict[Tuple[str, str], int] = Counter()
        for candidate in ordered:
            is_done = True
            for frame in candidate.frames:
                pair = frame.name, frame.server
                tries[pair] += 1
                succeeded, took_s = home.attempt(request, pair, tries[pair])
                seconds += took_s
                chooser.hear(request, frame, succeeded=succeeded, took_s=took_s)
                if not succeeded:
                    failures, is_done = failures + 1, False
                    break
            if is_done:
                break
        result.failures.append(failures)
        result.seconds.append(seconds)
    return result


CHOOSERS: Dict[str, Callable[[Home, int], Chooser]] = {
    "random": lambda home, seed: Named(load_policy("random", seed=seed)),
    "in_order": lambda home, seed: Named(load_policy("in_order")),
    "fewest_steps": lambda home, seed: Named(load_policy("fewest_steps")),
    "counts": lambda home, seed: Counting(),
    "learned": lambda home, seed: Learned(),
    "ideal": lambda home, seed: Ideal(is_told=False),
    "ideal, told": lambda home, seed: Ideal(is_told=True),
    "oracle": lambda home, seed: Oracle(home),
}


def compare(seeds: Sequence[int], names: Sequence[str] = tuple(CHOOSERS)) -> Dict[str, List[Result]]:
    """Run policies with each seed."""
    return {name: [run(home, CHOOSERS[name](home, seed)) for seed in seeds for home in [Home(seed)]] for name in names}


def interval(values: Sequence[float]) -> Tuple[float, float]:
    """Return the mean of some values, and half of its 95 % interval by 2,000 resamples."""
    chance = random.Random(0)
    means = sorted(statistics.fmean(chance.choices(values, k=len(values))) for _ in range(2000))
    return statistics.fmean(values), (means[1949] - means[50]) / 2.0


def above_oracle(results: Dict[str, List[Result]], name: str) -> Tuple[float, Tuple[float, float]]:
    """Return the steady failures of a policy above the oracle's, as a share, with the 95 % interval of other seeds.

    The means of the seeds are compared, so a seed counts by its failures.
    """
    pairs = [(one.steady, other.steady) for one, other in zip(results[name], results["oracle"])]
    chance = random.Random(0)
    resampled = sorted(_ratio(chance.choices(pairs, k=len(pairs))) for _ in range(2000))
    return _ratio(pairs) - 1.0, (resampled[50] - 1.0, resampled[1949] - 1.0)


def _ratio(pairs: Sequence[Tuple[int, int]]) -> float:
    return sum(one for one, _ in pairs) / sum(other for _, other in pairs)


def extra(results: Dict[str, List[Result]], name: str, first: int, end: int) -> List[float]:
    """Return how many more failures than the oracle a policy has, in 100 commands, by seed.

    Args:
        results: of each policy
        name: of the policy
        first: of the commands that count, after each drift; below 0: before it
        end: the first that does not count
    """
    intervals = [(drift + first, drift + end) for drift in DRIFTS]
    return [
        100.0 * sum(one.between(*each) - other.between(*each) for each in intervals) / (len(DRIFTS) * (end - first))
        for one, other in zip(results[name], results["oracle"])
    ]


def recovery(results: Dict[str, List[Result]], names: Sequence[str]) -> str:
    """Return how many more failures than the oracle policies have before and after a drift, as Markdown."""
    titles = " | ".join(f"`{name}`" for name in names)
    lines = [f"| commands after a drift | {titles} |", "| --- " * len(names) + "| --- |"]
    for first, end in ((-BEFORE_DRIFT, 0), *AFTER_DRIFT):
        title = f"{first + 1} to {end}" if first >= 0 else f"the {-first} before"
        cells = ["{:+.1f} ± {:.1f}".format(*interval(extra(results, name, first, end))) for name in names]
        lines.append(f"| {title} | {' | '.join(cells)} |")
    return "\n".join(lines)


def still_asked(results: Dict[str, List[Result]], name: str, first: int, end: int) -> Tuple[float, float]:
    """Return how often a server that has broken is still asked first, some commands after the drift.

    Args:
        results: of each policy
        name: of the policy
        first: commands after the drift, the first that counts
        end: the first that does not
    Returns:
        the share of the commands of frames whose best server has broken, and half of its 95 % interval
    """
    shares = []
    for one in results[name]:
        asked = [
            any(pair in broken for pair in one.first[number])
            for drift, broken in one.broken.items()
            for number in range(drift + first, drift + end)
            if {pair[0] for pair in one.first[number]} & {frame for frame, _ in broken}
        ]
        shares.append(sum(asked) / len(asked))
    return interval(shares)


def table(results: Dict[str, List[Result]]) -> str:
    """Return what each policy cost, as Markdown."""
    lines = [
        "| policy | failures | 301..1000 without drift windows | against the oracle | windows | time, s |",
        "| --- | --- | --- | --- | --- | --- |",
    ]
    for name, of_seeds in results.items():
        ratios = [one.steady / other.steady for one, other in zip(of_seeds, results["oracle"])]
        windows = [sum(one.between(drift, drift + RECOVERY) for drift in DRIFTS) for one in of_seeds]
        cells = [
            _cell([sum(one.failures) for one in of_seeds]),
            _cell([one.steady for one in of_seeds]),
            "{:+.1%} ± {:.1%}".format(*_less_one(interval(ratios))),
            _cell(windows),
            _cell([sum(one.seconds) for one in of_seeds]),
        ]
        lines.append(f"| `{name}` | {' | '.join(cells)} |")
    return "\n".join(lines)


def _cell(values: Sequence[float]) -> str:
    return "{:.0f} ± {:.0f}".format(*interval(values))


def _less_one(found: Tuple[float, float]) -> Tuple[float, float]:
    return found[0] - 1.0, found[1]
