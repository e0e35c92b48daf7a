#!/usr/bin/python3
"""The program of nested_machine.py on a machine so busy that each message is sent 0.3 s later than it is published."""

import os
import runpy
import time

from rospy.impl import tcpros_base

_write_data = tcpros_base.TCPROSTransport.write_data


def _write_later(transport, data):
    time.sleep(0.3)
    _write_data(transport, data)


if __name__ == "__main__":
    tcpros_base.TCPROSTransport.write_data = _write_later
    runpy.run_path(os.path.join(os.path.dirname(os.path.abspath(__file__)), "nested_machine.py"), run_name="__main__")
