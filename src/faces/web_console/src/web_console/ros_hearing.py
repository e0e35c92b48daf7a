"""Hands messages to those that show them."""

from typing import Any, Callable

import rospy


def show_raw(kind: Any, callback: Callable[[Any], None], message: rospy.AnyMsg) -> None:
    """Read a message of a kind, and call back with it; one that cannot be read or shown is logged."""
    show(lambda raw: callback(kind().deserialize(raw._buff)), message)


def show(callback: Callable[[Any], None], message: Any) -> None:
    """Call back with a message; a message that cannot be shown is logged."""
    try:
        callback(message)
    except Exception as error:  # boundary: a message that cannot be shown must not hide those after it
        rospy.logwarn("a %s cannot be shown: %s: %s", type(message).__name__, type(error).__name__, error)
