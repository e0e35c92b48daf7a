"""The node turtlebot_sim: a Turtlebot on the topics of the real one."""

import rospy

from roboframenet_sim.base import DifferentialBase
from roboframenet_sim.occupancy_grid import grid_of_room
from roboframenet_sim.person import Person
from roboframenet_sim.point_cloud import NO_WALLS
from roboframenet_sim.room import load_room_file
from roboframenet_sim.ros_base import RosBase, read_base_settings
from roboframenet_sim.ros_camera import RosPerson, read_camera_settings, read_person_settings
from roboframenet_sim.ros_stepping import Stepper, read_stepping_settings

ROBOT_RADIUS_M = 0.18
"""Radius of the Turtlebot's base: it cannot get nearer to a wall."""


class TurtlebotSim:
    """A Turtlebot, and optionally a person in front of it.

    Subscribes:
        ``cmd_vel`` (geometry_msgs/Twist), ``person/act`` (std_msgs/String)
    Publishes:
        ``odom`` (nav_msgs/Odometry), ``/tf``, ``camera/depth/points`` (sensor_msgs/PointCloud2),
        ``person/pose`` (geometry_msgs/PoseStamped), ``person/marker`` (visualization_msgs/Marker);
        ``/clock`` under /use_sim_time
    """

    def __init__(self) -> None:
        settings = read_base_settings(base_frame="base_link")
        camera_settings, person_settings = read_camera_settings(), read_person_settings()
        room_path, is_person = str(rospy.get_param("~room", "")), bool(rospy.get_param("~person", False))
        rospy.loginfo("%s %s %s room=%r person=%r", settings, camera_settings, person_settings, room_path, is_person)
        is_free, walls = None, NO_WALLS
        if room_path:
            room = load_room_file(room_path)
            is_free, walls = grid_of_room(room).inflated(ROBOT_RADIUS_M).is_free, room.all_walls()
        base = DifferentialBase(settings.limits, pose=settings.start, seed=settings.seed, is_free=is_free)
        self._base = RosBase(settings, base=base, command_topic="cmd_vel")
        self._person = RosPerson(
            camera_settings,
            person=Person(person_settings, robot=settings.start) if is_person else None,
            fixed_frame=settings.odom_frame,
            robot=settings.start,
            walls=walls,
        )

    def step(self, duration_s: float, stamp: rospy.Time) -> None:
        """Advance the time."""
        self._base.step(duration_s, stamp)
        self._person.step(duration_s, stamp, robot=self._base.pose)


def main() -> None:
    """Run the node until it is shut down."""
    rospy.init_node("turtlebot_sim")
    stepping_settings = read_stepping_settings(rate_hz=50.0)
    rospy.loginfo("%s", stepping_settings)
    Stepper(stepping_settings, step=TurtlebotSim().step).run()
