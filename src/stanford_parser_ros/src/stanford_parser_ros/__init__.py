"""Stanza wrapped in ROS: Universal and Stanford typed dependencies of English commands."""
