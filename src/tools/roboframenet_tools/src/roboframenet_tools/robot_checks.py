"""``rfn doctor --robot``: what a robot needs before the first sentence, checked on what was seen of its graph."""

from typing import Callable, Iterable, List, Tuple

from roboframenet_tools.finding import Finding
from roboframenet_tools.robot_graph import TWIST, Heard, Link, RobotGraph
from robot_stop.servers import find_servers

ODOMETRY = "nav_msgs/Odometry"
POSE = "geometry_msgs/PoseWithCovarianceStamped"
SCAN = "sensor_msgs/LaserScan"
BATTERY = "sensor_msgs/BatteryState"
LOOPBACK = ("localhost", "127.0.0.1", "127.0.1.1", "::1")
#: A stamp that is farther from now than this comes from another clock, or from a source that has stopped.
MOST_AGE_S = 1.0
#: The simulated robots of this project.
SIMULATED = ("turtlebot_sim", "pr2_sim")
MOST_NAMES = 6
PAGE = "docs/real_robot.md"


def robot_findings(graph: RobotGraph, *, moves_nothing: Iterable[str] = ()) -> List[Finding]:
    """Check what a robot needs: each finding with a problem says how to mend it.

    Args:
        graph: what was seen
        moves_nothing: action servers that a stop need not cancel
    """
    findings = [finding for check in CHECKS for finding in check(graph)]
    return findings + _stoppable(graph, frozenset(moves_nothing))


def _names(names: Iterable[str]) -> str:
    known = sorted(names)
    more = f" and {len(known) - MOST_NAMES} more" if len(known) > MOST_NAMES else ""
    return ", ".join(known[:MOST_NAMES]) + more


def _machines(graph: RobotGraph) -> List[Finding]:
    """Nodes must reach each other by the names that they give themselves."""
    findings: List[Finding] = []
    if graph.master_host not in LOOPBACK:
        if graph.own_host in LOOPBACK:
            found = f"the master is on {graph.master_host}, and nodes of this shell call themselves {graph.own_host}"
            mend = "export ROS_IP=ADDRESS, by which the robot reaches this machine, and unset ROS_HOSTNAME"
            findings.append(Finding("network", found, mend))
        alone = [node for node, host in graph.node_hosts.items() if host in LOOPBACK]
        if alone:
            found = f"nodes that other machines cannot reach, as their address is the loopback's: {_names(alone)}"
            findings.append(Finding("network", found, "start them with ROS_IP set, and without ROS_HOSTNAME"))
    for host in sorted(graph.unreachable_hosts):
        nodes = _names(node for node, its in graph.node_hosts.items() if its == host)
        mend = f"add {host} to /etc/hosts here, or start them with ROS_IP; 'rosnode cleanup' forgets dead nodes"
        findings.append(Finding("network", f"nodes on {host} do not answer: {nodes}", mend))
    return findings or [Finding("network", f"{len(graph.node_hosts)} nodes, their machines answer")]


def _time(graph: RobotGraph) -> List[Finding]:
    clocks = graph.publishers_of("/clock")
    if clocks and not graph.is_simulated_time:
        found = f"{_names(clocks)} publishes /clock, and nodes follow the time of their machines"
        return [Finding("time", found, "rosparam set /use_sim_time true, then start the pipeline again")]
    return []


def _simulated(graph: RobotGraph) -> List[Finding]:
    found = [node for node in graph.node_hosts if node.rsplit("/", 1)[-1] in SIMULATED]
    others = {node for topic in graph.velocity_topics for node in graph.bases_on(topic)}.difference(found)
    if found and others:
        said = f"{_names(found)} runs beside {_names(others)}: commands move both, and their odometry is mixed"
        return [Finding("simulator", said, "start robot.launch with sim:=false")]
    return []


def _base(graph: RobotGraph) -> List[Finding]:
    """Somebody must move by the velocities of spoken motions and of a stop."""
    findings: List[Finding] = []
    spoken = graph.published_by("move_action_server", TWIST)
    for topic in sorted({*graph.velocity_topics, *spoken}):
        others = [one for one, kind in graph.types.items() if kind == TWIST and one != topic and graph.bases_on(one)]
        if not graph.bases_on(topic):
            mend = "remap it to the topic of your base" + (f": {_names(others)}" if others else "")
            findings.append(Finding("base", f"nobody listens to the velocities on {topic}", mend))
        elif graph.unconnected.get(topic):
            found = f"{_names(graph.unconnected[topic])} listens to {topic}, and gets nothing from stop_server"
            mend = f"convert {TWIST} to the type that it wants; if that is its type, it cannot reach stop_server"
            findings.append(Finding("base", found, mend))
        else:
            findings.append(Finding("base", f"{_names(graph.bases_on(topic))} moves by {topic}"))
    return findings


def _drivers(graph: RobotGraph) -> List[Finding]:
    """Velocities that a stop does not reach: topics that drive a node, and no multiplexer is before it."""
    stopped = set(graph.velocity_topics)
    behind = {node for topic in stopped for node in graph.bases_on(topic)}
    findings: List[Finding] = []
    for topic in sorted(one for one, kind in graph.types.items() if kind == TWIST):
        drivers, bases = graph.publishers_of(topic), graph.bases_on(topic)
        # An input of a multiplexer that hears the stop too, or what that multiplexer makes of its inputs.
        if topic in stopped or not drivers or bases <= behind or drivers <= behind:
            continue
        found = f"{_names(drivers)} drives {_names(bases)} on {topic}, where a stop publishes nothing"
        findings.append(Finding("stop", found, f"name it in ~velocity_topics of stop_server ({PAGE}#the-stop)"))
    return findings


def _stoppable(graph: RobotGraph, moves_nothing: Iterable[str]) -> List[Finding]:
    """Action servers whose goals a stop cancels, and the others."""
    servers = {
        topic[: -len("/goal")]
        for topic, nodes in graph.subscribers.items()
        if topic.endswith("/goal") and nodes and graph.publishers_of(topic[: -len("/goal")] + "/status")
    }
    covered = {
        server.name
        for server in find_servers(
            graph.types,
            graph.subscribers,
            registered=graph.registered,
            others=graph.also_cancel,
            namespace=graph.namespace,
        )
    }
    # command and its kind are the pipeline's own: a stop ends their goals by the stop itself.
    own = {one for one in servers if graph.types.get(f"{one}/goal", "").startswith("roboframenet_msgs/")}
    left = servers - covered - own - set(moves_nothing)
    if not left:
        return [Finding("stop", f"cancels {len(covered)} action servers")]
    mend = f"name those that move the robot in ~also_cancel of stop_server ({PAGE}#the-stop), others in --moves-nothing"
    return [Finding("stop", f"a stop does not cancel the goals of {_names(left)}", mend)]


def _odometry(graph: RobotGraph) -> List[Finding]:
    findings: List[Finding] = []
    for topic in graph.heard_by("move_action_server", ODOMETRY):
        heard = graph.heard.get(topic)
        if not graph.publishers_of(topic):
            others = [one for one, kind in graph.types.items() if kind == ODOMETRY and graph.publishers_of(one)]
            mend = "remap it to the odometry of your base" + (f": {_names(others)}" if others else "")
            findings.append(Finding("odometry", f"move_action_server waits for {topic}, which nobody publishes", mend))
        elif heard is None:
            found = f"{_names(graph.publishers_of(topic))} publishes {topic}, and no message came"
            findings.append(Finding("odometry", found, f"'rostopic hz {topic}' on the robot; see the network above"))
        else:
            findings.append(_stamped("odometry", topic, heard))
    return findings


def _stamped(subject: str, topic: str, heard: Heard) -> Finding:
    if heard.age_s is None or abs(heard.age_s) <= MOST_AGE_S:
        return Finding(subject, f"{topic}, from {heard.frame_id or 'no frame'} to {heard.child_frame_id or 'no frame'}")
    when = _how_old(heard.age_s)
    mend = "let chrony or ntpd set the clocks of both machines; they must agree to a tenth of a second"
    return Finding(subject, f"{topic}: the stamps are {when}", mend)


def _how_old(age_s: float) -> str:
    return f"{abs(age_s):.1f} s {'old' if age_s > 0 else 'ahead'}"


def _localisation(graph: RobotGraph) -> List[Finding]:
    """Places need a pose in the map."""
    findings: List[Finding] = []
    for topic in graph.heard_by("location_memorizer", POSE):
        heard = graph.heard.get(topic)
        if not graph.publishers_of(topic):
            others = [one for one, kind in graph.types.items() if kind == POSE and graph.publishers_of(one)]
            mend = "remap amcl_pose of location_memorizer to the pose of your localisation"
            mend += f": {_names(others)}" if others else "; without one, the robot cannot remember places"
            findings.append(Finding("localisation", f"nobody publishes {topic}", mend))
        elif heard is None:
            mend = (
                "tell the robot where it is ('2D Pose Estimate' in RViz, or the topic initialpose), then drive a little"
            )
            findings.append(Finding("localisation", f"no pose on {topic} yet", mend))
        else:
            findings.append(Finding("localisation", f"{topic}, in the frame {heard.frame_id}"))
    return findings


def _chain(graph: RobotGraph, child: str) -> Tuple[Tuple[str, Link], ...]:
    """Return the transforms from a frame up to its root."""
    found: List[Tuple[str, Link]] = []
    while graph.links.get(child) and child not in [name for name, _ in found]:
        link = graph.links[child][0]
        found.append((child, link))
        child = link.parent
    return tuple(found)


def _transforms(graph: RobotGraph) -> List[Finding]:
    """tf must lead from the frame of the poses to the base."""
    findings: List[Finding] = []
    for child, links in sorted(graph.links.items()):
        if len(links) > 1:
            found = f"{child} has {len(links)} parents: {', '.join(link.parent for link in links)}"
            findings.append(Finding("tf", found, "let one node publish it: often a simulator or a second localisation"))
    base = next((one.child_frame_id for one in graph.heard.values() if one and one.child_frame_id), "base_link")
    poses = {one.frame_id for one in graph.heard.values() if one and one.frame_id and not one.child_frame_id}
    wanted = sorted(poses | set(graph.places.values())) or (
        ["map"] if graph.heard_by("location_memorizer", POSE) else []
    )
    chain = _chain(graph, base)
    above = [link.parent for _, link in chain]
    for frame in wanted:
        if frame in above or frame == base:
            findings.append(Finding("tf", f"{frame} to {base}"))
            continue
        root = above[-1] if above else base
        mend = f"start the localisation (amcl, slam_toolbox, cartographer), which publishes {frame} to {root}"
        if not above:
            mend = f"start the driver of the base, which publishes odom to {base}, or robot_state_publisher"
        findings.append(Finding("tf", f"no way from {frame} to {base}: tf ends at {root}", mend))
    for child, link in chain:
        if link.age_s is not None and abs(link.age_s) > MOST_AGE_S:
            when = _how_old(link.age_s)
            mend = "see whether its publisher still runs, and whether the clocks of the machines agree"
            findings.append(Finding("tf", f"the transform from {link.parent} to {child} is {when}", mend))
    return findings


def _targets(graph: RobotGraph) -> List[Finding]:
    """What frames are bound to must be there."""
    findings = [Finding("binding", problem, "correct the file") for problem in graph.binding_problems]
    for one in graph.bound:
        if one.kind == "action":
            is_there = bool(graph.publishers_of(f"{one.target}/status"))
        elif one.kind == "service":
            is_there = one.target in graph.services
        else:
            is_there = bool(graph.subscribers.get(one.target))
        if not is_there:
            mend = f"start it, or correct its name in {one.where}"
            findings.append(Finding("binding", f"there is no {one.kind} {one.target}", mend))
    if graph.bound and not findings:
        findings.append(Finding("binding", f"{len(graph.bound)} targets are there"))
    return findings


#: Topics that conditions watch: their type, and what nobody can tell without them.
SENSES = {"scan": (SCAN, "until you see a wall"), "battery_state": (BATTERY, "when the battery is low")}


def _senses(graph: RobotGraph) -> List[Finding]:
    """Conditions watch topics that a robot may lack. They are subscribed to only while somebody watches."""
    findings: List[Finding] = []
    for name in graph.senses:
        kind, said = SENSES[name]
        topic = graph.namespace + name
        others = [one for one, its in graph.types.items() if its == kind and graph.publishers_of(one)]
        if graph.publishers_of(topic):
            continue
        if others:
            findings.append(
                Finding("senses", f"'{said}' needs {name} of condition_watchers remapped: {_names(others)}")
            )
            continue
        mend = f"start the driver of the sensor, or leave {name} out of ~watch and ~files of condition_watchers"
        findings.append(Finding("senses", f"nobody publishes {topic}: '{said}' ends at once", mend))
    return findings


def _places(graph: RobotGraph) -> List[Finding]:
    if not graph.publishers_of(graph.namespace + "locations"):
        return []
    if not graph.places:
        mend = "drive to one and say 'This is the kitchen.', or write a places file"
        return [Finding("places", "the robot knows none", f"{mend} ({PAGE}#places)")]
    return [Finding("places", _names(graph.places))]


def _speed(graph: RobotGraph) -> List[Finding]:
    if graph.speed_m_per_s is None:
        return []
    for name, most in sorted(graph.speed_limits.items()):
        if graph.speed_m_per_s > most + 1e-9:
            found = f"spoken motions reach {graph.speed_m_per_s:g} m/s, and {name} is {most:g} m/s"
            mend = "lower ~linear_speed_m_per_s or ~quick_share of move_action_server"
            return [Finding("limits", found, mend)]
    return [Finding("limits", f"spoken motions reach {graph.speed_m_per_s:g} m/s")]


def _held(graph: RobotGraph) -> List[Finding]:
    if not graph.holds:
        return []
    return [Finding("stop", f"the emergency stop holds: {graph.holds}", "say 'Release the emergency stop.'")]


CHECKS: Tuple[Callable[[RobotGraph], List[Finding]], ...] = (
    _machines,
    _time,
    _simulated,
    _base,
    _drivers,
    _odometry,
    _localisation,
    _transforms,
    _places,
    _targets,
    _senses,
    _speed,
    _held,
)
