"""Locations as messages."""

import math

import rospy
from geometry_msgs.msg import Pose, PoseStamped

from location_memorizer.locations import Location


def to_pose(location: Location) -> PoseStamped:
    """Return a location as a stamped pose."""
    pose = PoseStamped()
    pose.header.frame_id = location.frame_id
    pose.header.stamp = rospy.Time.now()
    pose.pose.position.x = location.x_m
    pose.pose.position.y = location.y_m
    pose.pose.orientation.z = math.sin(location.heading_rad / 2.0)
    pose.pose.orientation.w = math.cos(location.heading_rad / 2.0)
    return pose


def to_location(frame_id: str, pose: Pose) -> Location:
    """Return the location of a pose.

    Args:
        frame_id: in which the pose is given
        pose: turned about the vertical axis
    Raises:
        ValueError: it has no frame, or numbers that are not finite
    """
    heading_rad = 2.0 * math.atan2(pose.orientation.z, pose.orientation.w)
    return Location(frame_id, pose.position.x, pose.position.y, heading_rad)
