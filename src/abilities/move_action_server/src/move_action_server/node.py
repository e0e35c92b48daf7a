"""The node move_action_server: four RFNServers that move and turn one base."""

import enum
import math
import time
from dataclasses import dataclass
from functools import partial
from typing import Callable, Dict, Mapping, Sequence, Union

import rospy
from geometry_msgs.msg import Twist
from roboframenet_msgs.msg import FilledSemanticFrameFeedback, FilledSemanticFrameResult

from move_action_server.base_claim import BaseClaim, BaseClaims
from move_action_server.motion import (
    STANDING,
    Motion,
    MotionCommand,
    MotionGoal,
    MotionProfile,
    MotionSettings,
    MotionState,
    check_goal,
    describe_amount,
    describe_progress,
)
from move_action_server.ros_odometry import LatestOdometry
from move_action_server.spoken_motion import (
    PACES,
    SPEEDS,
    CompassGoal,
    NotUnderstood,
    backward_goal,
    compass_goal,
    forward_goal,
    turn_goal,
)
from rfnserver import RFNServer, TypedFrame
from roboframenet_ros.health import Health, Level
from roboframenet_ros.parameters import ParameterError, Parameters, parameter
from roboframenet_ros.pausable_clock import PausableClock
from roboframenet_ros.ros_live_parameters import LiveParameters
from roboframenet_ros.ros_node import read_parameters, run_node
from roboframenet_ros.ros_place import Place
from roboframenet_ros.ros_publishing import publish
from typed_arguments import TypedArgument

#: Makes a motion of the arguments of a frame.
GoalOf = Callable[[Mapping[str, TypedArgument]], Union[MotionGoal, CompassGoal]]

GOAL_OF_FRAME: Mapping[str, GoalOf] = {
    "moving_forward": forward_goal,
    "moving_backward": backward_goal,
    "turning": turn_goal,
}
"""How to read the arguments of each frame."""
HEEDED: Mapping[str, Sequence[str]] = {"Manner": PACES, "Speed": SPEEDS}
"""What the servers heed beside the elements of their frames."""

_STRAIGHT, _TURN = MotionSettings.straight, MotionSettings.turn


@dataclass(frozen=True)
class Settings(Parameters):
    """Private parameters, checked.

    Attributes:
        max_distance_m: longest distance
        max_angle_rad: largest turn
        linear_speed_m_per_s: usual speed
        linear_acceleration_m_per_s2: acceleration and deceleration
        linear_creep_m_per_s: slowest speed that still moves the base
        distance_tolerance_m: smallest tolerance, for short distances
        angular_speed_rad_per_s: usual turn rate
        angular_acceleration_rad_per_s2: acceleration and deceleration
        angular_creep_rad_per_s: slowest turn rate that still moves the base
        angle_tolerance_rad: smallest tolerance, for small turns
        aim_share: the base stops within this share of the amount
        accept_share: a motion that ends farther from the goal than this share has failed
        odometry_timeout_s: after this time without odometry the goal is aborted
        stall_timeout_s: after this time without motion the base is stuck
        claim_timeout_s: how long a newer goal waits for the older one to stop the base
        feedback_period_s: time between feedback messages
        slow_share: share of the usual speed of a motion that is to be slow
        quick_share: share of the usual speed of a motion that is to be quick
        north_rad: yaw of north in the frame of the odometry; by REP 103, x is east and y is north

    Raises:
        ParameterError: a value out of its range, or values that contradict each other
    """

    max_distance_m: float = parameter(_STRAIGHT.max_amount, above=0.0)
    max_angle_rad: float = parameter(_TURN.max_amount, above=0.0)
    linear_speed_m_per_s: float = parameter(_STRAIGHT.speed_per_s, above=0.0, is_live=True)
    linear_acceleration_m_per_s2: float = parameter(_STRAIGHT.acceleration_per_s2, above=0.0, is_live=True)
    linear_creep_m_per_s: float = parameter(_STRAIGHT.creep_per_s, above=0.0)
    distance_tolerance_m: float = parameter(_STRAIGHT.tolerance, above=0.0)
    angular_speed_rad_per_s: float = parameter(_TURN.speed_per_s, above=0.0, is_live=True)
    angular_acceleration_rad_per_s2: float = parameter(_TURN.acceleration_per_s2, above=0.0, is_live=True)
    angular_creep_rad_per_s: float = parameter(_TURN.creep_per_s, above=0.0)
    angle_tolerance_rad: float = parameter(_TURN.tolerance, above=0.0)
    aim_share: float = parameter(MotionSettings.aim_share, above=0.0)
    accept_share: float = parameter(MotionSettings.accept_share, above=0.0)
    odometry_timeout_s: float = parameter(MotionSettings.odometry_timeout_s, least=0.1, most=60.0)
    stall_timeout_s: float = parameter(MotionSettings.stall_timeout_s, least=0.1, most=60.0)
    claim_timeout_s: float = parameter(2.0, least=0.05, most=60.0)
    feedback_period_s: float = parameter(0.5, least=0.05, most=60.0)
    slow_share: float = parameter(MotionSettings.slow_share, above=0.0, is_live=True)
    quick_share: float = parameter(MotionSettings.quick_share, above=1.0, is_live=True)
    north_rad: float = parameter(math.pi / 2.0, least=-math.pi, most=math.pi)

    def __post_init__(self) -> None:
        super().__post_init__()
        try:
            self.motion()
        except ValueError as error:
            raise ParameterError(str(error)) from error

    def motion(self) -> MotionSettings:
        """Return the settings of motions."""
        return MotionSettings(
            straight=MotionProfile(
                max_amount=self.max_distance_m,
                speed_per_s=self.linear_speed_m_per_s,
                acceleration_per_s2=self.linear_acceleration_m_per_s2,
                creep_per_s=self.linear_creep_m_per_s,
                tolerance=self.distance_tolerance_m,
            ),
            turn=MotionProfile(
                max_amount=self.max_angle_rad,
                speed_per_s=self.angular_speed_rad_per_s,
                acceleration_per_s2=self.angular_acceleration_rad_per_s2,
                creep_per_s=self.angular_creep_rad_per_s,
                tolerance=self.angle_tolerance_rad,
            ),
            aim_share=self.aim_share,
            accept_share=self.accept_share,
            odometry_timeout_s=self.odometry_timeout_s,
            stall_timeout_s=self.stall_timeout_s,
            slow_share=self.slow_share,
            quick_share=self.quick_share,
        )


class Outcome(enum.Enum):
    """How a goal ends."""

    SUCCEEDED = "done"
    ABORTED = "aborted"
    PREEMPTED = "preempted"


@dataclass(frozen=True)
class Ending:
    """The end of a goal, with the reason in words."""

    outcome: Outcome
    text: str


class MoveActionServer:
    """Moves and turns a base.

    Subscribes:
        ``odom`` (nav_msgs/Odometry)
    Publishes:
        ``cmd_vel`` (geometry_msgs/Twist), only while a goal is active, and zero at its end
    Actions:
        ``moving_forward``, ``moving_backward``, ``turning``, ``turning_to_direction``
        (roboframenet_msgs/FilledSemanticFrameAction)

    There is one base, so there is one motion at a time: a newer goal of any of the four servers preempts the older.
    """

    WAIT_S = 0.05
    FLUSH_S = 0.1

    def __init__(self, settings: Settings, *, namespace: str = "") -> None:
        self._settings = settings
        self._motion = settings.motion()
        self._claims = BaseClaims()
        self._odometry = LatestOdometry()
        self._velocity = rospy.Publisher("cmd_vel", Twist, queue_size=1, tcp_nodelay=True)
        rospy.on_shutdown(self._shut_down)
        self._servers: Dict[str, RFNServer] = {}
        goals: Dict[str, GoalOf] = {
            **GOAL_OF_FRAME,
            "turning_to_direction": partial(compass_goal, north_rad=settings.north_rad),
        }
        for frame_name, goal_of in goals.items():
            server = RFNServer(
                frame_name,
                self._callback(frame_name, goal_of),
                heeds=HEEDED,
                occupies=["base"],
            )
            server.register_preempt_callback(self._odometry.wake)
            self._servers[frame_name] = server
        self._live = LiveParameters(settings, self._tune, namespace=namespace)

    def start(self) -> None:
        """Offer the four servers, and register them with their frames: without a registrar, that takes seconds."""
        for server in self._servers.values():
            server.start()
        for frame_name, server in self._servers.items():
            server.register_with_frame(frame_name)

    def health(self) -> Health:
        """How the node is."""
        if self._odometry.count == 0:
            return Health(Level.WARN, f"No odometry yet on {self._odometry.topic}: the base does not move without it.")
        if self._odometry.latest() is None:
            return Health(Level.ERROR, f"The numbers on {self._odometry.topic} are not finite: the base does not move.")
        return Health(values={"odometry messages": self._odometry.count})

    def _tune(self, settings: Settings) -> None:
        # A motion that has begun ends with the settings that it began with.
        self._motion = settings.motion()

    def _shut_down(self) -> None:
        self._odometry.wake()
        # A driver stops the base before it gives it back, and after this claim nothing drives the base.
        self._claims.claim(timeout_s=self._settings.claim_timeout_s)
        self._publish(STANDING)
        # A thread of the publisher sends queued messages; the topics close when this method returns.
        time.sleep(self.FLUSH_S)

    def _publish(self, command: MotionCommand) -> None:
        message = Twist()
        message.linear.x = command.linear_m_per_s
        message.angular.z = command.angular_rad_per_s
        publish(self._velocity, message)

    def _callback(self, frame_name: str, goal_of: GoalOf) -> Callable[[TypedFrame], None]:
        def execute(frame: TypedFrame) -> None:
            server = self._servers[frame_name]
            ending = self._run(server, goal_of, {argument.name: argument for argument in frame.arguments})
            rospy.loginfo("%s %s: %s", frame_name, ending.outcome.value, ending.text)
            if ending.outcome is Outcome.SUCCEEDED:
                # The text of a success would be an answer to the person, who did not ask how far the robot came.
                server.set_succeeded(FilledSemanticFrameResult(success=True))
                return
            end = server.set_preempted if ending.outcome is Outcome.PREEMPTED else server.set_aborted
            end(FilledSemanticFrameResult(success=False), ending.text)

        return execute

    def _run(
        self,
        server: RFNServer,
        goal_of: GoalOf,
        arguments: Mapping[str, TypedArgument],
    ) -> Ending:
        try:
            goal = goal_of(arguments)
        except NotUnderstood as error:
            return Ending(Outcome.ABORTED, str(error))
        reason = check_goal(goal if isinstance(goal, MotionGoal) else goal.motion(0.0), settings=self._motion)
        if reason:
            return Ending(Outcome.ABORTED, reason)
        return self._drive(server, goal)

    def _drive(self, server: RFNServer, goal: Union[MotionGoal, CompassGoal]) -> Ending:
        """Take the base, move it, stop it, and give it back."""
        claim = self._claims.claim(timeout_s=self._settings.claim_timeout_s, is_cancelled=server.is_preempt_requested)
        if claim is None:
            if server.is_preempt_requested():
                return Ending(Outcome.PREEMPTED, "cancelled before the base was free")
            return Ending(Outcome.ABORTED, "the base is busy with another motion")
        try:
            return self._follow(server, goal, claim=claim)
        finally:
            self._publish(STANDING)
            claim.release()

    def _follow(self, server: RFNServer, wanted: Union[MotionGoal, CompassGoal], *, claim: BaseClaim) -> Ending:
        """Move the base until the motion ends. The caller stops the base."""
        motion_settings = self._motion
        start, count = self._odometry.wait_newer(
            than=self._odometry.count, timeout_s=motion_settings.odometry_timeout_s
        )
        if start is None:
            if server.is_preempt_requested():
                return Ending(Outcome.PREEMPTED, "cancelled before the first odometry")
            return Ending(Outcome.ABORTED, f"no odometry on {self._odometry.topic}")
        goal = wanted if isinstance(wanted, MotionGoal) else wanted.motion(start.yaw_rad)
        clock = PausableClock(
            ros_time_ns=lambda: rospy.Time.now().to_nsec(), is_simulated=not rospy.rostime.is_wallclock()
        )
        motion = Motion(goal, settings=motion_settings, start=start, now_s=clock.now_s())
        rospy.loginfo("%s: %s", goal.kind.value, describe_amount(goal))
        feedback_s, was_stuck = -math.inf, False
        while not rospy.is_shutdown():
            if server.is_preempt_requested():
                return Ending(Outcome.PREEMPTED, _how_far(motion, goal, is_stuck=was_stuck))
            if claim.is_revoked:
                return Ending(Outcome.PREEMPTED, "another motion takes the base")
            # In a simulation that is paused there is no odometry: the motion goes on when the simulation does.
            step = motion.step(now_s=clock.now_s())
            self._publish(step.command)
            if step.state is MotionState.ARRIVED:
                done = MotionGoal(kind=goal.kind, amount=motion.progress)
                return Ending(Outcome.SUCCEEDED, f"{describe_amount(done)} by odometry")
            if step.state is MotionState.FAILED:
                return Ending(Outcome.ABORTED, step.reason)
            is_stuck = motion.is_stuck(now_s=clock.now_s())
            if is_stuck != was_stuck or time.monotonic() - feedback_s >= self._settings.feedback_period_s:
                feedback_s, was_stuck = time.monotonic(), is_stuck
                server.publish_feedback(FilledSemanticFrameFeedback(is_succeeding=not is_stuck))
            sample, count = self._odometry.wait_newer(than=count, timeout_s=self.WAIT_S)
            if sample is not None:
                motion.observe(sample, now_s=clock.now_s())
        return Ending(Outcome.ABORTED, "the node is shut down")


def _how_far(motion: Motion, goal: MotionGoal, *, is_stuck: bool) -> str:
    """Return what a person is told of a motion that was ended: it may have been given a time, and no amount."""
    far = describe_progress(goal.kind, motion.progress)
    return f"{far} Something held the base." if is_stuck else far


def start(place: Place) -> MoveActionServer:
    """Start the server, as a node or with others in one process.

    Raises:
        ParameterError: a parameter is wrong
    """
    settings = read_parameters(Settings, prefix=place.private)
    rospy.loginfo("%s", settings)
    server = MoveActionServer(settings, namespace=place.namespace)
    server.start()
    return server


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    run_node("move_action_server", lambda: start(Place()))
