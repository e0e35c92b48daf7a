"""The start of a node: its parameters, its log, its diagnostics, and its end when it cannot start."""

import contextlib
import gc
import queue
import time
from dataclasses import fields
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Sequence, Type, TypeVar

import rospy

from roboframenet_ros.health import Health, SelfDiagnosing
from roboframenet_ros.parameters import ParameterError, Parameters, is_parameter
from roboframenet_ros.ros_connection_threads import accept_in_threads
from roboframenet_ros.ros_diagnostics import Diagnostics
from roboframenet_ros.ros_interrupts import Interrupts
from roboframenet_ros.ros_log import log_from_threads
from roboframenet_ros.ros_missed_publishers import connect_missed_publishers
from roboframenet_ros.ros_place import Place, ProblemsTopic
from roboframenet_ros.ros_prompt_connection import publish_promptly
from roboframenet_ros.ros_publishing import is_shutting_down

#: ROS may have shut down before anybody could be told; it is asked again after this time, seconds.
_LONGEST_WAIT_S = 5.0
_HOOKS_PERIOD_S = 0.02

Kind = TypeVar("Kind", bound=Parameters)
Node = TypeVar("Node")


class HostedStage(NamedTuple):
    """A stage that can run with others in one process.

    Attributes:
        name: that of its node
        start: starts it at a place; what it returns is kept until the end, and says how it is if it is `SelfDiagnosing`
    """

    name: str
    start: Callable[[Place], object]


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
    interrupts = _init_node(name)
    try:
        node = start()
    except (ParameterError, StartError) as error:
        rospy.logfatal("%s", error)
        raise SystemExit(f"{name}: {error}") from error
    Diagnostics({rospy.get_name()[1:]: _health_of(node)})
    _keep_what_is_there()
    if work is None:
        _wait_for_shutdown()
    else:
        work(node)
    _end(interrupts)
    del node


def run_stages(name: str, stages: Sequence[HostedStage]) -> None:
    """Run several stages in one process until ROS shuts down: one node with the topics, services and parameters of all.

    A stage that cannot start ends the process, as it ends its own: whoever started the node starts it again.

    Args:
        name: of the node
        stages: in the order in which they start, and in which rospy hands each message to those that share its topic

    Raises:
        SystemExit: a parameter is wrong, or a stage cannot start; the text says why
    """
    interrupts = _init_node(name)
    problems = ProblemsTopic()
    nodes: List[object] = []
    states: Dict[str, Callable[[], Health]] = {}
    for stage in stages:
        try:
            node = stage.start(Place(private=f"{stage.name}/", problems=problems))
        except (ParameterError, StartError) as error:
            rospy.logfatal("%s: %s", stage.name, error)
            raise SystemExit(f"{stage.name}: {error}") from error
        nodes.append(node)
        states[rospy.resolve_name(stage.name)[1:]] = _health_of(node)
    Diagnostics(states)
    _keep_what_is_there()
    _wait_for_shutdown()
    _end(interrupts)
    del nodes


def _init_node(name: str) -> Interrupts:
    """Connect to ROS; return what ends the node on Ctrl-C."""
    publish_promptly()
    accept_in_threads()
    rospy.init_node(name)
    interrupts = Interrupts()
    log_from_threads()
    connect_missed_publishers()
    return interrupts


def _keep_what_is_there() -> None:
    """Take what was made at the start out of what the garbage collector looks at.

    It stays until the end, and to look at all of it stops every thread for 20 to 150 ms, in the middle of a command.
    """
    gc.freeze()


def _end(interrupts: Interrupts) -> None:
    """Return when the hooks of the shutdown have run, and let the interpreter end soon."""
    interrupts.wait_for_hooks()
    # The interpreter looks for garbage several times while it ends; among the modules of Stanza, for most of a second.
    gc.freeze()


def _wait_for_shutdown() -> None:
    """Return when ROS has shut down; ``rospy.spin`` looks twice a second whether it does."""
    # Ctrl-C is handled in this thread, whatever it does: what tells it must take no lock that it may hold.
    told: queue.SimpleQueue[None] = queue.SimpleQueue()
    rospy.on_shutdown(lambda: told.put(None))
    while not is_shutting_down():
        with contextlib.suppress(queue.Empty):
            told.get(timeout=_LONGEST_WAIT_S)
            break
    while not rospy.is_shutdown():
        # Hooks that another thread runs.
        time.sleep(_HOOKS_PERIOD_S)


def _health_of(node: object) -> Callable[[], Health]:
    return node.health if isinstance(node, SelfDiagnosing) else Health
