"""Finds sequences of frames that carry out a filled frame, by its own servers or by its children."""

from dataclasses import dataclass, replace
from typing import Dict, Iterator, List, Optional, Sequence, Tuple

from frame_registrar.filling import (
    Unfillable,
    child_arguments,
    extra_thematic_arguments,
    fill,
    spoken_name,
    unmet_condition,
)
from frame_registrar.graph import FrameGraph
from frame_registrar.heeding import lost_arguments, sentence_about, unheeded_arguments
from roboframenet_ros.spoken_text import join_with_or
from semantic_frames.frame import RelatedFrame
from semantic_frames.server_profile import Purpose
from typed_arguments import FilledFrame, TypedArgument

Frames = Tuple[FilledFrame, ...]

#: How many filled frames one search expands. Frame files that people write need a handful.
MOST_FRAMES = 20_000
#: How many reasons of each kind are kept for a frame that nothing can carry out.
_MOST_REASONS = 20


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


@dataclass(frozen=True)
class _Expansion:
    """The children of one filled frame, before it is known whether servers can carry them out.

    Attributes:
        sequences: those that can be filled
        losses: for each sequence, whether none of its members gets some words that were said
        refusals: why children that have servers cannot be filled
        missing: children without a file
        unmet: values that children demand, when no child is meant for those that were said
    """

    sequences: Tuple[Frames, ...]
    losses: Tuple[bool, ...]
    refusals: Tuple[Refusal, ...]
    missing: Tuple[str, ...]
    unmet: Tuple[Refusal, ...]


#: Filled frames as a linked list: the first one and the others.
_Chain = Optional[Tuple[FilledFrame, "_Chain"]]


def _chain(frames: Sequence[FilledFrame], rest: _Chain) -> _Chain:
    for frame in reversed(frames):
        rest = (frame, rest)
    return rest


def _reversed_chain(chain: _Chain) -> Frames:
    frames: List[FilledFrame] = []
    while chain is not None:
        first, chain = chain
        frames.append(first)
    return tuple(reversed(frames))


class SequenceFinder:
    """Finds the sequences of frames with servers that carry out filled frames, during one search.

    The options of each filled frame are found once and kept. Only sequences whose members all have options are
    combined, so no combination is tried in vain.

    Attributes:
        graph: frames and servers; it must not change during the search
        is_truncated: whether the graph was too large to be searched completely
    """

    def __init__(self, graph: FrameGraph, *, robot: str = "", condition: Optional[str] = None) -> None:
        """
        Args:
            graph: frames and servers
            robot: whose servers; empty for those of all
            condition: the words of a condition, which servers watch; None for something to do
        """
        self.graph = graph
        self._robot = robot
        self._condition = condition
        self._purpose = Purpose.ACTS if condition is None else Purpose.WATCHES
        self.is_truncated = False
        self._expansions: Dict[FilledFrame, _Expansion] = {}
        self._known: Dict[FilledFrame, _Options] = {}

    def find(self, frames: Sequence[FilledFrame]) -> Iterator[Frames]:
        """Yield all sequences that carry out several filled frames one after the other, lazily."""
        if not all(self._options(frame) for frame in frames):
            return
        # Depth first, without recursion: chains of frames may be longer than the stack of Python.
        partial: List[Tuple[_Chain, _Chain]] = [(None, _chain(frames, None))]
        while partial:
            done, to_do = partial.pop()
            if to_do is None:
                yield _reversed_chain(done)
                continue
            first, rest = to_do
            options = self._options(first)
            for sequence in reversed(options.sequences):
                partial.append((done, _chain(sequence, rest)))
            for server in reversed(options.servers):
                partial.append(((replace(first, server=server), done), rest))

    def why_not(self, frames: Sequence[FilledFrame]) -> List[Refusal]:
        """Return why no server can carry out filled frames for which :meth:`find` yielded nothing."""
        stuck = [self._options(frame) for frame in frames if not self._options(frame)]
        refusals = [refusal for options in stuck for refusal in options.refusals]
        return [*refusals, self.no_server([name for options in stuck for name in options.missing])]

    def no_server(self, frame_names: Sequence[str]) -> Refusal:
        """Say that no server is registered for frames."""
        names = join_with_or(tuple(dict.fromkeys(f'"{name}"' for name in frame_names))[:6])
        if self._condition is not None:
            return Refusal("NO_SERVER", self._cannot_tell(f"no server watches {names}"))
        sentence = f"I understand what you want, but I cannot do it: no server is registered for {names}."
        return Refusal("NO_SERVER", sentence)

    def _unnoticed(self, argument: TypedArgument) -> Refusal:
        """Say that whoever watches a condition does not notice what an argument says."""
        reason = f'no server can tell that for "{argument.words or argument.text}"'
        return Refusal("VALUE_NOT_ALLOWED", self._cannot_tell(reason))

    def _cannot_tell(self, reason: str) -> str:
        what = f'whether "{self._condition}"' if self._condition else "whether that is so"
        return f"I understand what you want, but I cannot tell {what}: {reason}."

    def _options(self, filled: FilledFrame) -> _Options:
        """Return the options of a filled frame; those of its descendants are found first, without recursion."""
        waiting = [filled]
        while waiting:
            frame = waiting[-1]
            if frame in self._known:
                waiting.pop()
                continue
            if frame not in self._expansions:
                if len(self._expansions) >= MOST_FRAMES:
                    self.is_truncated = True
                    self._known[frame] = _Options(servers=self._servers(frame)[0], missing=(frame.name,))
                    continue
                self._expansions[frame] = self._expand(frame)
            expansion = self._expansions[frame]
            unknown = [child for sequence in expansion.sequences for child in sequence if child not in self._known]
            if unknown:
                waiting += unknown
            else:
                self._known[frame] = self._options_of(frame, expansion)
        return self._known[filled]

    def _options_of(self, filled: FilledFrame, expansion: "_Expansion") -> _Options:
        """Choose among the sequences of a frame, when the options of their members are known."""
        servers, unheeding = self._servers(filled)
        refusals, missing = [*unheeding, *expansion.refusals], [filled.name, *expansion.missing]
        sequences: List[Frames] = []
        lossy: List[Frames] = []
        for children, is_lossy in zip(expansion.sequences, expansion.losses):
            stuck = [self._known[child] for child in children if not self._known[child]]
            if not stuck:
                (lossy if is_lossy else sequences).append(children)
            for options in stuck:
                refusals += options.refusals
                missing += options.missing
        if servers or sequences or lossy:
            # Nobody is to lose words while others heed them.
            return _Options(servers=servers, sequences=tuple(sequences or (() if servers else lossy)))
        refusals += expansion.unmet
        # A reply names a handful; each level of the graph must not add its own.
        return _Options(
            refusals=tuple(dict.fromkeys(refusals))[:_MOST_REASONS],
            missing=tuple(dict.fromkeys(missing))[:_MOST_REASONS],
        )

    def _servers(self, filled: FilledFrame) -> Tuple[Tuple[str, ...], List[Refusal]]:
        """Return the servers of a frame that heed everything that was said, or why there are none."""
        servers = self.graph.servers(filled.name, self._purpose, self._robot)
        frame = self.graph.frame(filled.name)
        if frame is None or not servers:
            return servers, []
        profiles = {server: self.graph.profile(filled.name, server) for server in servers}
        unheeded = {server: unheeded_arguments(profile, filled, frame) for server, profile in profiles.items()}
        heeding = tuple(server for server in servers if not unheeded[server])
        lost = dict.fromkeys(arguments[0] for arguments in unheeded.values() if arguments)
        if heeding:
            return heeding, []
        if self._condition is not None:
            return heeding, [self._unnoticed(argument) for argument in lost]
        sentences = [sentence_about(argument, frame, tuple(profiles.values())) for argument in lost]
        return heeding, [Refusal("VALUE_NOT_ALLOWED", sentence) for sentence in sentences]

    def _expand(self, filled: FilledFrame) -> "_Expansion":
        frame = self.graph.frame(filled.name)
        refusals: List[Refusal] = []
        unmet: Dict[str, List[str]] = {}
        missing: List[str] = []
        sequences, losses = [], []
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
            if children is not None:
                sequences.append(children)
                losses.append(frame is not None and bool(lost_arguments(sequence, filled, frame)))
        return _Expansion(
            sequences=tuple(sequences),
            losses=tuple(losses),
            refusals=tuple(refusals),
            missing=tuple(missing),
            unmet=() if is_meant else tuple(_not_among(filled, *one) for one in unmet.items()),
        )

    def _fill_children(
        self, parent: FilledFrame, sequence: Sequence[RelatedFrame], refusals: List[Refusal], missing: List[str]
    ) -> Optional[Frames]:
        """Fill the members of a sequence; None when one cannot be filled, with the reason in refusals or missing."""
        children = []
        extra = {
            argument.name: argument
            for argument in extra_thematic_arguments(self.graph.frame(parent.name), parent.arguments)
        }
        for child in sequence:
            child_frame = self.graph.frame(child.name)
            if child_frame is None:
                missing.append(child.name)
                return None
            try:
                children.append(fill(child_frame, {**extra, **(child_arguments(parent, child) or {})}))
            except Unfillable as error:
                if self._is_offered(sequence):
                    refusals.append(Refusal(error.code, str(error)))
                return None
        return tuple(children)

    def _is_offered(self, sequence: Sequence[RelatedFrame]) -> bool:
        """Whether every member or one of its descendants has a server: other arguments might work."""
        return all(
            any(
                self.graph.servers(name, self._purpose, self._robot)
                for name in (child.name,) + self.graph.descendants(child.name)
            )
            for child in sequence
        )


def _not_among(filled: FilledFrame, element: str, values: Sequence[str]) -> Refusal:
    allowed = join_with_or(dict.fromkeys(values))
    said = filled.text(element)
    if not said:
        return Refusal(
            "MISSING_ELEMENT",
            f"The {spoken_name(element)} is missing. It can be {allowed}.",
        )
    return Refusal("VALUE_NOT_ALLOWED", f'The {spoken_name(element)} cannot be "{said}", only {allowed}.')
