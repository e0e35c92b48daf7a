"""The node turtle_odometry: the pose of a turtle of turtlesim as the odometry of a base."""

import math

import rospy
import tf2_ros
from nav_msgs.msg import Odometry
from turtlesim.msg import Pose

from roboframenet_ros.ros_node import run_node
from roboframenet_ros.ros_publishing import publish
from roboframenet_sim.base import Pose as BasePose
from roboframenet_sim.base import Velocity
from roboframenet_sim.ros_base import base_messages, publish_transform

ODOM_FRAME, BASE_FRAME = "odom", "base_link"


class TurtleOdometry:
    """Tells where the turtle is.

    Subscribes:
        ``turtle1/pose`` (turtlesim/Pose)
    Publishes:
        ``odom`` (nav_msgs/Odometry), ``/tf``
    """

    def __init__(self) -> None:
        self._odometry = rospy.Publisher("odom", Odometry, queue_size=10)
        self._transforms = tf2_ros.TransformBroadcaster()
        self._subscriber = rospy.Subscriber("turtle1/pose", Pose, self._on_pose, queue_size=1)

    def _on_pose(self, pose: Pose) -> None:
        if not all(map(math.isfinite, (pose.x, pose.y, pose.theta, pose.linear_velocity, pose.angular_velocity))):
            rospy.logwarn_throttle(10.0, "a pose of the turtle that is no number is dropped")
            return
        odometry, transform = base_messages(
            BasePose(x_m=pose.x, y_m=pose.y, yaw_rad=pose.theta),
            Velocity(linear_m_per_s=pose.linear_velocity, angular_rad_per_s=pose.angular_velocity),
            frames=(ODOM_FRAME, BASE_FRAME),
            stamp=rospy.Time.now(),
        )
        publish(self._odometry, odometry)
        publish_transform(self._transforms, transform)


def main() -> None:
    """Run the node until ROS shuts down."""
    run_node("turtle_odometry", TurtleOdometry)
