"""``rfn place``: remembers where the robot stands, and writes the places that it knows as a file."""

import argparse
import math
import sys
import time
from typing import Dict

import actionlib
import rosgraph
import rospy
from actionlib_msgs.msg import GoalStatus
from roboframenet_msgs.msg import (
    FilledFrameElement,
    FilledSemanticFrame,
    FilledSemanticFrameAction,
    FilledSemanticFrameGoal,
    Locations,
)

from location_memorizer.locations import Location, write_locations
from location_memorizer.ros_poses import to_location
from roboframenet_ros.ros_waiting import wait_for_action_server, wait_for_message

EXAMPLES = """examples:
  rfn place kitchen             remember that this is the kitchen, as after "This is the kitchen."
  rfn place                     list the places that the robot knows
  rfn place --out places.yaml   write them, for the parameter places_file of location_memorizer

exit status: 0 done, 2 wrong usage, or it was not done
"""
_CONNECT_S = 5.0
_LONGEST_S = 10.0
_LOOK_S = 0.05


class _NotDone(Exception):
    """The message says why."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn place``."""
    parser.epilog = EXAMPLES
    parser.add_argument("name", nargs="*", help="what this place is called")
    parser.add_argument("--out", metavar="FILE", help="write the places that the robot knows")


def run(arguments: argparse.Namespace) -> int:
    """Remember, list or write; return the exit status."""
    try:
        if not rosgraph.is_master_online():
            raise _NotDone("no ROS master answers: start the pipeline")
        rospy.init_node("rfn_place", anonymous=True, disable_signals=True)
        if arguments.name:
            print(_remember(" ".join(arguments.name)))
        if arguments.out or not arguments.name:
            places = _places()
            if arguments.out:
                write_locations(places, arguments.out)
                print(f"{len(places)} {'place' if len(places) == 1 else 'places'} in {arguments.out}")
            else:
                _list(places)
    except (_NotDone, OSError) as error:
        print(f"rfn place: {error}", file=sys.stderr)
        return 2
    return 0


def _remember(name: str) -> str:
    """Let location_memorizer remember where the robot stands; return what to tell.

    Raises:
        _NotDone: it refuses, or does not answer
    """
    client = actionlib.ActionClient("location_memorizer", FilledSemanticFrameAction)
    if not wait_for_action_server(client, _CONNECT_S):
        raise _NotDone("location_memorizer does not run")
    elements = [FilledFrameElement(name="location", argument=name)]
    handle = client.send_goal(
        FilledSemanticFrameGoal(FilledSemanticFrame(name="naming_location", frame_elements=elements))
    )
    end_s = time.monotonic() + _LONGEST_S
    while handle.get_comm_state() != actionlib.CommState.DONE:
        if time.monotonic() >= end_s:
            handle.cancel()
            raise _NotDone("location_memorizer does not answer")
        time.sleep(_LOOK_S)
    if handle.get_goal_status() != GoalStatus.SUCCEEDED:
        raise _NotDone(handle.get_goal_status_text() or "location_memorizer did not do it")
    return f"This is the {name}."


def _places() -> Dict[str, Location]:
    """Return the places that the robot knows.

    Raises:
        _NotDone: nobody publishes them
    """
    try:
        message = wait_for_message("locations", Locations, _CONNECT_S)
    except rospy.ROSException as error:
        raise _NotDone("nobody publishes locations: does location_memorizer run?") from error
    return {
        name: to_location(stamped.header.frame_id, stamped.pose) for name, stamped in zip(message.names, message.poses)
    }


def _list(places: Dict[str, Location]) -> None:
    for name, place in sorted(places.items()):
        degrees = math.degrees(place.heading_rad)
        print(
            f"{name:<20} x {place.x_m:.2f} m, y {place.y_m:.2f} m, heading {degrees:.0f} degrees, in {place.frame_id}"
        )
    if not places:
        print("The robot knows no place. Drive to one and say 'This is the kitchen.', or 'rfn place kitchen'.")
