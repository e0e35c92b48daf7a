#!/usr/bin/python3
"""The node: its services, a command in and candidates out, files that are wrong, and what is killed."""

import os
import sys

import rospy
import rostest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from candidate_cases import CandidateCases
from frame_file_cases import FrameFileCases
from registration_cases import RegistrationCases


class FrameRegistrarTest(CandidateCases, FrameFileCases, RegistrationCases):
    """One launch serves all subjects."""


if __name__ == "__main__":
    rospy.init_node("test_frame_registrar_node")
    rostest.rosrun("frame_registrar", "frame_registrar_node", FrameRegistrarTest)
