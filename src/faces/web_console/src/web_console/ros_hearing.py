"""Hands messages to those that show them."""

from typing import Any, Callable

import rospy


def show(callback: Callable[[Any], None], message: Any) -> None:
    """Call back with a message; a message that cannot be shown is logged."""
    try:
        callback(message)
    except Exception as error:  # boundary: a message that cannot be shown must not hide those after it
        rospy.logwarn("a %s cannot be shown: %s: %s", type(message).__name__, type(error).__name__, error)
