"""Hierarchical state machines: the documented public interface of SMACH, without ROS."""

from smach.concurrence import Concurrence
from smach.container import Container
from smach.exceptions import (
    InvalidConstructionError,
    InvalidStateError,
    InvalidTransitionError,
    InvalidUserCodeError,
    SmachError,
)
from smach.iterator import Iterator
from smach.log import logdebug, logerr, loginfo, logwarn, set_loggers
from smach.sequence import Sequence
from smach.state import CBState, State
from smach.state_machine import StateMachine
from smach.user_data import Const, Remapper, UserData, get_const
from smach.util import CBInterface, cb_interface, has_smach_interface, is_shutdown, set_shutdown_check

__all__ = [
    "CBInterface",
    "CBState",
    "Concurrence",
    "Const",
    "Container",
    "InvalidConstructionError",
    "InvalidStateError",
    "InvalidTransitionError",
    "InvalidUserCodeError",
    "Iterator",
    "Remapper",
    "Sequence",
    "SmachError",
    "State",
    "StateMachine",
    "UserData",
    "cb_interface",
    "get_const",
    "has_smach_interface",
    "is_shutdown",
    "logdebug",
    "logerr",
    "loginfo",
    "logwarn",
    "set_loggers",
    "set_shutdown_check",
]
