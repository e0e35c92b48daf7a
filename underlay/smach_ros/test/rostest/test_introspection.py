#!/usr/bin/python3
"""The introspection topics show a machine, with a real master."""

import json
import unittest

import rospy
import rostest
from smach_msgs.msg import SmachContainerInitialStatusCmd, SmachContainerStatus, SmachContainerStructure

import smach
import smach_ros
from roboframenet_testing import wait_until


def machine():
    inner = smach.StateMachine(["done"])
    with inner:
        smach.StateMachine.add("LEAF", smach.CBState(lambda ud: "done", outcomes=["done"]))
    outer = smach.StateMachine(["done"])
    with outer:
        smach.StateMachine.add("FIRST", inner, {"done": "SECOND"})
        smach.StateMachine.add("SECOND", smach.CBState(lambda ud: "done", outcomes=["done"]))
    return outer


class IntrospectionTest(unittest.TestCase):
    def setUp(self):
        self.statuses, self.structures = [], {}
        self.subscribers = [
            rospy.Subscriber("show/smach/container_status", SmachContainerStatus, self.statuses.append),
            rospy.Subscriber(
                "show/smach/container_structure",
                SmachContainerStructure,
                lambda msg: self.structures.update({msg.path: msg}),
            ),
        ]
        self.machine = machine()
        self.machine.userdata.answer = 42
        self.machine.userdata.thing = object()
        self.server = smach_ros.IntrospectionServer("show", self.machine, "/ROOT")
        self.server.start()
        wait_until(lambda: set(self.structures) == {"/ROOT", "/ROOT/FIRST"})

    def tearDown(self):
        self.server.stop()
        for subscriber in self.subscribers:
            subscriber.unregister()

    def test_structure_status_and_json(self):
        root = self.structures["/ROOT"]
        self.assertEqual((root.children, root.container_outcomes), (["FIRST", "SECOND"], ["done"]))
        self.assertIn(
            ("done", "FIRST", "SECOND"), list(zip(root.internal_outcomes, root.outcomes_from, root.outcomes_to))
        )
        self.assertEqual(self.machine.execute(), "done")
        wait_until(
            lambda: any(status.path == "/ROOT" and status.active_states == ["SECOND"] for status in self.statuses)
        )
        values = self.values_of_root(lambda values: values.get("answer") == 42)
        self.assertIn("object object", values["thing"], "what JSON cannot say is described")
        self.machine.userdata.answer = 43
        self.assertEqual(self.machine.execute(), "done")
        self.values_of_root(lambda values: values.get("answer") == 43)

    def values_of_root(self, are_right):
        """Userdata in the first status of the root that is right; fails when none comes."""
        found = []

        def look():
            found[:] = [
                values
                for values in (
                    json.loads(status.local_data) for status in list(self.statuses) if status.path == "/ROOT"
                )
                if are_right(values)
            ]
            return bool(found)

        wait_until(look, message=lambda: [status.local_data for status in self.statuses])
        return found[0]

    def test_client_sets_initial_state_and_bad_commands_are_refused(self):
        client = smach_ros.IntrospectionClient()
        wait_until(lambda: any("show" in name for name in client.get_servers()))
        pub = rospy.Publisher("show/smach/container_init", SmachContainerInitialStatusCmd, queue_size=5)
        wait_until(lambda: pub.get_num_connections() > 0)
        pub.publish(SmachContainerInitialStatusCmd(path="/ROOT", initial_states=["NOWHERE"]))
        pub.publish(
            SmachContainerInitialStatusCmd(
                path="/ROOT", initial_states=["SECOND"], local_data="(dp0\nVanswer\np1\nI1\ns."
            )
        )
        added = smach.UserData()
        added.answer = 7
        self.assertTrue(client.set_initial_state("show", "/ROOT", ["SECOND"], added, rospy.Duration(20)))
        self.assertEqual(self.machine.get_initial_states(), ["SECOND"])
        self.assertEqual(self.machine.userdata.answer, 7)


if __name__ == "__main__":
    rospy.init_node("test_introspection")
    rostest.rosrun("smach_ros", "introspection", IntrospectionTest)
