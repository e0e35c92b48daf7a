"""Searches the graph of frames for everything that is able to do what was said."""

from dataclasses import dataclass, replace
from itertools import islice
from typing import Dict, Iterator, List, Optional, Sequence, Tuple, Union

from semantic_frames.frame import ListPolicy, SemanticFrame

from frame_registrar.filling import FilledFrame, Unfillable, alternatives, child_arguments, fill, words
from frame_registrar.graph import FrameGraph

Frames = Tuple[FilledFrame, ...]


@dataclass(frozen=True)
class Argument:
    """The argument of an element, and the items when it is a list.

    Attributes:
        name: of the element
        text: the argument as it was said
        items: of a list; empty for a single argument
        conjunction: "and" or "or" between the items
    """

    name: str
    text: str
    items: Tuple[str, ...] = ()
    conjunction: str = ""


@dataclass(frozen=True)
class Reading:
    """One way to understand a clause.

    Attributes:
        frame_name: the frame that the verb evokes
        arguments: of its elements
        coverage: share of the clause's content words that it accounts for, 0 to 1
    """

    frame_name: str
    arguments: Tuple[Argument, ...] = ()
    coverage: float = 1.0


@dataclass(frozen=True)
class Candidate:
    """Frames that, carried out in this order, do what was said; each names its server.

    Attributes:
        frames: at least one
        coverage: smallest coverage of the readings that it comes from
    """

    frames: Frames
    coverage: float


@dataclass(frozen=True)
class Refusal:
    """Nothing can do what was said.

    Attributes:
        code: as in ``Reply.code``
        sentence: for a person
    """

    code: str
    sentence: str


#: When several readings fail, the reason that tells the person most comes first.
_REASONS = ("LIMIT", "VALUE_NOT_ALLOWED", "MISSING_ELEMENT", "NO_SERVER", "UNKNOWN_FRAME")


def search(
    graph: FrameGraph, clauses: Sequence[Sequence[Reading]], *, max_candidates: int
) -> Union[Tuple[Candidate, ...], Refusal]:
    """Find every way to carry out the clauses of a sentence, one after the other.

    Args:
        graph: frames and servers
        clauses: in the order in which they are to be done; the readings of each are alternatives
        max_candidates: the search ends when so many are found
    Returns:
        candidates, those of a higher coverage first; a refusal when there is none
    """
    by_clause: List[List[Candidate]] = []
    for readings in clauses:
        found: List[Candidate] = []
        refusals: List[Refusal] = []
        for reading in sorted(readings, key=lambda reading: -reading.coverage):
            outcome = _of_reading(graph, reading, max_candidates - len(found))
            if isinstance(outcome, Refusal):
                refusals.append(outcome)
            else:
                found += outcome
            if len(found) >= max_candidates:
                break
        if not found:
            return (
                min(refusals, key=lambda refusal: _REASONS.index(refusal.code))
                if refusals
                else Refusal("NO_READING", "I understood nothing that I could do.")
            )
        by_clause.append(found)
    candidates = list(islice(_concatenations(by_clause), max_candidates))
    return tuple(sorted(candidates, key=lambda candidate: -candidate.coverage))


def _concatenations(by_clause: Sequence[Sequence[Candidate]]) -> Iterator[Candidate]:
    if not by_clause:
        return
    for first in by_clause[0]:
        if len(by_clause) == 1:
            yield first
            continue
        for rest in _concatenations(by_clause[1:]):
            yield Candidate(frames=first.frames + rest.frames, coverage=min(first.coverage, rest.coverage))


def _of_reading(graph: FrameGraph, reading: Reading, limit: int) -> Union[List[Candidate], Refusal]:
    frame = graph.frame(reading.frame_name)
    if frame is None:
        return Refusal(
            "UNKNOWN_FRAME", f'The lexicon speaks of "{words(reading.frame_name)}", but no file describes that frame.'
        )
    found: List[Candidate] = []
    refusal: Optional[Refusal] = None
    for task in _tasks(frame, reading):
        try:
            filled = [fill(frame, arguments) for arguments in task]
        except Unfillable as error:
            refusal = refusal or Refusal(error.code, str(error))
            continue
        realised = _sequence(graph, filled)
        found += [
            Candidate(frames=frames, coverage=reading.coverage) for frames in islice(realised, limit - len(found))
        ]
        if len(found) >= limit:
            break
    if found:
        return found
    return refusal or _nobody(graph, frame)


def _tasks(frame: SemanticFrame, reading: Reading) -> Iterator[List[Dict[str, str]]]:
    """Take lists apart: "or" gives alternative tasks, "and" one frame for each item where the frame repeats."""
    lists = [argument for argument in reading.arguments if len(argument.items) > 1]
    alternative = next((argument for argument in lists if argument.conjunction == "or"), None)
    if alternative is not None:
        for item in alternative.items:
            yield from _tasks(frame, _with(reading, alternative, item))
        return
    repeated = next(iter(lists), None) if frame.on_list is ListPolicy.REPEAT else None
    if repeated is None:
        yield [{argument.name: argument.text for argument in reading.arguments}]
        return
    parts = [list(_tasks(frame, _with(reading, repeated, item)))[0] for item in repeated.items]
    yield [arguments for part in parts for arguments in part]


def _with(reading: Reading, argument: Argument, item: str) -> Reading:
    return replace(
        reading,
        arguments=tuple(
            Argument(name=other.name, text=item) if other is argument else other for other in reading.arguments
        ),
    )


def _sequence(graph: FrameGraph, frames: Sequence[FilledFrame]) -> Iterator[Frames]:
    """All combinations of the ways to carry out each of several frames, lazily."""
    if not frames:
        yield ()
        return
    for first in _realisations(graph, frames[0]):
        for rest in _sequence(graph, frames[1:]):
            yield first + rest


def _realisations(graph: FrameGraph, filled: FilledFrame) -> Iterator[Frames]:
    """Every way to carry out one filled frame: its own servers, then what its children can do."""
    for server in graph.servers(filled.name):
        yield (replace(filled, server=server),)
    frame = graph.frame(filled.name)
    if frame is None:
        return
    for sequence in frame.children:
        children: List[FilledFrame] = []
        for child in sequence:
            arguments = child_arguments(filled, child)
            child_frame = graph.frame(child.name)
            if arguments is None or child_frame is None:
                break
            try:
                children.append(fill(child_frame, arguments))
            except Unfillable:
                break
        else:
            yield from _sequence(graph, children)


def _nobody(graph: FrameGraph, frame: SemanticFrame) -> Refusal:
    able = (frame.name,) + graph.descendants(frame.name)
    names = tuple(f'"{name}"' for name in able[:6])
    return Refusal(
        "NO_SERVER",
        f"I understand what you want, but nobody here can do it: no server is registered for {alternatives(names)}.",
    )
