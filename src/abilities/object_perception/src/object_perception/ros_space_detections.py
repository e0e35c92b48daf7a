"""The node that turns detections in space into objects of the world."""

from dataclasses import dataclass
from typing import List, Tuple

import rospy
from vision_msgs.msg import Detection3D, Detection3DArray

from object_perception.beliefs import Sighting
from object_perception.camera import ConeView, Forward, NoView, View
from object_perception.detections import BoxInSpace, sightings_in_space
from object_perception.geometry import Transform
from object_perception.ros_looks import Perceiver, check_labels, transform_of
from roboframenet_ros.parameters import Parameters, parameter
from roboframenet_ros.ros_node import read_parameters, run_node


@dataclass(frozen=True)
class Settings(Parameters):
    """The private parameters of this node, after validation.

    Attributes:
        labels: names of the classes by their number; "-" for one that is of no interest
        view_rad: angle between the middle of the view and its rim, radians; 0: a look without a thing tells nothing
        nearest_m: distances at which things are found, metres
        furthest_m: the other bound, metres
        forward: the axis along which the sensor looks

    Raises:
        ParameterError: a value is not allowed
    """

    labels: Tuple[str, ...] = parameter(())
    view_rad: float = parameter(0.35, least=0.0, most=3.2)
    nearest_m: float = parameter(0.3, least=0.0, most=10.0)
    furthest_m: float = parameter(3.0, least=0.0, most=100.0)
    forward: Forward = parameter(Forward.Z)


class SpaceDetections(Perceiver):
    """Turns detections in space into objects.

    Subscribes:
        detections (vision_msgs/Detection3DArray)
    Parameters: see :class:`Settings`, `object_perception.beliefs.BeliefSettings`.
    """

    def __init__(self, settings: Settings) -> None:
        """
        Raises:
            StartError: there are no labels
        """
        check_labels(settings.labels)
        super().__init__()
        self._settings = settings
        self._subscriber = rospy.Subscriber("detections", Detection3DArray, self._on_detections, queue_size=10)
        self._looks.start()
        rospy.loginfo("ready: %s", settings)

    def _on_detections(self, message: Detection3DArray) -> None:
        boxes = [_box(one) for one in message.detections]

        def reading(place: Transform, _: Transform) -> Tuple[List[Sighting], View]:
            found = sightings_in_space(boxes, place, labels=self._settings.labels, world_frame=self._looks.world_frame)
            settings = self._settings
            if not settings.view_rad:
                return found, NoView()
            return found, ConeView(place, settings.view_rad, settings.nearest_m, settings.furthest_m, settings.forward)

        self._looks.add(message.header, reading)


def _box(message: Detection3D) -> BoxInSpace:
    """Convert a detection; one without a box is where its best hypothesis is."""
    size = (message.bbox.size.x, message.bbox.size.y, message.bbox.size.z)
    center = transform_of(message.bbox.center)
    if not any(size) and message.results:
        center = transform_of(max(message.results, key=lambda result: result.score).pose.pose)
    return BoxInSpace(center, size, tuple((result.id, result.score) for result in message.results))


def main() -> None:
    """Run the node until ROS shuts down; exit with a message if it cannot start."""
    run_node("detections_3d_to_world", lambda: SpaceDetections(read_parameters(Settings)))
