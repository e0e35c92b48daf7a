"""Poses of named places, from the topic `locations`."""

import threading
from typing import Dict

import rospy
from geometry_msgs.msg import PoseStamped
from roboframenet_msgs.msg import Locations

from rfnserver.places import UnknownPlace, destination_name


class Places:
    """The named places that are known.

    Subscribes:
        locations (roboframenet_msgs/Locations, latched)
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._poses: Dict[str, PoseStamped] = {}
        self._subscriber = rospy.Subscriber("locations", Locations, self._on_locations, queue_size=1)

    def _on_locations(self, message: Locations) -> None:
        with self._lock:
            self._poses = dict(zip(message.names, message.poses))

    def locate(self, words: str) -> PoseStamped:
        """Return the pose of a place, stamped with the present time.

        Raises:
            UnknownPlace: it is not known; the message offers similar names
        """
        with self._lock:
            poses = dict(self._poses)
        known = poses[destination_name(words, poses)]
        pose = PoseStamped(header=known.header, pose=known.pose)
        pose.header.stamp = rospy.Time.now()
        return pose

    def close(self) -> None:
        """Unsubscribe."""
        self._subscriber.unregister()


__all__ = ["Places", "UnknownPlace"]
