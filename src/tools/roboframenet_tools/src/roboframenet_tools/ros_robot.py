"""Looks at the graph of a robot for ``rfn doctor --robot``."""

import os
import socket
import time
from dataclasses import replace
from typing import Any, Dict, FrozenSet, Iterable, List, Mapping, Optional, Tuple
from urllib.parse import urlparse

import rosgraph
import rosgraph.network
import roslib.message
import rospy
from roboframenet_msgs.msg import EmergencyStop, FrameServers, Locations
from tf2_msgs.msg import TFMessage

from checked_files.problem import FileRefused
from checked_files.source_files import read_text
from frame_bindings.binding_file import load_bindings
from roboframenet_ros.ros_master import NO_ANSWER, SystemState, TimedMaster, is_running, listeners_of
from roboframenet_tools.robot_checks import ODOMETRY, POSE
from roboframenet_tools.robot_graph import Bound, Heard, Link, RobotGraph

#: How long topics are listened to, and how long the master and each node may take to answer; seconds.
LISTEN_S = 3.0
_TIMEOUT_S = 2.0


def look_at_robot(*, listen_s: float = LISTEN_S) -> RobotGraph:
    """Look at the running graph; it takes some seconds.

    Args:
        listen_s: how long to listen to odometry, poses and tf

    Raises:
        NO_ANSWER: the master does not answer
    """
    namespace = rospy.get_namespace()
    state, types = TimedMaster(timeout_s=_TIMEOUT_S).graph()
    without_me = _without(state, rospy.get_name())
    graph = RobotGraph(
        publishers=without_me.publishers, subscribers=without_me.subscribers, types=types, namespace=namespace
    )
    wanted = {*graph.heard_by("move_action_server", ODOMETRY), *graph.heard_by("location_memorizer", POSE)}
    listener = _Listener(wanted, types)
    time.sleep(listen_s)
    listener.close()
    addresses = _addresses(
        {node for ends in (graph.publishers, graph.subscribers) for one in ends.values() for node in one}
    )
    hosts = {node: urlparse(uri).hostname or "" for node, uri in addresses.items()}
    velocity_topics = _resolved("stop_server/velocity_topics", ["cmd_vel"])
    bound, problems = _bindings(rospy.get_param("frame_bindings/files", []))
    return replace(
        graph,
        master_host=urlparse(rosgraph.get_master_uri()).hostname or "",
        own_host=rosgraph.network.get_host_name(),
        node_hosts=hosts,
        unreachable_hosts=_unreachable(addresses, hosts),
        services=_services(),
        heard={topic: listener.heard.get(topic) for topic in wanted},
        links={child: tuple(parents.values()) for child, parents in listener.links.items()},
        unconnected=_unconnected(addresses.get(f"{namespace}stop_server", ""), velocity_topics, graph, addresses),
        velocity_topics=velocity_topics,
        also_cancel=_resolved("stop_server/also_cancel", ["move_base"]),
        registered=listener.registered,
        bound=bound,
        binding_problems=problems,
        places=listener.places,
        is_simulated_time=bool(rospy.get_param("/use_sim_time", False)),
        holds=listener.holds,
        senses=_senses(hosts, namespace),
        speed_m_per_s=_spoken_speed(hosts, namespace),
        speed_limits=_speed_limits(rospy.get_param("/", {})),
    )


class _Listener:
    """Hears the topics that tell of the robot."""

    def __init__(self, topics: Iterable[str], types: Mapping[str, str]) -> None:
        self.heard: Dict[str, Heard] = {}
        self.links: Dict[str, Dict[str, Link]] = {}
        self.places: Mapping[str, str] = {}
        self.registered: FrozenSet[str] = frozenset()
        self.holds = ""
        self._subscribers = [
            rospy.Subscriber("/tf", TFMessage, self._on_tf, queue_size=100),
            rospy.Subscriber("/tf_static", TFMessage, self._on_static, queue_size=100),
            rospy.Subscriber("locations", Locations, self._on_places, queue_size=1),
            rospy.Subscriber("frame_servers", FrameServers, self._on_servers, queue_size=1),
            rospy.Subscriber("emergency_stop", EmergencyStop, self._on_stop, queue_size=1),
        ]
        for topic in topics:
            message_class = roslib.message.get_message_class(types.get(topic, ""))
            if message_class is not None:
                self._subscribers.append(
                    rospy.Subscriber(topic, message_class, self._on_message, callback_args=topic, queue_size=1)
                )

    def close(self) -> None:
        for subscriber in self._subscribers:
            subscriber.unregister()

    def _on_message(self, message: Any, topic: str) -> None:
        child = getattr(message, "child_frame_id", "").lstrip("/")
        # A pose is said once and kept, so its stamp is as old as the last motion.
        age_s = _age_s(message.header.stamp) if child else None
        self.heard[topic] = Heard(age_s, message.header.frame_id.lstrip("/"), child)

    def _on_tf(self, message: TFMessage) -> None:
        for one in message.transforms:
            self._take(one, _age_s(one.header.stamp))

    def _on_static(self, message: TFMessage) -> None:
        for one in message.transforms:
            self._take(one, None)

    def _take(self, transform: Any, age_s: Optional[float]) -> None:
        parent = transform.header.frame_id.lstrip("/")
        self.links.setdefault(transform.child_frame_id.lstrip("/"), {})[parent] = Link(parent, age_s)

    def _on_places(self, message: Locations) -> None:
        self.places = {name: pose.header.frame_id.lstrip("/") for name, pose in zip(message.names, message.poses)}

    def _on_servers(self, message: FrameServers) -> None:
        self.registered = frozenset(rospy.resolve_name(one.callback_topic) for one in message.callbacks)

    def _on_stop(self, message: EmergencyStop) -> None:
        self.holds = (message.by or message.sentence) if message.is_engaged else ""


def _age_s(stamp: rospy.Time) -> Optional[float]:
    now = rospy.get_rostime()
    return None if stamp.is_zero() or now.is_zero() else (now - stamp).to_sec()


def _without(state: SystemState, me: str) -> SystemState:
    """Leave out one node, and topics that nobody else uses."""

    def others(ends: Mapping[str, FrozenSet[str]]) -> Dict[str, FrozenSet[str]]:
        return {topic: nodes - {me} for topic, nodes in ends.items() if nodes - {me}}

    return SystemState(others(state.publishers), others(state.subscribers))


def _resolved(parameter: str, default: List[str]) -> Tuple[str, ...]:
    return tuple(rospy.resolve_name(str(name)) for name in rospy.get_param(parameter, default))


def _addresses(nodes: Iterable[str]) -> Dict[str, str]:
    master = TimedMaster(timeout_s=_TIMEOUT_S)
    found: Dict[str, str] = {}
    for node in nodes:
        try:
            found[node] = master.uri_of(node)
        except NO_ANSWER:
            # It has ended since.
            continue
    return found


def _unreachable(addresses: Mapping[str, str], hosts: Mapping[str, str]) -> FrozenSet[str]:
    """Return the hosts of which no node answers; a name that nobody resolves is one of them."""
    found = set()
    for host in set(hosts.values()):
        uris = [addresses[node] for node, its in hosts.items() if its == host]
        try:
            socket.getaddrinfo(host, None)
        except OSError:
            found.add(host)
            continue
        if not any(is_running(uri, timeout_s=_TIMEOUT_S) for uri in uris[:3]):
            found.add(host)
    return frozenset(found)


def _unconnected(
    stop_server: str, topics: Iterable[str], graph: RobotGraph, addresses: Mapping[str, str]
) -> Dict[str, FrozenSet[str]]:
    if not stop_server:
        return {}
    try:
        connected = listeners_of(stop_server, timeout_s=_TIMEOUT_S)
    except NO_ANSWER:
        return {}
    return {
        topic: frozenset(node for node in graph.bases_on(topic) & set(addresses) if (topic, node) not in connected)
        for topic in topics
    }


def _services() -> FrozenSet[str]:
    return frozenset(name for name, _ in rosgraph.Master(rospy.get_name()).getSystemState()[2])


def _bindings(files: Any) -> Tuple[Tuple[Bound, ...], Tuple[str, ...]]:
    """Read the files of bindings, where they can be read here."""
    found: List[Bound] = []
    problems: List[str] = []
    for path in [files] if isinstance(files, str) else files:
        if not os.path.exists(path):
            problems.append(f"{path}: there is no such file on this machine")
            continue
        try:
            bindings = load_bindings(read_text(path), path).bindings
        except FileRefused as error:
            problems += [str(problem) for problem in error.problems]
            continue
        except OSError as error:
            problems.append(str(error))
            continue
        found += [Bound(one.kind.value, rospy.resolve_name(one.target), f"{path}:{one.line}") for one in bindings]
    return tuple(found), tuple(problems)


def _senses(hosts: Mapping[str, str], namespace: str) -> Tuple[str, ...]:
    if not {f"{namespace}condition_watchers", f"{namespace}turtlebot_abilities"} & set(hosts):
        return ()
    watched = rospy.get_param("condition_watchers/watch", ["surroundings"])
    files = rospy.get_param("condition_watchers/files", "")
    scan = ("scan",) if "surroundings" in watched else ()
    return scan + (("battery_state",) if "battery.yaml" in str(files) else ())


def _spoken_speed(hosts: Mapping[str, str], namespace: str) -> Optional[float]:
    if not {f"{namespace}move_action_server", f"{namespace}turtlebot_abilities"} & set(hosts):
        return None
    usual = rospy.get_param("move_action_server/linear_speed_m_per_s", 0.3)
    return float(usual) * float(rospy.get_param("move_action_server/quick_share", 1.5))


def _speed_limits(parameters: Any, path: str = "") -> Dict[str, float]:
    """Find what planners of the navigation stack take for the greatest speed."""
    found: Dict[str, float] = {}
    for name, value in parameters.items() if isinstance(parameters, dict) else ():
        if isinstance(value, dict):
            found.update(_speed_limits(value, f"{path}/{name}"))
        elif name in ("max_vel_x", "max_vel_trans") and isinstance(value, (int, float)):
            found[f"{path}/{name}"] = float(value)
    return found
