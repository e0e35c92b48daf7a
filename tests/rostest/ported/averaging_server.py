#!/usr/bin/python3
"""The server of the actionlib tutorial with a goal callback; only the line that creates the server is changed."""

import math
import os

import rospy
from actionlib_tutorials.msg import AveragingAction, AveragingFeedback, AveragingResult
from std_msgs.msg import Float32

from rfnserver import RFNServer

HERE = os.path.dirname(os.path.abspath(__file__))


class AveragingServer:
    """Averages the number of samples of a topic that the goal names."""

    def __init__(self, name):
        self._wanted = 0
        self._numbers = []
        self._server = RFNServer(name, AveragingAction, auto_start=False, ignored_elements=["item"])
        self._server.register_goal_callback(self.on_goal)
        self._server.register_preempt_callback(self.on_preempt)
        self._subscriber = rospy.Subscriber("random_number", Float32, self.on_number)
        self._server.start()
        self._server.add_semantic_frame(os.path.join(HERE, "frames", "averaging.yaml"))
        self._server.add_lexical_unit(os.path.join(HERE, "lexical_units", "average.yaml"))
        self._server.register_with_frame("averaging")

    def on_goal(self):
        self._wanted = self._server.accept_new_goal().samples
        self._numbers = []

    def on_preempt(self):
        rospy.loginfo("preempted")
        self._server.set_preempted()

    def on_number(self, message):
        if not self._server.is_active():
            return
        self._numbers.append(message.data)
        mean = sum(self._numbers) / len(self._numbers)
        std_dev = math.sqrt(sum((number - mean) ** 2 for number in self._numbers) / len(self._numbers))
        self._server.publish_feedback(
            AveragingFeedback(sample=len(self._numbers), data=message.data, mean=mean, std_dev=std_dev)
        )
        if len(self._numbers) < self._wanted:
            return
        result = AveragingResult(mean=mean, std_dev=std_dev)
        if mean < 0.5:
            self._server.set_aborted(result)
        else:
            self._server.set_succeeded(result)


if __name__ == "__main__":
    rospy.init_node("averaging")
    server = AveragingServer(rospy.get_name())
    rospy.spin()
