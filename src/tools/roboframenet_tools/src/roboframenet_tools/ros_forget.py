"""``rfn forget``: lets the robot forget what it has learned."""

import argparse
import os
import sys
from typing import Optional

import rosgraph
import rospy
from std_srvs.srv import Trigger

from roboframenet_ros.deadline import NoAnswer, within
from roboframenet_ros.sqlite_file import StoreError
from roboframenet_tools.learned import NothingLearned, forget
from world_model.store import Store, default_memory_file, forgotten_in_words

EXAMPLES = """examples:
  rfn forget --world
  rfn forget --world --file ~/.ros/world.sqlite
  rfn forget --learned make_your_way.navigating_to_location

What the file of the world says stays known. A running world_model forgets by its service forget_world; without one, or
with --file, the file is cleared. --learned forgets one thing that a person taught by an answer, so that it is asked
about again; 'rfn list --learned' shows the names.

exit status: 0 done, 2 wrong usage, or it was not forgotten
"""
_CALLER = "/rfn_forget"
_LONGEST_S = 10.0


class _NotForgotten(Exception):
    """The message says why."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn forget``."""
    parser.epilog = EXAMPLES
    parser.add_argument("--world", action="store_true", help="what was learned of things, persons, places and devices")
    parser.add_argument("--learned", metavar="NAME", help="what a person taught the robot")
    parser.add_argument("--file", metavar="FILE", help="use this file, and ask no node")


def run(arguments: argparse.Namespace) -> int:
    """Forget what is asked; return the exit status."""
    if bool(arguments.world) == bool(arguments.learned):
        print("rfn forget: say what: 'rfn forget --world' or 'rfn forget --learned NAME'", file=sys.stderr)
        return 2
    try:
        if arguments.learned:
            print(forget(arguments.learned, arguments.file or ""))
            return 0
        told = None if arguments.file else _by_the_node()
        print(told or _in_file(os.path.expanduser(arguments.file or default_memory_file())))
    except (_NotForgotten, NothingLearned, StoreError) as error:
        print(f"rfn forget: {error}", file=sys.stderr)
        return 2
    return 0


def _by_the_node() -> Optional[str]:
    """Ask the running node, and return what it says; None when none runs.

    Raises:
        _NotForgotten: it refuses, or does not answer
    """
    name = rospy.resolve_name("forget_world")
    try:
        rosgraph.Master(_CALLER).lookupService(name)
    except (OSError, rosgraph.MasterException):
        return None
    try:
        answer = within(_LONGEST_S, rospy.ServiceProxy(name, Trigger), name="forget the world")
    except (rospy.ServiceException, rospy.ROSException, NoAnswer) as error:
        raise _NotForgotten(f"world_model runs, and did not do it: {error}") from error
    if not answer.success:
        raise _NotForgotten(answer.message)
    return str(answer.message)


def _in_file(path: str) -> str:
    """Clear a file that no node uses.

    Raises:
        _NotForgotten: there is no such file
        StoreError: it cannot be read or written
    """
    if not os.path.isfile(path):
        raise _NotForgotten(f"no world_model runs, and there is no file {path}; --file names another one")
    store = Store(path)
    try:
        count = store.clear()
    finally:
        store.close()
    return f"{forgotten_in_words(count)} It was kept in {path}."
