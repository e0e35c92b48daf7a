"""The node ``fleet_member``: a robot tells the language service of itself, and acts by its policy when it is alone."""

import threading
import time
from typing import Optional

import rospy
from actionlib_msgs.msg import GoalID
from nav_msgs.msg import Odometry
from roboframenet_msgs.msg import (
    CommandStatus,
    FilledFrameElement,
    FilledSemanticFrame,
    FilledSemanticFrameActionGoal,
    FilledSemanticFrameGoal,
    FleetMember,
    FleetService,
)
from std_msgs.msg import String

from roboframenet_ros.health import Health, Level
from roboframenet_ros.parameters import ParameterError
from roboframenet_ros.ros_node import read_parameters, run_node
from roboframenet_ros.ros_place import Place
from roboframenet_ros.ros_robots import ROBOT_NAME, own_robot
from robot_fleet.loss import Act, Hearing, Policy
from robot_fleet.ros_untaken import UntakenOfFleet
from robot_fleet.settings import MemberSettings

_JOIN_TIMEOUT_S = 2.0


class FleetMemberNode:
    """Tells of the robot in whose namespace it runs.

    Subscribes: ``fleet_service``, ``status``, ``odom``, and what `UntakenOfFleet` does. Publishes: ``fleet_member``,
    ``fleet_reply``, and by its policy ``text`` ("Stop.") and ``<home_server>/goal``.
    """

    def __init__(self, robot: str, settings: MemberSettings) -> None:
        self._settings = settings
        self._lock = threading.Lock()
        self._hearing = Hearing(time.monotonic())
        self._home_s: Optional[float] = None
        self._open_commands = 0
        self._odometry = Odometry()
        self._robot = robot
        self._members = rospy.Publisher("fleet_member", FleetMember, queue_size=5)
        self._text = rospy.Publisher("text", String, queue_size=5)
        self._home: Optional[rospy.Publisher] = None
        if settings.on_loss is Policy.GO_HOME:
            if not settings.home_server or not settings.home_frame:
                raise ParameterError("on_loss go_home needs home_server and home_frame")
            self._home = rospy.Publisher(f"{settings.home_server}/goal", FilledSemanticFrameActionGoal, queue_size=1)
        self._untaken = UntakenOfFleet(robot)
        self._is_closing = threading.Event()
        self._worker = threading.Thread(target=self._work, name="fleet_member", daemon=True)

    def start(self) -> None:
        """Take part."""
        rospy.on_shutdown(self._shutdown)
        self._subscribers = [
            rospy.Subscriber("fleet_service", FleetService, self._hear_service, queue_size=1),
            rospy.Subscriber("status", CommandStatus, self._hear_status, queue_size=1),
            rospy.Subscriber("odom", Odometry, self._hear_odometry, queue_size=1),
        ]
        self._untaken.start()
        self._worker.start()

    def health(self) -> Health:
        """How the node is."""
        if self._hearing.is_lost:
            return Health(Level.WARN, f"The language service is not heard: {self._settings.on_loss.value}.")
        return Health()

    def _shutdown(self) -> None:
        self._is_closing.set()
        self._worker.join(_JOIN_TIMEOUT_S)
        self._untaken.close()

    def _hear_service(self, service: FleetService) -> None:
        # What the network delivers late is no sign of life.
        if service.is_up and abs((rospy.Time.now() - service.stamp).to_sec()) <= self._settings.silence_s:
            with self._lock:
                self._hearing, acts = self._hearing.hear(time.monotonic())
            for _ in acts:
                rospy.loginfo("%s hears the language service again", self._robot)

    def _hear_status(self, status: CommandStatus) -> None:
        self._open_commands = len(status.active)

    def _hear_odometry(self, odometry: Odometry) -> None:
        self._odometry = odometry

    def _work(self) -> None:
        while not self._is_closing.wait(self._settings.period_s):
            with self._lock:
                self._hearing, acts = self._hearing.turn(
                    time.monotonic(), silence_s=self._settings.silence_s, policy=self._settings.on_loss
                )
            for act in acts:
                self._do(act)
            if self._home_s is not None and time.monotonic() >= self._home_s:
                self._home_s = None
                self._go_home()
            self._tell()

    def _do(self, act: Act) -> None:
        if act is Act.STOP:
            self._text.publish(String(data="Stop."))
        elif act is Act.GO_HOME:
            # A goal right behind a stop would end with it.
            self._home_s = time.monotonic() + self._settings.home_delay_s
        else:
            rospy.logwarn("%s lost the language service: %s", self._robot, self._settings.on_loss.value)

    def _go_home(self) -> None:
        assert self._home is not None
        elements = [FilledFrameElement(name=name, argument=words) for name, words in self._settings.elements.items()]
        now = rospy.Time.now()
        message = FilledSemanticFrameActionGoal(
            goal=FilledSemanticFrameGoal(
                frame=FilledSemanticFrame(name=self._settings.home_frame, frame_elements=elements)
            )
        )
        message.goal_id = GoalID(stamp=now, id=f"{rospy.get_name()}-home-{now.to_nsec()}")
        message.header.stamp = now
        self._home.publish(message)

    def _tell(self) -> None:
        odometry = self._odometry
        member = FleetMember(
            name=self._robot,
            spoken_names=list(self._settings.spoken_names),
            open_commands=self._open_commands,
            on_loss=self._settings.on_loss.value,
            has_lost_service=self._hearing.is_lost,
        )
        member.pose.header, member.pose.pose = odometry.header, odometry.pose.pose
        self._members.publish(member)


def start(place: Place) -> FleetMemberNode:
    """Start the stage.

    Raises:
        ParameterError: a parameter is wrong, or the namespace has no robot
    """
    robot = own_robot()
    if not robot:
        raise ParameterError(f"{ROBOT_NAME} must be the name of a robot: that of its namespace")
    node = FleetMemberNode(robot, read_parameters(MemberSettings, prefix=place.private))
    node.start()
    return node


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    run_node("fleet_member", lambda: start(Place()))
