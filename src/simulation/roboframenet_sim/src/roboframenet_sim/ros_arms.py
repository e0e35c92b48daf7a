"""The node pr2_sim: arms and base of a PR2 on the topics and actions of the real one."""

from typing import Dict

import actionlib
import rospy
from pr2_controllers_msgs.msg import JointTrajectoryAction, JointTrajectoryGoal
from sensor_msgs.msg import JointState

from roboframenet_ros.ros_node import read_parameters, run_node
from roboframenet_ros.ros_publishing import publish
from roboframenet_sim.arm import Arm, Trajectory, TrajectoryPoint, arm_limits, tucked_positions
from roboframenet_sim.base import DifferentialBase
from roboframenet_sim.occupancy_grid import grid_of_room
from roboframenet_sim.room import load_room_file
from roboframenet_sim.ros_base import BaseSettings, RosBase
from roboframenet_sim.ros_stepping import Stepper, SteppingSettings

ROBOT_RADIUS_M = 0.33
"""Radius of the PR2's base: it cannot come nearer to a wall."""


def trajectory_of(goal: JointTrajectoryGoal) -> Trajectory:
    """Read a goal. Velocities and accelerations of the points are ignored: the arm moves straight between them."""
    return Trajectory(
        joint_names=tuple(goal.trajectory.joint_names),
        points=tuple(
            TrajectoryPoint(positions_rad=tuple(point.positions), time_s=point.time_from_start.to_sec())
            for point in goal.trajectory.points
        ),
    )


class ArmController:
    """The trajectory action of one arm.

    The steps of the simulation handle goals: nothing waits, and a new goal replaces the one before.
    """

    def __init__(self, name: str, arm: Arm) -> None:
        self._arm = arm
        self._server = actionlib.SimpleActionServer(name, JointTrajectoryAction, auto_start=False)
        self._server.start()
        # The status timer of a stock server still publishes while the topics close.
        rospy.on_shutdown(self._server.action_server.status_timer.shutdown)

    def step(self, duration_s: float) -> None:
        """Advance the time."""
        if self._server.is_new_goal_available():
            self._accept()
        self._arm.step(duration_s)
        if not self._server.is_active():
            return
        if self._server.is_preempt_requested():
            self._arm.hold()
            self._server.set_preempted(text="the arm holds still")
        elif not self._arm.is_moving:
            self._server.set_succeeded(text="the arm is there")

    def _accept(self) -> None:
        trajectory = trajectory_of(self._server.accept_new_goal())
        reason = self._arm.check(trajectory)
        if reason is None:
            self._arm.follow(trajectory)
            return
        rospy.logerr("trajectory refused: %s", reason)
        self._arm.hold()
        self._server.set_aborted(text=reason)


class RosArms:
    """Both arms of a PR2.

    Publishes:
        ``joint_states`` (sensor_msgs/JointState)
    Actions:
        ``r_arm_controller/joint_trajectory_action``, ``l_arm_controller/joint_trajectory_action``
    """

    def __init__(self) -> None:
        self._joints = rospy.Publisher("joint_states", JointState, queue_size=10)
        self._arms: Dict[str, Arm] = {
            prefix: Arm(arm_limits(prefix), positions_rad=tucked_positions(prefix)) for prefix in ("r", "l")
        }
        self._controllers = [
            ArmController(f"{prefix}_arm_controller/joint_trajectory_action", arm) for prefix, arm in self._arms.items()
        ]

    def step(self, duration_s: float, stamp: rospy.Time) -> None:
        """Advance the time."""
        message = JointState()
        message.header.stamp = stamp
        for controller in self._controllers:
            controller.step(duration_s)
        for arm in self._arms.values():
            message.name += list(arm.positions_rad)
            message.position += list(arm.positions_rad.values())
            message.velocity += list(arm.velocities_rad_per_s.values())
        publish(self._joints, message)


class Pr2Sim:
    """A PR2.

    Subscribes:
        ``base_controller/command`` (geometry_msgs/Twist)
    Publishes:
        ``odom`` (nav_msgs/Odometry), ``joint_states`` (sensor_msgs/JointState), ``/tf``; ``/clock`` under /use_sim_time
    Actions:
        ``r_arm_controller/joint_trajectory_action``, ``l_arm_controller/joint_trajectory_action``
        (pr2_controllers_msgs/JointTrajectoryAction)
    """

    def __init__(self) -> None:
        settings = read_parameters(BaseSettings, defaults=BaseSettings(base_frame="base_footprint"))
        rospy.loginfo("%s", settings)
        is_free = (
            grid_of_room(load_room_file(settings.room)).inflated(ROBOT_RADIUS_M).is_free if settings.room else None
        )
        base = DifferentialBase(settings.limits, pose=settings.start, seed=settings.seed, is_free=is_free)
        self._base = RosBase(settings, base=base, command_topic="base_controller/command")
        self._arms = RosArms()

    def step(self, duration_s: float, stamp: rospy.Time) -> None:
        """Advance the time."""
        self._base.step(duration_s, stamp)
        self._arms.step(duration_s, stamp)


def _start() -> Stepper:
    settings = read_parameters(SteppingSettings)
    rospy.loginfo("%s", settings)
    stepper = Stepper(settings, step=Pr2Sim().step)
    stepper.start()
    return stepper


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    run_node("pr2_sim", _start)
