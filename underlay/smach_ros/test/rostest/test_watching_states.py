#!/usr/bin/python3
"""States that watch a topic or a condition, with a real master."""

import threading
import unittest

import rospy
import rostest
from std_msgs.msg import Int32

import smach
import smach_ros
from roboframenet_testing import wait_until


class WatchingStatesTest(unittest.TestCase):
    def run_monitor(self, values, **kwargs):
        state = smach_ros.MonitorState("numbers", Int32, lambda ud, msg: msg.data >= 0, **kwargs)
        result = []
        thread = threading.Thread(target=lambda: result.append(state.execute(smach.UserData())), daemon=True)
        pub = rospy.Publisher("numbers", Int32, queue_size=10)
        thread.start()
        try:
            wait_until(lambda: pub.get_num_connections() > 0)
            for value in values:
                pub.publish(Int32(value))
            if not values:
                state.request_preempt()
            thread.join(20.0)
        finally:
            pub.unregister()
        return result

    def test_monitor_valid(self):
        self.assertEqual(self.run_monitor([1, 2], max_checks=2), ["valid"])

    def test_monitor_invalid(self):
        self.assertEqual(self.run_monitor([1, -2]), ["invalid"])

    def test_monitor_preempted(self):
        self.assertEqual(self.run_monitor([]), ["preempted"])

    def test_condition(self):
        asked = []
        state = smach_ros.ConditionState(lambda ud: asked.append(1) or len(asked) == 3, max_checks=3)
        self.assertEqual((state.execute(smach.UserData()), len(asked)), ("true", 3))
        self.assertEqual(smach_ros.ConditionState(lambda ud: False, max_checks=2).execute(smach.UserData()), "false")


if __name__ == "__main__":
    rospy.init_node("test_watching_states")
    rostest.rosrun("smach_ros", "watching_states", WatchingStatesTest)
