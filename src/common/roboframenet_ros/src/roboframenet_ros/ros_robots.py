"""Names of the robots that one language service serves: each has a namespace of its own below that of the service."""

import threading
from typing import Any, Callable, Dict, Generic, Iterator, Optional, Type, TypeVar

import rosgraph
import rospy

#: A searched parameter, set in the namespace of each robot of a fleet: its name, which is that of the namespace.
ROBOT_NAME = "robot_name"
#: Names come from the wire.
MOST_ROBOTS = 20_000

Kept = TypeVar("Kept")


def own_robot() -> str:
    """Return the name of the robot that this node belongs to; empty for a node of the only robot, or of the service."""
    parameter = rospy.search_param(ROBOT_NAME)
    return str(rospy.get_param(parameter, "")) if parameter else ""


def is_robot_name(name: str) -> bool:
    """Whether a name can be that of a robot: it is a namespace without a slash."""
    return "/" not in name and "~" not in name and bool(rosgraph.names.is_legal_name(name))


def topic_of(robot: str, topic: str, *, own: str = "") -> str:
    """Return a topic of a robot.

    Args:
        robot: its name; empty for the only robot
        topic: its name in the namespace of a robot
        own: the robot that this node belongs to
    """
    return topic if robot in ("", own) else f"{robot}/{topic}"


class OfEachRobot(Generic[Kept]):
    """Something that is made when a robot is first heard of, such as its publisher; safe for several threads."""

    def __init__(self, make: Callable[[str], Kept]) -> None:
        """
        Args:
            make: called with the name of the robot, empty for the only one
        """
        self._make = make
        self._lock = threading.Lock()
        self._kept: Dict[str, Kept] = {}

    def get(self, robot: str) -> Optional[Kept]:
        """Return what belongs to a robot; None if that is no name of a robot, or if there are too many."""
        kept = self._kept.get(robot)
        if kept is not None:
            return kept
        with self._lock:
            if robot not in self._kept:
                if len(self._kept) >= MOST_ROBOTS or not (robot == "" or is_robot_name(robot)):
                    rospy.logerr_throttle(10.0, f"{robot[:40]!r} cannot be the name of a robot here")
                    return None
                self._kept[robot] = self._make(robot)
            return self._kept[robot]

    def __iter__(self) -> Iterator[str]:
        """The robots that were heard of."""
        return iter(list(self._kept))


class PublisherOfEachRobot:
    """A topic in the namespace of each robot."""

    def __init__(self, topic: str, kind: Type[Any], *, own: str = "", **options: Any) -> None:
        """Advertise the topic of the own robot, or of the only one.

        Args:
            topic: its name in the namespace of a robot
            kind: of the messages
            own: the robot that this node belongs to
            **options: of ``rospy.Publisher``
        """
        self._own = own
        self._publishers: OfEachRobot[rospy.Publisher] = OfEachRobot(
            lambda robot: rospy.Publisher(topic_of(robot, topic), kind, **options)
        )
        self._publishers.get("")

    def prepare(self, robot: str) -> None:
        """Advertise the topic of a robot, so that its first message finds subscribers."""
        self._publishers.get("" if robot == self._own else robot)

    def publish(self, robot: str, message: Any) -> None:
        """Publish a message to a robot."""
        publisher = self._publishers.get("" if robot == self._own else robot)
        if publisher is not None:
            publisher.publish(message)
