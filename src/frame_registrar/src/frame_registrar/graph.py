"""Keeps the graph of semantic frames: their children, and the servers registered for them."""

from typing import Dict, FrozenSet, List, Mapping, Optional, Set, Tuple

import networkx

from checked_files.marked_yaml import NAME_EXPECTED, did_you_mean, is_name
from checked_files.problem import FileRefused, Problem
from semantic_frames.frame import ConstantArgument, ElementMapping, RelatedFrame, SemanticFrame
from semantic_frames.server_profile import AS_IN_2012, Purpose, ServerProfile, profile_problems

#: Registrations come from the wire, and none is ever withdrawn.
MOST_REGISTRATIONS = 5000
#: Frames that a graph holds.
MOST_FRAMES = 20_000


class FrameGraph:
    """Frames by name, their relations, and the action servers that registered for each.

    A server may register for a frame, and a parent may name it, before its file is added.
    """

    def __init__(self) -> None:
        self._frames: Dict[str, SemanticFrame] = {}
        #: Of each frame: the profile of each server, in the order of registration.
        self._servers: Dict[str, Dict[str, ServerProfile]] = {}
        self._dead: Set[str] = set()
        self._graph = networkx.DiGraph()

    @property
    def frames(self) -> Mapping[str, SemanticFrame]:
        """Every frame, by name."""
        return self._frames

    def add(self, frame: SemanticFrame) -> bool:
        """Add a frame; it replaces a frame of the same name.

        Args:
            frame: read from its file
        Returns:
            whether the graph changed; False for a frame that is known already
        Raises:
            FileRefused: the frame would close a cycle, or an element named in a relation does not exist; the graph
                is not changed
        """
        known = self._frames.get(frame.name)
        if known == frame:
            return False
        if known is None and len(self._frames) >= MOST_FRAMES:
            raise FileRefused(
                [Problem("TOO_MANY", frame.path, frame.line, "name", f"{MOST_FRAMES} frames already", "fewer")]
            )
        problems = self._element_problems(frame)
        cycle = self._cycle(frame)
        if cycle:
            problems.append(
                Problem(
                    code="CYCLE",
                    path=frame.path,
                    line=_line_of_child(frame, cycle),
                    key="children",
                    found=" -> ".join(cycle),
                    expected="relations that lead away from the frame, never back",
                )
            )
        if problems:
            raise FileRefused(problems)
        self._frames[frame.name] = frame
        if frame.name in self._graph:
            self._graph.remove_edges_from(list(self._graph.out_edges(frame.name)))
        self._graph.add_node(frame.name)
        self._graph.add_edges_from((frame.name, child.name) for sequence in frame.children for child in sequence)
        return True

    def _cycle(self, frame: SemanticFrame) -> List[str]:
        """Return the names along a cycle that the frame would close; the first one is also the last."""
        for child in (child.name for sequence in frame.children for child in sequence):
            if child == frame.name:
                return [frame.name, frame.name]
            # The graph has no cycle yet, so each new one leads through this frame. The search runs from both ends, and
            # a frame that nobody names yet ends it at once.
            if child in self._graph and frame.name in self._graph:
                try:
                    return [frame.name] + list(networkx.bidirectional_shortest_path(self._graph, child, frame.name))
                except networkx.NetworkXNoPath:
                    pass
        return []

    def remove(self, name: str) -> None:
        """Remove a frame. Registrations and parents that name it are kept, and count when it is added again."""
        self._frames.pop(name, None)
        if name in self._graph:
            self._graph.remove_edges_from(list(self._graph.out_edges(name)))

    def _element_problems(self, frame: SemanticFrame) -> List[Problem]:
        """Check the relations of the frame to known children, and of known parents to the frame."""
        problems = []
        for child in (child for sequence in frame.children for child in sequence):
            if child.name in self._frames and child.name != frame.name:
                problems += _relation_problems(frame, child, self._frames[child.name], frame.path, child.line)
        parents = self._graph.predecessors(frame.name) if frame.name in self._graph else ()
        for parent in (self._frames[name] for name in parents if name in self._frames):
            for child in (child for sequence in parent.children for child in sequence):
                if child.name == frame.name and parent.name != frame.name:
                    problems += _relation_problems(parent, child, frame, frame.path, frame.line)
        return problems

    def register(self, frame_name: str, server: str, profile: ServerProfile = AS_IN_2012) -> Tuple[str, ...]:
        """Register an action server for a frame; a second registration replaces the profile of the first.

        Args:
            frame_name: a frame, also one whose file is not added yet
            server: name of the action server
            profile: what the server states about itself
        Returns:
            why it is refused; empty when it is registered
        """
        if not frame_name.strip() or not server.strip():
            return ("a registration needs the name of a frame and of an action server",)
        for name in (frame_name, server):
            if not is_name(name):
                return (f"expected {NAME_EXPECTED}, found {len(name)} characters: {name[:40]!r}",)
        problems = profile_problems(profile, self._frames.get(frame_name))
        if problems:
            return problems
        is_new = server not in self._servers.get(frame_name, ())
        if is_new and len(self.registrations()) >= MOST_REGISTRATIONS and not self._forget_dead():
            return (f"there are {MOST_REGISTRATIONS} registrations already",)
        self._servers.setdefault(frame_name, {})[server] = profile
        self._dead.discard(server)
        return ()

    def knows(self, frame_name: str, server: str, profile: ServerProfile) -> bool:
        """Whether a server is registered for a frame with this profile, and may be used: to register it again changes
        nothing."""
        return server not in self._dead and self._servers.get(frame_name, {}).get(server) == profile

    def _forget_dead(self) -> bool:
        """Remove the registrations of dead servers to make room; a server that comes back registers again."""
        count = len(self.registrations())
        for frame_name, servers in list(self._servers.items()):
            self._servers[frame_name] = {
                server: profile for server, profile in servers.items() if server not in self._dead
            }
            if not self._servers[frame_name]:
                del self._servers[frame_name]
        self._dead.clear()
        return len(self.registrations()) < count

    def remark(self, frame_name: str, server: str) -> str:
        """Return what is odd about a registration that was accepted; empty for nothing."""
        frame = self._frames.get(frame_name)
        if frame is not None:
            # Its file may have been added or replaced after the registration.
            profile = self._servers.get(frame_name, {}).get(server)
            return "; ".join(profile_problems(profile, frame)) if profile is not None else ""
        hint = did_you_mean(frame_name, tuple(self._frames))
        return f"no file describes the frame '{frame_name}' yet" + (f"; {hint}" if hint else "")

    def registrations(self) -> Tuple[Tuple[str, str], ...]:
        """Every registration: frame name and action server, by frame, in the order in which they were made."""
        return tuple((frame, server) for frame, servers in self._servers.items() for server in servers)

    def set_dead(self, servers: FrozenSet[str]) -> bool:
        """Stop using these servers, and use all others again.

        Returns:
            whether anything changed
        """
        dead = {server for server in servers if any(server in known for known in self._servers.values())}
        is_changed = dead != self._dead
        self._dead = dead
        return is_changed

    def is_alive(self, server: str) -> bool:
        """Whether a server may be used: no check found it dead."""
        return server not in self._dead

    def servers(self, frame_name: str, purpose: Purpose = Purpose.ACTS, robot: str = "") -> Tuple[str, ...]:
        """Return the live action servers of a frame that act, or those that watch, in the order of registration.

        Args:
            frame_name: of a frame
            purpose: what the goals of the servers do
            robot: whose servers; those that belong to no robot are everybody's. Empty for the servers of all
        """
        return tuple(
            server
            for server, profile in self._servers.get(frame_name, {}).items()
            if server not in self._dead and profile.purpose is purpose and (not robot or profile.robot in ("", robot))
        )

    def profile(self, frame_name: str, server: str) -> ServerProfile:
        """Return what a server stated about itself when it registered for a frame.

        Raises:
            KeyError: it is not registered
        """
        return self._servers[frame_name][server]

    def descendants(self, frame_name: str) -> Tuple[str, ...]:
        """Sorted names of the frames below a frame, including those without a file."""
        if frame_name not in self._graph:
            return ()
        return tuple(sorted(networkx.descendants(self._graph, frame_name)))

    def unknown_children(self) -> Tuple[Problem, ...]:
        """Children that no file describes yet: reported by the linter, and no reason to refuse a frame."""
        return tuple(
            Problem(
                code="UNKNOWN_FRAME",
                path=frame.path,
                line=child.line,
                key="children",
                found=f"'{child.name}'",
                expected="the name of a frame",
                hint=did_you_mean(child.name, self._frames),
            )
            for frame in self._frames.values()
            for sequence in frame.children
            for child in sequence
            if child.name not in self._frames
        )

    def frame(self, name: str) -> Optional[SemanticFrame]:
        """Return the frame with a name; None if there is none."""
        return self._frames.get(name)


def _line_of_child(frame: SemanticFrame, cycle: List[str]) -> int:
    children = [child for sequence in frame.children for child in sequence]
    return next((child.line for child in children if child.name in cycle), frame.line)


def _relation_problems(
    parent: SemanticFrame, child: RelatedFrame, target: SemanticFrame, path: str, line: int
) -> List[Problem]:
    names = [element.name for element in target.frame_elements]
    return [
        Problem(
            code="UNKNOWN_ELEMENT",
            path=path,
            line=line,
            key=f"children {child.name} child_name",
            found=f"'{relation.child_name}'",
            expected=f"an element of {target.name}, which {parent.name} names as its child: "
            f"{', '.join(names) or 'it has none'}",
            hint=did_you_mean(relation.child_name, names),
        )
        for relation in child.frame_element_relations
        if isinstance(relation, (ElementMapping, ConstantArgument)) and relation.child_name not in names
    ]
