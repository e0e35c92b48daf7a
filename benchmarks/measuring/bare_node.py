#!/usr/bin/env python3
"""A rospy node that does nothing: what it takes while idle is no fault of the nodes that are measured beside it."""

import rospy

rospy.init_node("bare")
rospy.spin()
