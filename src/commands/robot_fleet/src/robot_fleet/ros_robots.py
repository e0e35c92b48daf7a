"""The robots of a fleet as action servers of commands."""

from typing import Callable, Dict, Optional, Set

import rospy
from actionlib_msgs.msg import GoalID
from roboframenet_msgs.msg import (
    CommandStatus,
    ExecuteCommandActionFeedback,
    ExecuteCommandActionGoal,
    ExecuteCommandActionResult,
    ExecuteCommandGoal,
    FrameCatalogue,
    Lexicon,
    Reply,
)

from roboframenet_ros.ros_robots import OfEachRobot, is_robot_name, topic_of
from roboframenet_ros.ros_server_links import ServerLinks, newest_link

#: Called with the id of a command and its reply.
OnReply = Callable[[str, Reply], None]
#: Called with the id of a command that a robot has begun.
OnBegun = Callable[[str], None]
#: Called with the name of a robot and what it does.
OnStatus = Callable[[str, CommandStatus], None]


class _Link:
    """The topics of one robot."""

    def __init__(self, robot: str, on_reply: OnReply, on_begun: OnBegun) -> None:
        self.goal = rospy.Publisher(topic_of(robot, "command/goal"), ExecuteCommandActionGoal, queue_size=100)
        self.cancel = rospy.Publisher(topic_of(robot, "command/cancel"), GoalID, queue_size=100)
        self.result = rospy.Subscriber(
            topic_of(robot, "command/result"),
            ExecuteCommandActionResult,
            lambda message: on_reply(message.status.goal_id.id, message.result.reply),
            queue_size=100,
        )
        self.feedback = rospy.Subscriber(
            topic_of(robot, "command/feedback"),
            ExecuteCommandActionFeedback,
            lambda message: on_begun(message.status.goal_id.id),
            queue_size=100,
        )
        self._links = ServerLinks(publishers=(self.goal, self.cancel), subscribers=(self.result, self.feedback))

    def is_ready(self) -> bool:
        """Whether the command server of the robot is connected; its stop server hears the goals, too."""
        return self._links.are_complete(*newest_link(self.result))


class RobotLinks:
    """Sends commands to robots; each command is sent once.

    Publishes: ``<robot>/command/goal``, ``<robot>/command/cancel``. Subscribes: ``<robot>/command/result``,
    ``<robot>/command/feedback``, and for some time ``<robot>/status``.
    """

    def __init__(self, on_reply: OnReply, on_begun: OnBegun, on_status: OnStatus) -> None:
        """
        Args:
            on_reply: called with the id of a command and its reply, in a thread of rospy
            on_begun: called with the id of a command when its robot tells of it, again and again, in a thread of rospy
            on_status: called with the name of a robot that is watched and what it does, in a thread of rospy
        """
        self._on_status = on_status
        self._watched: Dict[str, rospy.Subscriber] = {}
        self._links: OfEachRobot[_Link] = OfEachRobot(lambda robot: _Link(robot, on_reply, on_begun))

    def prepare(self, robot: str) -> None:
        """Open the topics of a robot."""
        self._links.get(robot)

    def watch(self, robot: str) -> None:
        """Hear what a robot does."""
        self.prepare(robot)
        if robot not in self._watched and is_robot_name(robot):
            self._watched[robot] = rospy.Subscriber(
                topic_of(robot, "status"),
                CommandStatus,
                lambda message: self._on_status(robot, message),
                queue_size=1,
            )

    def unwatch(self, robot: str) -> None:
        """Hear it no more."""
        watched = self._watched.pop(robot, None)
        if watched is not None:
            watched.unregister()

    def send(self, robot: str, text: str, *, command_id: str) -> bool:
        """Send a command; returns False if the robot is not connected yet."""
        link = self._links.get(robot)
        if link is None or not link.is_ready():
            return False
        now = rospy.Time.now()
        message = ExecuteCommandActionGoal(goal=ExecuteCommandGoal(text=text))
        message.goal_id = GoalID(stamp=now, id=command_id)
        message.header.stamp = now
        link.goal.publish(message)
        return True

    def cancel(self, robot: str, *, command_id: str) -> None:
        """Cancel a command."""
        link = self._links.get(robot)
        if link is not None:
            link.cancel.publish(GoalID(id=command_id))


class ServiceWatch:
    """Whether framer, registrar and parser are running: they have published what they know, and are connected.

    Subscribes: ``lexicon``, ``frame_catalogue``, ``parse``
    """

    def __init__(self, on_verbs: Callable[[Set[str]], None], read_verbs: Callable[[Lexicon], Set[str]]) -> None:
        # Topics are advertised some time before a node takes commands.
        self._has_lexicon = False

        def hear_lexicon(message: Lexicon) -> None:
            on_verbs(read_verbs(message))
            self._has_lexicon = True

        self._subscribers: Dict[str, rospy.Subscriber] = {
            "semantic_framer": rospy.Subscriber("lexicon", Lexicon, hear_lexicon, queue_size=1),
            "frame_registrar": rospy.Subscriber("frame_catalogue", FrameCatalogue, _ignore, queue_size=1),
            # Whoever hears "command_parse" is taken for the framer.
            "stanford_parser_ros": rospy.Subscriber("parse", rospy.AnyMsg, _ignore, queue_size=1),
        }

    def missing(self) -> Optional[str]:
        """Return the name of a node that is not running; None if all are."""
        gone = next((name for name, one in self._subscribers.items() if not one.get_num_connections()), None)
        if gone == "semantic_framer":
            self._has_lexicon = False
        return gone if gone or self._has_lexicon else "semantic_framer"


def _ignore(_message: object) -> None:
    pass
