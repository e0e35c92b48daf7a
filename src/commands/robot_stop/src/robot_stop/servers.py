"""Finds the action servers that a stop cancels."""

from dataclasses import dataclass
from typing import AbstractSet, Dict, FrozenSet, Iterable, Mapping

FRAME_GOAL_TYPE = "roboframenet_msgs/FilledSemanticFrameActionGoal"
#: A server whose goals have another type takes frames under its name and this suffix (rfnserver).
ENTRANCE = "/frame"

Nodes = AbstractSet[str]


@dataclass(frozen=True)
class Server:
    """An action server that a stop cancels.

    Attributes:
        name: resolved name
        takes_frames: whether its goals come from commands; other goals may come from any program
    """

    name: str
    takes_frames: bool

    @property
    def cancel_topic(self) -> str:
        """The topic on which it hears cancels."""
        return f"{self.name}/cancel"

    @property
    def status_topic(self) -> str:
        """The topic on which it publishes the status of its goals."""
        return f"{self.name}/status"


def find_servers(
    topic_types: Mapping[str, str],
    listeners: Mapping[str, Nodes],
    *,
    registered: Iterable[str],
    others: Iterable[str],
    namespace: str = "/",
) -> FrozenSet[Server]:
    """Find the action servers that a stop cancels.

    A ported server counts twice: as NAME/frame, which takes frames, and as NAME, to which ordinary clients send
    their goals.

    Args:
        topic_types: type of each topic that the master knows, including those of nodes that are gone
        listeners: nodes that hear each topic
        registered: names of servers that registered for a frame, whatever the type of their goals
        others: names of further servers to cancel
        namespace: of the robot, with a slash behind it: other servers that take frames may belong to other robots

    Returns:
        those of them that hear cancels now
    """
    of_frames = {
        topic[: -len("/goal")]
        for topic, topic_type in topic_types.items()
        if topic.startswith(namespace) and topic.endswith("/goal") and topic_type == FRAME_GOAL_TYPE
    }
    of_frames.update(name.rstrip("/") for name in registered)
    found: Dict[str, bool] = {name.rstrip("/"): False for name in others}
    for name in of_frames:
        if not name.endswith(ENTRANCE):
            continue
        ported = name[: -len(ENTRANCE)]
        # "arm" and "arm/frame" of two different nodes are unrelated.
        if _listeners_of(f"{ported}/cancel", listeners) & _listeners_of(f"{name}/cancel", listeners):
            found[ported] = False
    found.update((name, True) for name in of_frames)
    servers = (Server(name, takes_frames) for name, takes_frames in found.items() if name)
    return frozenset(server for server in servers if _listeners_of(server.cancel_topic, listeners))


def shown_names(names: Iterable[str]) -> FrozenSet[str]:
    """Names to show to a person: the two names of a ported server become one."""
    known = frozenset(names)
    return frozenset(
        name[: -len(ENTRANCE)] if name.endswith(ENTRANCE) and name[: -len(ENTRANCE)] in known else name
        for name in known
    )


def _listeners_of(topic: str, listeners: Mapping[str, Nodes]) -> Nodes:
    return listeners.get(topic, frozenset())
