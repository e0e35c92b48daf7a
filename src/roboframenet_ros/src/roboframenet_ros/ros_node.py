"""The start of a node: its parameters, its log, its diagnostics, and its end when it cannot start."""

from dataclasses import fields
from typing import Any, Callable, Optional, Type, TypeVar

import rospy

from roboframenet_ros.health import Health, SelfDiagnosing
from roboframenet_ros.parameters import ParameterError, Parameters, is_parameter
from roboframenet_ros.ros_diagnostics import Diagnostics
from roboframenet_ros.ros_log import log_from_threads

Kind = TypeVar("Kind", bound=Parameters)
Node = TypeVar("Node")


class StartError(RuntimeError):
    """A node cannot start although its parameters are right; the message says why."""


def read_parameters(kind: Type[Kind], *, prefix: str = "~", defaults: Optional[Kind] = None) -> Kind:
    """Read the parameters that a class declares.

    Args:
        kind: a dataclass; each field that is declared with `parameter` is a parameter of its name
        prefix: what stands before the names; private parameters by default
        defaults: the values of parameters that are not set; those of the class by default

    Raises:
        ParameterError: a parameter has another type, or is out of its range
    """
    declared: Any = [one for one in fields(kind) if is_parameter(one)]
    unset = kind() if defaults is None else defaults
    return kind(**{one.name: rospy.get_param(prefix + one.name, getattr(unset, one.name)) for one in declared})


def run_node(name: str, start: Callable[[], Node], *, work: Optional[Callable[[Node], object]] = None) -> None:
    """Run a node until ROS shuts down.

    Args:
        name: of the node
        start: reads the parameters and starts the node; what it returns is kept until the end, and says how it is if it
            is `SelfDiagnosing`
        work: what the main thread does until the end; nothing by default

    Raises:
        SystemExit: a parameter is wrong, or the node cannot start; the text says why
    """
    rospy.init_node(name)
    log_from_threads()
    try:
        node = start()
    except (ParameterError, StartError) as error:
        rospy.logfatal("%s", error)
        raise SystemExit(f"{name}: {error}") from error
    Diagnostics(node.health if isinstance(node, SelfDiagnosing) else Health)
    if work is None:
        rospy.spin()
    else:
        work(node)
    del node
