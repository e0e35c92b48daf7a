"""The node turtlebot_sim: a Turtlebot on the topics of the real one."""
import rospy

from roboframenet_sim.base import DifferentialBase
from roboframenet_sim.ros_base import BaseSettings, RosBase, read_base_settings
from roboframenet_sim.ros_stepping import Stepper, read_stepping_settings


class TurtlebotSim:
    """A Turtlebot.

    Subscribes:
        ``cmd_vel`` (geometry_msgs/Twist)
    Publishes:
        ``odom`` (nav_msgs/Odometry), ``/tf``; ``/clock`` under /use_sim_time
    """

    def __init__(self, settings: BaseSettings) -> None:
        base = DifferentialBase(settings.limits, pose=settings.start, seed=settings.seed)
        self._base = RosBase(settings, base=base, command_topic="cmd_vel")

    def step(self, duration_s: float, stamp: rospy.Time) -> None:
        """Let time pass."""
        self._base.step(duration_s, stamp)


def main() -> None:
    """Run the node until it is shut down."""
    rospy.init_node("turtlebot_sim")
    base_settings = read_base_settings(base_frame="base_link")
    stepping_settings = read_stepping_settings(rate_hz=50.0)
    rospy.loginfo("%s %s", base_settings, stepping_settings)
    Stepper(stepping_settings, step=TurtlebotSim(base_settings).step).run()
