"""The node home_sim: a home with persons and a robot that acts, perceives and is driven."""

import collections
import json
import threading
from dataclasses import asdict, dataclass
from typing import Any, Deque, Dict, List, Optional, Tuple

import actionlib
import rospkg
import rospy
from geometry_msgs.msg import PoseWithCovarianceStamped
from roboframenet_msgs.msg import FilledSemanticFrameAction, FilledSemanticFrameResult, WorldUpdate
from std_msgs.msg import Header, String

from roboframenet_ros.parameters import Parameters, parameter
from roboframenet_ros.ros_node import StartError, read_parameters, run_node
from roboframenet_ros.ros_publishing import publish
from roboframenet_sim.base import Velocity
from roboframenet_sim.home_actions import Action, Failure
from roboframenet_sim.home_arranging import arranged
from roboframenet_sim.home_engine import Home, Outcome
from roboframenet_sim.home_file import load_home_file
from roboframenet_sim.home_floor import PERSON_RADIUS_M
from roboframenet_sim.home_state import PR2, ROBOT, TURTLEBOT, Faults
from roboframenet_sim.home_truth import truth_of
from roboframenet_sim.point_cloud import Cylinder
from roboframenet_sim.room import RoomError
from roboframenet_sim.ros_base import BaseSettings, RosBase, quaternion_of_yaw
from roboframenet_sim.ros_pr2 import RosArms
from roboframenet_sim.ros_sensors import RosBattery, RosLaser
from roboframenet_sim.ros_stepping import Stepper, SteppingSettings
from roboframenet_sim.ros_world_objects import map_objects, seen_objects

ROBOTS = {"pr2": PR2, "turtlebot": TURTLEBOT}
#: The robot perceives, and the truth is published, so often; seconds of ROS time.
_PERCEPTION_S = 0.5
_TRUTH_S = 0.2
#: The pose is published again when the robot has moved so far.
_POSE_STEP_M = 0.05


@dataclass(frozen=True)
class HomeSettings(Parameters):
    """Private parameters of the home, checked.

    Attributes:
        home_file: path of a home; empty for ``config/home.yaml`` of the package
        robot: pr2 or turtlebot
        slip, blocked_door: probabilities of faults
        may_be_arranged: whether a test may start the home anew

    Raises:
        ParameterError: a value out of its range
    """

    home_file: str = parameter("")
    robot: str = parameter("pr2")
    slip: float = parameter(0.0, least=0.0, most=1.0)
    blocked_door: float = parameter(0.0, least=0.0, most=1.0)
    may_be_arranged: bool = parameter(False)


class _Base:
    """The base of the home's robot, as :class:`RosBase` drives it."""

    def __init__(self, home: Home, lock: Any) -> None:
        self._home = home
        self._lock = lock
        self.pose = home.base.pose
        self.velocity = home.base.velocity

    def command(self, velocity: Velocity) -> bool:
        """Take a velocity command."""
        with self._lock:
            self._home.drive(velocity)
        return velocity.is_finite()

    def step(self, duration_s: float) -> None:
        """Advance the home."""
        with self._lock:
            self._home.step(duration_s)
            self.pose, self.velocity = self._home.base.pose, self._home.base.velocity


class HomeSim:
    """A home.

    Subscribes:
        ``cmd_vel`` (geometry_msgs/Twist), ``said`` (std_msgs/String): what the robot says;
        ``home/person`` (std_msgs/String): "bob walk kitchen", "anna take newspaper", "bob ring", ...;
        ``home/arrange`` (std_msgs/String): a JSON mapping as in :func:`arranged`; the home starts anew, and the robot
        forgets where things and persons are
    Publishes:
        ``odom``, ``/tf``, ``amcl_pose``; with a PR2 ``joint_states``;
        ``scan`` (sensor_msgs/LaserScan), ``battery_state`` (sensor_msgs/BatteryState);
        ``world_updates`` (WorldUpdate): the map, and what the robot sees; ``home/map`` (WorldUpdate, latched);
        ``home/bell`` (std_msgs/Header): the bell of the door;
        ``home/heard`` (std_msgs/String): what the robot hears; ``home/truth`` (std_msgs/String, latched): all, as JSON
    Actions:
        ``home/act`` (FilledSemanticFrameAction): an action; with a PR2 also those of its arms
    """

    def __init__(self) -> None:
        """
        Raises:
            StartError: the home file cannot be read
        """
        settings, base_settings = read_parameters(HomeSettings), read_parameters(BaseSettings)
        rospy.loginfo("%s", settings)
        if settings.robot not in ROBOTS:
            raise StartError(f"~robot must be one of {', '.join(sorted(ROBOTS))}, got {settings.robot!r}")
        path = settings.home_file or rospkg.RosPack().get_path("roboframenet_sim") + "/config/home.yaml"
        try:
            plan, state = load_home_file(path, robot=ROBOTS[settings.robot])
        except (OSError, RoomError) as error:
            raise StartError(str(error)) from error
        self._lock = threading.RLock()
        faults = Faults(settings.slip, settings.blocked_door)
        self._home = Home(plan, state, seed=base_settings.seed, faults=faults)
        self._base = RosBase(base_settings, base=_Base(self._home, self._lock), command_topic="cmd_vel")
        self._arms: Optional[RosArms] = RosArms() if settings.robot == "pr2" else None
        self._laser = RosLaser(self._obstacles)
        self._battery = RosBattery(state.robot.battery, self._charge)
        self._pose = rospy.Publisher("amcl_pose", PoseWithCovarianceStamped, queue_size=5, latch=True)
        self._truth = rospy.Publisher("home/truth", String, queue_size=5, latch=True)
        self._bell = rospy.Publisher("home/bell", Header, queue_size=5)
        self._heard = rospy.Publisher("home/heard", String, queue_size=20)
        self._map = rospy.Publisher("home/map", WorldUpdate, queue_size=1, latch=True)
        self._updates = rospy.Publisher(
            "world_updates", WorldUpdate, queue_size=50, subscriber_listener=_Newcomers(self)
        )
        self._heard_until_s = 0.0
        self._last: Dict[str, Any] = {}
        self._due_s: Dict[str, float] = {}
        self._goals: Deque[Any] = collections.deque()
        self._cancels: Deque[Any] = collections.deque()
        self._running: Dict[int, Tuple[Action, Any]] = {}
        self._map.publish(WorldUpdate(objects=map_objects(plan)))
        self._said = rospy.Subscriber("said", String, self._on_said, queue_size=50)
        self._person = rospy.Subscriber("home/person", String, self._on_person, queue_size=50)
        self._begin = state
        if settings.may_be_arranged:
            self._arrange = rospy.Subscriber("home/arrange", String, self._on_arrange, queue_size=5)
        self._server = actionlib.ActionServer(
            "home/act", FilledSemanticFrameAction, self._on_goal, self._on_cancel, auto_start=False
        )
        self._server.start()
        rospy.on_shutdown(self._server.status_timer.shutdown)

    def map_update(self) -> WorldUpdate:
        """Return what is known of a home before anything is seen."""
        return WorldUpdate(objects=map_objects(self._home.plan))

    def step(self, duration_s: float, stamp: rospy.Time) -> None:
        """Advance the time."""
        self._begin_goals()
        self._base.step(duration_s, stamp)
        if self._arms is not None:
            self._arms.step(duration_s, stamp)
        self._laser.step(duration_s, stamp, robot=self._base.pose)
        with self._lock:
            outcomes = self._home.outcomes()
            state = self._home.state
            plan, floor = self._home.plan, self._home.floor
        self._end_goals(outcomes)
        # What is said from now on has the time of this state, and is told after the next step.
        begin_s, self._heard_until_s = self._heard_until_s, state.time_s
        for event in state.events:
            if event.kind == "said" and ROBOT in event.to and begin_s <= event.time_s < state.time_s:
                publish(self._heard, String(data=f"{plan.entities[event.who].name}: {event.what}"))
        if self._is_due("sight", _PERCEPTION_S, stamp):
            self._perceive(plan, state, floor, stamp)
        if self._is_due("truth", _TRUTH_S, stamp):
            truth = json.dumps(
                {"truth": truth_of(plan, state), "events": [asdict(event) for event in state.events[-20:]]}
            )
            if truth != self._last.get("truth"):
                self._last["truth"] = truth
                publish(self._truth, String(data=truth))
        self._battery.step(duration_s, stamp, charge=state.robot.battery)
        self._publish_pose(stamp)

    def _obstacles(self) -> Tuple[Any, List[Cylinder]]:
        """Return what the laser meets: outlines, and persons."""
        with self._lock:
            state, floor = self._home.state, self._home.floor
        poses = [person.pose for person in state.people.values()]
        return floor.outlines(state), [Cylinder(pose.x_m, pose.y_m, PERSON_RADIUS_M, 1.7) for pose in poses]

    def _charge(self, charge: float) -> None:
        with self._lock:
            self._home.set_charge(charge)

    def _is_due(self, name: str, period_s: float, stamp: rospy.Time) -> bool:
        now_s = stamp.to_sec()
        if now_s < self._due_s.get(name, 0.0):
            return False
        self._due_s[name] = now_s + period_s
        return True

    def _perceive(self, plan: Any, state: Any, floor: Any, stamp: rospy.Time) -> None:
        seen = floor.visible(state)
        objects = seen_objects(plan, state, seen, stamp)
        key = repr([(one.id, one.relations, one.states, round(one.pose.pose.position.x, 1)) for one in objects])
        if key == self._last.get("seen") and not self._is_due("again", 4 * _PERCEPTION_S, stamp):
            return
        self._last["seen"] = key
        publish(self._updates, WorldUpdate(objects=objects))

    def _publish_pose(self, stamp: rospy.Time) -> None:
        pose = self._base.pose
        last = self._last.get("pose")
        if last is not None and abs(last.x_m - pose.x_m) + abs(last.y_m - pose.y_m) < _POSE_STEP_M:
            if abs(last.yaw_rad - pose.yaw_rad) < 0.1:
                return
        self._last["pose"] = pose
        message = PoseWithCovarianceStamped()
        message.header.stamp, message.header.frame_id = stamp, "map"
        message.pose.pose.position.x, message.pose.pose.position.y = pose.x_m, pose.y_m
        message.pose.pose.orientation = quaternion_of_yaw(pose.yaw_rad)
        publish(self._pose, message)

    def _on_said(self, message: String) -> None:
        with self._lock:
            self._home.say(ROBOT, message.data)

    def _on_person(self, message: String) -> None:
        words = (message.data.split() + ["", "", ""])[:3]
        if words[1] == "ring":
            self._bell.publish(Header(stamp=rospy.Time.now(), frame_id=words[0]))
            return
        with self._lock:
            failure = self._home.tell_person(words[0], words[1], words[2])
        if failure is not None:
            rospy.logwarn("%s: %s", message.data, failure.sentence)

    def _on_arrange(self, message: String) -> None:
        plan, floor = self._home.plan, self._home.floor
        try:
            wishes: Dict[str, str] = json.loads(message.data)
            state = arranged(plan, floor, self._begin, wishes)
        except (ValueError, AttributeError) as error:
            rospy.logerr("home/arrange: %s", error)
            return
        with self._lock:
            self._home.start_anew(state)
            self._heard_until_s = self._home.state.time_s
            self._last.clear()
        forgotten = [one.id for one in plan.entities.values() if one.kind in ("thing", "person")]
        publish(self._updates, WorldUpdate(missing=forgotten))

    # The action server holds its own lock while it calls these, and takes it when a goal ends: they wait for nothing.

    def _on_goal(self, handle: Any) -> None:
        self._goals.append(handle)

    def _on_cancel(self, handle: Any) -> None:
        self._cancels.append(handle)

    def _begin_goals(self) -> None:
        while self._goals:
            handle = self._goals.popleft()
            handle.set_accepted()
            try:
                action = action_of(handle.get_goal().frame)
            except (TypeError, ValueError) as error:
                self._abort(handle, Failure("unknown", f"This is no action: {error}."))
                continue
            with self._lock:
                failure = self._home.begin(action)
            if failure is not None:
                self._abort(handle, failure)
            else:
                self._running[id(action)] = (action, handle)
        while self._cancels:
            handle = self._cancels.popleft()
            kinds = [action.kind for action, running in self._running.values() if running == handle]
            with self._lock:
                for kind in kinds:
                    self._home.preempt(kind)

    def _end_goals(self, outcomes: Tuple[Outcome, ...]) -> None:
        for outcome in outcomes:
            _, handle = self._running.pop(id(outcome.action), (None, None))
            if handle is None:
                continue
            if outcome.is_preempted:
                handle.set_canceled(FilledSemanticFrameResult(success=False), "preempted")
            elif outcome.failure is not None:
                self._abort(handle, outcome.failure)
            else:
                handle.set_succeeded(FilledSemanticFrameResult(success=True), "done")

    @staticmethod
    def _abort(handle: Any, failure: Failure) -> None:
        handle.set_aborted(FilledSemanticFrameResult(success=False), json.dumps(asdict(failure)))


class _Newcomers(rospy.SubscribeListener):
    """Tells the map to each new subscriber of the updates."""

    def __init__(self, home: HomeSim) -> None:
        super().__init__()
        self._home = home

    def peer_subscribe(self, _topic: str, _publish: Any, peer_publish: Any) -> None:
        """Somebody subscribes."""
        peer_publish(self._home.map_update())


def action_of(frame: Any) -> Action:
    """Read an action from a frame: its name is the kind, its elements are the fields of :class:`Action`.

    Raises:
        TypeError, ValueError: there is no such field, or an amount is no number
    """
    values: Dict[str, Any] = {element.name: element.argument for element in frame.frame_elements}
    if "amount" in values:
        values["amount"] = float(values["amount"])
    return Action(frame.name, **values)


def _start() -> Stepper:
    settings = read_parameters(SteppingSettings)
    rospy.loginfo("%s", settings)
    stepper = Stepper(settings, step=HomeSim().step)
    stepper.start()
    return stepper


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter or the home file is wrong."""
    run_node("home_sim", _start)
