#!/usr/bin/python3
"""A program whose machine runs in a thread while the main thread spins; what is behind "preempted" cleans up."""

import threading

import rospy
from actionlib.msg import TestAction, TestGoal
from std_msgs.msg import String
from std_srvs.srv import SetBool

import smach
import smach_ros


class Tell(smach.State):
    """Publishes a text and waits until it is out."""

    def __init__(self, publisher, text):
        smach.State.__init__(self, outcomes=["succeeded"])
        self._publisher, self._text = publisher, text

    def execute(self, userdata):
        self._publisher.publish(self._text)
        rospy.sleep(0.1)
        return "succeeded"


if __name__ == "__main__":
    rospy.init_node("thread_machine")
    told = rospy.Publisher("told", String, queue_size=5, latch=True)
    machine = smach.StateMachine(["done", "failed"])
    with machine:
        smach.StateMachine.add(
            "WORK",
            smach_ros.SimpleActionState("watched", TestAction, TestGoal(1)),
            {"succeeded": "done", "aborted": "failed", "preempted": "SWITCH_OFF"},
        )
        smach.StateMachine.add(
            "SWITCH_OFF",
            smach_ros.ServiceState("motors", SetBool, False),
            {"succeeded": "TELL", "aborted": "failed", "preempted": "failed"},
        )
        smach.StateMachine.add("TELL", Tell(told, "motors are off"), {"succeeded": "done"})
    smach_ros.set_preempt_handler(machine)
    outcomes = []
    thread = threading.Thread(target=lambda: outcomes.append(machine.execute()))
    thread.start()
    rospy.spin()
    thread.join()
    print("outcome:", outcomes[0], flush=True)
