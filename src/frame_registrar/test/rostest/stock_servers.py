#!/usr/bin/python3
"""Action servers as actionlib has them: they register nowhere and know nothing of the registrar."""

import actionlib
import rospy
from roboframenet_msgs.msg import FilledSemanticFrameAction

rospy.init_node("stock_servers")
servers = [
    actionlib.SimpleActionServer(name, FilledSemanticFrameAction, lambda goal: None, auto_start=False)
    for name in rospy.get_param("~servers")
]
for server in servers:
    server.start()
    rospy.on_shutdown(server.action_server.status_timer.shutdown)
rospy.spin()
