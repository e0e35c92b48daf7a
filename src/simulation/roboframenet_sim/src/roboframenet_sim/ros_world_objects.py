"""A home in the messages of the world: its map, and what the robot sees."""

from typing import Any, Iterable, List

import rospy
from roboframenet_msgs.msg import WorldObject, WorldRelation

from roboframenet_sim.home_looks import states_of
from roboframenet_sim.home_state import ROBOT, Entity, Plan, State
from roboframenet_sim.ros_base import quaternion_of_yaw

SOURCE = "home_sim"


def _object(entity: Entity, point: Any, yaw_rad: float = 0.0) -> WorldObject:
    one = WorldObject(id=entity.id, source=SOURCE, other_names=list(entity.names[1:]), category=entity.category)
    sorts = {
        "room": WorldObject.PLACE,
        "door": WorldObject.DOOR,
        "person": WorldObject.PERSON,
        "robot": WorldObject.ROBOT,
    }
    one.sort = sorts.get(entity.kind, WorldObject.DEVICE if "switch" in entity.traits else WorldObject.THING)
    if entity.kind == "thing":
        # One of many mugs has no name of its own.
        one.category = entity.name
        one.other_names.append(entity.category)
    else:
        one.name = entity.name
    one.attributes = [value for _, value in entity.attributes]
    one.pose.header.frame_id = "map"
    one.pose.pose.position.x, one.pose.pose.position.y = point
    one.pose.pose.position.z = entity.height_m if entity.kind == "furniture" else 0.0
    one.pose.pose.orientation = quaternion_of_yaw(yaw_rad)
    if entity.kind in ("room", "furniture", "door"):
        one.size.x, one.size.y = entity.x_m[1] - entity.x_m[0], entity.y_m[1] - entity.y_m[0]
        one.size.z = 2.5 if entity.kind == "room" else max(0.1, entity.height_m)
    return one


def map_objects(plan: Plan) -> List[WorldObject]:
    """Return rooms, doors and furniture; a map does not say what is open or on."""
    found: List[WorldObject] = []
    for entity in plan.entities.values():
        if entity.kind not in ("room", "door", "furniture"):
            continue
        one = _object(entity, entity.centre)
        one.relations = [WorldRelation("to", room) for room in entity.rooms]
        if entity.room:
            one.relations.append(WorldRelation("in", entity.room))
        found.append(one)
    return found


def seen_objects(plan: Plan, state: State, seen: Iterable[str], stamp: rospy.Time) -> List[WorldObject]:
    """Return what the robot sees now, what it holds, and itself."""
    found: List[WorldObject] = []
    for ident in dict.fromkeys([*seen, *state.held_by(ROBOT)]):
        entity = plan.entities[ident]
        point = plan.position(state, ident)
        yaw_rad = state.people[ident].pose.yaw_rad if ident in state.people else 0.0
        one = _object(entity, point, yaw_rad)
        place = state.places.get(ident)
        if place is not None and place.relation == "held":
            one.relations = [WorldRelation("held_by", place.holder)]
        elif place is not None:
            one.relations = [WorldRelation(place.relation, place.holder)]
        room = entity.room or plan.room_at(point)
        if entity.kind not in ("room", "door") and room and (place is None or place.holder != room):
            one.relations.append(WorldRelation("in", room))
        one.relations += [WorldRelation("to", other) for other in entity.rooms]
        one.states = states_of(state, entity)
        one.stamp = stamp
        found.append(one)
    pose = state.robot.pose
    me = WorldObject(id=ROBOT, sort="robot", source=SOURCE, stamp=stamp)
    me.pose.header.frame_id = "map"
    me.pose.pose.position.x, me.pose.pose.position.y = pose.x_m, pose.y_m
    me.pose.pose.orientation = quaternion_of_yaw(pose.yaw_rad)
    room = plan.room_at((pose.x_m, pose.y_m))
    me.relations = [WorldRelation("in", room)] if room else []
    found.append(me)
    return found
