"""Realisations of filled frames: servers of their own, or what their descendants can do in their place."""

from dataclasses import dataclass, replace
from typing import Dict, Iterator, List, Optional, Sequence, Tuple

from frame_registrar.filling import (
    FilledFrame,
    Unfillable,
    alternatives,
    child_arguments,
    fill,
    unmet_condition,
    words,
)
from frame_registrar.graph import FrameGraph
from semantic_frames.frame import RelatedFrame

Frames = Tuple[FilledFrame, ...]

#: Different filled frames that one search looks at. Frame files of people need a handful.
MOST_FRAMES = 20_000


@dataclass(frozen=True)
class Refusal:
    """Nothing can do what was said.

    Attributes:
        code: as in ``Reply.code``
        sentence: for a person
    """

    code: str
    sentence: str


@dataclass(frozen=True)
class _Ways:
    """What is known of one filled frame.

    Attributes:
        servers: that registered for it
        sequences: of filled children, every member of which can be realised
        refusals: why children did not count although somebody carries them out; only when there is no way
        missing: frames that a server would have to register for; only when there is no way
    """

    servers: Tuple[str, ...] = ()
    sequences: Tuple[Frames, ...] = ()
    refusals: Tuple[Refusal, ...] = ()
    missing: Tuple[str, ...] = ()

    def __bool__(self) -> bool:
        return bool(self.servers or self.sequences)


class Realiser:
    """Realises filled frames during one search.

    Whether a filled frame can be realised is found out once and remembered, and only sequences whose every member can
    be are combined: so each combination that is tried is one that is found.

    Attributes:
        graph: frames and servers; it must not change during the search
        is_cut: whether the graph was too large to look at all of it
    """

    def __init__(self, graph: FrameGraph) -> None:
        self.graph = graph
        self.is_cut = False
        self._known: Dict[FilledFrame, _Ways] = {}
        self._looked_at = 0

    def realise(self, frames: Sequence[FilledFrame]) -> Iterator[Frames]:
        """Yield all combinations of the ways to carry out each of several filled frames in turn, lazily."""
        if all(self._ways(frame) for frame in frames):
            yield from self._combinations(frames)

    def why_not(self, frames: Sequence[FilledFrame]) -> List[Refusal]:
        """Return why nobody can carry out some filled frames, for which :meth:`realise` yielded nothing."""
        stuck = [self._ways(frame) for frame in frames if not self._ways(frame)]
        refusals = [refusal for ways in stuck for refusal in ways.refusals]
        names = tuple(dict.fromkeys(f'"{name}"' for ways in stuck for name in ways.missing))
        refusals.append(
            Refusal(
                "NO_SERVER",
                "I understand what you want, but nobody here can do it: no server is registered for "
                f"{alternatives(names[:6])}.",
            )
        )
        return refusals

    def _combinations(self, frames: Sequence[FilledFrame]) -> Iterator[Frames]:
        if not frames:
            yield ()
            return
        for first in self._one(frames[0]):
            for rest in self._combinations(frames[1:]):
                yield first + rest

    def _one(self, filled: FilledFrame) -> Iterator[Frames]:
        """Every way to carry out one filled frame: its own servers, then what its children can do."""
        ways = self._ways(filled)
        for server in ways.servers:
            yield (replace(filled, server=server),)
        for sequence in ways.sequences:
            yield from self._combinations(sequence)

    def _ways(self, filled: FilledFrame) -> _Ways:
        if filled not in self._known:
            if self._looked_at >= MOST_FRAMES:
                self.is_cut = True
                return _Ways(servers=self.graph.servers(filled.name), missing=(filled.name,))
            self._looked_at += 1
            self._known[filled] = self._look(filled)
        return self._known[filled]

    def _look(self, filled: FilledFrame) -> _Ways:
        frame = self.graph.frame(filled.name)
        servers = self.graph.servers(filled.name)
        refusals: List[Refusal] = []
        unmet: Dict[str, List[str]] = {}
        missing = [filled.name]
        sequences = []
        is_meant = False
        for sequence in frame.children if frame is not None else ():
            conditions = [
                condition for condition in (unmet_condition(filled, child) for child in sequence) if condition
            ]
            if conditions:
                if self._is_offered(sequence):
                    unmet.setdefault(conditions[0].parent_name, []).extend(conditions[0].child_values)
                continue
            is_meant = True
            children = self._fill_children(filled, sequence, refusals, missing)
            if children is None:
                continue
            stuck = [self._ways(child) for child in children if not self._ways(child)]
            if not stuck:
                sequences.append(children)
            for ways in stuck:
                refusals += ways.refusals
                missing += ways.missing
        if servers or sequences:
            return _Ways(servers=servers, sequences=tuple(sequences))
        if not is_meant:
            refusals += [_not_among(filled, element, values) for element, values in unmet.items()]
        return _Ways(refusals=tuple(dict.fromkeys(refusals)), missing=tuple(dict.fromkeys(missing)))

    def _fill_children(
        self, parent: FilledFrame, sequence: Sequence[RelatedFrame], refusals: List[Refusal], missing: List[str]
    ) -> Optional[Frames]:
        """Fill the members of a sequence; None when one cannot be, and then why."""
        children = []
        for child in sequence:
            child_frame = self.graph.frame(child.name)
            if child_frame is None:
                missing.append(child.name)
                return None
            try:
                children.append(fill(child_frame, child_arguments(parent, child) or {}))
            except Unfillable as error:
                if self._is_offered(sequence):
                    refusals.append(Refusal(error.code, str(error)))
                return None
        return tuple(children)

    def _is_offered(self, sequence: Sequence[RelatedFrame]) -> bool:
        """Whether every member has a server, itself or in a descendant: with other arguments it might be done."""
        return all(
            any(self.graph.servers(name) for name in (child.name,) + self.graph.descendants(child.name))
            for child in sequence
        )


def _not_among(filled: FilledFrame, element: str, values: Sequence[str]) -> Refusal:
    allowed = alternatives(tuple(dict.fromkeys(values)))
    said = filled.argument(element)
    if not said:
        return Refusal("MISSING_ELEMENT", f"The {words(element)} of {words(filled.name)} is missing: it is {allowed}.")
    return Refusal("VALUE_NOT_ALLOWED", f'The {words(element)} cannot be "{said}": it is {allowed}.')
