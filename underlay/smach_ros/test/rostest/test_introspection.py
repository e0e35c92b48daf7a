#!/usr/bin/python3
"""The introspection topics show a machine, with a real master. A part of the test plays smach_viewer."""

import base64
import io
import pickle
import threading
import unittest
from enum import IntEnum

import rospy
import rostest
from smach_msgs.msg import SmachContainerInitialStatusCmd, SmachContainerStatus, SmachContainerStructure

import smach
import smach_ros
from roboframenet_testing import wait_until


class Colour(IntEnum):
    """A class that a viewer cannot import."""

    RED = 1


class Unpickler(pickle.Unpickler):
    """Loads plain values only, as a viewer that has no class of the robot."""

    def find_class(self, module, name):
        raise pickle.UnpicklingError(f"the viewer has no {module}.{name}")


class Gate(smach.State):
    """Waits until the test lets it pass."""

    def __init__(self):
        smach.State.__init__(self, outcomes=["done", "failed"])
        self.opened = threading.Event()

    def execute(self, userdata):
        assert self.opened.wait(30.0)
        return "done"


class Viewer:
    """Does with each message what smach_viewer does: decode, load, compare, and draw anew when something changed."""

    def __init__(self, server):
        self.containers, self.initial, self.active, self.userdata, self.redraws = {}, {}, {}, {}, []
        self.errors = []
        self._subscribers = [
            rospy.Subscriber(server + "/smach/container_structure", SmachContainerStructure, self._see_structure),
            rospy.Subscriber(server + "/smach/container_status", SmachContainerStatus, self._see_status),
        ]

    def stop(self):
        for subscriber in self._subscribers:
            subscriber.unregister()

    def _see_structure(self, message):
        self.containers[message.path] = message

    def _see_status(self, message):
        if message.path not in self.containers:
            return
        try:
            values = Unpickler(io.BytesIO(base64.b64decode(message.local_data))).load()
            assert isinstance(values, dict)
        except Exception as error:  # reported by the tests
            self.errors.append((message.local_data, error))
            return
        path = message.path
        seen = (set(message.initial_states), set(message.active_states))
        if seen != (self.initial.get(path), self.active.get(path)):
            self.redraws.append((path, message.active_states))
        self.initial[path], self.active[path] = seen
        self.userdata[path] = values

    def edges(self, path, with_implicit):
        """Transitions as the viewer draws them; an implicit one leads to the outcome of its name."""
        message = self.containers[path]
        edges = zip(message.internal_outcomes, message.outcomes_from, message.outcomes_to)
        return {
            (outcome, label, outcome if target == "None" else target)
            for outcome, label, target in edges
            if with_implicit or target != "None"
        }


def machine(gates):
    inner = smach.StateMachine(["done", "failed"])
    with inner:
        smach.StateMachine.add("LEAF", gates["LEAF"])
    outer = smach.StateMachine(["done", "failed"])
    with outer:
        smach.StateMachine.add("FIRST", inner, {"done": "SECOND", "failed": ""})
        smach.StateMachine.add("SECOND", gates["SECOND"])
    return outer


class IntrospectionTest(unittest.TestCase):
    path = "/ROOT"

    def setUp(self):
        self.gates = {"LEAF": Gate(), "SECOND": Gate()}
        self.machine = machine(self.gates)
        self.machine.userdata.answer = 42
        self.viewer = Viewer("show")
        self.server = smach_ros.IntrospectionServer("show", self.machine, self.path)
        self.server.start()
        self.inner = self.path.rstrip("/") + "/FIRST"
        wait_until(lambda: set(self.viewer.userdata) == {self.path, self.inner})

    def tearDown(self):
        for gate in self.gates.values():
            gate.opened.set()
        self.server.stop()
        self.viewer.stop()
        self.assertEqual(self.viewer.errors, [])

    def active(self):
        return self.viewer.active[self.path], self.viewer.active[self.inner]

    def test_viewer_follows_the_machine(self):
        thread = threading.Thread(target=self.machine.execute, daemon=True)
        thread.start()
        wait_until(lambda: self.active() == ({"FIRST"}, {"LEAF"}))
        self.gates["LEAF"].opened.set()
        wait_until(lambda: self.active() == ({"SECOND"}, set()))
        self.machine.userdata.answer = 43
        self.gates["SECOND"].opened.set()
        thread.join(20.0)
        wait_until(lambda: self.active() == (set(), set()))
        wait_until(lambda: self.viewer.userdata[self.path] == {"answer": 43})
        drawn = [active for path, active in self.viewer.redraws if path == self.path]
        self.assertEqual(drawn[-3:], [["FIRST"], ["SECOND"], []])

    def test_viewer_draws_the_structure_and_can_hide_implicit_transitions(self):
        root = self.viewer.containers[self.path]
        self.assertEqual((root.children, root.container_outcomes), (["FIRST", "SECOND"], ["done", "failed"]))
        explicit = {("done", "FIRST", "SECOND")}
        implicit = {("failed", "FIRST", "failed"), ("done", "SECOND", "done"), ("failed", "SECOND", "failed")}
        self.assertEqual(self.viewer.edges(self.path, with_implicit=False), explicit)
        self.assertEqual(self.viewer.edges(self.path, with_implicit=True), explicit | implicit)

    def test_values_that_a_viewer_cannot_load_are_described(self):
        self.machine.userdata.thing = object()
        self.machine.userdata.colour = Colour.RED
        self.machine.userdata.speed = float("nan")
        self.machine.userdata.many = {1: (2.5, [Colour.RED, None, True])}
        wait_until(lambda: "many" in self.viewer.userdata[self.path])
        values = self.viewer.userdata[self.path]
        self.assertIn("object object", values.pop("thing"))
        self.assertEqual(values, {"answer": 42, "colour": 1, "speed": "nan", "many": {"1": [2.5, [1, None, True]]}})

    def test_client_sets_initial_state_and_bad_commands_are_refused(self):
        client = smach_ros.IntrospectionClient()
        wait_until(lambda: any("show" in name for name in client.get_servers()))
        pub = rospy.Publisher("show/smach/container_init", SmachContainerInitialStatusCmd, queue_size=5)
        wait_until(lambda: pub.get_num_connections() > 0)
        pickled = base64.b64encode(pickle.dumps({"answer": 1}, 2)).decode("ascii")
        for label, local_data in (("NOWHERE", ""), ("SECOND", pickled), ("SECOND", "(dp0\nVanswer\np1\nI1\ns.")):
            pub.publish(SmachContainerInitialStatusCmd(self.path, [label], local_data))
        added = smach.UserData()
        added.answer = 7
        self.assertTrue(client.set_initial_state("show", self.path, ["SECOND"], added, rospy.Duration(20)))
        self.assertEqual((self.machine.get_initial_states(), self.machine.userdata.answer), (["SECOND"], 7))
        # Without userdata, as the viewer asks; also when it runs with another implementation of SMACH.
        self.assertTrue(client.set_initial_state("show", self.path, ["FIRST"], timeout=rospy.Duration(20)))
        self.assertEqual((self.machine.get_initial_states(), self.machine.userdata.answer), (["FIRST"], 7))
        empty = base64.b64encode(pickle.dumps({}, 2)).decode("ascii")
        pub.publish(SmachContainerInitialStatusCmd(self.path, ["SECOND"], empty))
        wait_until(lambda: self.machine.get_initial_states() == ["SECOND"])


class RootPathTest(IntrospectionTest):
    """The same with the root of the tree as the path."""

    path = "/"


if __name__ == "__main__":
    rospy.init_node("test_introspection")
    rostest.rosrun("smach_ros", "introspection", "__main__")
