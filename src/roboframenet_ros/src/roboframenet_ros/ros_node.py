"""The start of a node: its parameters, its log, and its end when a parameter is wrong."""

from dataclasses import fields
from typing import Any, Callable, Type, TypeVar

import rospy

from roboframenet_ros.parameters import ParameterError, Parameters
from roboframenet_ros.ros_log import log_from_threads

Kind = TypeVar("Kind", bound=Parameters)


def read_parameters(kind: Type[Kind], *, prefix: str = "~") -> Kind:
    """Read the parameters that a class declares.

    Args:
        kind: a dataclass; each of its fields is a parameter of its name
        prefix: what stands before the names; private parameters by default

    Raises:
        ParameterError: a parameter has another type, or is out of its range
    """
    declared: Any = fields(kind)
    return kind(**{one.name: rospy.get_param(prefix + one.name, one.default) for one in declared})


def run_node(name: str, start: Callable[[], object]) -> None:
    """Run a node until ROS shuts down.

    Args:
        name: of the node
        start: reads the parameters and starts the node; what it returns is kept until the end

    Raises:
        SystemExit: a parameter is wrong; the text says which and why
    """
    rospy.init_node(name)
    log_from_threads()
    try:
        node = start()
    except ParameterError as error:
        rospy.logfatal("%s", error)
        raise SystemExit(f"{name}: {error}") from error
    rospy.spin()
    del node
