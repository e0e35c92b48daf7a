"""What is known of each server for each frame, in the circumstances that matter.

A server succeeds at some rate, and may be weak where the robot is, with what the frame is about, with both together, or
with a single thing. What is believed of a weakness is kept for each rate, because both explain a failure: "it fails in
the kitchen" or "it fails". A success elsewhere later decides between them, and takes back the blame of the other.
"""

import enum
import itertools
from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from operator import mul
from typing import Dict, Iterable, List, Mapping, Optional, Sequence, Tuple

from experience.belief import CHANGED, OPEN, RATES, Belief, aged
from experience.trial import Circumstances, Trial

#: Probability that a server breaks or is mended between two trials of its frame.
HAZARD = 0.004
#: Where a server is weak, this share of its successes is left.
_LEFT = 0.15
#: How likely a server is to be weak in one value of each aspect, before any trial. Rooms and kinds of things often
#: matter; one room together with one kind, or one single thing, seldom.
_WEAK = (0.0, 0.12, 0.12, 0.01, 0.03)
#: An explanation names a weakness that is likelier than not.
_LIKELY = 0.5
#: Trials that an explanation counts, at most.
RECENT = 20
#: Subjects, and cells of each, that are known; those that were tried last stay.
MOST_SUBJECTS, MOST_CELLS = 200, 24
#: Share of a new time in the mean time.
_NEWEST = 0.25


class Aspect(enum.IntEnum):
    """What success may depend on; the numbers are those of the message ``ServerExperience``."""

    NOTHING = 0
    PLACE = 1
    KINDS = 2
    PLACE_AND_KINDS = 3
    REFERENTS = 4


@dataclass(frozen=True)
class Subject:
    """Of whom something is known: a server, for a frame, with a robot."""

    frame: str
    server: str
    robot: str = ""


@dataclass(frozen=True)
class Cell:
    """The trials in one value of an aspect.

    Attributes:
        belief: of the aspect `NOTHING`: how likely each rate is; of others: how likely the server is weak there, if
            that is its rate
        recent: whether each of the last ones succeeded, oldest first
    """

    belief: Belief = OPEN
    recent: Tuple[bool, ...] = ()

    @cached_property
    def left(self) -> Tuple[float, ...]:
        """Of an aspect other than `NOTHING`: the share of its successes that is left, for each rate."""
        return tuple([1.0 - (1.0 - _LEFT) * weak for weak in self.belief])


#: A cell of an aspect, and the value of the aspect.
Key = Tuple[int, str]


@dataclass(frozen=True)
class Record:
    """What is known of a subject.

    Attributes:
        cells: by the aspect and its value
        tick: trials of the frame by any server, when that was known
        took_s: how long a trial takes, mean
    """

    cells: Mapping[Key, Cell]
    tick: int = 0
    took_s: float = 0.0


@dataclass(frozen=True)
class Expectation:
    """What is expected of a subject in some circumstances.

    Attributes:
        rate: how often it succeeds
        cells: what it follows from, `NOTHING` first
        kept: how likely this still holds: it may have changed
        took_s: how long it takes; None when it was never tried
        aspect: in which it is weak; `NOTHING` when it is weak in none
        cell: its trials in this aspect; None when it was never tried
    """

    rate: float
    cells: Tuple[Cell, ...]
    kept: float = 1.0
    took_s: Optional[float] = None
    aspect: Aspect = Aspect.NOTHING
    cell: Optional[Cell] = None

    def gain(self, other: float) -> float:
        """Return how much more often than another rate it may succeed; where it does not, that counts as nothing."""
        of_changed = Cell(CHANGED), *self.cells[1:]
        return self.kept * _gain(self.cells, other) + (1.0 - self.kept) * _gain(of_changed, other)


def value_of(aspect: Aspect, circumstances: Circumstances) -> Optional[str]:
    """Return the value of an aspect; None when it is unknown."""
    place, kinds = circumstances.place, circumstances.kinds
    known = ("", place, kinds, f"{place} {kinds}" if place and kinds else "", circumstances.referents)
    return known[aspect] if known[aspect] or aspect == 0 else None


@dataclass
class Experience:
    """What was experienced; one thread at a time uses it.

    Attributes:
        records: what is known of each subject; what was tried last is last
        ticks: by frame: its trials by any server
    """

    records: Dict[Subject, Record] = field(default_factory=dict)
    ticks: Dict[str, int] = field(default_factory=dict)

    def hear(self, trial: Trial) -> None:
        """Count a trial."""
        if not trial.counts:
            return
        tick = self.ticks[trial.frame] = self.ticks.get(trial.frame, 0) + 1
        subject = Subject(trial.frame, trial.server, trial.circumstances.robot)
        known = self.records.pop(subject, None)
        keys = _keys(trial.circumstances)
        cells = _later(known.cells, tick - known.tick) if known is not None else {}
        before = [cells.pop(key, _new(key)) for key in keys]
        beliefs = _after([cell.belief for cell in before], succeeded=trial.is_success)
        for key, cell, belief in zip(keys, before, beliefs):
            cells[key] = Cell(belief, (*cell.recent, trial.is_success)[-RECENT:])
        for key in list(cells)[: max(0, len(cells) - MOST_CELLS)]:
            del cells[key]
        took_s = trial.took_s if known is None else known.took_s + _NEWEST * (trial.took_s - known.took_s)
        self.records[subject] = Record(cells, tick, took_s)
        if len(self.records) > MOST_SUBJECTS:
            del self.records[next(iter(self.records))]

    def expect(self, subject: Subject, circumstances: Circumstances) -> Expectation:
        """Return what is expected of a subject."""
        keys = _keys(circumstances)
        record = self.records.get(subject)
        if record is None:
            return Expectation(_rate_of_new(OPEN, keys), tuple([_new(key) for key in keys]))
        cells = [record.cells.get(key) or _new(key) for key in keys]
        rate, kept = _rate(cells), _kept(self.ticks.get(subject.frame, 0) - record.tick)
        if kept < 1.0:
            rate = kept * rate + (1.0 - kept) * _rate_of_new(CHANGED, keys)
        rates = cells[0].belief
        weak = [sum(map(mul, rates, cell.belief)) if cell.recent else 0.0 for cell in cells[1:]]
        most = max(weak, default=0.0)
        at = 1 + weak.index(most) if most > _LIKELY else 0
        return Expectation(rate, tuple(cells), kept, record.took_s, Aspect(keys[at][0]), cells[at])


def _keys(circumstances: Circumstances) -> List[Key]:
    """Return the cells of some circumstances, `NOTHING` first; aspects that are unknown have none."""
    values = ((int(aspect), value_of(aspect, circumstances)) for aspect in Aspect)
    return [(aspect, value) for aspect, value in values if value is not None]


def _new(key: Key) -> Cell:
    return _NEW[key[0]]


_NEW = (Cell(OPEN), *(Cell((weak,) * len(RATES)) for weak in _WEAK[1:]))


def _kept(steps: int) -> float:
    """Return how likely a server has not changed within some trials of its frame."""
    return (1.0 - HAZARD) ** steps if steps > 0 else 1.0


def _later(cells: Mapping[Key, Cell], steps: int) -> Dict[Key, Cell]:
    """Return what is known some trials of the frame later: a server that has changed has no old weakness."""
    rates = cells[Aspect.NOTHING, ""].belief
    now = aged(rates, steps, hazard=HAZARD)
    kept = _kept(steps)
    # How likely the server is still what it was, if that is its rate.
    same = [kept * old / new for old, new in zip(rates, now)]
    found: Dict[Key, Cell] = {}
    for key, cell in cells.items():
        weak = _WEAK[key[0]]
        belief = now if key[0] == Aspect.NOTHING else [weak + one * (old - weak) for one, old in zip(same, cell.belief)]
        found[key] = Cell(tuple(belief), cell.recent)
    return found


def _after(beliefs: Sequence[Belief], *, succeeded: bool) -> List[Belief]:
    """Return beliefs after a trial, by Bayes' rule: of the rates, and of each weakness that may have played a part."""
    rates, *weak = beliefs
    found: List[List[float]] = [[] for _ in beliefs]
    for position, rate in enumerate(RATES):
        whole, of_weak = 0.0, [0.0] * len(weak)
        for combination in _combinations(len(weak)):
            share, left = 1.0, rate
            for is_weak, belief in zip(combination, weak):
                share *= belief[position] if is_weak else 1.0 - belief[position]
                left *= _LEFT if is_weak else 1.0
            share *= left if succeeded else 1.0 - left
            whole += share
            of_weak = [one + share * is_weak for one, is_weak in zip(of_weak, combination)]
        found[0].append(rates[position] * whole)
        for shares, one in zip(found[1:], of_weak):
            shares.append(one / whole)
    total = sum(found[0])
    return [tuple([share / total for share in found[0]]), *(tuple(shares) for shares in found[1:])]


@lru_cache(maxsize=None)
def _combinations(count: int) -> Tuple[Tuple[bool, ...], ...]:
    return tuple(itertools.product((False, True), repeat=count))


def _rate(cells: Sequence[Cell]) -> float:
    """Return the expected rate. The arbitrator asks for it often, so the sums are those of C."""
    values: Iterable[float] = map(mul, RATES, cells[0].belief)
    for cell in cells[1:]:
        values = map(mul, values, cell.left)
    return float(sum(values))


def _rate_of_new(rates: Belief, keys: Sequence[Key]) -> float:
    """Return the expected rate of a server of which no weakness is known."""
    return _rate_without_trials(rates, tuple([aspect for aspect, _ in keys]))


@lru_cache(maxsize=64)
def _rate_without_trials(rates: Belief, aspects: Tuple[int, ...]) -> float:
    return _rate([Cell(rates), *(_NEW[aspect] for aspect in aspects[1:])])


def _gain(cells: Sequence[Cell], other: float) -> float:
    """Return the expected gain over another rate: without any weakness, and by the mean of the others."""
    rates, *weak = [cell.belief for cell in cells]
    found = 0.0
    for position, rate in enumerate(RATES):
        strong = left = 1.0
        for belief in weak:
            strong *= 1.0 - belief[position]
            left *= 1.0 - (1.0 - _LEFT) * belief[position]
        weakened = rate * (left - strong) / (1.0 - strong) if strong < 1.0 else 0.0
        found += rates[position] * (strong * max(0.0, rate - other) + (1.0 - strong) * max(0.0, weakened - other))
    return found


def learned_from(trials: Iterable[Trial]) -> Experience:
    """Return what is known after some trials, oldest first."""
    found = Experience()
    for trial in trials:
        found.hear(trial)
    return found
