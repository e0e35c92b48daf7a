#!/usr/bin/python3
"""What a bag shows is in the world: the things, their places, what was taken away, and nothing that is not there."""

import subprocess
import tempfile
import unittest
from pathlib import Path
from typing import Any, Dict, List, Tuple

import make_bags
import rospy
import rostest
from roboframenet_msgs.msg import World, WorldObject, WorldUpdate

from roboframenet_testing import wait_until

#: How near a told place must be to the true one, metres.
NEAR_M = 0.12


class PerceptionTest(unittest.TestCase):
    """The bag is played once; the tests read what was told, and when."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.worlds: List[Dict[str, WorldObject]] = []
        cls.updates: List[WorldUpdate] = []
        cls.bag = rospy.get_param("~bag")
        cls.subscribers = [
            rospy.Subscriber("world", World, cls.on_world),
            rospy.Subscriber("world_updates", WorldUpdate, cls.updates.append),
        ]
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / f"{cls.bag}.bag"
            {
                "image": make_bags.write_image_bag,
                "space": make_bags.write_space_bag,
                "tags": make_bags.write_tag_bag,
            }[cls.bag](path)
            command = ["rosbag", "play", "--clock", "--quiet", "--wait-for-subscribers", str(path)]
            subprocess.run(command, check=True, timeout=120)
        # The last looks are taken after the bag has ended.
        wait_until(
            lambda: any(cls.is_at(one, make_bags.ELSEWHERE) for one in cls.placed().values()), message=cls.placed
        )

    @classmethod
    def on_world(cls, message: World) -> None:
        cls.worlds.append({one.id: one for one in message.objects})

    @classmethod
    def placed(cls) -> Dict[str, WorldObject]:
        """Return what the newest snapshot has a place of."""
        return {name: one for name, one in cls.worlds[-1].items() if one.pose.header.frame_id} if cls.worlds else {}

    @staticmethod
    def is_at(one: WorldObject, where: Tuple[float, float, float]) -> bool:
        position = one.pose.pose.position
        return all(abs(a - b) < NEAR_M for a, b in zip((position.x, position.y, position.z), where))

    def told(self, **fields: Any) -> List[WorldObject]:
        found = [one for update in self.updates for one in update.objects]
        return [one for one in found if all(getattr(one, name) == value for name, value in fields.items())]

    def test_two_mugs_are_where_they_stand(self) -> None:
        placed = self.placed()
        self.assertEqual(["mug", "mug"], [one.category for one in placed.values()], placed)
        self.assertEqual({"map"}, {one.pose.header.frame_id for one in placed.values()})
        for where in (make_bags.FIRST, make_bags.ELSEWHERE):
            self.assertEqual(1, sum(self.is_at(one, where) for one in placed.values()), (where, placed))

    def test_the_drive_made_no_new_things(self) -> None:
        self.assertEqual(2, len({one.id for one in self.told()}), [one.id for one in self.told()])
        if self.bag == "tags":
            self.assertEqual({"mug_of_anna", "mug_of_bob"}, {one.id for one in self.told()})

    def test_the_mug_that_was_taken_away_was_missing(self) -> None:
        missing = [name for update in self.updates for name in update.missing]
        self.assertEqual(1, len(missing), missing)
        (moved,) = missing
        self.assertTrue(self.is_at(self.placed()[moved], make_bags.ELSEWHERE))
        without = [world[moved] for world in self.worlds if moved in world]
        self.assertTrue(any(not one.pose.header.frame_id for one in without))

    def test_what_was_hidden_was_not_missed(self) -> None:
        first = [one for one in self.placed().values() if self.is_at(one, make_bags.FIRST)]
        self.assertEqual(1, len(first))
        self.assertFalse(any(first[0].id in update.missing for update in self.updates))

    def test_a_flicker_and_what_was_unsure_were_not_told(self) -> None:
        self.assertEqual([], [one.id for one in self.told() if one.category != "mug"])

    def test_places_are_told_by_the_time_they_were_seen(self) -> None:
        stamps = [one.stamp.to_sec() - make_bags.BEGIN_S for one in self.told()]
        self.assertTrue(all(0.0 <= stamp <= make_bags.LENGTH_S for stamp in stamps), stamps)
        self.assertLess(len(stamps), 40)


if __name__ == "__main__":
    rospy.init_node("perception_test")
    rostest.rosrun("object_perception", "perception", PerceptionTest)
