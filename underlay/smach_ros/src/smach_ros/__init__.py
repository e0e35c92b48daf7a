"""SMACH in ROS: states that watch, preemption at shutdown, and introspection."""
import rospy
import smach

from smach_ros.condition_state import ConditionState
from smach_ros.introspection import IntrospectionClient, IntrospectionServer
from smach_ros.monitor_state import MonitorState
from smach_ros.util import set_preempt_handler

__all__ = ["ConditionState", "IntrospectionClient", "IntrospectionServer", "MonitorState", "set_preempt_handler"]

# Transitions of SMACH are detail in a ROS log; the program that runs the machine says what matters.
smach.set_loggers(rospy.logdebug, rospy.logwarn, rospy.logdebug, rospy.logerr)
smach.set_shutdown_check(rospy.is_shutdown)
