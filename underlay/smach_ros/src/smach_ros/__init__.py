"""SMACH in ROS: states for actions, services and topics, and introspection."""
import rospy
import smach

from smach_ros.introspection import IntrospectionClient, IntrospectionServer

__all__ = ["IntrospectionClient", "IntrospectionServer"]

# Transitions of SMACH are detail in a ROS log; the program that runs the machine says what matters.
smach.set_loggers(rospy.logdebug, rospy.logwarn, rospy.logdebug, rospy.logerr)
smach.set_shutdown_check(rospy.is_shutdown)
