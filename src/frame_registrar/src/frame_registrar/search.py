"""Searches the graph of frames for the candidates of each clause."""

from dataclasses import dataclass, replace
from itertools import islice, product
from typing import Dict, Iterator, List, Mapping, Optional, Sequence, Tuple, Union

from frame_registrar.filling import Unfillable, fill, spoken_name
from frame_registrar.graph import FrameGraph
from frame_registrar.sequence_finder import Frames, Refusal, SequenceFinder
from semantic_frames.frame import ListPolicy, SemanticFrame
from typed_arguments import TypedArgument

__all__ = [
    "Candidate",
    "Conditions",
    "Found",
    "Reading",
    "Refusal",
    "candidates_of",
    "combinations",
    "reply_outcome",
    "search",
]


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


@dataclass(frozen=True)
class Conditions:
    """A condition with a list: "Anna and Bob are here", "you see a wall or a door".

    Attributes:
        is_all: whether all of them have to hold, or one
        parts: what is found for each member of the list
    """

    is_all: bool
    parts: Tuple["Found", ...]


#: What is found for a clause: its candidates, or several conditions.
Found = Union[Tuple[Candidate, ...], Conditions]

#: When several readings fail, the reply gives the most informative reason: the first of these.
_REASONS = ("LIMIT", "VALUE_NOT_ALLOWED", "MISSING_ELEMENT", "NO_SERVER", "UNKNOWN_FRAME")
#: Codes of refusals of what was said of an element, not of the deed.
_ABOUT_VALUES = ("LIMIT", "VALUE_NOT_ALLOWED")
#: Limit of sequences that are examined; several paths through the graph may give the same one.
_MOST_EXAMINED = 100_000
_NOTHING_UNDERSTOOD = Refusal("NO_READING", "I understood nothing that I could do.")


def reply_outcome(refusal: Refusal) -> str:
    """Return the outcome that a command ends with in the registrar: the name of a constant of ``Reply``."""
    return "NEEDS_INFORMATION" if refusal.code == "MISSING_ELEMENT" else "REFUSED"


def search(
    graph: FrameGraph,
    clauses: Sequence[Sequence[Reading]],
    *,
    max_candidates: int,
    robot: str = "",
    conditions: Optional[Mapping[int, str]] = None,
) -> Union[Tuple[Found, ...], Refusal]:
    """Find every way to carry out each clause of a sentence, and to watch each of its conditions.

    Args:
        graph: frames and servers
        clauses: in the order in which they are carried out; the readings of each are alternatives
        max_candidates: the search for a clause ends at this number
        robot: who is to do it; empty if there is one robot
        conditions: positions of the clauses that are watched instead of done, with their words
    Returns:
        what is found for each clause, its likeliest reading first; a refusal when a clause has nothing
    """
    finder = SequenceFinder(graph, robot=robot)
    by_clause: List[Found] = []
    for position, readings in enumerate(clauses):
        words = (conditions or {}).get(position)
        found: Union[Found, Refusal]
        if words is None:
            found = _search_clause(finder, readings, max_candidates)
        else:
            found = _search_condition(SequenceFinder(graph, robot=robot, condition=words), readings, max_candidates)
        if isinstance(found, Refusal):
            return found
        by_clause.append(found)
    return tuple(by_clause) or _NOTHING_UNDERSTOOD


def candidates_of(found: Found) -> Tuple[Candidate, ...]:
    """Return all candidates of a clause; those of a condition with a list one member after the other."""
    if isinstance(found, Conditions):
        return tuple(candidate for part in found.parts for candidate in candidates_of(part))
    return found


def combinations(by_clause: Sequence[Found], most: int) -> Tuple[Frames, ...]:
    """Return the candidates as 2012 published them: at most ``most`` sequences of frames that carry out all clauses."""
    products = islice(product(*map(candidates_of, by_clause)), most)
    return tuple(tuple(frame for candidate in found for frame in candidate.frames) for found in products)


def _search_condition(
    finder: SequenceFinder, readings: Sequence[Reading], max_candidates: int
) -> Union[Found, Refusal]:
    """Find who watches a condition: in the likeliest reading that somebody watches, and in no other.

    A clause tries its next reading when it fails, but a condition that nobody can tell any more must not become another
    one.
    """
    refusal = _NOTHING_UNDERSTOOD
    for reading in sorted(readings, key=_order):
        found = _search_members(finder, reading, max_candidates)
        if not isinstance(found, Refusal):
            return found
        refusal = found if refusal is _NOTHING_UNDERSTOOD else _more_informative(refusal, found)
    return refusal


def _search_members(finder: SequenceFinder, reading: Reading, max_candidates: int) -> Union[Found, Refusal]:
    """Find who watches a condition, each member of a list for itself."""
    listed = next((argument for argument in reading.arguments if argument.separate_members), None)
    if listed is not None:
        parts: List[Found] = []
        for member in listed.separate_members:
            part = _search_members(finder, _with(reading, listed, member), max_candidates)
            if isinstance(part, Refusal):
                return part
            parts.append(part)
        return Conditions(listed.conjunction not in ("or", "nor"), tuple(parts))
    found = _search_clause(finder, [reading], max_candidates)
    if isinstance(found, Refusal):
        return found
    # Watching one thing after the other would not be watching.
    single = tuple(candidate for candidate in found if len(candidate.frames) == 1)
    return single or finder.no_server([reading.frame_name])


def _more_informative(one: Refusal, other: Refusal) -> Refusal:
    return min((one, other), key=_informs)


def _informs(refusal: Refusal) -> int:
    return _REASONS.index(refusal.code) if refusal.code in _REASONS else len(_REASONS)


def _order(reading: Reading) -> Tuple[int, float]:
    return reading.preference, -reading.coverage


def _search_clause(
    finder: SequenceFinder, readings: Sequence[Reading], max_candidates: int
) -> Union[Tuple[Candidate, ...], Refusal]:
    """Find the candidates of one clause, the likeliest reading first, without duplicates.

    A reading whose values nobody can do leaves its place only to one that accounts for the same words.
    """
    found: Dict[Frames, Candidate] = {}
    refusals: List[Refusal] = []
    refused: List[Reading] = []
    for reading in sorted(readings, key=_order):
        if any(_loses_words(reading, likelier) for likelier in refused):
            continue
        frame = finder.graph.frame(reading.frame_name)
        if frame is None:
            name = spoken_name(reading.frame_name)
            refusals.append(
                Refusal("UNKNOWN_FRAME", f'The lexicon names the frame "{name}", but no file describes it.')
            )
            continue
        for task in _tasks(frame, reading):
            is_found = False
            reasons: Sequence[Refusal] = ()
            try:
                filled = [fill(frame, arguments) for arguments in task]
            except Unfillable as error:
                reasons = [Refusal(error.code, str(error))]
            else:
                for frames in islice(finder.find(filled), _MOST_EXAMINED):
                    is_found = True
                    found.setdefault(frames, Candidate(frames, reading.coverage, reading.preference))
                    if len(found) >= max_candidates:
                        return tuple(found.values())
                if not is_found:
                    reasons = finder.why_not(filled)
            refusals += reasons
            if any(reason.code in _ABOUT_VALUES for reason in reasons):
                refused.append(reading)
    if found:
        return tuple(found.values())
    if finder.is_truncated:
        return Refusal(
            "TOO_MANY_CANDIDATES", "There are more ways to do that than I can check, and I found none that works."
        )
    if not refusals:
        return _NOTHING_UNDERSTOOD
    # min() keeps the first of equals: the likeliest reading.
    return min(refusals, key=_informs)


def _loses_words(reading: Reading, likelier: Reading) -> bool:
    """Whether no element of a reading has some word that an element of a likelier one has."""
    said = {position for argument in reading.arguments for position in argument.positions}
    heads = {argument.head_position for argument in likelier.arguments if argument.positions}
    return not heads - {0} <= said


def _tasks(frame: SemanticFrame, reading: Reading) -> Iterator[List[Dict[str, TypedArgument]]]:
    """Expand lists: "or" gives alternative tasks; "and" gives one frame for each member if the frame repeats."""
    lists = [argument for argument in reading.arguments if argument.separate_members]
    alternative = next((argument for argument in lists if argument.conjunction == "or"), None)
    if alternative is not None:
        for member in alternative.separate_members:
            yield from _tasks(frame, _with(reading, alternative, member))
        return
    repeated = next(iter(lists), None) if frame.on_list is ListPolicy.REPEAT else None
    if repeated is None:
        yield [{argument.name: argument for argument in reading.arguments}]
        return
    parts = [next(_tasks(frame, _with(reading, repeated, member))) for member in repeated.separate_members]
    yield [arguments for part in parts for arguments in part]


def _with(reading: Reading, argument: TypedArgument, member: TypedArgument) -> Reading:
    """Return a reading with one member of a list in its place."""
    return replace(reading, arguments=tuple(member if other is argument else other for other in reading.arguments))
