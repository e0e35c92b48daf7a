#!/usr/bin/python3
"""A program that sends a goal, and stays until it is killed: frame_client.py SERVER frame|fibonacci|topic.

"topic" publishes the goal of a frame and listens to nothing, as rostopic does.
"""

import sys

import actionlib
import rospy
from actionlib_tutorials.msg import FibonacciAction, FibonacciGoal
from roboframenet_msgs.msg import (
    FilledSemanticFrameAction,
    FilledSemanticFrameActionGoal,
    FilledSemanticFrameGoal,
)

from roboframenet_testing import wait_until

if __name__ == "__main__":
    server, kind = sys.argv[1:3]
    rospy.init_node("frame_client", anonymous=True)
    if kind == "topic":
        publisher = rospy.Publisher(f"{server}/goal", FilledSemanticFrameActionGoal, queue_size=1)
        wait_until(lambda: publisher.get_num_connections() == 1)
        publisher.publish(FilledSemanticFrameActionGoal())
    else:
        action, goal = {
            "frame": (FilledSemanticFrameAction, FilledSemanticFrameGoal()),
            "fibonacci": (FibonacciAction, FibonacciGoal(order=3)),
        }[kind]
        client = actionlib.SimpleActionClient(server, action)
        assert client.wait_for_server(rospy.Duration(60.0))
        client.send_goal(goal)
    rospy.spin()
