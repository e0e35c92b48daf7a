"""The node turtlebot_sim: a Turtlebot on the topics of the real one."""

from dataclasses import replace

import rospy

from roboframenet_ros.ros_node import read_parameters, run_node
from roboframenet_ros.ros_place import Place
from roboframenet_sim.base import DifferentialBase
from roboframenet_sim.occupancy_grid import grid_of_room
from roboframenet_sim.person import Person
from roboframenet_sim.point_cloud import NO_WALLS
from roboframenet_sim.room import load_room_file
from roboframenet_sim.ros_base import BaseSettings, RosBase, tf_name
from roboframenet_sim.ros_camera import CameraSettings, RosPerson
from roboframenet_sim.ros_sensors import RosBattery, RosLaser
from roboframenet_sim.ros_stepping import Stepper, SteppingSettings

ROBOT_RADIUS_M = 0.18
"""Radius of the Turtlebot's base: it cannot get nearer to a wall."""

_CHARGE = 0.8
"""First charge of the battery."""


class TurtlebotSim:
    """A Turtlebot, and optionally a person in front of it.

    Subscribes:
        ``cmd_vel`` (geometry_msgs/Twist), ``person/act`` (std_msgs/String), ``battery/charge`` (std_msgs/Float32)
    Publishes:
        ``odom`` (nav_msgs/Odometry), ``/tf``, ``camera/depth/points`` (sensor_msgs/PointCloud2),
        ``person/pose`` (geometry_msgs/PoseStamped), ``person/marker`` (visualization_msgs/Marker),
        ``scan`` (sensor_msgs/LaserScan), ``battery_state`` (sensor_msgs/BatteryState);
        ``/clock`` under /use_sim_time
    """

    def __init__(self, *, private: str = "~") -> None:
        settings = read_parameters(BaseSettings, prefix=private)
        camera_settings = read_parameters(CameraSettings, prefix=private)
        settings = replace(settings, odom_frame=tf_name(settings.odom_frame), base_frame=tf_name(settings.base_frame))
        camera_settings = replace(camera_settings, camera_frame=tf_name(camera_settings.camera_frame))
        rospy.loginfo("%s %s", settings, camera_settings)
        is_free, walls = None, NO_WALLS
        if settings.room:
            room = load_room_file(settings.room)
            is_free, walls = grid_of_room(room).inflated(ROBOT_RADIUS_M).is_free, room.all_walls()
        base = DifferentialBase(settings.limits, pose=settings.start, seed=settings.seed, is_free=is_free)
        self._base = RosBase(settings, base=base, command_topic="cmd_vel")
        self._person = RosPerson(
            camera_settings,
            person=Person(camera_settings.walk, robot=settings.start) if camera_settings.person else None,
            fixed_frame=settings.odom_frame,
            robot=settings.start,
            walls=walls,
        )
        self._laser = RosLaser(lambda: (walls, self._person.bodies()), frame=settings.base_frame)
        self._battery = RosBattery(_CHARGE)

    def step(self, duration_s: float, stamp: rospy.Time) -> None:
        """Advance the time."""
        self._base.step(duration_s, stamp)
        self._person.step(duration_s, stamp, robot=self._base.pose)
        self._laser.step(duration_s, stamp, robot=self._base.pose)
        self._battery.step(duration_s, stamp)


def start(place: Place) -> Stepper:
    """Start the simulation, as a node or with others in one process.

    Raises:
        ParameterError: a parameter is wrong
    """
    settings = read_parameters(SteppingSettings, prefix=place.private)
    rospy.loginfo("%s", settings)
    stepper = Stepper(settings, step=TurtlebotSim(private=place.private).step)
    stepper.start()
    return stepper


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    run_node("turtlebot_sim", lambda: start(Place()))
