"""The node home_sim: a home with persons and robots that act, perceive and are driven."""

import json
import threading
from dataclasses import asdict, dataclass, replace
from typing import Dict, List, Sequence, Tuple

import rospkg
import rospy
from std_msgs.msg import String

from roboframenet_ros.parameters import Parameters, parameter
from roboframenet_ros.ros_node import StartError, read_parameters, run_node
from roboframenet_ros.ros_publishing import publish
from roboframenet_sim.base import Pose
from roboframenet_sim.home_arranging import arranged
from roboframenet_sim.home_company import Company, Member
from roboframenet_sim.home_file import load_home_file
from roboframenet_sim.home_state import PR2, ROBOT, TURTLEBOT, Event, Faults, State
from roboframenet_sim.home_truth import Truth, truth_of
from roboframenet_sim.room import RoomError
from roboframenet_sim.ros_base import BaseSettings
from roboframenet_sim.ros_home_robot import RosHomeRobot
from roboframenet_sim.ros_stepping import Stepper, SteppingSettings
from roboframenet_sim.weather import Weather

ROBOTS = {"pr2": PR2, "turtlebot": TURTLEBOT}
_NAMES = {"pr2": "PR2", "turtlebot": "Turtlebot"}
#: The truth is published so often; seconds of ROS time.
_TRUTH_S = 0.2
#: A second robot stands so far from the first one.
_APART_M = 1.5


@dataclass(frozen=True)
class HomeSettings(Parameters):
    """Private parameters of the home, checked.

    Attributes:
        home_file: path of a home; empty for ``config/home.yaml`` of the package
        robot: pr2 or turtlebot
        guest: a second robot, in the namespace of its name: turtlebot; empty for none
        slip, blocked_door: probabilities of faults
        may_be_arranged: whether a test may start the home anew; with one robot only

    Raises:
        ParameterError: a value out of its range
    """

    home_file: str = parameter("")
    robot: str = parameter("pr2")
    guest: str = parameter("")
    slip: float = parameter(0.0, least=0.0, most=1.0)
    blocked_door: float = parameter(0.0, least=0.0, most=1.0)
    may_be_arranged: bool = parameter(False)


class HomeSim:
    """A home. The names of a second robot are in its namespace: ``turtlebot/cmd_vel``.

    Subscribes:
        ``cmd_vel`` (geometry_msgs/Twist), ``said`` (std_msgs/String): what the robot says;
        ``home/person`` (std_msgs/String): "bob walk kitchen", "anna take newspaper", "bob ring", ...;
        ``home/weather`` (std_msgs/String): "rain" or "dry", until it changes by itself;
        ``home/arrange`` (std_msgs/String): a JSON mapping as in :func:`arranged`; the home starts anew, and the robot
        forgets where things and persons are
    Publishes:
        ``odom``, ``/tf``, ``amcl_pose``; with a PR2 ``joint_states``;
        ``scan`` (sensor_msgs/LaserScan), ``battery_state`` (sensor_msgs/BatteryState);
        ``world_updates`` (WorldUpdate): the map, and what the robot sees; ``home/map`` (WorldUpdate, latched);
        ``home/bell`` (std_msgs/Header): the bell of the door;
        ``home/rain`` (std_msgs/Bool, latched): the rain gauge outside;
        ``home/heard`` (std_msgs/String): what the robot hears; ``home/truth`` (std_msgs/String, latched): all, as JSON,
        and how often the home was arranged
    Actions:
        ``home/act`` (FilledSemanticFrameAction): an action; with a PR2 also those of its arms
    """

    def __init__(self) -> None:
        """
        Raises:
            StartError: the home file cannot be read, there is no such robot, or two of a kind
        """
        settings, base_settings = read_parameters(HomeSettings), read_parameters(BaseSettings)
        rospy.loginfo("%s", settings)
        kinds = [settings.robot, *([settings.guest] if settings.guest else [])]
        for name, kind in zip(("robot", "guest"), kinds):
            if kind not in ROBOTS:
                raise StartError(f"~{name} must be one of {', '.join(sorted(ROBOTS))}, got {kind!r}")
        if len(set(kinds)) < len(kinds) or settings.guest == "pr2":
            raise StartError(f"~guest may be a turtlebot beside a pr2, got {settings.guest!r} beside {kinds[0]!r}")
        if settings.guest and settings.may_be_arranged:
            raise StartError("~may_be_arranged is for a home with one robot")
        path = settings.home_file or rospkg.RosPack().get_path("roboframenet_sim") + "/config/home.yaml"
        try:
            plan, state = load_home_file(path, robot=ROBOTS[settings.robot])
        except (OSError, RoomError) as error:
            raise StartError(str(error)) from error
        self._lock = threading.RLock()
        members = [Member(kinds[0] if settings.guest else ROBOT, _NAMES[kinds[0]], ROBOTS[kinds[0]])]
        if settings.guest:
            pose = state.robot.pose
            start = Pose(pose.x_m + _APART_M, pose.y_m, pose.yaw_rad)
            members.append(Member(settings.guest, _NAMES[settings.guest], ROBOTS[settings.guest], start))
        faults = Faults(settings.slip, settings.blocked_door)
        self._company = Company(plan, state, members, seed=base_settings.seed, faults=faults)
        self._host = self._company.homes[members[0].id]
        self._weather = Weather(seed=base_settings.seed)
        self._is_raining = False
        self._truth = rospy.Publisher("home/truth", String, queue_size=5, latch=True)
        self._last_truth = ""
        #: All on which the truth depends.
        self._last_facts: Tuple[State, bool, int] = (State(), False, -1)
        self._arranged_times = 0
        self._robots: List[RosHomeRobot] = []
        for kind, member in zip(kinds, members):
            space = "" if member is members[0] else f"{kind}/"
            robot = RosHomeRobot(
                self._company, member.id, space, base_settings, has_arms=kind == "pr2", lock=self._lock
            )
            robot.rain(is_raining=False)
            self._robots.append(robot)
        self._begin = state
        self._subscribers = [
            rospy.Subscriber("home/person", String, self._on_person, queue_size=50),
            rospy.Subscriber("home/weather", String, self._on_weather, queue_size=5),
        ]
        if settings.may_be_arranged:
            self._subscribers.append(rospy.Subscriber("home/arrange", String, self._on_arrange, queue_size=5))

    def step(self, duration_s: float, stamp: rospy.Time) -> None:
        """Advance the time."""
        for robot in self._robots:
            robot.begin_goals()
        with self._lock:
            self._company.step(duration_s)
            self._weather.step(duration_s)
            is_raining, plan, state = self._weather.is_raining, self._host.plan, self._host.state
            arranged_times = self._arranged_times
        for robot in self._robots:
            robot.step(duration_s, stamp)
            if is_raining is not self._is_raining:
                robot.rain(is_raining=is_raining)
        self._is_raining = is_raining
        if self._robots[0].is_due("truth", _TRUTH_S, stamp):
            # Most of the time nothing has changed.
            facts = (replace(state, time_s=0.0, robot=replace(state.robot, battery=0.0)), is_raining, arranged_times)
            if facts != self._last_facts:
                self._last_facts = facts
                self._tell_truth(truth_of(plan, state), state.events, is_raining, arranged_times)

    def _tell_truth(self, truth: Truth, events: Sequence[Event], is_raining: bool, arranged_times: int) -> None:
        facts = {**truth, "weather.is_raining": is_raining, "home.arranged": arranged_times}
        told = json.dumps({"truth": facts, "events": [asdict(event) for event in events[-20:]]})
        if told != self._last_truth:
            self._last_truth = told
            publish(self._truth, String(data=told))

    def _on_person(self, message: String) -> None:
        words = (message.data.split() + ["", "", ""])[:3]
        if words[1] == "ring":
            for robot in self._robots:
                robot.ring(words[0])
            return
        with self._lock, self._company.acting(next(iter(self._company.homes))) as home:
            failure = home.tell_person(words[0], words[1], words[2])
        if failure is not None:
            rospy.logwarn("%s: %s", message.data, failure.sentence)

    def _on_weather(self, message: String) -> None:
        if message.data not in ("rain", "dry"):
            rospy.logwarn('home/weather: expected "rain" or "dry", got %r', message.data)
            return
        with self._lock:
            self._weather.change(is_raining=message.data == "rain")

    def _on_arrange(self, message: String) -> None:
        plan, floor = self._host.plan, self._host.floor
        try:
            wishes: Dict[str, str] = json.loads(message.data)
            state = arranged(plan, floor, self._begin, wishes)
        except (ValueError, AttributeError) as error:
            rospy.logerr("home/arrange: %s", error)
            return
        forgotten = [one.id for one in plan.entities.values() if one.kind in ("thing", "person")]
        with self._lock:
            self._host.start_anew(state)
            self._arranged_times += 1
            self._last_truth = ""
            self._robots[0].start_anew(forgotten)


def _start() -> Stepper:
    settings = read_parameters(SteppingSettings)
    rospy.loginfo("%s", settings)
    stepper = Stepper(settings, step=HomeSim().step)
    stepper.start()
    return stepper


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter or the home file is wrong."""
    run_node("home_sim", _start)
