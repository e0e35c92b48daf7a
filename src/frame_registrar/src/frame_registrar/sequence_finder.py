"""Finds sequences of frames that carry out a filled frame, by its own servers or by its children."""

from dataclasses import dataclass, replace
from typing import Dict, Iterator, List, Optional, Sequence, Tuple

from frame_registrar.filling import (
    Unfillable,
    child_arguments,
    fill,
    join_with_or,
    spoken_name,
    unmet_condition,
)
from frame_registrar.graph import FrameGraph
from semantic_frames.frame import RelatedFrame
from typed_arguments import FilledFrame

Frames = Tuple[FilledFrame, ...]

#: How many filled frames one search expands. Frame files that people write need a handful.
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
class _Options:
    """The ways to carry out one filled frame.

    Attributes:
        servers: servers that registered for it
        sequences: sequences of filled children that servers can carry out
        refusals: why children that have servers cannot be used; only if there are no options
        missing: frames that need a server; only if there are no options
    """

    servers: Tuple[str, ...] = ()
    sequences: Tuple[Frames, ...] = ()
    refusals: Tuple[Refusal, ...] = ()
    missing: Tuple[str, ...] = ()

    def __bool__(self) -> bool:
        return bool(self.servers or self.sequences)


class SequenceFinder:
    """Finds the sequences of frames with servers that carry out filled frames, during one search.

    The options of each filled frame are found once and kept. Only sequences whose members all have options are
    combined, so no combination is tried in vain.

    Attributes:
        graph: frames and servers; it must not change during the search
        is_truncated: whether the graph was too large to be searched completely
    """

    def __init__(self, graph: FrameGraph) -> None:
        self.graph = graph
        self.is_truncated = False
        self._known: Dict[FilledFrame, _Options] = {}
        self._expanded = 0

    def find(self, frames: Sequence[FilledFrame]) -> Iterator[Frames]:
        """Yield all sequences that carry out several filled frames one after the other, lazily."""
        if all(self._options(frame) for frame in frames):
            yield from self._combinations(frames)

    def why_not(self, frames: Sequence[FilledFrame]) -> List[Refusal]:
        """Return why no server can carry out filled frames for which :meth:`find` yielded nothing."""
        stuck = [self._options(frame) for frame in frames if not self._options(frame)]
        refusals = [refusal for options in stuck for refusal in options.refusals]
        names = tuple(dict.fromkeys(f'"{name}"' for options in stuck for name in options.missing))
        refusals.append(
            Refusal(
                "NO_SERVER",
                "I understand what you want, but I cannot do it: no server is registered for "
                f"{join_with_or(names[:6])}.",
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
        """Every sequence that carries out one filled frame: its own servers first, then its children."""
        options = self._options(filled)
        for server in options.servers:
            yield (replace(filled, server=server),)
        for sequence in options.sequences:
            yield from self._combinations(sequence)

    def _options(self, filled: FilledFrame) -> _Options:
        if filled not in self._known:
            if self._expanded >= MOST_FRAMES:
                self.is_truncated = True
                return _Options(servers=self.graph.servers(filled.name), missing=(filled.name,))
            self._expanded += 1
            self._known[filled] = self._expand(filled)
        return self._known[filled]

    def _expand(self, filled: FilledFrame) -> _Options:
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
            stuck = [self._options(child) for child in children if not self._options(child)]
            if not stuck:
                sequences.append(children)
            for options in stuck:
                refusals += options.refusals
                missing += options.missing
        if servers or sequences:
            return _Options(servers=servers, sequences=tuple(sequences))
        if not is_meant:
            refusals += [_not_among(filled, element, values) for element, values in unmet.items()]
        return _Options(refusals=tuple(dict.fromkeys(refusals)), missing=tuple(dict.fromkeys(missing)))

    def _fill_children(
        self, parent: FilledFrame, sequence: Sequence[RelatedFrame], refusals: List[Refusal], missing: List[str]
    ) -> Optional[Frames]:
        """Fill the members of a sequence; None when one cannot be filled, with the reason in refusals or missing."""
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
        """Whether every member or one of its descendants has a server: other arguments might work."""
        return all(
            any(self.graph.servers(name) for name in (child.name,) + self.graph.descendants(child.name))
            for child in sequence
        )


def _not_among(filled: FilledFrame, element: str, values: Sequence[str]) -> Refusal:
    allowed = join_with_or(tuple(dict.fromkeys(values)))
    said = filled.text(element)
    if not said:
        return Refusal(
            "MISSING_ELEMENT",
            f"The {spoken_name(element)} of {spoken_name(filled.name)} is missing. It can be {allowed}.",
        )
    return Refusal("VALUE_NOT_ALLOWED", f'The {spoken_name(element)} cannot be "{said}", only {allowed}.')
