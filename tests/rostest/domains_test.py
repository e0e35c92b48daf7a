#!/usr/bin/python3
"""Says the sentences of a script to a simulated robot; each must do what the script expects."""

import unittest

import rospy
import yaml

from roboframenet_demo.node import Demonstration
from roboframenet_demo.ros_pipeline import is_pipeline_complete
from roboframenet_demo.script import read_line
from roboframenet_rostest import can_do
from roboframenet_testing import wait_until


class DomainsTest(unittest.TestCase):
    """One conversation."""

    def test_every_sentence_does_what_it_should(self) -> None:
        with open(rospy.get_param("~script"), encoding="utf-8") as file:
            lines = [read_line(entry) for entry in yaml.safe_load(file)]
        demonstration = Demonstration()
        wait_until(is_pipeline_complete, 120.0, "the pipeline did not come up")
        self.assertTrue(can_do(rospy.get_param("~frames")), "the robot did not register")
        self.assertTrue(demonstration.wait_until_ready(timeout_s=120.0), "servers come and go")
        for line in lines:
            demonstration.run(line)
        wrong = [f"{row[0]}: {row[-1]}" for row in demonstration.rows if row[-1] != "ok"]
        self.assertEqual(wrong, [])


if __name__ == "__main__":
    import rostest

    rospy.init_node("domains_test")
    rostest.rosrun("roboframenet_tests", rospy.get_name().strip("/"), DomainsTest)
