"""Places of the world: those that world_model knows, and those that it is told."""

import math
import re
from typing import Dict, Sequence

import rospy
from geometry_msgs.msg import PoseStamped
from roboframenet_msgs.msg import WorldObject

from location_memorizer.locations import Location
from location_memorizer.ros_poses import to_location
from rfnserver.places import location_name

_NOT_IN_AN_ID = re.compile(r"[^\w./-]+", re.ASCII)


def places_of(objects: Sequence[WorldObject]) -> Dict[str, Location]:
    """Return where the places are that have a pose, under each of their names."""
    found: Dict[str, Location] = {}
    for one in objects:
        position, turned = one.pose.pose.position, one.pose.pose.orientation
        for name in filter(None, map(location_name, [one.name, *one.other_names])):
            if one.pose.header.frame_id and all(map(math.isfinite, (position.x, position.y, turned.z, turned.w))):
                found[name] = to_location(one.pose.header.frame_id, one.pose.pose)
    return found


def place_of(name: str, pose: PoseStamped, known: Sequence[WorldObject]) -> WorldObject:
    """Return a remembered place as an object of the world.

    Args:
        name: of the place
        pose: of the robot there
        known: the places of the world; one of this name that has a size keeps the pose of its middle
    """
    same = next((one for one in known if name in map(location_name, [one.name, *one.other_names])), None)
    return WorldObject(
        id=same.id if same else _NOT_IN_AN_ID.sub("_", name)[:100],
        sort=WorldObject.PLACE,
        name="" if same else name,
        pose=PoseStamped() if same and same.size.x else pose,
        source="location_memorizer",
        stamp=rospy.Time.now(),
    )
