"""The node that turns AR tags into objects of the world."""

from dataclasses import dataclass
from typing import List, Tuple

import rospy
from ar_track_alvar_msgs.msg import AlvarMarkers
from std_msgs.msg import Header

from checked_files import FileRefused
from checked_files.source_files import read_text
from object_perception.beliefs import Sighting
from object_perception.camera import ConeView, NoView, View
from object_perception.geometry import Transform
from object_perception.ros_looks import Perceiver, transform_of
from object_perception.tag_file import SeenTag, load_tag_file, sightings_of_tags
from roboframenet_ros.parameters import Parameters, parameter
from roboframenet_ros.ros_node import StartError, read_parameters, run_node


@dataclass(frozen=True)
class Settings(Parameters):
    """The private parameters of this node, after validation.

    Attributes:
        tags_file: which objects carry which tags
        score: how sure a reading of a tag is; its message has no probability
        camera_frame: optical frame of the camera; empty: an image without a tag tells nothing
        view_rad: angle between the middle of the view and its rim, radians
        nearest_m: distances at which tags are read, metres
        furthest_m: the other bound, metres

    Raises:
        ParameterError: a value is not allowed
    """

    tags_file: str = parameter("")
    score: float = parameter(0.85, least=0.5, most=1.0)
    camera_frame: str = parameter("")
    view_rad: float = parameter(0.35, least=0.0, most=3.2)
    nearest_m: float = parameter(0.2, least=0.0, most=10.0)
    furthest_m: float = parameter(2.0, least=0.0, most=100.0)


class ArTags(Perceiver):
    """Turns AR tags into the objects that carry them.

    Subscribes:
        ar_pose_marker (ar_track_alvar_msgs/AlvarMarkers)
    Parameters: see :class:`Settings`, `object_perception.beliefs.BeliefSettings`.
    """

    def __init__(self, settings: Settings) -> None:
        """
        Raises:
            StartError: there is no file of tags, or it has mistakes
        """
        self._settings = settings
        try:
            self._tags = load_tag_file(read_text(settings.tags_file), settings.tags_file)
        except FileRefused as refused:
            raise StartError("; ".join(str(problem) for problem in refused.problems)) from refused
        super().__init__()
        self._subscriber = rospy.Subscriber("ar_pose_marker", AlvarMarkers, self._on_markers, queue_size=10)
        self._looks.start()
        rospy.loginfo("ready: %d tags, %s", len(self._tags), settings)

    def _on_markers(self, message: AlvarMarkers) -> None:
        settings = self._settings
        if not message.markers and not settings.camera_frame:
            return
        # The header of the list is empty, and so is that of each pose; those of the markers are right.
        header = message.markers[0].header if message.markers else Header(frame_id=settings.camera_frame)
        seen = [SeenTag(one.id, transform_of(one.pose.pose)) for one in message.markers]

        def reading(place: Transform, camera: Transform) -> Tuple[List[Sighting], View]:
            found = sightings_of_tags(
                seen, self._tags, place, score=settings.score, world_frame=self._looks.world_frame
            )
            if not settings.camera_frame:
                return found, NoView()
            return found, ConeView(camera, settings.view_rad, settings.nearest_m, settings.furthest_m)

        self._looks.add(header, reading, sensor_frame=settings.camera_frame)


def main() -> None:
    """Run the node until ROS shuts down; exit with a message if it cannot start."""
    run_node("ar_tags_to_world", lambda: ArTags(read_parameters(Settings)))
