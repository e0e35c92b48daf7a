"""Which action servers a stop cancels."""

from dataclasses import dataclass
from typing import AbstractSet, Dict, FrozenSet, Iterable, Mapping

FRAME_GOAL_TYPE = "roboframenet_msgs/FilledSemanticFrameActionGoal"
#: A server with a type of its own takes frames under its name and this (rfnserver).
ENTRANCE = "/frame"

Nodes = AbstractSet[str]


@dataclass(frozen=True)
class Server:
    """An action server that a stop cancels.

    Attributes:
        name: resolved
        takes_frames: its goals come from commands; those of the others may come from any program
    """

    name: str
    takes_frames: bool

    @property
    def cancel_topic(self) -> str:
        """Where it hears cancels."""
        return f"{self.name}/cancel"

    @property
    def status_topic(self) -> str:
        """Where it tells what its goals do."""
        return f"{self.name}/status"


def find_servers(
    topic_types: Mapping[str, str], listeners: Mapping[str, Nodes], *, registered: Iterable[str], others: Iterable[str]
) -> FrozenSet[Server]:
    """Find the action servers that a stop cancels.

    A ported server counts twice: as NAME/frame, which takes frames, and as NAME, where its ordinary clients send their
    goals.

    Args:
        topic_types: type of each topic that the master knows; it forgets none, not even of nodes that are gone
        listeners: nodes that hear each topic
        registered: names of servers that registered for a frame, whatever the type of their goals
        others: names of further servers to cancel

    Returns:
        those of them that hear cancels now
    """
    of_frames = {
        topic[: -len("/goal")]
        for topic, topic_type in topic_types.items()
        if topic.endswith("/goal") and topic_type == FRAME_GOAL_TYPE
    }
    of_frames.update(name.rstrip("/") for name in registered)
    found: Dict[str, bool] = {name.rstrip("/"): False for name in others}
    for name in of_frames:
        if not name.endswith(ENTRANCE):
            continue
        ported = name[: -len(ENTRANCE)]
        # "arm" and "arm/frame" of two nodes only happen to be called alike.
        if _listeners_of(f"{ported}/cancel", listeners) & _listeners_of(f"{name}/cancel", listeners):
            found[ported] = False
    found.update((name, True) for name in of_frames)
    servers = (Server(name, takes_frames) for name, takes_frames in found.items() if name)
    return frozenset(server for server in servers if _listeners_of(server.cancel_topic, listeners))


def shown_names(names: Iterable[str]) -> FrozenSet[str]:
    """Names for a person: the two of a ported server are one."""
    known = frozenset(names)
    return frozenset(
        name[: -len(ENTRANCE)] if name.endswith(ENTRANCE) and name[: -len(ENTRANCE)] in known else name
        for name in known
    )


def _listeners_of(topic: str, listeners: Mapping[str, Nodes]) -> Nodes:
    return listeners.get(topic, frozenset())
