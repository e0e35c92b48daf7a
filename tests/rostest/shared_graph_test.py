#!/usr/bin/python3
"""Runs the tests of several modules one after the other in one graph: to start it takes longer than most of them.

Each module has its private parameters from this node, and runs alone, too: ``type="domains_test.py"``.
"""

import importlib
import sys
import unittest

import rospy
import rostest


def suite() -> unittest.TestSuite:
    """Return the tests of the modules in ``~modules``, in their order."""
    loader = unittest.TestLoader()
    return unittest.TestSuite(
        loader.loadTestsFromModule(importlib.import_module(name)) for name in rospy.get_param("~modules")
    )


if __name__ == "__main__":
    rospy.init_node("shared_graph_test", disable_signals=True)
    # The node has the name of the <test>.
    rostest.rosrun("roboframenet_tests", rospy.get_name().strip("/"), "__main__.suite", sys.argv)
