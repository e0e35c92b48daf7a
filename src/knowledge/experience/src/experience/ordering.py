"""Which candidate first: by the expected success and time, with the reason for a person."""

from dataclasses import dataclass
from typing import Dict, Iterable, List, Sequence, Tuple

from experience.known import Aspect, Expectation, Subject
from experience.snapshot import Snapshot
from experience.trial import Circumstances, kinds_of, referents_of
from typed_arguments import FilledFrame

#: What a failure costs beside its time, seconds: the person waits, and the robot may have to tidy up.
FAILURE_S = 300.0
#: How long a server takes that was never tried, seconds, while nothing of its frame is known.
_UNTRIED_S = 10.0
#: In frames where failing harms nothing, a server is tried that may be better: what is found out serves so many
#: commands.
_SERVES = 2.0
#: Reasons name trials that say something: so many at least.
_FEWEST = 2


@dataclass(frozen=True)
class Judged:
    """A candidate with what is expected of it.

    Attributes:
        position: among the candidates that were given
        servers: of its frames, in order
        worth: larger is better
        rate: how often it succeeds, expected
        took_s: how long it takes, expected
        weakest: the expectation of the frame that is likeliest to fail
        weakest_server: its server
    """

    position: int
    servers: Tuple[str, ...]
    worth: float
    rate: float
    took_s: float
    weakest: Expectation
    weakest_server: str


#: What is expected of a server, how often it succeeds, and how long it takes, seconds.
_Expected = Tuple[Expectation, float, float]


class Judge:
    """Judges the candidates of a clause; each server and frame is looked up once."""

    def __init__(self, known: Snapshot) -> None:
        self._known = known
        # Candidates share their arguments, which are expensive to compare.
        self._found: Dict[Tuple[object, ...], _Expected] = {}
        self._about: Dict[Tuple[int, ...], Tuple[str, str]] = {}

    def judge(self, candidates: Sequence[Sequence[FilledFrame]]) -> List[Judged]:
        """Return what is expected of the candidates of a clause, each of which is a sequence of frames.

        A sequence fails when one of its frames fails, and then takes no more time. If a candidate that fails costs its
        time and `FAILURE_S`, the expected cost of a clause is least when candidates are tried by descending success
        divided by cost: two neighbours in the other order would cost more when they are exchanged.
        """
        found = [[self._expect(frame) for frame in frames] for frames in candidates]
        best = max((_product(rate for _, rate, _ in expected) for expected in found), default=0.0)
        return [
            self._judged(position, frames, expected, best)
            for position, (frames, expected) in enumerate(zip(candidates, found))
        ]

    def _judged(self, position: int, frames: Sequence[FilledFrame], found: Sequence[_Expected], best: float) -> Judged:
        success, took_s = 1.0, 0.0
        for _, rate, frame_s in found:
            took_s += success * frame_s
            success *= rate
        believed = success
        # What is likeliest is tried anyway.
        if len(frames) == 1 and success < best and frames[0].name in self._known.explorable:
            believed = min(1.0, believed + _SERVES * found[0][0].gain(best))
        worth = believed / (took_s + FAILURE_S * (1.0 - believed) + 1e-9)
        at = min(range(len(frames)), key=lambda one: found[one][1])
        servers = tuple(frame.server for frame in frames)
        return Judged(position, servers, worth, success, took_s, found[at][0], frames[at].server)

    def _expect(self, frame: FilledFrame) -> _Expected:
        words = tuple([id(argument) for argument in frame.arguments])
        key = frame.name, frame.server, words
        found = self._found.get(key)
        if found is not None:
            return found
        known = self._known
        kinds, referents = self._about.get(words) or (kinds_of(frame.arguments), referents_of(frame.arguments))
        self._about[words] = kinds, referents
        robot = known.robots.get(frame.server, "")
        expected = known.experience.expect(
            Subject(frame.name, frame.server, robot), Circumstances(kinds, referents, known.place, robot)
        )
        took_s = _UNTRIED_S if expected.took_s is None else expected.took_s
        result = expected, min(1.0, max(0.01, expected.rate)), took_s
        self._found[key] = result
        return result


def _product(values: Iterable[float]) -> float:
    product = 1.0
    for value in values:
        product *= value
    return product


def reason_of(first: Judged, judged: Sequence[Judged], known: Snapshot) -> str:
    """Say why a candidate is asked first; empty when nothing that is known speaks for it.

    Args:
        first: the candidate that is asked first
        judged: all, in the order of the registrar
        known: what it was judged by
    """
    others = [one for one in judged if one.servers != first.servers]
    if not others:
        return ""
    beginning = f"I asked {_names(first)} first"
    bad = min(others, key=lambda one: one.rate)
    told = _failures(bad, known)
    if told and bad.rate < first.rate:
        return f"{beginning}: {told}."
    told = _successes(first, known)
    if told:
        return f"{beginning}: {told}."
    slow = max(others, key=lambda one: one.took_s)
    if first.weakest.took_s is not None and slow.weakest.took_s is not None and slow.took_s > 1.2 * first.took_s:
        return f"{beginning}: it takes about {first.took_s:.0f} s, and {_names(slow)} {slow.took_s:.0f} s."
    if first.weakest.took_s is None and any(one.weakest.took_s is not None for one in others):
        return f"{beginning}: I have not tried it yet."
    return ""


def _names(candidate: Judged) -> str:
    return ", ".join(server.lstrip("/") for server in dict.fromkeys(candidate.servers))


def _failures(candidate: Judged, known: Snapshot) -> str:
    cell = candidate.weakest.cell
    if cell is None or len(cell.recent) < _FEWEST or all(cell.recent):
        return ""
    failed = cell.recent.count(False)
    return f"{candidate.weakest_server.lstrip('/')} failed {_of(failed, len(cell.recent))}{_where(candidate, known)}"


def _successes(candidate: Judged, known: Snapshot) -> str:
    cell = candidate.weakest.cell
    if cell is None or len(cell.recent) < _FEWEST or not any(cell.recent):
        return ""
    return f"it succeeded {_of(cell.recent.count(True), len(cell.recent))}{_where(candidate, known)}"


def _of(count: int, total: int) -> str:
    return f"{count} of {total} times"


def _where(candidate: Judged, known: Snapshot) -> str:
    is_there = candidate.weakest.aspect in (Aspect.PLACE, Aspect.PLACE_AND_KINDS)
    return f" in the {known.place.replace('_', ' ')}" if known.place and is_there else ""
