"""Remembers places: "This is the office."."""

import os
import threading
from dataclasses import dataclass
from typing import Dict, Optional, Tuple

import rospy
from geometry_msgs.msg import PoseStamped, PoseWithCovarianceStamped
from roboframenet_msgs.msg import FilledSemanticFrame, Locations, World, WorldObject, WorldUpdate

from location_memorizer.locations import Location, LocationFileError, read_locations, write_locations
from location_memorizer.ros_poses import to_location, to_pose
from location_memorizer.ros_world import place_of, places_of
from location_memorizer.srv import GetLocation, GetLocationRequest, GetLocationResponse
from rfnserver import RFNServer
from rfnserver.places import location_name
from roboframenet_ros.home_folder import file_in_ros_home
from roboframenet_ros.parameters import Parameters, parameter
from roboframenet_ros.ros_node import read_parameters, run_node
from roboframenet_ros.unreadable_file import set_aside


@dataclass(frozen=True)
class Settings(Parameters):
    """Private parameters, checked.

    Attributes:
        places_file: places that are known from the start; empty for none
        memory_file: where remembered places are kept; empty for ``locations.yaml`` in the ROS home folder

    Raises:
        ParameterError: a value of another type
    """

    places_file: str = parameter("")
    memory_file: str = parameter("")


class LocationMemorizer:
    """Keeps places and their names.

    Actions:
        location_memorizer (roboframenet_msgs/FilledSemanticFrameAction): frame naming_location
    Services:
        get_location (location_memorizer/GetLocation)
    Subscribes:
        amcl_pose (geometry_msgs/PoseWithCovarianceStamped): where the robot is
        world (roboframenet_msgs/World): places that world_model knows
    Publishes:
        locations (roboframenet_msgs/Locations, latched)
        world_updates (roboframenet_msgs/WorldUpdate): places that were remembered
    Parameters: see :class:`Settings`.
    """

    def __init__(self, parameters: str = "~") -> None:
        """
        Args:
            parameters: prefix of the names of the parameters

        Raises:
            ParameterError: a parameter is wrong
        """
        settings = read_parameters(Settings, prefix=parameters)
        self._lock = threading.Lock()
        self._here: Optional[Location] = None
        self._memory_file = os.path.expanduser(settings.memory_file or file_in_ros_home("locations.yaml"))
        # A person writes the one file, and this node the other: its names are known by their words already.
        places = (self._read(settings.places_file) or {}) if settings.places_file else {}
        self._places = {location_name(name): location for name, location in places.items()}
        remembered = self._read(self._memory_file) if os.path.exists(self._memory_file) else {}
        if remembered is None:
            self._set_memory_aside()
        self._remembered = remembered or {}
        self._of_world: Dict[str, Location] = {}
        self._world: Tuple[WorldObject, ...] = ()
        self._updates = rospy.Publisher("world_updates", WorldUpdate, queue_size=10)
        self._publisher = rospy.Publisher("locations", Locations, queue_size=1, latch=True)
        self._publish()
        self._subscriber = rospy.Subscriber("amcl_pose", PoseWithCovarianceStamped, self._on_pose, queue_size=1)
        self._world_subscriber = rospy.Subscriber("world", World, self._on_world, queue_size=1)
        self._service = rospy.Service("get_location", GetLocation, self._on_get_location)
        self._server = RFNServer("location_memorizer", self._on_frame)
        self._server.register_with_frame("naming_location")
        self._server.start()

    @staticmethod
    def _read(path: str) -> Optional[Dict[str, Location]]:
        """Return the places of a file; None when it cannot be read."""
        try:
            return read_locations(path)
        except (LocationFileError, OSError) as error:
            rospy.logerr("places are missing: %s", error)
            return None

    def _set_memory_aside(self) -> None:
        """Keep a memory that cannot be read: the next place would overwrite it."""
        try:
            rospy.logwarn("kept the unreadable memory file as %s", set_aside(self._memory_file))
        except OSError as error:
            rospy.logerr("the unreadable memory file will be overwritten: %s", error)

    def _known(self) -> Dict[str, Location]:
        return {**self._of_world, **self._places, **self._remembered}

    def _on_world(self, message: World) -> None:
        """Offer the places of the world under their names too."""
        with self._lock:
            self._world = tuple(one for one in message.objects if one.sort == WorldObject.PLACE)
            of_world = places_of(self._world)
            is_new, self._of_world = of_world != self._of_world, of_world
        if is_new:
            self._publish()

    def _publish(self) -> None:
        known = self._known()
        self._publisher.publish(Locations(names=list(known), poses=[to_pose(location) for location in known.values()]))

    def _on_pose(self, message: PoseWithCovarianceStamped) -> None:
        try:
            here = to_location(message.header.frame_id, message.pose.pose)
        except ValueError as error:
            rospy.logwarn_throttle(10.0, "ignoring a pose: %s", error)
            return
        with self._lock:
            self._here = here

    def _on_get_location(self, request: GetLocationRequest) -> GetLocationResponse:
        with self._lock:
            location = self._known().get(location_name(request.name))
            here = self._here
        if location is not None:
            return GetLocationResponse(success=True, pose=to_pose(location))
        # A client that ignores 'success' and drives there does not move.
        return GetLocationResponse(success=False, pose=to_pose(here) if here else PoseStamped())

    def _on_frame(self, frame: FilledSemanticFrame) -> None:
        words = next((element.argument for element in frame.frame_elements if element.name == "location"), "")
        name = location_name(words)
        if not name:
            self._server.set_aborted(None, "I did not hear what this place is called.")
            return
        with self._lock:
            if self._here is None:
                self._server.set_aborted(None, "I do not know where I am, so I cannot remember this place.")
                return
            self._remembered[name] = self._here
            remembered = dict(self._remembered)
            place = place_of(name, to_pose(self._here), self._world)
        self._publish()
        self._updates.publish(WorldUpdate(objects=[place]))
        try:
            write_locations(remembered, self._memory_file)
        except OSError as error:
            self._server.set_aborted(
                None, f"I remember {words} until I am switched off, but could not write it down: {error}"
            )
            return
        rospy.loginfo("remembered '%s' at (%.2f, %.2f)", name, remembered[name].x_m, remembered[name].y_m)


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    run_node("location_memorizer", LocationMemorizer)
