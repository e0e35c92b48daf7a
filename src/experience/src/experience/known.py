"""What is known of each server for each frame, in the circumstances that matter.

Success may depend on where the robot is, on what the frame is about, on both, on single things, or on nothing of that.
Each of these aspects keeps its own beliefs and predicts each trial before it counts it; the aspects that predicted best
decide. So a server that fails with glasses is known by glasses, and a server that is broken is known everywhere.
"""

import enum
import math
from dataclasses import dataclass, field
from functools import cached_property
from typing import Dict, Iterable, Mapping, Optional, Tuple

from experience.belief import CHANGED, OPEN, Belief, after, aged, mean, mixed, moments
from experience.trial import Circumstances, Trial

#: Probability that a server breaks or is mended between two trials of its frame.
HAZARD = 0.003
#: How much a new cell believes what is known of the server elsewhere; the rest is open.
_INHERITED = 0.85
#: The log weights of the aspects before any trial: the fewer circumstances, the likelier.
_NO_EVIDENCE = (0.0, -1.0, -1.0, -2.0, -2.0)
#: The share of the evidence that is kept with each trial.
_MEMORY = 0.97
_OPEN_MOMENTS, _CHANGED_MOMENTS = moments(OPEN), moments(CHANGED)
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
        belief: how often they succeed
        tick: trials of the frame by any server, when that was known
        recent: whether each of the last ones succeeded, oldest first
    """

    belief: Belief = OPEN
    tick: int = 0
    recent: Tuple[bool, ...] = ()

    @cached_property
    def moments(self) -> Tuple[float, float]:
        """The expected rate and its expected square, when that was known."""
        return moments(self.belief)


@dataclass(frozen=True)
class Record:
    """What is known of a subject.

    Attributes:
        cells: by the aspect and its value
        evidence: log weight of each aspect
        took_s: how long a trial takes, mean
    """

    cells: Mapping[Tuple[int, str], Cell]
    evidence: Tuple[float, ...] = _NO_EVIDENCE
    took_s: float = 0.0


@dataclass(frozen=True)
class Expectation:
    """What is expected of a subject in some circumstances.

    Attributes:
        rate: how often it succeeds
        spread: how uncertain the rate is: its standard deviation
        took_s: how long it takes; None when it was never tried
        aspect: that counts most
        cell: its trials; None when it was never tried
    """

    rate: float = _OPEN_MOMENTS[0]
    spread: float = math.sqrt(_OPEN_MOMENTS[1] - _OPEN_MOMENTS[0] ** 2)
    took_s: Optional[float] = None
    aspect: Aspect = Aspect.NOTHING
    cell: Optional[Cell] = None


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
        record = self.records.get(subject)
        before = record or Record({})
        beliefs = _beliefs(before, trial.circumstances, tick)
        cells, evidence = dict(before.cells), list(before.evidence)
        predicted: Dict[int, float] = {}
        for aspect, (value, old, _) in beliefs.items():
            rate = mean(old)
            predicted[aspect] = math.log(rate if trial.is_success else 1.0 - rate)
            known = cells.get((aspect, value), Cell())
            recent = (*known.recent, trial.is_success)[-RECENT:]
            cells.pop((aspect, value), None)
            cells[aspect, value] = Cell(after(old, succeeded=trial.is_success), tick, recent)
        for aspect, score in predicted.items():
            # An aspect that is unknown this time neither gains nor loses against the first.
            gain = score - predicted[0]
            evidence[aspect] = _NO_EVIDENCE[aspect] + _MEMORY * (evidence[aspect] - _NO_EVIDENCE[aspect]) + gain
        took_s = trial.took_s if record is None else before.took_s + _NEWEST * (trial.took_s - before.took_s)
        for key in list(cells)[: max(0, len(cells) - MOST_CELLS)]:
            del cells[key]
        self.records.pop(subject, None)
        self.records[subject] = Record(cells, tuple(evidence), took_s)
        if len(self.records) > MOST_SUBJECTS:
            del self.records[next(iter(self.records))]

    def expect(self, subject: Subject, circumstances: Circumstances) -> Expectation:
        """Return what is expected of a subject."""
        record = self.records.get(subject)
        if record is None:
            return Expectation()
        # Means of mixtures are mixtures of means, so no belief is made here: the arbitrator asks for each command.
        tick = self.ticks.get(subject.frame, 0)
        inherited = _OPEN_MOMENTS
        total = rate = square = heaviest = 0.0
        best, best_cell = Aspect.NOTHING, None
        for aspect in Aspect:
            value = value_of(aspect, circumstances)
            if value is None:
                continue
            cell = record.cells.get((aspect, value))
            found = inherited
            if cell is not None:
                found = _blended(cell.moments, (1.0 - HAZARD) ** (tick - cell.tick), _CHANGED_MOMENTS)
            if aspect == 0:
                inherited = _blended(found, _INHERITED, _OPEN_MOMENTS)
            weight = math.exp(record.evidence[aspect])
            total, rate, square = total + weight, rate + weight * found[0], square + weight * found[1]
            if cell is not None and weight > heaviest:
                heaviest, best, best_cell = weight, aspect, cell
        rate, square = rate / total, square / total
        return Expectation(rate, math.sqrt(max(0.0, square - rate * rate)), record.took_s, best, best_cell)


def _blended(known: Tuple[float, float], share: float, other: Tuple[float, float]) -> Tuple[float, float]:
    """Return the moments of a belief of which only a share is kept; the rest is another one."""
    rest = 1.0 - share
    return share * known[0] + rest * other[0], share * known[1] + rest * other[1]


def _beliefs(record: Record, circumstances: Circumstances, tick: int) -> Dict[int, Tuple[str, Belief, Optional[Cell]]]:
    """Return for each aspect that is known its value, what is believed now, and its cell."""
    found: Dict[int, Tuple[str, Belief, Optional[Cell]]] = {}
    inherited = OPEN
    for aspect in Aspect:
        value = value_of(aspect, circumstances)
        if value is None:
            continue
        cell = record.cells.get((aspect, value))
        belief = inherited if cell is None else aged(cell.belief, tick - cell.tick, hazard=HAZARD)
        found[aspect] = value, belief, cell
        if aspect == 0:
            inherited = mixed([(_INHERITED, belief), (1.0 - _INHERITED, OPEN)])
    return found


def learned_from(trials: Iterable[Trial]) -> Experience:
    """Return what is known after some trials, oldest first."""
    found = Experience()
    for trial in trials:
        found.hear(trial)
    return found
