"""Random states of the simulated home, and what a robot knows that has seen a part of it."""

import random
from dataclasses import dataclass, replace
from typing import Dict, FrozenSet, List

import rospy
from roboframenet_msgs.msg import World as WorldMessage

from roboframenet_sim.home_file import load_home_file
from roboframenet_sim.home_state import Entity, Place, Plan, State
from roboframenet_sim.ros_world_objects import map_objects, seen_objects
from roboframenet_testing.workspace import package
from world_model import World
from world_model.ros_messages import world_from_message

HOME = package("roboframenet_sim") / "config/home.yaml"
_SEEN_SHARE = 0.75


@dataclass(frozen=True)
class Scene:
    """A state of the home, and the ids of what the robot has seen of it."""

    plan: Plan
    state: State
    seen: FrozenSet[str]

    def entities(self, *kinds: str) -> List[Entity]:
        """Return the entities of some kinds, in the order of the home."""
        return [one for one in self.plan.entities.values() if one.kind in kinds]

    def is_seen(self, one: Entity) -> bool:
        """Whether the robot has seen an entity."""
        return one.id in self.seen

    def room_of(self, one: Entity) -> str:
        """Return the id of the room that an entity is in."""
        return one.room or self.plan.room_at(self.plan.position(self.state, one.id))


def scene_of(seed: int) -> Scene:
    """Return a random scene: things and persons are anywhere, doors and devices are in any state."""
    chance = random.Random(seed)
    plan, state = load_home_file(str(HOME))
    entities = list(plan.entities.values())
    surfaces = [one for one in entities if one.kind == "furniture" and "surface" in one.traits]
    containers = [one for one in entities if one.kind == "furniture" and "container" in one.traits]
    for thing in (one for one in entities if one.kind == "thing"):
        relation, holders = chance.choice([("on", surfaces), ("on", surfaces), ("in", containers)])
        holder = chance.choice(holders)
        state = state.with_place(thing.id, Place(relation, holder.id, *holder.centre))
    rooms = [one for one in entities if one.kind == "room"]
    for person in state.people:
        room = chance.choice(rooms)
        pose = replace(state.people[person].pose, x_m=room.centre[0], y_m=room.centre[1])
        state = state.with_person(person, pose=pose)
    for one in entities:
        if "closable" in one.traits or (one.kind == "door" and one.rooms and "passage" not in one.id):
            state = state.with_property(one.id, is_open=chance.random() < 0.5)
        if "switch" in one.traits:
            state = state.with_property(one.id, is_on=chance.random() < 0.5)
    seen = frozenset(one.id for one in entities if one.kind != "room" and chance.random() < _SEEN_SHARE)
    return Scene(plan, state, seen)


def known_of(scene: Scene) -> World:
    """Return what the robot knows: the map, and how it saw the rest."""
    objects: Dict[str, object] = {one.id: one for one in map_objects(scene.plan)}
    seen = [name for name in scene.plan.entities if name in scene.seen]
    objects.update((one.id, one) for one in seen_objects(scene.plan, scene.state, seen, rospy.Time(1)))
    return world_from_message(WorldMessage(version="1", objects=list(objects.values())))
