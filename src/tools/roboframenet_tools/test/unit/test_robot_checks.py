"""``rfn doctor --robot``: a robot that lacks nothing, and each thing that may be wrong with one."""

from dataclasses import replace
from typing import Any, Dict, List

import pytest

from roboframenet_tools.finding import Finding
from roboframenet_tools.robot_checks import robot_findings
from roboframenet_tools.robot_graph import TWIST, Bound, Heard, Link, RobotGraph

ACTIONLIB = {"goal": "move_base_msgs/MoveBaseActionGoal", "cancel": "actionlib_msgs/GoalID"}


def nodes(*names: str) -> "frozenset[str]":
    return frozenset(names)


GOOD = RobotGraph(
    master_host="robot",
    own_host="10.0.0.7",
    node_hosts={
        "/base": "robot",
        "/amcl": "robot",
        "/move_base": "robot",
        "/stop_server": "10.0.0.7",
        "/move_action_server": "10.0.0.7",
        "/location_memorizer": "10.0.0.7",
    },
    publishers={
        "/cmd_vel": nodes("/move_action_server", "/stop_server", "/move_base"),
        "/odom": nodes("/base"),
        "/amcl_pose": nodes("/amcl"),
        "/scan": nodes("/laser"),
        "/battery_state": nodes("/base"),
        "/locations": nodes("/location_memorizer"),
        "/move_base/status": nodes("/move_base"),
    },
    subscribers={
        "/cmd_vel": nodes("/base", "/stop_server", "/command_server"),
        "/odom": nodes("/move_action_server"),
        "/amcl_pose": nodes("/location_memorizer"),
        "/move_base/goal": nodes("/move_base"),
        "/move_base/cancel": nodes("/move_base"),
    },
    types={
        "/cmd_vel": TWIST,
        "/odom": "nav_msgs/Odometry",
        "/amcl_pose": "geometry_msgs/PoseWithCovarianceStamped",
        "/scan": "sensor_msgs/LaserScan",
        "/battery_state": "sensor_msgs/BatteryState",
        "/move_base/goal": "move_base_msgs/MoveBaseActionGoal",
    },
    heard={"/odom": Heard(0.05, "odom", "base_footprint"), "/amcl_pose": Heard(None, "map")},
    links={
        "odom": (Link("map", 0.1),),
        "base_footprint": (Link("odom", 0.02),),
        "base_link": (Link("base_footprint"),),
    },
    bound=(Bound("action", "/move_base", "bindings.yaml:2"),),
    places={"kitchen": "map"},
    senses=("scan", "battery_state"),
    speed_m_per_s=0.45,
    speed_limits={"/move_base/DWAPlannerROS/max_vel_x": 0.55},
)


def problems(graph: RobotGraph, **options: Any) -> List[Finding]:
    return [finding for finding in robot_findings(graph, **options) if finding.advice]


def changed(part: str, **changes: Any) -> RobotGraph:
    """Return the good robot with other entries in one of its tables; None takes an entry away."""
    table: Dict[str, Any] = {**getattr(GOOD, part), **{f"/{name}": value for name, value in changes.items()}}
    return replace(GOOD, **{part: {name: value for name, value in table.items() if value is not None}})


def test_a_robot_that_lacks_nothing() -> None:
    assert [str(one) for one in problems(GOOD)] == []
    assert {one.subject for one in robot_findings(GOOD)} >= {
        "network",
        "base",
        "odometry",
        "localisation",
        "tf",
        "stop",
    }


ELSEWHERE = replace(
    GOOD,
    publishers={**GOOD.publishers, "/nav_vel": nodes("/move_base")},
    subscribers={**GOOD.subscribers, "/nav_vel": nodes("/wheels")},
    types={**GOOD.types, "/nav_vel": TWIST},
)


@pytest.mark.parametrize(
    "graph,subject,found,mended",
    [
        (replace(GOOD, own_host="127.0.0.1"), "network", "call themselves 127.0.0.1", "ROS_IP"),
        (changed("node_hosts", arm="localhost"), "network", "/arm", "ROS_IP"),
        (replace(GOOD, unreachable_hosts=frozenset({"robot"})), "network", "/amcl, /base, /move_base", "/etc/hosts"),
        (changed("publishers", clock=nodes("/gazebo")), "time", "/gazebo publishes /clock", "use_sim_time true"),
        (changed("node_hosts", turtlebot_sim="robot"), "simulator", "/turtlebot_sim runs beside /base", "sim:=false"),
        (
            changed("subscribers", cmd_vel=nodes("/stop_server", "/command_server"), wheels=nodes("/base")),
            "base",
            "nobody listens to the velocities on /cmd_vel",
            "remap",
        ),
        (replace(GOOD, unconnected={"/cmd_vel": nodes("/base")}), "base", "gets nothing", "convert"),
        (
            replace(changed("subscribers", stop_vel=nodes("/arm")), velocity_topics=("/stop_vel",)),
            "stop",
            "/move_action_server, /move_base, /stop_server drives /base on /cmd_vel",
            "~velocity_topics",
        ),
        (ELSEWHERE, "stop", "/move_base drives /wheels on /nav_vel", "~velocity_topics"),
        (replace(GOOD, also_cancel=()), "stop", "the goals of /move_base", "~also_cancel"),
        (changed("publishers", odom=None), "odometry", "which nobody publishes", "remap"),
        (changed("heard", odom=None), "odometry", "no message came", "rostopic hz"),
        (changed("heard", odom=Heard(9.0, "odom", "base_footprint")), "odometry", "9.0 s old", "chrony"),
        (changed("heard", odom=Heard(-9.0, "odom", "base_footprint")), "odometry", "9.0 s ahead", "chrony"),
        (changed("publishers", amcl_pose=None), "localisation", "nobody publishes /amcl_pose", "remap"),
        (changed("heard", amcl_pose=None), "localisation", "no pose on /amcl_pose", "initialpose"),
        (replace(GOOD, links={"base_footprint": (Link("odom", 0.0),)}), "tf", "no way from map", "amcl"),
        (replace(GOOD, links={}), "tf", "no way from map to base_footprint", "driver of the base"),
        (
            replace(GOOD, links={**GOOD.links, "odom": (Link("map", 0.0), Link("world", 0.0))}),
            "tf",
            "odom has 2 parents: map, world",
            "one node",
        ),
        (replace(GOOD, links={**GOOD.links, "odom": (Link("map", 40.0),)}), "tf", "map to odom is 40.0 s old", "runs"),
        (replace(GOOD, places={}), "places", "knows none", "This is the kitchen"),
        (replace(GOOD, places={"desk": "old_map"}), "tf", "no way from old_map", "old_map"),
        (replace(GOOD, bound=(Bound("action", "/dock", "b.yaml:9"),)), "binding", "no action /dock", "b.yaml:9"),
        (replace(GOOD, bound=(Bound("service", "/led", "b.yaml:9"),)), "binding", "no service /led", "b.yaml:9"),
        (replace(GOOD, bound=(Bound("topic", "/say", "b.yaml:9"),)), "binding", "no topic /say", "b.yaml:9"),
        (replace(GOOD, binding_problems=("b.yaml: no such file",)), "binding", "no such file", "correct"),
        (changed("publishers", scan=None), "senses", "nobody publishes /scan", "~watch"),
        (replace(GOOD, speed_m_per_s=0.9), "limits", "max_vel_x is 0.55 m/s", "~quick_share"),
        (replace(GOOD, holds="the lock topic"), "stop", "emergency stop holds: the lock topic", "Release"),
    ],
)
def test_each_thing_that_may_be_wrong(graph: RobotGraph, subject: str, found: str, mended: str) -> None:
    (only,) = problems(graph)
    assert (only.subject, found in only.found, mended in only.advice) == (subject, True, True), str(only)


def test_topics_that_may_be_meant_are_named() -> None:
    types = {**GOOD.types, "/base/odometry": "nav_msgs/Odometry"}
    publishers = {**GOOD.publishers, "/base/odometry": nodes("/base")}
    (only,) = problems(replace(GOOD, types=types, publishers={**publishers, "/odom": nodes()}))
    assert only.advice.endswith(": /base/odometry")


def test_a_multiplexer_stops_what_is_behind_it() -> None:
    """A stop goes to its input of highest priority; its other inputs and its output need no zero."""
    graph = replace(
        GOOD,
        publishers={**GOOD.publishers, "/nav_vel": nodes("/move_base"), "/wheel_vel": nodes("/mux")},
        subscribers={
            **GOOD.subscribers,
            "/cmd_vel": nodes("/mux"),
            "/nav_vel": nodes("/mux"),
            "/wheel_vel": nodes("/base"),
        },
        types={**GOOD.types, "/nav_vel": TWIST, "/wheel_vel": TWIST},
    )
    assert not problems(graph)


def test_a_server_that_moves_nothing_may_be_left() -> None:
    graph = replace(GOOD, also_cancel=())
    assert not problems(graph, moves_nothing=["/move_base"])


def test_frames_in_a_circle_end_the_search() -> None:
    links = {"odom": (Link("base_footprint", 0.0),), "base_footprint": (Link("odom", 0.0),)}
    assert any("no way from map" in one.found for one in problems(replace(GOOD, links=links)))


def test_a_robot_without_places_needs_no_map() -> None:
    gone = {name: value for name, value in GOOD.subscribers.items() if name != "/amcl_pose"}
    graph = replace(
        GOOD,
        subscribers=gone,
        heard={"/odom": GOOD.heard["/odom"]},
        places={},
        links={"base_footprint": (Link("odom", 0.0),)},
    )
    graph = replace(graph, publishers={name: value for name, value in GOOD.publishers.items() if name != "/locations"})
    assert not problems(graph)
