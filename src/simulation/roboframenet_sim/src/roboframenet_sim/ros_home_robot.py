"""A robot of a home over ROS: its base, its senses and its actions."""

import collections
import json
from dataclasses import asdict, replace
from typing import Any, Deque, Dict, List, Optional, Tuple

import actionlib
import rospy
from geometry_msgs.msg import PoseWithCovarianceStamped
from roboframenet_msgs.msg import FilledSemanticFrameAction, FilledSemanticFrameResult, WorldUpdate
from std_msgs.msg import Bool, Header, String

from roboframenet_ros.ros_publishing import publish
from roboframenet_sim.base import Velocity
from roboframenet_sim.home_actions import Action, Failure
from roboframenet_sim.home_company import Company
from roboframenet_sim.home_engine import Outcome
from roboframenet_sim.home_floor import PERSON_RADIUS_M
from roboframenet_sim.home_state import ROBOT
from roboframenet_sim.point_cloud import Cylinder
from roboframenet_sim.ros_arms import RosArms
from roboframenet_sim.ros_base import BaseSettings, RosBase, quaternion_of_yaw
from roboframenet_sim.ros_sensors import RosBattery, RosLaser
from roboframenet_sim.ros_world_objects import map_objects, seen_objects

#: The robot perceives so often; seconds of ROS time.
_PERCEPTION_S = 0.5
#: The pose is published again when the robot has moved so far.
_POSE_STEP_M = 0.05


class _Base:
    """The base of a robot of the home, as :class:`RosBase` drives it. The home advances it."""

    def __init__(self, company: Company, name: str, lock: Any) -> None:
        self._home = company.homes[name]
        self._lock = lock
        self.pose = self._home.base.pose
        self.velocity = self._home.base.velocity

    def command(self, velocity: Velocity) -> bool:
        """Take a velocity command."""
        with self._lock:
            self._home.drive(velocity)
        return velocity.is_finite()

    def step(self, _duration_s: float) -> None:
        """Read where the home has it."""
        with self._lock:
            self.pose, self.velocity = self._home.base.pose, self._home.base.velocity


class RosHomeRobot:
    """A robot of a home.

    Args:
        company: the robots of the home
        name: its id among them
        space: before the names of its topics: empty, or its namespace with a slash behind
        settings: of its base
        has_arms: whether it offers the actions of a PR2's arms
        lock: of the home

    Subscribes, publishes and serves: see :class:`roboframenet_sim.ros_home.HomeSim`
    """

    def __init__(
        self, company: Company, name: str, space: str, settings: BaseSettings, *, has_arms: bool, lock: Any
    ) -> None:
        self._company, self._name, self._lock = company, name, lock
        if space:
            frames = {key: space + getattr(settings, key) for key in ("odom_frame", "base_frame")}
            settings = replace(settings, **frames)
        self._base = RosBase(
            settings, base=_Base(company, name, lock), command_topic=f"{space}cmd_vel", odometry_topic=f"{space}odom"
        )
        self._arms: Optional[RosArms] = RosArms() if has_arms else None
        self._laser = RosLaser(self._obstacles, frame=settings.base_frame, topic=f"{space}scan")
        self._battery = RosBattery(company.homes[name].state.robot.battery, self._charge, space=space)
        self._pose = rospy.Publisher(f"{space}amcl_pose", PoseWithCovarianceStamped, queue_size=5, latch=True)
        self._heard = rospy.Publisher(f"{space}home/heard", String, queue_size=20)
        self._bell = rospy.Publisher(f"{space}home/bell", Header, queue_size=5)
        self._rain = rospy.Publisher(f"{space}home/rain", Bool, queue_size=5, latch=True)
        self._map = rospy.Publisher(f"{space}home/map", WorldUpdate, queue_size=1, latch=True)
        self._updates = rospy.Publisher(
            f"{space}world_updates", WorldUpdate, queue_size=50, subscriber_listener=_Newcomers(self)
        )
        self._heard_until_s = 0.0
        self._last: Dict[str, Any] = {}
        self._due_s: Dict[str, float] = {}
        self._goals: Deque[Any] = collections.deque()
        self._cancels: Deque[Any] = collections.deque()
        self._running: Dict[int, Tuple[Action, Any]] = {}
        self._map.publish(self.map_update())
        self._said = rospy.Subscriber(f"{space}said", String, self._on_said, queue_size=50)
        self._server = actionlib.ActionServer(
            f"{space}home/act", FilledSemanticFrameAction, self._on_goal, self._on_cancel, auto_start=False
        )
        self._server.start()
        rospy.on_shutdown(self._server.status_timer.shutdown)

    def map_update(self) -> WorldUpdate:
        """Return what is known of a home before anything is seen."""
        return WorldUpdate(objects=map_objects(self._company.homes[self._name].plan))

    def begin_goals(self) -> None:
        """Begin and cancel what was asked for since the last step."""
        while self._goals:
            handle = self._goals.popleft()
            handle.set_accepted()
            try:
                action = action_of(handle.get_goal().frame)
            except (TypeError, ValueError) as error:
                _abort(handle, Failure("unknown", f"This is not an action: {error}."))
                continue
            with self._lock, self._company.acting(self._name) as home:
                failure = home.begin(action)
            if failure is not None:
                _abort(handle, failure)
            else:
                self._running[id(action)] = (action, handle)
        while self._cancels:
            handle = self._cancels.popleft()
            kinds = [action.kind for action, running in self._running.values() if running == handle]
            with self._lock:
                for kind in kinds:
                    self._company.homes[self._name].preempt(kind)

    def step(self, duration_s: float, stamp: rospy.Time) -> None:
        """Tell what has become of the robot in a step of the home."""
        self._base.step(duration_s, stamp)
        if self._arms is not None:
            self._arms.step(duration_s, stamp)
        self._laser.step(duration_s, stamp, robot=self._base.pose)
        with self._lock:
            home = self._company.homes[self._name]
            outcomes, state = home.outcomes(), home.state
            plan, floor = home.plan, home.floor
        self._end_goals(outcomes)
        # What is said from now on has the time of this state, and is told after the next step.
        begin_s, self._heard_until_s = self._heard_until_s, state.time_s
        for event in state.events:
            if event.kind == "said" and ROBOT in event.to and begin_s <= event.time_s < state.time_s:
                publish(self._heard, String(data=f"{plan.entities[event.who].name}: {event.what}"))
        if self.is_due("sight", _PERCEPTION_S, stamp):
            self._perceive(plan, state, floor, stamp)
        self._battery.step(duration_s, stamp, charge=state.robot.battery)
        self._publish_pose(stamp)

    def start_anew(self, forgotten: List[str]) -> None:
        """The home has been arranged: forget where things are. Called with the lock."""
        self._heard_until_s = self._company.homes[self._name].state.time_s
        self._last.clear()
        publish(self._updates, WorldUpdate(missing=forgotten))

    def ring(self, who: str) -> None:
        """Somebody rings the bell."""
        publish(self._bell, Header(stamp=rospy.Time.now(), frame_id=who))

    def rain(self, *, is_raining: bool) -> None:
        """The rain gauge says something else."""
        publish(self._rain, Bool(data=is_raining))

    def _obstacles(self) -> Tuple[Any, List[Cylinder]]:
        """Return what the laser meets: outlines, and persons."""
        with self._lock:
            home = self._company.homes[self._name]
            state, floor = home.state, home.floor
        poses = [person.pose for person in state.people.values()]
        return floor.outlines(state), [Cylinder(pose.x_m, pose.y_m, PERSON_RADIUS_M, 1.7) for pose in poses]

    def _charge(self, charge: float) -> None:
        with self._lock, self._company.acting(self._name) as home:
            home.set_charge(charge)

    def is_due(self, name: str, period_s: float, stamp: rospy.Time) -> bool:
        """Whether something is to be done again that is done every so many seconds."""
        now_s = stamp.to_sec()
        if now_s < self._due_s.get(name, 0.0):
            return False
        self._due_s[name] = now_s + period_s
        return True

    def _perceive(self, plan: Any, state: Any, floor: Any, stamp: rospy.Time) -> None:
        # Most of the time nothing moves: what is seen is what was seen before.
        sight = floor.sight_of(state)
        is_same = sight == self._last.get("sight")
        if is_same and not self.is_due("again", 4 * _PERCEPTION_S, stamp):
            return
        if not is_same:
            self._last["sight"], self._last["visible"] = sight, floor.visible(state)
        objects = seen_objects(plan, state, self._last["visible"], stamp)
        key = [
            (
                one.id,
                [(relation.relation, relation.reference) for relation in one.relations],
                one.states,
                round(one.pose.pose.position.x, 1),
            )
            for one in objects
        ]
        if not is_same and key == self._last.get("seen") and not self.is_due("again", 4 * _PERCEPTION_S, stamp):
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
        with self._lock, self._company.acting(self._name) as home:
            home.say(ROBOT, message.data)

    # The action server holds its own lock while it calls these, and takes it when a goal ends: they wait for nothing.

    def _on_goal(self, handle: Any) -> None:
        self._goals.append(handle)

    def _on_cancel(self, handle: Any) -> None:
        self._cancels.append(handle)

    def _end_goals(self, outcomes: Tuple[Outcome, ...]) -> None:
        for outcome in outcomes:
            _, handle = self._running.pop(id(outcome.action), (None, None))
            if handle is None:
                continue
            if outcome.is_preempted:
                handle.set_canceled(FilledSemanticFrameResult(success=False), "preempted")
            elif outcome.failure is not None:
                _abort(handle, outcome.failure)
            else:
                handle.set_succeeded(FilledSemanticFrameResult(success=True), "done")


class _Newcomers(rospy.SubscribeListener):
    """Tells the map to each new subscriber of the updates."""

    def __init__(self, robot: RosHomeRobot) -> None:
        super().__init__()
        self._robot = robot

    def peer_subscribe(self, _topic: str, _publish: Any, peer_publish: Any) -> None:
        """Somebody subscribes."""
        peer_publish(self._robot.map_update())


def _abort(handle: Any, failure: Failure) -> None:
    handle.set_aborted(FilledSemanticFrameResult(success=False), json.dumps(asdict(failure)))


def action_of(frame: Any) -> Action:
    """Read an action from a frame: its name is the kind, its elements are the fields of :class:`Action`.

    Raises:
        TypeError, ValueError: there is no such field, or an amount is no number
    """
    values: Dict[str, Any] = {element.name: element.argument for element in frame.frame_elements}
    if "amount" in values:
        values["amount"] = float(values["amount"])
    return Action(frame.name, **values)
