"""The node turtle_sim: a turtle on the topics of turtlesim_node, without its window."""

import threading
from typing import Tuple

import rospy
from geometry_msgs.msg import Twist
from turtlesim.msg import Pose
from turtlesim.srv import TeleportAbsolute, TeleportAbsoluteRequest, TeleportAbsoluteResponse

from roboframenet_ros.ros_node import read_parameters, run_node
from roboframenet_ros.ros_publishing import publish
from roboframenet_sim.ros_stepping import Stepper, SteppingSettings
from roboframenet_sim.turtle import Turtle


class TurtleSim:
    """One turtle.

    Subscribes:
        ``turtle1/cmd_vel`` (geometry_msgs/Twist)
    Publishes:
        ``turtle1/pose`` (turtlesim/Pose); ``/clock`` under /use_sim_time
    Services:
        ``turtle1/teleport_absolute`` (turtlesim/TeleportAbsolute)
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._turtle = Turtle()
        self._pose = rospy.Publisher("turtle1/pose", Pose, queue_size=1)
        self._subscriber = rospy.Subscriber("turtle1/cmd_vel", Twist, self._on_velocity, queue_size=1)
        self._service = rospy.Service("turtle1/teleport_absolute", TeleportAbsolute, self._on_teleport)

    def _on_velocity(self, message: Twist) -> None:
        with self._lock:
            self._turtle.drive(message.linear.x, message.angular.z)

    def _on_teleport(self, request: TeleportAbsoluteRequest) -> TeleportAbsoluteResponse:
        with self._lock:
            self._turtle.put(request.x, request.y, request.theta)
        return TeleportAbsoluteResponse()

    def step(self, duration_s: float, _stamp: rospy.Time) -> None:
        """Advance the time."""
        with self._lock:
            turtle = self._turtle
            turtle.step(duration_s)
            values = (turtle.x_m, turtle.y_m, turtle.yaw_rad, turtle.linear_m_per_s, turtle.angular_rad_per_s)
        publish(self._pose, Pose(*values))


def _start() -> Tuple[TurtleSim, Stepper]:
    sim = TurtleSim()
    stepper = Stepper(read_parameters(SteppingSettings), step=sim.step)
    stepper.start()
    return sim, stepper


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    run_node("turtle_sim", _start)
