"""The texts of the files that ``rfn new`` writes; :mod:`roboframenet_tools.scaffold` fills them in."""

FRAME = """# Name the frame of FrameNet here, or say in a comment why it has none.
name: {name}
description: The robot does what "{verb}" means.
framenet: ""
frame_elements:
{elements}
"""
UNIT = """frame_name: {name}
verb: [{verb}]
frame_element_grammatical_relations:
{relations}
examples:
{examples}
"""
SERVER = '''#!/usr/bin/env python3
"""RFNServer of the frame {name}."""
import os

{imports}
FOLDER = {folder}


{callback}


if __name__ == "__main__":
    rospy.init_node("{name}_server")
    server = {constructor}
    server.add_semantic_frame(os.path.join(FOLDER, "frames", "{name}.yaml"))
    server.add_lexical_unit(os.path.join(FOLDER, "lexical_units", "{name}.yaml"))
    server.register_with_frame("{name}")
    server.start()
    rospy.spin()
'''
CALLBACK = '''def {name}(frame):
    """Do it; a goal that is not ended here succeeds, an exception aborts it with its text."""
    rospy.loginfo("{verb}: %s", argument(frame, "{element}"))'''
EXECUTE = '''def execute(goal):
    """Do it; end the goal with set_succeeded, set_aborted (text= says why) or set_preempted."""
    rospy.loginfo("{verb}: %s", goal)
    server.set_succeeded()'''
UNIT_TEST = '''"""The files of the frame {name} are right, and its examples are understood."""
import os
import subprocess

FOLDER = os.path.join(os.path.dirname(os.path.realpath(__file__)), "..", "..")


def test_files_and_examples():
    ended = subprocess.run(["rfn", "check", "--examples", FOLDER], capture_output=True, text=True, timeout=300)
    assert ended.returncode == 0, ended.stdout + ended.stderr
'''
PACKAGE_XML = """<?xml version="1.0"?>
<package format="3">
  <name>{package}</name>
  <version>0.0.0</version>
  <description>Abilities of a robot that understands English.</description>
  <maintainer email="you@example.com">you</maintainer>
  <license>TODO</license>

  <buildtool_depend>catkin</buildtool_depend>
  <buildtool_depend>roboframenet_cmake</buildtool_depend>
  <exec_depend>python3-rospkg</exec_depend>
  <exec_depend>rfnserver</exec_depend>
  <exec_depend>roboframenet_bringup</exec_depend>
  <exec_depend>rospy</exec_depend>
{dependencies}  <test_depend>python3-pytest</test_depend>
  <test_depend>roboframenet_msgs</test_depend>
  <test_depend>roboframenet_rostest</test_depend>
  <test_depend>roboframenet_tools</test_depend>
  <test_depend>rostest</test_depend>
</package>
"""
CMAKE_LISTS = """cmake_minimum_required(VERSION 3.10)
project({package})

find_package(catkin REQUIRED COMPONENTS roboframenet_cmake)
catkin_package()

file(GLOB nodes CONFIGURE_DEPENDS nodes/*)
catkin_install_python(PROGRAMS ${{nodes}} DESTINATION ${{CATKIN_PACKAGE_BIN_DESTINATION}})
install(DIRECTORY frames launch lexical_units DESTINATION ${{CATKIN_PACKAGE_SHARE_DESTINATION}})

# test/unit with pytest, test/rostest/*.test with rostest.
roboframenet_add_tests()
"""
LAUNCH = """<launch>
  <!-- What this robot can do. While a pipeline runs: roslaunch {package} {package}.launch
       Together with one, in one line: roslaunch roboframenet_bringup robot.launch
       robot_file:=$(rospack find {package})/launch/{package}.launch -->
  <arg name="sim" default="false" doc="true: simulate the robot; these servers need no robot yet"/>
  <arg name="respawn" default="true" doc="restart a node that dies"/>

{nodes}
</launch>
"""
NODE = '  <node pkg="{package}" type="{name}_server" name="{name}_server" respawn="$(arg respawn)" output="screen"/>'
ROSTEST = """<launch>
  <include file="$(find roboframenet_bringup)/launch/pipeline.launch"/>
  <include file="$(find {package})/launch/{package}.launch"/>
  <test test-name="{name}" pkg="{package}" type="{name}_test.py" time-limit="300"/>
</launch>
"""
ROSTEST_CODE = '''#!/usr/bin/env python3
"""A person says it, and the server does it."""
import unittest

import rospy
import rostest
from roboframenet_msgs.msg import Reply
from roboframenet_rostest import say, wait_for_pipeline


class {capital}Test(unittest.TestCase):
    def test_what_is_said_is_done(self):
        wait_for_pipeline(["{name}"], unit_files=["{name}.yaml"])
        reply = say("{sentence}")
        self.assertEqual(Reply.DONE, reply.outcome, reply.sentence)


if __name__ == "__main__":
    rospy.init_node("{name}_test")
    rostest.rosrun("{package}", "{name}", {capital}Test)
'''
