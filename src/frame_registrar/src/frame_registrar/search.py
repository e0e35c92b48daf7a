"""Searches the graph of frames for the candidates of each clause."""

from dataclasses import dataclass, replace
from itertools import islice, product
from typing import Dict, Iterator, List, Sequence, Tuple, Union

from frame_registrar.filling import Unfillable, fill, spoken_name
from frame_registrar.graph import FrameGraph
from frame_registrar.sequence_finder import Frames, Refusal, SequenceFinder
from semantic_frames.frame import ListPolicy, SemanticFrame
from typed_arguments import TypedArgument

__all__ = ["Candidate", "Reading", "Refusal", "combinations", "reply_outcome", "search"]


@dataclass(frozen=True)
class Reading:
    """One way to understand a clause.

    Attributes:
        frame_name: the frame that the verb evokes
        arguments: of its elements
        coverage: share of the clause's content words that it accounts for, 0 to 1
        preference: 0 for the likeliest reading, then 1; alternatives that were said ("or") are one reading
    """

    frame_name: str
    arguments: Tuple[TypedArgument, ...] = ()
    coverage: float = 1.0
    preference: int = 0


@dataclass(frozen=True)
class Candidate:
    """Frames that carry out a clause, in this order; each names its server.

    Attributes:
        frames: at least one
        coverage: coverage of its reading
        preference: preference of its reading; every candidate of 0 is tried before those of 1
    """

    frames: Frames
    coverage: float
    preference: int = 0


#: When several readings fail, the reply gives the most informative reason: the first of these.
_REASONS = ("LIMIT", "VALUE_NOT_ALLOWED", "MISSING_ELEMENT", "NO_SERVER", "UNKNOWN_FRAME")
#: Limit of sequences that are examined; several paths through the graph may give the same one.
_MOST_EXAMINED = 100_000
_NOTHING_UNDERSTOOD = Refusal("NO_READING", "I understood nothing that I could do.")


def reply_outcome(refusal: Refusal) -> str:
    """Return the outcome that a command ends with in the registrar: the name of a constant of ``Reply``."""
    return "NEEDS_INFORMATION" if refusal.code == "MISSING_ELEMENT" else "REFUSED"


def search(
    graph: FrameGraph, clauses: Sequence[Sequence[Reading]], *, max_candidates: int
) -> Union[Tuple[Tuple[Candidate, ...], ...], Refusal]:
    """Find every way to carry out each clause of a sentence.

    Args:
        graph: frames and servers
        clauses: in the order in which they are carried out; the readings of each are alternatives
        max_candidates: the search for a clause ends at this number
    Returns:
        candidates of each clause, those of the likeliest reading first; a refusal when a clause has none
    """
    finder = SequenceFinder(graph)
    by_clause: List[Tuple[Candidate, ...]] = []
    for readings in clauses:
        found = _search_clause(finder, readings, max_candidates)
        if isinstance(found, Refusal):
            return found
        by_clause.append(found)
    return tuple(by_clause) or _NOTHING_UNDERSTOOD


def combinations(by_clause: Sequence[Sequence[Candidate]], most: int) -> Tuple[Frames, ...]:
    """Return the candidates as 2012 published them: at most ``most`` sequences of frames that carry out all clauses."""
    products = islice(product(*by_clause), most)
    return tuple(tuple(frame for candidate in found for frame in candidate.frames) for found in products)


def _order(reading: Reading) -> Tuple[int, float]:
    return reading.preference, -reading.coverage


def _search_clause(
    finder: SequenceFinder, readings: Sequence[Reading], max_candidates: int
) -> Union[Tuple[Candidate, ...], Refusal]:
    """Find the candidates of one clause, the likeliest reading first, without duplicates."""
    found: Dict[Frames, Candidate] = {}
    refusals: List[Refusal] = []
    for reading in sorted(readings, key=_order):
        frame = finder.graph.frame(reading.frame_name)
        if frame is None:
            name = spoken_name(reading.frame_name)
            refusals.append(
                Refusal("UNKNOWN_FRAME", f'The lexicon names the frame "{name}", but no file describes it.')
            )
            continue
        for task in _tasks(frame, reading):
            try:
                filled = [fill(frame, arguments) for arguments in task]
            except Unfillable as error:
                refusals.append(Refusal(error.code, str(error)))
                continue
            is_found = False
            for frames in islice(finder.find(filled), _MOST_EXAMINED):
                is_found = True
                found.setdefault(frames, Candidate(frames, reading.coverage, reading.preference))
                if len(found) >= max_candidates:
                    return tuple(found.values())
            if not is_found:
                refusals += finder.why_not(filled)
    if found:
        return tuple(found.values())
    if finder.is_truncated:
        return Refusal(
            "TOO_MANY_CANDIDATES", "There are more ways to do that than I can check, and I found none that works."
        )
    if not refusals:
        return _NOTHING_UNDERSTOOD
    # min() keeps the first of equals: the likeliest reading.
    return min(refusals, key=lambda refusal: _REASONS.index(refusal.code))


def _tasks(frame: SemanticFrame, reading: Reading) -> Iterator[List[Dict[str, TypedArgument]]]:
    """Expand lists: "or" gives alternative tasks; "and" gives one frame for each member if the frame repeats."""
    lists = [argument for argument in reading.arguments if len(argument.members) > 1]
    alternative = next((argument for argument in lists if argument.conjunction == "or"), None)
    if alternative is not None:
        for member in alternative.members:
            yield from _tasks(frame, _with(reading, alternative, member))
        return
    repeated = next(iter(lists), None) if frame.on_list is ListPolicy.REPEAT else None
    if repeated is None:
        yield [{argument.name: argument for argument in reading.arguments}]
        return
    parts = [next(_tasks(frame, _with(reading, repeated, member))) for member in repeated.members]
    yield [arguments for part in parts for arguments in part]


def _with(reading: Reading, argument: TypedArgument, member: TypedArgument) -> Reading:
    """Return a reading with one member of a list; it keeps the relation that was said once for all members."""
    relation = member.relation or argument.relation
    alone = replace(
        member, name=argument.name, relation=relation, semantic_type=member.semantic_type or argument.semantic_type
    )
    return replace(reading, arguments=tuple(alone if other is argument else other for other in reading.arguments))
