"""Stanza wrapped in ROS: Universal and Stanford typed dependencies of English commands."""

from stanford_parser_ros.phrase_tree import Tree, unsquash_tree

__all__ = ["Tree", "unsquash_tree"]
