#!/usr/bin/python3
"""A server that is started on demand: it waits as long as the frame says, or dies at it."""

import os
import sys
import time

import rospy

from rfnserver import RFNServer
from rfnserver.arguments import argument


def carry_out(frame):
    if argument(frame, "manner") == "deadly":
        os._exit(3)
    end = time.monotonic() + float(argument(frame, "duration_s", "0"))
    while time.monotonic() < end and not server.is_preempt_requested():
        time.sleep(0.01)
    if not server.is_preempt_requested():
        server.set_succeeded(None, f"by process {os.getpid()}")


rospy.init_node("started")
server = RFNServer(sys.argv[1], carry_out)
server.start()
rospy.spin()
