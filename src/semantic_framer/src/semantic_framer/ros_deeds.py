"""What a robot has done, as the executor tells it."""

import threading
from typing import Dict, Mapping, Tuple

import rospy
from roboframenet_msgs.msg import TriedFrame

from referring_expressions.deeds import DeedsDone
from roboframenet_ros.ros_robots import topic_of
from semantic_frames.frame import SemanticFrame
from typed_arguments import FilledFrame
from typed_arguments.ros_messages import frame_that_was_tried

#: Clauses of commands that are remembered.
_MOST_CLAUSES = 500


class Deeds:
    """Remembers what the servers of one robot have carried out since the node started.

    Subscribes:
        tried_frames (TriedFrame)
    """

    def __init__(self, robot: str) -> None:
        """
        Args:
            robot: its name; empty for the only one
        """
        self._lock = threading.Lock()
        self._clauses: Dict[Tuple[str, int], Tuple[FilledFrame, ...]] = {}
        self._subscriber = rospy.Subscriber(topic_of(robot, "tried_frames"), TriedFrame, self._on_tried, queue_size=100)

    def done(self, frames: Mapping[str, SemanticFrame]) -> DeedsDone:
        """Return what was done.

        Args:
            frames: by name
        """
        with self._lock:
            return DeedsDone(tuple(self._clauses.values()), frames)

    def _on_tried(self, message: TriedFrame) -> None:
        if message.outcome != TriedFrame.SUCCEEDED:
            return
        try:
            frame = frame_that_was_tried(message)
        except ValueError as error:
            rospy.logwarn("cmd=%s a deed is forgotten: %s", message.command.id, error)
            return
        key = (message.command.id, message.clause)
        with self._lock:
            before = self._clauses.pop(key, ())
            self._clauses[key] = (*before, frame)
            while len(self._clauses) > _MOST_CLAUSES:
                del self._clauses[next(iter(self._clauses))]
