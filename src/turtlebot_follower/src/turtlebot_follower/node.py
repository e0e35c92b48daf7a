"""The node turtlebot_follower: "Follow me." as an RFNServer."""

import enum
import math
import threading
import time
from dataclasses import dataclass
from typing import Any, Optional, Tuple, Union

import rospy
from dynamic_reconfigure.server import Server as ReconfigureServer
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from roboframenet_msgs.msg import FilledSemanticFrame, FilledSemanticFrameFeedback, FilledSemanticFrameResult
from sensor_msgs.msg import PointCloud2

from rfnserver import RFNServer
from roboframenet_ros.parameters import ParameterError, Parameters, parameter
from roboframenet_ros.ros_node import read_parameters, run_node
from roboframenet_ros.ros_place import Place
from roboframenet_ros.ros_publishing import publish
from turtlebot_follower.centroid import Box, Centroid, CloudError, centroid, points_of
from turtlebot_follower.cfg import FollowerConfig
from turtlebot_follower.following import Follower, FollowingSettings, FollowingStep, Sight
from turtlebot_follower.ros_other_followers import FollowerError, LaunchFollower, ServiceFollower

FRAME_NAME = "following"


class Mode(enum.Enum):
    """Which follower is used: this node, a service, or a launch file."""

    OWN = "own"
    SERVICE = "service"
    LAUNCH = "launch"


@dataclass(frozen=True)
class Settings(Parameters):
    """Private parameters, checked; they do not change while the node runs.

    Attributes:
        mode: which follower is used
        launchfile: path of the launch file in the mode launch
        service: name of the service in the mode service
        service_timeout_s: how long the service may take, and launched nodes to end
        pixel_step: only every n-th point of every n-th row is used
        odometry_timeout_s: older odometry is not used

    Raises:
        ParameterError: the mode is unknown, the launch file is missing, or a number is out of its range
    """

    mode: Mode = parameter(Mode.OWN)
    launchfile: str = parameter("")
    service: str = parameter("turtlebot_follower/change_state")
    service_timeout_s: float = parameter(2.0, least=0.1, most=60.0)
    pixel_step: int = parameter(2, least=1, most=32)
    odometry_timeout_s: float = parameter(0.5, least=0.1, most=60.0)

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.mode is Mode.LAUNCH and not self.launchfile:
            raise ParameterError("~mode launch needs ~launchfile")


@dataclass(frozen=True)
class Tuning:
    """Parameters that dynamic_reconfigure can change."""

    box: Box
    following: FollowingSettings
    min_share: float


def tuning_of(config: Any) -> Tuning:
    """Read a configuration of dynamic_reconfigure.

    Raises:
        ValueError: the box is empty
    """
    return Tuning(
        box=Box(
            min_x_m=config.min_x, max_x_m=config.max_x, min_y_m=config.min_y, max_y_m=config.max_y, max_z_m=config.max_z
        ),
        following=FollowingSettings(
            goal_z_m=config.goal_z,
            z_scale_per_s=config.z_scale,
            x_scale_rad_per_m_s=config.x_scale,
            speed_share=config.speed_share,
            max_linear_m_per_s=config.max_linear_m_per_s,
            max_angular_rad_per_s=config.max_angular_rad_per_s,
            lost_timeout_s=config.lost_timeout_s,
        ),
        min_share=config.min_share,
    )


@dataclass(frozen=True)
class Picture:
    """The person in a point cloud, if any, and the time of the cloud."""

    person: Optional[Centroid]
    stamp_s: float
    number: int


class TurtlebotFollower:
    """Follows the person in front of the robot while the goal is active.

    Subscribes:
        ``camera/depth/points`` (sensor_msgs/PointCloud2) and ``odom`` (nav_msgs/Odometry), only while following
    Publishes:
        ``cmd_vel`` (geometry_msgs/Twist), only while following, and zero at the end
    Actions:
        ``following`` (roboframenet_msgs/FilledSemanticFrameAction)
    """

    WAIT_S = 0.1
    FEEDBACK_S = 0.5
    FLUSH_S = 0.1
    CLOUD_BUFFER_BYTES = 1 << 24
    """A cloud of 640x480 has five megabytes, and is read at once."""

    def __init__(self, settings: Settings, *, namespace: str = "") -> None:
        self._settings = settings
        self._condition = threading.Condition()
        self._picture: Optional[Picture] = None
        self._driven: Tuple[float, float] = (0.0, -math.inf)
        self._tuning: Optional[Tuning] = None
        self._configuration: Any = None
        self._is_ending = threading.Event()
        self._idle = threading.Event()
        self._idle.set()
        self._velocity = rospy.Publisher("cmd_vel", Twist, queue_size=1, tcp_nodelay=True)
        self._reconfigure = ReconfigureServer(FollowerConfig, self._take_tuning, namespace)
        # The camera shows that somebody is there, and not who, where from or where to.
        self._server = RFNServer(
            FRAME_NAME,
            self._follow,
            heeds={"cotheme": ["me"]},
            unheeded=["goal", "source", "path", "manner", "area"],
            occupies=["base"],
        )
        self._server.register_preempt_callback(self._wake)
        rospy.on_shutdown(self._shut_down)

    def start(self) -> None:
        """Offer the server, and register it with its frame."""
        self._server.register_with_frame(FRAME_NAME)
        self._server.start()

    def _take_tuning(self, config: Any, _level: int) -> Any:
        try:
            tuning = tuning_of(config)
        except ValueError as error:
            if self._tuning is None:
                raise
            rospy.logerr("parameters unchanged: %s", error)
            return self._configuration
        self._configuration = config
        self._tuning = tuning
        rospy.loginfo("%s", tuning)
        return config

    def _wake(self) -> None:
        with self._condition:
            self._condition.notify_all()

    def _shut_down(self) -> None:
        # While this hook runs, is_shutdown() is still false: topics and services can be used.
        self._is_ending.set()
        self._wake()
        # The thread of the goal stops the robot; a thread of the publisher sends queued messages.
        self._idle.wait(2.0 * self._settings.service_timeout_s)
        time.sleep(self.FLUSH_S)

    def _publish(self, step: FollowingStep) -> None:
        message = Twist()
        message.linear.x = step.linear_m_per_s
        message.angular.z = step.angular_rad_per_s
        publish(self._velocity, message)

    def _take_cloud(self, message: PointCloud2) -> None:
        tuning = self._tuning
        try:
            points = points_of(
                message.data,
                height=message.height,
                width=message.width,
                point_step=message.point_step,
                row_step=message.row_step,
                is_bigendian=bool(message.is_bigendian),
                offsets={field.name: field.offset for field in message.fields},
                datatypes={field.name: field.datatype for field in message.fields},
                pixel_step=self._settings.pixel_step,
            )
        except CloudError as error:
            rospy.logerr_throttle(5.0, "%s", error)
            return
        person = centroid(points, box=tuning.box, min_share=tuning.min_share) if tuning else None
        with self._condition:
            number = self._picture.number + 1 if self._picture else 1
            self._picture = Picture(person=person, stamp_s=message.header.stamp.to_sec(), number=number)
            self._condition.notify_all()

    def _take_odometry(self, message: Odometry) -> None:
        self._driven = (message.twist.twist.linear.x, time.monotonic())

    def _follow(self, _frame: FilledSemanticFrame) -> None:
        """Follow until the goal is preempted or the person is lost."""
        self._idle.clear()
        try:
            if self._settings.mode is Mode.OWN:
                problem = self._follow_oneself()
            elif self._settings.mode is Mode.SERVICE:
                problem = self._let_follow(
                    ServiceFollower(self._settings.service, timeout_s=self._settings.service_timeout_s)
                )
            else:
                problem = self._let_follow(
                    LaunchFollower(self._settings.launchfile, timeout_s=self._settings.service_timeout_s)
                )
        finally:
            self._publish(FollowingStep(0.0, 0.0, Sight.UNSEEN))
            self._idle.set()
        if problem:
            rospy.logwarn("aborted: %s", problem)
            self._server.set_aborted(FilledSemanticFrameResult(success=False), problem)
        else:
            rospy.loginfo("preempted")
            self._server.set_preempted(FilledSemanticFrameResult(success=False))

    def _is_over(self) -> bool:
        return self._is_ending.is_set() or self._server.is_preempt_requested()

    def _follow_oneself(self) -> str:
        """Follow, and return why it ended; empty when it was preempted."""
        with self._condition:
            self._picture = None
        subscribers = [
            rospy.Subscriber("odom", Odometry, self._take_odometry, queue_size=1, tcp_nodelay=True),
            rospy.Subscriber(
                "camera/depth/points",
                PointCloud2,
                self._take_cloud,
                queue_size=1,
                buff_size=self.CLOUD_BUFFER_BYTES,
                tcp_nodelay=True,
            ),
        ]
        try:
            return self._follow_pictures(subscribers[1].resolved_name)
        finally:
            for subscriber in subscribers:
                subscriber.unregister()

    def _follow_pictures(self, topic: str) -> str:
        follower = Follower(self._tuning.following, now_s=time.monotonic())
        last_number, picture_s, feedback_s = 0, -math.inf, -math.inf
        while not self._is_over():
            with self._condition:
                if self._picture is None or self._picture.number == last_number:
                    self._condition.wait(self.WAIT_S)
                picture = self._picture
            follower.settings = self._tuning.following
            now_s = time.monotonic()
            if picture is not None and picture.number != last_number:
                last_number, picture_s = picture.number, now_s
                driven_m_per_s, driven_s = self._driven
                is_fresh = now_s - driven_s <= self._settings.odometry_timeout_s
                step = follower.observe(
                    picture.person,
                    stamp_s=picture.stamp_s,
                    driven_m_per_s=driven_m_per_s if is_fresh else None,
                    now_s=now_s,
                )
                self._publish(step)
            elif now_s - picture_s > 3.0 * self.WAIT_S:
                step = follower.wait(now_s=now_s)
                self._publish(step)
            else:
                continue
            if step.sight is Sight.LOST:
                if last_number == 0:
                    return f"I see nothing: no point cloud on {topic}."
                return f"I have lost you: I saw nobody for {follower.settings.lost_timeout_s:g} seconds."
            if now_s - feedback_s >= self.FEEDBACK_S:
                feedback_s = now_s
                self._server.publish_feedback(FilledSemanticFrameFeedback(is_succeeding=step.sight is Sight.SEEN))
        return ""

    def _let_follow(self, follower: Union[ServiceFollower, LaunchFollower]) -> str:
        """Run the robot's own follower, and return why it ended; empty when it was preempted."""
        try:
            follower.start()
            problem = ""
            while not self._is_over() and not problem:
                with self._condition:
                    self._condition.wait(self.FEEDBACK_S)
                problem = follower.problem()
                self._server.publish_feedback(FilledSemanticFrameFeedback(is_succeeding=not problem))
            return problem
        except FollowerError as error:
            return str(error)
        finally:
            try:
                follower.stop()
            except FollowerError as error:
                rospy.logerr("the follower may still follow: %s", error)


def start(place: Place) -> TurtlebotFollower:
    """Start the server, as a node or with others in one process.

    Raises:
        ParameterError: a parameter is wrong
    """
    settings = read_parameters(Settings, prefix=place.private)
    rospy.loginfo("%s", settings)
    follower = TurtlebotFollower(settings, namespace=place.namespace)
    follower.start()
    return follower


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    run_node("turtlebot_follower", lambda: start(Place()))
