#!/usr/bin/python3
"""Parts of a robot, each a node of its own: ``robot_parts.py PART``. All but ``sound_base`` are wrong."""

import sys
from typing import Any, Callable, Dict, List

import actionlib
import rosgraph
import rospy
from actionlib_tutorials.msg import FibonacciAction
from geometry_msgs.msg import PoseWithCovarianceStamped, TransformStamped, Twist, TwistStamped
from move_base_msgs.msg import MoveBaseAction
from nav_msgs.msg import Odometry
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import BatteryState, LaserScan
from tf2_msgs.msg import TFMessage

PERIOD_S = 0.1
LATE_S = 60.0
#: What a part publishes in each period.
Published = Callable[[], None]


def serve(name: str, action: Any) -> None:
    server = actionlib.SimpleActionServer(name, action, lambda _goal: server.set_succeeded(), auto_start=False)
    server.start()


def odometry(late_s: float) -> Published:
    publisher = rospy.Publisher("odom", Odometry, queue_size=1)

    def publish() -> None:
        message = Odometry(child_frame_id="base_link")
        message.header.frame_id, message.header.stamp = "odom", rospy.Time.now() - rospy.Duration(late_s)
        message.pose.pose.orientation.w = 1.0
        publisher.publish(message)

    return publish


def transforms(*links: str) -> Published:
    publisher = rospy.Publisher("/tf", TFMessage, queue_size=10)

    def publish() -> None:
        message = TFMessage()
        for link in links:
            parent, child = link.split(">")
            one = TransformStamped(child_frame_id=child)
            one.header.frame_id, one.header.stamp, one.transform.rotation.w = parent, rospy.Time.now(), 1.0
            message.transforms.append(one)
        publisher.publish(message)

    return publish


def sound_base() -> List[Published]:
    """What a robot needs."""
    rospy.Subscriber("cmd_vel", Twist, lambda _message: None)
    pose = PoseWithCovarianceStamped()
    pose.header.frame_id, pose.header.stamp, pose.pose.pose.orientation.w = "map", rospy.Time.now(), 1.0
    rospy.Publisher("amcl_pose", PoseWithCovarianceStamped, queue_size=1, latch=True).publish(pose)
    rospy.Publisher("scan", LaserScan, queue_size=1)
    rospy.Publisher("battery_state", BatteryState, queue_size=1)
    serve("move_base", MoveBaseAction)
    return [odometry(0.0), transforms("map>odom", "odom>base_link")]


def wrong_base() -> List[Published]:
    """Hears stamped velocities, has a clock that is late, knows no pose, and has an arm that no stop cancels."""
    rospy.Subscriber("cmd_vel", TwistStamped, lambda _message: None)
    rospy.Publisher("amcl_pose", PoseWithCovarianceStamped, queue_size=1)
    serve("arm_controller", FibonacciAction)
    return [odometry(LATE_S), transforms("odom>base_link")]


def planner() -> List[Published]:
    """Drives wheels where no stop reaches it, and has a clock of its own."""
    velocities = rospy.Publisher("nav_vel", Twist, queue_size=1)
    rospy.Publisher("/clock", Clock, queue_size=1)
    return [lambda: velocities.publish(Twist())]


def wheels() -> List[Published]:
    """Is driven by the planner, and publishes what another node publishes."""
    rospy.Subscriber("nav_vel", Twist, lambda _message: None)
    return [transforms("laser>base_link")]


def turtlebot_sim() -> List[Published]:
    """A simulated robot that was left running, and a node whose machine is gone."""
    rospy.Subscriber("cmd_vel", Twist, lambda _message: None)
    rosgraph.Master("/lost_camera").registerPublisher("/image", "sensor_msgs/Image", "http://camera.invalid:40000/")
    return []


PARTS: Dict[str, Callable[[], List[Published]]] = {
    one.__name__: one for one in (sound_base, wrong_base, planner, wheels, turtlebot_sim)
}


if __name__ == "__main__":
    rospy.init_node(sys.argv[1])
    published = PARTS[sys.argv[1]]()
    while not rospy.is_shutdown():
        for publish_one in published:
            publish_one()
        rospy.sleep(PERIOD_S)
