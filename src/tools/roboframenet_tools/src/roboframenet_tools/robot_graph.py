"""What ``rfn doctor --robot`` has seen of a robot, without ROS."""

from dataclasses import dataclass, field
from typing import FrozenSet, Mapping, Optional, Tuple

TWIST = "geometry_msgs/Twist"
#: Nodes of this project that hear velocities to know who drives, and move nothing by them.
_LISTENERS = frozenset({"stop_server", "command_server", "stages", "web_console"})
_NOBODY: FrozenSet[str] = frozenset()


@dataclass(frozen=True)
class Heard:
    """A message that was heard on a topic.

    Attributes:
        age_s: time since its stamp, seconds; None without a stamp
        frame_id: of its header
        child_frame_id: of an odometry message
    """

    age_s: Optional[float] = None
    frame_id: str = ""
    child_frame_id: str = ""


@dataclass(frozen=True)
class Link:
    """A transform from a frame to its child; ``age_s`` is None for a static one."""

    parent: str
    age_s: Optional[float] = None


@dataclass(frozen=True)
class Bound:
    """What a binding is bound to: an action, a service or a topic; ``where`` is its file and line."""

    kind: str
    target: str
    where: str


@dataclass(frozen=True)
class RobotGraph:
    """A graph of ROS as it was seen during some seconds. All names are resolved.

    Attributes:
        master_host: host of the address of the master
        own_host: name or address that nodes of this shell give themselves
        node_hosts: by node the host of its address
        unreachable_hosts: those of them that do not answer
        publishers: nodes that publish each topic
        subscribers: nodes that hear each topic
        types: of the topics
        services: that somebody offers
        heard: the newest message of each topic that was listened to; None for silence
        links: by child frame its parents in tf
        unconnected: by velocity topic, the nodes that listen and are not connected to ``stop_server``
        velocity_topics: where a stop publishes zero velocity
        also_cancel: servers that a stop cancels beside those of frames
        registered: servers that are registered for frames
        bound: targets of bindings
        binding_problems: files of bindings that cannot be read
        places: by name of a place the frame of its pose
        is_simulated_time: whether nodes follow ``/clock``
        holds: why the emergency stop holds; empty when it does not
        senses: names of topics that conditions of condition_watchers are about
        speed_m_per_s: greatest speed of spoken motions; None when nothing moves by words
        speed_limits: by name of the parameter, what the robot's navigation takes for its greatest speed
        namespace: of the pipeline, with a slash behind it
    """

    master_host: str = "localhost"
    own_host: str = "localhost"
    node_hosts: Mapping[str, str] = field(default_factory=dict)
    unreachable_hosts: FrozenSet[str] = frozenset()
    publishers: Mapping[str, FrozenSet[str]] = field(default_factory=dict)
    subscribers: Mapping[str, FrozenSet[str]] = field(default_factory=dict)
    types: Mapping[str, str] = field(default_factory=dict)
    services: FrozenSet[str] = frozenset()
    heard: Mapping[str, Optional[Heard]] = field(default_factory=dict)
    links: Mapping[str, Tuple[Link, ...]] = field(default_factory=dict)
    unconnected: Mapping[str, FrozenSet[str]] = field(default_factory=dict)
    velocity_topics: Tuple[str, ...] = ("/cmd_vel",)
    also_cancel: Tuple[str, ...] = ("/move_base",)
    registered: FrozenSet[str] = frozenset()
    bound: Tuple[Bound, ...] = ()
    binding_problems: Tuple[str, ...] = ()
    places: Mapping[str, str] = field(default_factory=dict)
    is_simulated_time: bool = False
    holds: str = ""
    senses: Tuple[str, ...] = ()
    speed_m_per_s: Optional[float] = None
    speed_limits: Mapping[str, float] = field(default_factory=dict)
    namespace: str = "/"

    def heard_by(self, node: str, type_name: str) -> Tuple[str, ...]:
        """Return the topics of a type to which a node of the pipeline subscribes; it is named without its namespace."""
        return self._topics(self.subscribers, node, type_name)

    def published_by(self, node: str, type_name: str) -> Tuple[str, ...]:
        """Return the topics of a type that a node of the pipeline publishes."""
        return self._topics(self.publishers, node, type_name)

    def _topics(self, ends: Mapping[str, FrozenSet[str]], node: str, type_name: str) -> Tuple[str, ...]:
        wanted = self.namespace + node
        return tuple(sorted(one for one, nodes in ends.items() if wanted in nodes and self.types.get(one) == type_name))

    def publishers_of(self, topic: str) -> FrozenSet[str]:
        """Return the nodes that publish a topic."""
        return self.publishers.get(topic, _NOBODY)

    def bases_on(self, topic: str) -> FrozenSet[str]:
        """Return the nodes that may move by the velocities of a topic."""
        return frozenset(
            node for node in self.subscribers.get(topic, _NOBODY) if node.rsplit("/", 1)[-1] not in _LISTENERS
        )
