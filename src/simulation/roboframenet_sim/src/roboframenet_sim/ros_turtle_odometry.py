"""The node turtle_odometry: the pose of a turtle of turtlesim as the odometry of a base."""

import math

import rospy
import tf2_ros
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import Odometry
from turtlesim.msg import Pose

from roboframenet_ros.ros_node import run_node
from roboframenet_ros.ros_publishing import publish
from roboframenet_sim.ros_base import quaternion_of_yaw

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
        odometry = Odometry(child_frame_id=BASE_FRAME)
        odometry.header.frame_id, odometry.header.stamp = ODOM_FRAME, rospy.Time.now()
        odometry.pose.pose.position.x, odometry.pose.pose.position.y = pose.x, pose.y
        odometry.pose.pose.orientation = quaternion_of_yaw(pose.theta)
        odometry.twist.twist.linear.x, odometry.twist.twist.angular.z = pose.linear_velocity, pose.angular_velocity
        publish(self._odometry, odometry)
        transform = TransformStamped(header=odometry.header, child_frame_id=BASE_FRAME)
        transform.transform.translation.x, transform.transform.translation.y = pose.x, pose.y
        transform.transform.rotation = odometry.pose.pose.orientation
        try:
            self._transforms.sendTransform(transform)
        except rospy.ROSException:
            # The topic has been closed: ROS shuts down.
            return


def main() -> None:
    """Run the node until ROS shuts down."""
    run_node("turtle_odometry", TurtleOdometry)
