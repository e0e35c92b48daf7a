"""Finds what the robot would do for a sentence, in one process, without ROS."""
