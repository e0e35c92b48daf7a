#!/usr/bin/python3
"""The world: told by file, topic and service, latched for whoever comes later, and still known after a kill."""

import os
import random
import signal
import threading
import time
import unittest
from typing import List, Set
from xmlrpc.client import ServerProxy

import rosgraph
import rospy
from geometry_msgs.msg import PoseWithCovarianceStamped
from roboframenet_msgs.msg import KnownNames, World, WorldObject, WorldRelation, WorldUpdate
from roboframenet_msgs.srv import UpdateWorld, UpdateWorldResponse
from std_srvs.srv import Trigger

from roboframenet_testing import wait_until


def thing(name: str, **known: object) -> WorldObject:
    return WorldObject(id=name, sort=WorldObject.THING, source="test", **known)


class WorldModelTest(unittest.TestCase):
    """The methods run in the order of their names."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.worlds: List[World] = []
        cls.names: List[KnownNames] = []
        rospy.Subscriber("world", World, cls.worlds.append)
        rospy.Subscriber("known_names", KnownNames, cls.names.append)
        rospy.wait_for_service("update_world", timeout=60.0)
        wait_until(lambda: cls.worlds)

    def update(self, *objects: WorldObject, **update: object) -> UpdateWorldResponse:
        return rospy.ServiceProxy("update_world", UpdateWorld)(WorldUpdate(objects=list(objects), **update))

    def ids(self) -> Set[str]:
        return {one.id for one in self.worlds[-1].objects}

    def test_1_file_is_known_from_the_start(self) -> None:
        self.assertEqual(self.ids(), {"kitchen", "table_1", "anna"})
        wait_until(lambda: self.names and [known.name for known in self.names[-1].names] == ["anna"])

    def test_2_update_is_acknowledged_and_published(self) -> None:
        answer = self.update(thing("mug_1", category="mug", relations=[WorldRelation("on", "table_1")]))
        self.assertTrue(answer.success, answer.errors)
        wait_until(lambda: self.worlds[-1].version == answer.version)
        self.assertIn("mug_1", self.ids())

    def test_3_update_by_topic_does_the_same(self) -> None:
        publisher = rospy.Publisher("world_updates", WorldUpdate, queue_size=1)
        wait_until(lambda: publisher.get_num_connections() > 0)
        publisher.publish(WorldUpdate(objects=[thing("cup_1", category="cup")]))
        wait_until(lambda: "cup_1" in self.ids())

    def test_4_wrong_update_changes_nothing_and_says_why(self) -> None:
        before = self.ids()
        wrong = thing("bowl_2")
        wrong.sort = "animal"
        for answer in (self.update(thing("bowl_1"), thing("a bowl")), self.update(wrong)):
            self.assertFalse(answer.success)
            self.assertTrue(answer.errors)
        self.assertEqual(self.update(thing("bowl_1"), thing("a bowl")).refused, (1,))
        self.assertEqual(self.ids(), before)

    def test_5_robot_is_where_its_localisation_says(self) -> None:
        publisher = rospy.Publisher("amcl_pose", PoseWithCovarianceStamped, queue_size=1, latch=True)
        pose = PoseWithCovarianceStamped()
        pose.header.frame_id = "map"
        pose.pose.pose.position.x, pose.pose.pose.orientation.w = 1.5, 1.0
        publisher.publish(pose)
        wait_until(lambda: "robot" in self.ids())
        publisher.unregister()

    def test_6_nothing_acknowledged_is_lost_when_the_node_is_killed(self) -> None:
        kills, moments = rospy.get_param("~kills"), random.Random(2026)
        acknowledged: Set[str] = set()
        is_over = threading.Event()

        def write() -> None:
            number = 0
            while not is_over.is_set():
                number += 1
                try:
                    if self.update(thing(f"thing_{number}")).success:
                        acknowledged.add(f"thing_{number}")
                except (rospy.ServiceException, rospy.ROSException):
                    is_over.wait(0.05)  # it was killed, and comes back

        writer = threading.Thread(target=write)
        writer.start()
        try:
            for _ in range(kills):
                known = len(acknowledged)
                wait_until(lambda least=known: len(acknowledged) > least, timeout_s=60.0)
                time.sleep(moments.uniform(0.0, 0.3))
                self.kill()
        finally:
            is_over.set()
            writer.join(60.0)
        rospy.wait_for_service("update_world", timeout=60.0)
        answer = self.update(thing("last"))
        wait_until(lambda: self.worlds[-1].version == answer.version)
        self.assertLessEqual(acknowledged | {"mug_1", "cup_1", "table_1", "last"}, self.ids())

    def test_7_what_was_learned_before_a_restart_is_of_an_earlier_run(self) -> None:
        known = {one.id: one for one in self.worlds[-1].objects}
        self.assertGreater(known["mug_1"].place_of_before.to_sec(), 1e9)
        self.assertEqual(known["table_1"].place_of_before.to_sec(), 0.0)
        self.update(thing("mug_1", relations=[WorldRelation("held_by", "anna")]))
        wait_until(
            lambda: [one.place_of_before.to_sec() for one in self.worlds[-1].objects if one.id == "mug_1"] == [0]
        )

    def test_8_forgetting_leaves_what_the_file_says(self) -> None:
        answer = rospy.ServiceProxy("forget_world", Trigger)()
        self.assertTrue(answer.success, answer.message)
        # Where the robot is now was not learned.
        wait_until(lambda: self.ids() - {"robot"} == {"kitchen", "table_1", "anna"})

    def kill(self) -> None:
        master = rosgraph.Master("/world_model_test")
        pid = ServerProxy(master.lookupNode(rospy.resolve_name("world_model"))).getPid("/test")[2]
        os.kill(pid, signal.SIGKILL)
        wait_until(lambda: self.is_another(pid), timeout_s=60.0, message="the node does not return")

    @staticmethod
    def is_another(pid: int) -> bool:
        try:
            uri = rosgraph.Master("/test").lookupNode(rospy.resolve_name("world_model"))
            return bool(ServerProxy(uri).getPid("/test")[2] != pid)
        except (OSError, rosgraph.MasterException):
            return False


if __name__ == "__main__":
    import rostest

    rospy.init_node("world_model_test")
    rostest.rosrun("world_model", "world_model_test", WorldModelTest)
