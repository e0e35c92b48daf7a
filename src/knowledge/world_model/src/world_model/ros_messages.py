"""Converts objects and updates to messages and back."""

import math
from typing import Optional, Tuple

import rospy
from geometry_msgs.msg import Point, PoseStamped, Quaternion, Vector3
from roboframenet_msgs import msg

from world_model.knowledge import Update
from world_model.world import World
from world_model.world_object import Pose, Relation, Sort, WorldObject

_SORTS = {sort.value: sort for sort in Sort}


def world_to_message(world: World, now_s: float) -> msg.World:
    """Convert a snapshot; ``now_s`` is ROS time."""
    return msg.World(
        version=world.version,
        stamp=rospy.Time.from_sec(now_s),
        objects=[object_to_message(one) for one in world.objects],
        left_out=world.left_out,
    )


def world_from_message(message: msg.World) -> World:
    """Convert a snapshot; an object of an unknown sort counts as a thing."""
    return World(message.version, tuple(object_from_message(one) for one in message.objects), message.left_out)


def update_from_message(message: msg.WorldUpdate) -> Update:
    """Convert an update.

    Raises:
        ValueError: a sort is unknown; the text names it
    """
    for position, one in enumerate(message.objects):
        if one.sort not in _SORTS and one.sort:
            raise ValueError(f"object {position} has the sort {one.sort!r}, expected one of {', '.join(_SORTS)}")
    return Update(
        objects=tuple(object_from_message(one) for one in message.objects),
        replaces=message.replaces,
        missing=tuple(message.missing),
        gone=tuple(message.gone),
    )


def object_to_message(one: WorldObject) -> msg.WorldObject:
    """Convert an object."""
    return msg.WorldObject(
        id=one.id,
        sort=one.sort.value,
        name=one.name,
        other_names=list(one.other_names),
        category=one.category,
        attributes=list(one.attributes),
        size=Vector3(*one.size_m),
        pose=pose_to_message(one.pose),
        relations=[msg.WorldRelation(relation.relation, relation.reference) for relation in one.relations],
        states=list(one.states),
        source=one.source,
        stamp=rospy.Time.from_sec(one.stamp_s),
        place_of_before=rospy.Time.from_sec(one.place_of_before_s),
        states_of_before=rospy.Time.from_sec(one.states_of_before_s),
    )


def object_from_message(message: msg.WorldObject) -> WorldObject:
    """Convert an object; numbers that are not finite stay, and `mistakes` names them."""
    return WorldObject(
        id=message.id,
        sort=_SORTS.get(message.sort, Sort.THING),
        name=message.name,
        other_names=tuple(message.other_names),
        category=message.category,
        attributes=tuple(message.attributes),
        size_m=(message.size.x, message.size.y, message.size.z),
        pose=pose_from_message(message.pose),
        relations=tuple(Relation(one.relation, one.reference) for one in message.relations),
        states=tuple(message.states),
        source=message.source,
        stamp_s=message.stamp.to_sec(),
        place_of_before_s=message.place_of_before.to_sec(),
        states_of_before_s=message.states_of_before.to_sec(),
    )


def pose_to_message(pose: Optional[Pose]) -> PoseStamped:
    """Convert a pose; None becomes one with an empty frame."""
    message = PoseStamped()
    if pose is not None:
        message.header.frame_id = pose.frame_id
        message.pose.position = Point(pose.x_m, pose.y_m, pose.z_m)
        message.pose.orientation = Quaternion(*pose.orientation)
    return message


def pose_from_message(message: PoseStamped) -> Optional[Pose]:
    """Convert a pose; None for one with an empty frame. An orientation that was never set means none."""
    if not message.header.frame_id:
        return None
    position, turned = message.pose.position, message.pose.orientation
    orientation: Tuple[float, float, float, float] = (turned.x, turned.y, turned.z, turned.w)
    if not any(orientation) and all(map(math.isfinite, orientation)):
        orientation = (0.0, 0.0, 0.0, 1.0)
    return Pose(message.header.frame_id, position.x, position.y, position.z, orientation)
