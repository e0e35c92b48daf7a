#!/usr/bin/python3
"""The server of the actionlib tutorial with an execute callback; only the line that creates the server is changed."""

import os

import rospy
from actionlib_tutorials.msg import FibonacciAction, FibonacciFeedback, FibonacciResult

from rfnserver import RFNServer

HERE = os.path.dirname(os.path.abspath(__file__))


class FibonacciServer:
    """Computes the sequence, one number per period."""

    def __init__(self, name):
        self._rate_hz = 20.0
        # The words "the Fibonacci sequence" say which frame is meant, and no more.
        self._server = RFNServer(
            name,
            FibonacciAction,
            execute_cb=self.execute,
            auto_start=False,
            ignored_elements=["sequence", "counted_as"],
        )
        self._server.start()
        self._server.add_semantic_frame(os.path.join(HERE, "frames", "computing_fibonacci_sequence.yaml"))
        self._server.add_lexical_unit(os.path.join(HERE, "lexical_units", "compute.yaml"))
        self._server.register_with_frame("computing_fibonacci_sequence")

    def execute(self, goal):
        rate = rospy.Rate(self._rate_hz)
        feedback = FibonacciFeedback(sequence=[0, 1])
        for _ in range(1, goal.order):
            if self._server.is_preempt_requested():
                self._server.set_preempted(FibonacciResult(sequence=feedback.sequence))
                return
            feedback.sequence.append(feedback.sequence[-1] + feedback.sequence[-2])
            self._server.publish_feedback(feedback)
            rate.sleep()
        self._server.set_succeeded(FibonacciResult(sequence=feedback.sequence))


if __name__ == "__main__":
    rospy.init_node("fibonacci")
    server = FibonacciServer(rospy.get_name())
    rospy.spin()
