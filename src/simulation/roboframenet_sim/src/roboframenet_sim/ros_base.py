"""The topics of a simulated base: takes velocity commands, publishes odometry and tf."""

import math
import threading
from dataclasses import dataclass
from typing import Tuple

import rospy
import tf2_ros
from geometry_msgs.msg import Quaternion, TransformStamped, Twist
from nav_msgs.msg import Odometry

from roboframenet_ros.parameters import Parameters, parameter
from roboframenet_ros.ros_publishing import is_shutting_down, publish
from roboframenet_sim.base import BaseLimits, DifferentialBase, Pose, Velocity


@dataclass(frozen=True)
class BaseSettings(Parameters):
    """Private parameters of the base, checked.

    Attributes:
        max_linear_m_per_s: top speed
        max_angular_rad_per_s: top turn rate
        linear_acceleration_m_per_s2: largest acceleration
        angular_acceleration_rad_per_s2: largest acceleration of turns
        command_timeout_s: how long a command holds
        velocity_noise: standard deviation of the executed velocity, as a share of it
        start_x_m, start_y_m, start_yaw_rad: first pose
        seed: of the noise
        odom_frame: name of the odometry frame
        base_frame: name of the frame of the robot
        room: path of a floor plan whose walls stop the robot; empty for an open floor

    Raises:
        ParameterError: a value out of its range, or a frame name that is empty
    """

    max_linear_m_per_s: float = parameter(BaseLimits.max_linear_m_per_s, above=0.0)
    max_angular_rad_per_s: float = parameter(BaseLimits.max_angular_rad_per_s, above=0.0)
    linear_acceleration_m_per_s2: float = parameter(BaseLimits.linear_acceleration_m_per_s2, above=0.0)
    angular_acceleration_rad_per_s2: float = parameter(BaseLimits.angular_acceleration_rad_per_s2, above=0.0)
    command_timeout_s: float = parameter(BaseLimits.command_timeout_s, above=0.0)
    velocity_noise: float = parameter(BaseLimits.velocity_noise, least=0.0, most=1.0)
    start_x_m: float = parameter(0.0)
    start_y_m: float = parameter(0.0)
    start_yaw_rad: float = parameter(0.0)
    seed: int = parameter(0)
    odom_frame: str = parameter("odom", may_be_empty=False)
    base_frame: str = parameter("base_link", may_be_empty=False)
    room: str = parameter("")

    @property
    def limits(self) -> BaseLimits:
        """Speeds and accelerations."""
        return BaseLimits(
            max_linear_m_per_s=self.max_linear_m_per_s,
            max_angular_rad_per_s=self.max_angular_rad_per_s,
            linear_acceleration_m_per_s2=self.linear_acceleration_m_per_s2,
            angular_acceleration_rad_per_s2=self.angular_acceleration_rad_per_s2,
            command_timeout_s=self.command_timeout_s,
            velocity_noise=self.velocity_noise,
        )

    @property
    def start(self) -> Pose:
        """The first pose."""
        return Pose(x_m=self.start_x_m, y_m=self.start_y_m, yaw_rad=self.start_yaw_rad)


def tf_name(frame: str) -> str:
    """Return the name of a frame of this robot: behind the searched parameter ``tf_prefix``, if there is one."""
    parameter_name = rospy.search_param("tf_prefix")
    prefix = str(rospy.get_param(parameter_name, "")).strip("/") if parameter_name else ""
    return f"{prefix}/{frame}" if prefix and not frame.startswith("/") else frame


def quaternion_of_yaw(yaw_rad: float) -> Quaternion:
    """Return the rotation about the vertical axis."""
    return Quaternion(z=math.sin(yaw_rad / 2.0), w=math.cos(yaw_rad / 2.0))


class RosBase:
    """The base, its command topic, and its odometry.

    Subscribes:
        the command topic (geometry_msgs/Twist): linear.x in m/s and angular.z in rad/s are used, the rest is ignored
    Publishes:
        the odometry topic (nav_msgs/Odometry), ``/tf`` from the odometry frame to the base frame
    """

    def __init__(
        self, settings: BaseSettings, *, base: DifferentialBase, command_topic: str, odometry_topic: str = "odom"
    ) -> None:
        self._settings = settings
        self._base = base
        self._lock = threading.Lock()
        self._odom = rospy.Publisher(odometry_topic, Odometry, queue_size=10)
        self._tf = tf2_ros.TransformBroadcaster()
        self._subscriber = rospy.Subscriber(command_topic, Twist, self._take_command, queue_size=1, tcp_nodelay=True)

    @property
    def pose(self) -> Pose:
        """The pose of the base in the odometry frame."""
        with self._lock:
            return self._base.pose

    def _take_command(self, message: Twist) -> None:
        with self._lock:
            is_driven = self._base.command(
                Velocity(linear_m_per_s=message.linear.x, angular_rad_per_s=message.angular.z)
            )
        if not is_driven:
            rospy.logerr_throttle(1.0, "velocity command that is not finite: the base stops")

    def step(self, duration_s: float, stamp: rospy.Time) -> None:
        """Advance the time, and publish the pose of the base."""
        with self._lock:
            self._base.step(duration_s)
            pose, velocity = self._base.pose, self._base.velocity
        frames = self._settings.odom_frame, self._settings.base_frame
        odometry, transform = base_messages(pose, velocity, frames=frames, stamp=stamp)
        publish(self._odom, odometry)
        publish_transform(self._tf, transform)


def base_messages(
    pose: Pose, velocity: Velocity, *, frames: Tuple[str, str], stamp: rospy.Time
) -> Tuple[Odometry, TransformStamped]:
    """Return how a base tells where it is and how it moves.

    Args:
        pose: in the odometry frame
        velocity: of the base
        frames: the odometry frame, and that of the base
        stamp: of both messages
    """
    odometry = Odometry(child_frame_id=frames[1])
    odometry.header.frame_id, odometry.header.stamp = frames[0], stamp
    odometry.pose.pose.position.x, odometry.pose.pose.position.y = pose.x_m, pose.y_m
    odometry.pose.pose.orientation = quaternion_of_yaw(pose.yaw_rad)
    odometry.twist.twist.linear.x = velocity.linear_m_per_s
    odometry.twist.twist.angular.z = velocity.angular_rad_per_s
    transform = TransformStamped(header=odometry.header, child_frame_id=frames[1])
    transform.transform.translation.x, transform.transform.translation.y = pose.x_m, pose.y_m
    transform.transform.rotation = odometry.pose.pose.orientation
    return odometry, transform


def publish_transform(broadcaster: tf2_ros.TransformBroadcaster, transform: TransformStamped) -> None:
    """Send a transform; a topic that closes because the node shuts down is not an error."""
    try:
        broadcaster.sendTransform(transform)
    except rospy.ROSException:
        if not is_shutting_down():
            raise
