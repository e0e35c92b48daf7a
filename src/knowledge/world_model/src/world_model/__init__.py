"""What the robot knows of things, persons, places, doors and devices."""

from world_model.world import World
from world_model.world_object import Pose, Relation, Sort, WorldObject

__all__ = ["Pose", "Relation", "Sort", "World", "WorldObject"]
