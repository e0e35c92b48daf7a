"""The topics of a simulated base: takes velocity commands, publishes odometry and tf."""

import math
import threading
from dataclasses import dataclass

import rospy
import tf2_ros
from geometry_msgs.msg import Quaternion, TransformStamped, Twist
from nav_msgs.msg import Odometry

from roboframenet_sim.base import BaseLimits, DifferentialBase, Pose, Velocity
from roboframenet_sim.ros_stepping import publish


@dataclass(frozen=True)
class BaseSettings:
    """First pose of the base, and the names of its frames.

    Raises:
        ValueError: the first pose is not finite, or a frame name is empty
    """

    limits: BaseLimits
    start: Pose
    seed: int
    odom_frame: str
    base_frame: str

    def __post_init__(self) -> None:
        for name, value in (
            ("start_x_m", self.start.x_m),
            ("start_y_m", self.start.y_m),
            ("start_yaw_rad", self.start.yaw_rad),
        ):
            if not (isinstance(value, (int, float)) and math.isfinite(value)):
                raise ValueError(f"~{name} must be a finite number, got {value!r}")
        if not (self.odom_frame and self.base_frame):
            raise ValueError("~odom_frame and ~base_frame must not be empty")


def read_base_settings(*, base_frame: str) -> BaseSettings:
    """Read the parameters of the base.

    Args:
        base_frame: the default of ~base_frame
    """
    return BaseSettings(
        limits=BaseLimits(
            max_linear_m_per_s=rospy.get_param("~max_linear_m_per_s", BaseLimits.max_linear_m_per_s),
            max_angular_rad_per_s=rospy.get_param("~max_angular_rad_per_s", BaseLimits.max_angular_rad_per_s),
            linear_acceleration_m_per_s2=rospy.get_param(
                "~linear_acceleration_m_per_s2", BaseLimits.linear_acceleration_m_per_s2
            ),
            angular_acceleration_rad_per_s2=rospy.get_param(
                "~angular_acceleration_rad_per_s2", BaseLimits.angular_acceleration_rad_per_s2
            ),
            command_timeout_s=rospy.get_param("~command_timeout_s", BaseLimits.command_timeout_s),
            velocity_noise=rospy.get_param("~velocity_noise", BaseLimits.velocity_noise),
        ),
        start=Pose(
            x_m=rospy.get_param("~start_x_m", 0.0),
            y_m=rospy.get_param("~start_y_m", 0.0),
            yaw_rad=rospy.get_param("~start_yaw_rad", 0.0),
        ),
        seed=int(rospy.get_param("~seed", 0)),
        odom_frame=str(rospy.get_param("~odom_frame", "odom")),
        base_frame=str(rospy.get_param("~base_frame", base_frame)),
    )


def quaternion_of_yaw(yaw_rad: float) -> Quaternion:
    """Return the rotation about the vertical axis."""
    return Quaternion(z=math.sin(yaw_rad / 2.0), w=math.cos(yaw_rad / 2.0))


class RosBase:
    """The base, its command topic, and its odometry.

    Subscribes:
        the command topic (geometry_msgs/Twist): linear.x in m/s and angular.z in rad/s are used, the rest is ignored
    Publishes:
        ``odom`` (nav_msgs/Odometry), ``/tf`` from the odometry frame to the base frame
    """

    def __init__(self, settings: BaseSettings, *, base: DifferentialBase, command_topic: str) -> None:
        self._settings = settings
        self._base = base
        self._lock = threading.Lock()
        self._odom = rospy.Publisher("odom", Odometry, queue_size=10)
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
        rotation = quaternion_of_yaw(pose.yaw_rad)
        odometry = Odometry()
        odometry.header.stamp = stamp
        odometry.header.frame_id = self._settings.odom_frame
        odometry.child_frame_id = self._settings.base_frame
        odometry.pose.pose.position.x, odometry.pose.pose.position.y = pose.x_m, pose.y_m
        odometry.pose.pose.orientation = rotation
        odometry.twist.twist.linear.x = velocity.linear_m_per_s
        odometry.twist.twist.angular.z = velocity.angular_rad_per_s
        publish(self._odom, odometry)
        transform = TransformStamped()
        transform.header = odometry.header
        transform.child_frame_id = self._settings.base_frame
        transform.transform.translation.x, transform.transform.translation.y = pose.x_m, pose.y_m
        transform.transform.rotation = rotation
        publish_transform(self._tf, transform)


def publish_transform(broadcaster: tf2_ros.TransformBroadcaster, transform: TransformStamped) -> None:
    """Send a transform; a topic that closes because the node shuts down is not an error."""
    try:
        broadcaster.sendTransform(transform)
    except rospy.ROSException:
        if not rospy.is_shutdown():
            raise
