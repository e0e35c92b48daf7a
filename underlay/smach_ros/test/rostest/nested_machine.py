#!/usr/bin/python3
"""A program whose nested machine waits for goals; prints its outcome."""

import rospy
from actionlib.msg import TestAction, TestGoal

import smach
import smach_ros

if __name__ == "__main__":
    rospy.init_node("nested_machine")
    items = smach.Iterator(["done", "preempted"], [], [], it=range(3), exhausted_outcome="done")
    with items:
        smach.Iterator.set_contained_state(
            "GOAL", smach_ros.SimpleActionState("watched", TestAction, TestGoal(1)), loop_outcomes=["succeeded"]
        )
    both = smach.Concurrence(
        ["done", "preempted"], "done", outcome_map={"preempted": {"ITEMS": "preempted", "CONDITION": "preempted"}}
    )
    with both:
        smach.Concurrence.add("ITEMS", items)
        smach.Concurrence.add("CONDITION", smach_ros.ConditionState(lambda userdata: False, max_checks=-1))
    outer = smach.StateMachine(["done", "preempted"])
    with outer:
        smach.StateMachine.add("BOTH", both)
    smach_ros.set_preempt_handler(outer)
    print("outcome:", outer.execute(), flush=True)
