"""The node move_base_sim: navigation on the floor plan of a room, with the action and topics of move_base and amcl."""

import math
import os
import threading
import time
from dataclasses import dataclass
from typing import List, Optional, Tuple

import actionlib
import numpy as np
import rospkg
import rospy
import tf2_ros
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped, Quaternion, TransformStamped, Twist
from move_base_msgs.msg import MoveBaseAction, MoveBaseFeedback
from nav_msgs.msg import OccupancyGrid as OccupancyGridMessage
from nav_msgs.msg import Odometry, Path
from std_msgs.msg import Header

from roboframenet_ros.parameters import Parameters, parameter
from roboframenet_ros.pausable_clock import PausableClock
from roboframenet_ros.ros_node import read_parameters, run_node
from roboframenet_ros.ros_publishing import publish
from roboframenet_sim.base import STANDING, Pose, Velocity
from roboframenet_sim.occupancy_grid import OccupancyGrid, grid_of_room
from roboframenet_sim.path_following import FollowingLimits, PathFollower
from roboframenet_sim.planner import NoPath, plan
from roboframenet_sim.room import load_room_file
from roboframenet_sim.ros_base import quaternion_of_yaw
from roboframenet_sim.ros_stepping import start_loop


@dataclass(frozen=True)
class NavigationSettings(Parameters):
    """Private parameters, checked.

    Attributes:
        room: path of the floor plan; empty for ``config/room.yaml`` of the package
        map_frame: name of the frame of the map
        inflation_radius_m: distance that the centre of the robot keeps from every obstacle
        odometry_timeout_s: after this time without odometry the goal is aborted
        stuck_timeout_s: after this time without motion the robot is stuck
        linear_speed_m_per_s: speed
        angular_speed_rad_per_s: turn rate

    Raises:
        ParameterError: a value out of its range
    """

    room: str = parameter("")
    map_frame: str = parameter("map")
    inflation_radius_m: float = parameter(0.4, least=0.0, most=2.0)
    odometry_timeout_s: float = parameter(1.0, least=0.1, most=60.0)
    stuck_timeout_s: float = parameter(10.0, least=0.5, most=600.0)
    linear_speed_m_per_s: float = parameter(FollowingLimits.linear_m_per_s, above=0.0)
    angular_speed_rad_per_s: float = parameter(FollowingLimits.angular_rad_per_s, above=0.0)

    @property
    def limits(self) -> FollowingLimits:
        """How the robot drives."""
        return FollowingLimits(linear_m_per_s=self.linear_speed_m_per_s, angular_rad_per_s=self.angular_speed_rad_per_s)


class BadPose(ValueError):
    """The pose is not usable; the message is the reason."""


def yaw_of(rotation: Quaternion) -> float:
    """Return the direction of a robot on the floor.

    Raises:
        BadPose: the orientation is not a rotation, or not about the vertical axis
    """
    length = math.sqrt(rotation.x**2 + rotation.y**2 + rotation.z**2 + rotation.w**2)
    if not 0.9 < length < 1.1:
        raise BadPose(f"the orientation is not a rotation: its quaternion has length {length:.3g}")
    if math.hypot(rotation.x, rotation.y) > 0.05:
        raise BadPose("the orientation is not about the vertical axis")
    return 2.0 * math.atan2(rotation.z, rotation.w)


def message_of_grid(grid: OccupancyGrid, *, header: Header) -> OccupancyGridMessage:
    """Pack a grid as a map: 100 is occupied, 0 is free."""
    message = OccupancyGridMessage(header=header)
    message.info.map_load_time = header.stamp
    message.info.resolution = grid.resolution_m
    message.info.height, message.info.width = grid.is_taken.shape
    message.info.origin.position.x, message.info.origin.position.y = grid.origin_x_m, grid.origin_y_m
    message.info.origin.orientation.w = 1.0
    message.data = (grid.is_taken.ravel() * np.int8(100)).tolist()
    return message


class MoveBaseSim:
    """Plans on the map and drives there.

    The odometry of the simulated robots is exact and starts at their pose in the map, so map and odometry frame are the
    same.

    Subscribes:
        ``odom`` (nav_msgs/Odometry)
    Publishes:
        ``cmd_vel`` (geometry_msgs/Twist), only while a goal is active, and zero at its end; ``map``
        (nav_msgs/OccupancyGrid, latched); ``amcl_pose`` (geometry_msgs/PoseWithCovarianceStamped, latched); ``~plan``
        (nav_msgs/Path, latched); ``~current_goal`` (geometry_msgs/PoseStamped, latched); ``/tf_static``
    Actions:
        ``move_base`` (move_base_msgs/MoveBaseAction)
    """

    WAIT_S = 0.1
    POSE_PERIOD_S = 0.2
    STUCK_M = 0.03
    STUCK_RAD = 0.1

    def __init__(self, settings: NavigationSettings) -> None:
        self._settings = settings
        grid = grid_of_room(
            load_room_file(
                settings.room or os.path.join(rospkg.RosPack().get_path("roboframenet_sim"), "config", "room.yaml")
            )
        )
        self._floor = grid.inflated(settings.inflation_radius_m)
        self._condition = threading.Condition()
        self._is_ending = threading.Event()
        self._odometry: Optional[Tuple[Pose, str]] = None
        self._is_new = False
        self._seen_s = -math.inf
        self._follower: Optional[PathFollower] = None
        self._mark: Tuple[Pose, float] = (Pose(), 0.0)
        self._pose_sent_s = -math.inf
        self._tf = tf2_ros.StaticTransformBroadcaster()
        self._joined_frame = ""
        self._velocity = rospy.Publisher("cmd_vel", Twist, queue_size=1)
        self._map = rospy.Publisher("map", OccupancyGridMessage, queue_size=1, latch=True)
        self._amcl_pose = rospy.Publisher("amcl_pose", PoseWithCovarianceStamped, queue_size=1, latch=True)
        self._plan = rospy.Publisher("~plan", Path, queue_size=1, latch=True)
        self._goal = rospy.Publisher("~current_goal", PoseStamped, queue_size=1, latch=True)
        publish(self._map, message_of_grid(grid, header=self._header()))
        self._subscriber = rospy.Subscriber("odom", Odometry, self._take_odometry, queue_size=1, tcp_nodelay=True)
        self._server = actionlib.SimpleActionServer("move_base", MoveBaseAction, auto_start=False)
        self._server.start()
        rospy.on_shutdown(self._shut_down)

    def _header(self) -> Header:
        return Header(stamp=rospy.Time.now(), frame_id=self._settings.map_frame)

    def _take_odometry(self, message: Odometry) -> None:
        position = message.pose.pose.position
        try:
            pose = Pose(x_m=position.x, y_m=position.y, yaw_rad=yaw_of(message.pose.pose.orientation))
        except BadPose as error:
            rospy.logerr_throttle(1.0, "odometry: %s", error)
            return
        if not (math.isfinite(pose.x_m) and math.isfinite(pose.y_m)):
            rospy.logerr_throttle(1.0, "odometry is not finite")
            return
        with self._condition:
            self._odometry = (pose, message.header.frame_id)
            self._is_new = True
            self._condition.notify_all()

    def run(self) -> None:
        """Plan and drive until shutdown. This thread makes all decisions."""
        clock = PausableClock(
            ros_time_ns=lambda: rospy.Time.now().to_nsec(), is_simulated=not rospy.rostime.is_wallclock()
        )
        while not self._is_ending.is_set():
            with self._condition:
                if not self._is_new:
                    self._condition.wait(self.WAIT_S)
                is_new, self._is_new = self._is_new, False
                odometry = self._odometry
            now_s = clock.now_s()
            if is_new:
                self._seen_s = now_s
            if odometry is not None:
                self._publish_pose(*odometry, now_s)
            if self._server.is_new_goal_available():
                self._begin(self._server.accept_new_goal().target_pose, odometry, now_s)
            if self._server.is_active() and odometry is not None and self._follower is not None:
                self._drive(self._follower, odometry[0], now_s)

    def _publish_pose(self, pose: Pose, odom_frame: str, now_s: float) -> None:
        if odom_frame != self._joined_frame:
            self._joined_frame = odom_frame
            transform = TransformStamped(header=self._header(), child_frame_id=odom_frame)
            transform.transform.rotation.w = 1.0
            self._tf.sendTransform(transform)
        if now_s - self._pose_sent_s >= self.POSE_PERIOD_S:
            self._pose_sent_s = now_s
            message = PoseWithCovarianceStamped(header=self._header())
            message.pose.pose = self._stamped(pose).pose
            publish(self._amcl_pose, message)
            if self._server.is_active():
                self._server.publish_feedback(MoveBaseFeedback(base_position=self._stamped(pose)))

    def _stamped(self, pose: Pose) -> PoseStamped:
        message = PoseStamped(header=self._header())
        message.pose.position.x, message.pose.position.y = pose.x_m, pose.y_m
        message.pose.orientation = quaternion_of_yaw(pose.yaw_rad)
        return message

    def _begin(self, target: PoseStamped, odometry: Optional[Tuple[Pose, str]], now_s: float) -> None:
        """Plan. The base stands during planning."""
        self._follower = None
        self._publish_velocity(STANDING)
        try:
            if odometry is None or now_s - self._seen_s > self._settings.odometry_timeout_s:
                raise NoPath("no odometry: the robot does not know where it is")
            if target.header.frame_id not in ("", self._settings.map_frame, odometry[1]):
                raise NoPath(
                    f'a goal in the frame "{target.header.frame_id}" cannot be used, '
                    f'only in "{self._settings.map_frame}"'
                )
            yaw_rad = yaw_of(target.pose.orientation)
            corners = plan(
                self._floor,
                start=(odometry[0].x_m, odometry[0].y_m),
                goal=(target.pose.position.x, target.pose.position.y),
            )
        except (NoPath, BadPose) as error:
            rospy.logwarn("no plan: %s", error)
            self._server.set_aborted(text=str(error))
            return
        self._publish_plan(corners)
        publish(self._goal, self._stamped(Pose(corners[-1][0], corners[-1][1], yaw_rad)))
        self._mark = (odometry[0], now_s)
        self._follower = PathFollower(corners, yaw_rad=yaw_rad, limits=self._settings.limits)

    def _publish_plan(self, corners: List[Tuple[float, float]]) -> None:
        publish(self._plan, Path(header=self._header(), poses=[self._stamped(Pose(x, y)) for x, y in corners]))

    def _drive(self, follower: PathFollower, pose: Pose, now_s: float) -> None:
        if self._server.is_preempt_requested():
            self._publish_velocity(STANDING)
            self._server.set_preempted(text="the base stands")
            return
        reason = self._trouble(pose, now_s)
        if reason:
            self._publish_velocity(STANDING)
            self._server.set_aborted(text=reason)
            return
        velocity = follower.command(pose)
        self._publish_velocity(velocity or STANDING)
        if velocity is None:
            self._server.set_succeeded(text="the goal is reached")

    def _trouble(self, pose: Pose, now_s: float) -> str:
        if now_s - self._seen_s > self._settings.odometry_timeout_s:
            return "odometry is lost"
        mark, mark_s = self._mark
        if (
            math.hypot(pose.x_m - mark.x_m, pose.y_m - mark.y_m) > self.STUCK_M
            or abs(math.remainder(pose.yaw_rad - mark.yaw_rad, 2.0 * math.pi)) > self.STUCK_RAD
        ):
            self._mark = (pose, now_s)
        elif now_s - mark_s > self._settings.stuck_timeout_s:
            return "the robot is stuck"
        return ""

    def _publish_velocity(self, velocity: Velocity) -> None:
        message = Twist()
        message.linear.x = velocity.linear_m_per_s
        message.angular.z = velocity.angular_rad_per_s
        publish(self._velocity, message)

    def _shut_down(self) -> None:
        # While this hook runs, is_shutdown() is still false. Nothing must drive the base after the zero below.
        self._is_ending.set()
        self._server.action_server.status_timer.shutdown()
        time.sleep(self.WAIT_S)
        if self._server.is_active():
            self._publish_velocity(STANDING)
            # A thread of the publisher sends queued messages; the topics close when this method returns.
            time.sleep(0.1)


def _start() -> MoveBaseSim:
    settings = read_parameters(NavigationSettings)
    rospy.loginfo("%s", settings)
    node = MoveBaseSim(settings)
    start_loop(node.run)
    return node


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    run_node("move_base_sim", _start)
