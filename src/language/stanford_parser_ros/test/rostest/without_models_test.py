#!/usr/bin/python3
"""A parser whose models cannot be loaded says so to each command, and is not started again and again."""

import unittest
from typing import List

import rosnode
import rospy
import rostest
from roboframenet_msgs.msg import Command, Reply, StageEvent

from roboframenet_testing import wait_until
from roboframenet_testing.ros_connections import is_connected

NODE = "/stanford_parser_ros"


class WithoutModelsTest(unittest.TestCase):
    def test_each_command_gets_the_reason(self) -> None:
        events: List[StageEvent] = []
        commands = rospy.Publisher("command_text", Command, queue_size=10)
        rospy.Subscriber("stage_events", StageEvent, events.append, queue_size=10)
        wait_until(lambda: is_connected(rospy.get_name(), "command_text", NODE))
        process = rosnode.get_api_uri(rospy.get_master(), NODE)
        for number in (1, 2):
            commands.publish(Command(id=str(number), text="Turn left."))
            wait_until(lambda number=number: len(events) == number)
            reply = events[-1].reply
            self.assertEqual((Reply.FAILED, "STAGE_ERROR"), (reply.outcome, reply.code))
            self.assertIn("no model folder /no/such/folder", reply.sentence)
        self.assertEqual(process, rosnode.get_api_uri(rospy.get_master(), NODE, skip_cache=True))


if __name__ == "__main__":
    rospy.init_node("without_models_test")
    rostest.rosrun("stanford_parser_ros", "without_models", WithoutModelsTest)
