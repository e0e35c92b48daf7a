"""Three simulated robots with one language service, as the tests of fleets see them."""

import os
import signal
import threading
import time
from dataclasses import dataclass, field
from typing import Dict, List, Tuple

import rospy
from nav_msgs.msg import Odometry
from roboframenet_msgs.msg import Fleet, FleetService, FrameServers, Reply
from std_msgs.msg import String

from roboframenet_testing import comes_true, wait_until
from roboframenet_testing.ros_processes import process_of

ROBOTS = ("alpha", "beta", "gamma")
#: Slower is standing: metres or radians a second.
STANDING = 0.01
#: x, y, and z and w of the quaternion of the yaw.
Pose = Tuple[float, float, float, float]
Poses = Dict[str, Pose]
_WAIT_S = 90.0
_REST_S = 0.5
_AGAIN_S = 5.0


@dataclass
class Seen:
    """What a robot did: its speed, when it was last heard, and when it last moved; monotonic seconds."""

    speed: float = 0.0
    heard_s: float = 0.0
    moved_s: float = 0.0
    pose: Pose = (0.0, 0.0, 0.0, 1.0)
    replies: List[Reply] = field(default_factory=list)


class Robots:
    """What the robots do, and what is said to them."""

    def __init__(self, robots: Tuple[str, ...] = ROBOTS) -> None:
        self._lock = threading.Lock()
        self.names = robots
        self.fleet = Fleet()
        self.service = FleetService()
        self.seen: Dict[str, Seen] = {robot: Seen() for robot in robots}
        self.replies: List[Reply] = []
        self._servers = FrameServers()
        self._texts = {name: rospy.Publisher(f"{name}/text", String, queue_size=10) for name in robots}
        self._texts[""] = rospy.Publisher("text", String, queue_size=10)
        self._subscribers = [
            rospy.Subscriber("fleet", Fleet, self._hear_fleet, queue_size=1),
            rospy.Subscriber("fleet_service", FleetService, self._hear_service, queue_size=1),
            rospy.Subscriber("frame_servers", FrameServers, self._hear_servers, queue_size=1),
            rospy.Subscriber("reply", Reply, self.replies.append, queue_size=100),
        ]
        for robot in self.names:
            self._subscribers += [
                rospy.Subscriber(f"{robot}/odom", Odometry, self._hear_odometry, robot, queue_size=1),
                rospy.Subscriber(f"{robot}/reply", Reply, self.seen[robot].replies.append, queue_size=100),
            ]

    def _hear_fleet(self, message: Fleet) -> None:
        self.fleet = message

    def _hear_service(self, message: FleetService) -> None:
        self.service = message

    def _hear_servers(self, message: FrameServers) -> None:
        self._servers = message

    def _hear_odometry(self, message: Odometry, robot: str) -> None:
        seen, twist = self.seen[robot], message.twist.twist
        position, turn = message.pose.pose.position, message.pose.pose.orientation
        seen.speed = max(abs(twist.linear.x), abs(twist.angular.z))
        seen.pose = (position.x, position.y, turn.z, turn.w)
        seen.heard_s = time.monotonic()
        if seen.speed > STANDING:
            seen.moved_s = seen.heard_s

    def members(self) -> Tuple[str, ...]:
        """The robots that take part."""
        return tuple(robot.name for robot in self.fleet.robots)

    def wait_until_ready(self, frames: Tuple[str, ...] = ("turning", "moving_forward")) -> None:
        """Return when all robots take part, their servers are registered, and the parser runs."""
        wanted = {(robot, frame) for robot in self.names for frame in frames}
        wait_until(lambda: self.members() == tuple(sorted(self.names)) and self.service.is_up, _WAIT_S)
        wait_until(lambda: wanted <= {(one.profile.robot, one.frame_name) for one in self._servers.callbacks}, _WAIT_S)
        # stop_server and fleet must hear what is said.
        wait_until(lambda: self._texts[""].get_num_connections() >= 1 + len(self.names), _WAIT_S)
        for robot in self.names:
            wait_until(lambda robot=robot: self._texts[robot].get_num_connections() >= 2, _WAIT_S)

    def say(self, text: str, *, to: str = "") -> None:
        """Say something to all robots, or to one."""
        self._texts[to].publish(String(data=text))

    def ask(self, text: str, *, to: str = "", timeout_s: float = _WAIT_S) -> Reply:
        """Say something, and return its reply."""
        replies = self.seen[to].replies if to else self.replies
        before = len(replies)
        self.say(text, to=to)
        wait_until(
            lambda: any(reply.command.text == text for reply in replies[before:]), timeout_s, f"no reply: {text}"
        )
        return next(reply for reply in replies[before:] if reply.command.text == text)

    def turned(self) -> Poses:
        """The poses of all robots."""
        return {robot: seen.pose for robot, seen in self.seen.items()}

    def who_moved(self, before: Poses) -> Tuple[str, ...]:
        """The robots whose pose is another one."""
        return tuple(
            robot
            for robot, seen in self.seen.items()
            if max(abs(now - then) for now, then in zip(seen.pose, before[robot])) > 0.02
        )

    def all_move(self) -> None:
        """Return when all robots are moving: those that stand are told to; the others go on undisturbed."""
        told_s: Dict[str, float] = {}

        def are_moving() -> bool:
            for robot in self.names:
                if self.stands(robot) and time.monotonic() - told_s.get(robot, 0.0) > _AGAIN_S:
                    told_s[robot] = time.monotonic()
                    self.say("Turn left 3600 degrees.", to=robot)
            return all(seen.speed > 0.2 and not self.stands(robot) for robot, seen in self.seen.items())

        wait_until(are_moving, _WAIT_S, "they do not move")

    def stands(self, robot: str) -> bool:
        """Whether a robot has stood for some time: a server that drives against a stop moves it again."""
        seen = self.seen[robot]
        return seen.heard_s - seen.moved_s > _REST_S

    def stand(self, robots: Tuple[str, ...], timeout_s: float = 10.0) -> bool:
        """Whether robots stand before a deadline."""
        return comes_true(lambda: all(map(self.stands, robots)), timeout_s)


def kill(node: str) -> None:
    """End the process of a node at once, as when its machine fails."""
    os.kill(process_of(node), signal.SIGKILL)
