"""The node that turns detections in images with depths into objects of the world."""

from dataclasses import dataclass
from typing import List, Optional, Tuple

import message_filters
import rospy
from sensor_msgs.msg import CameraInfo, Image
from vision_msgs.msg import Detection2DArray

from object_perception.beliefs import Sighting
from object_perception.camera import Camera, DepthError, ImageView, View, depths_of
from object_perception.detections import BoxInImage, sightings_in_image
from object_perception.geometry import Transform
from object_perception.ros_looks import Perceiver, check_labels
from roboframenet_ros.parameters import Parameters, parameter
from roboframenet_ros.ros_node import read_parameters, run_node


@dataclass(frozen=True)
class Settings(Parameters):
    """The private parameters of this node, after validation.

    Attributes:
        labels: names of the classes by their number; "-" for one that is of no interest
        slop_s: detections and a depth image whose stamps differ by no more are of one look, seconds
        nearest_m: depths at which things are found, metres
        furthest_m: the other bound, metres

    Raises:
        ParameterError: a value is not allowed
    """

    labels: Tuple[str, ...] = parameter(())
    slop_s: float = parameter(0.05, least=0.001, most=1.0)
    nearest_m: float = parameter(0.3, least=0.0, most=10.0)
    furthest_m: float = parameter(4.0, least=0.1, most=100.0)


class ImageDetections(Perceiver):
    """Turns detections in images with depths into objects.

    Subscribes:
        detections (vision_msgs/Detection2DArray), depth (sensor_msgs/Image, registered to the image of the detections),
        camera_info (sensor_msgs/CameraInfo)
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
        self._camera: Optional[Camera] = None
        self._frame_id = ""
        self._info = rospy.Subscriber("camera_info", CameraInfo, self._on_camera, queue_size=1)
        detections = message_filters.Subscriber("detections", Detection2DArray, queue_size=10)
        depth = message_filters.Subscriber("depth", Image, queue_size=10)
        self._both = message_filters.ApproximateTimeSynchronizer([detections, depth], 20, settings.slop_s)
        self._both.registerCallback(self._on_both)
        self._looks.start()
        rospy.loginfo("ready: %s", settings)

    def _on_camera(self, message: CameraInfo) -> None:
        focal_x, focal_y, center_x, center_y = message.K[0], message.K[4], message.K[2], message.K[5]
        if focal_x > 0.0 and focal_y > 0.0 and message.width and message.height:
            self._frame_id = message.header.frame_id
            self._camera = Camera(focal_x, focal_y, center_x, center_y, message.width, message.height)
        else:
            rospy.logwarn_throttle(10.0, "the camera is not calibrated: camera_info has no focal length")

    def _on_both(self, detections: Detection2DArray, depth: Image) -> None:
        camera = self._camera
        if camera is None:
            rospy.logwarn_throttle(10.0, f"nothing was heard on {rospy.resolve_name('camera_info')}")
            return
        if (depth.width, depth.height) != (camera.width, camera.height):
            rospy.logwarn_throttle(
                10.0,
                f"the depth image has {depth.width} x {depth.height} pixels and the camera {camera.width} x "
                f"{camera.height}: it must be registered to the image of the detections",
            )
            return
        try:
            depths = depths_of(
                depth.data,
                width=depth.width,
                height=depth.height,
                row_bytes=depth.step,
                encoding=depth.encoding,
                is_bigendian=bool(depth.is_bigendian),
            )
        except DepthError as error:
            rospy.logwarn_throttle(10.0, str(error))
            return
        boxes = [
            BoxInImage(
                one.bbox.center.x,
                one.bbox.center.y,
                one.bbox.size_x,
                one.bbox.size_y,
                tuple((result.id, result.score) for result in one.results),
            )
            for one in detections.detections
        ]

        def reading(place: Transform, _: Transform) -> Tuple[List[Sighting], View]:
            found = sightings_in_image(
                boxes, camera, depths, place, labels=self._settings.labels, world_frame=self._looks.world_frame
            )
            return found, ImageView(camera, depths, place, self._settings.nearest_m, self._settings.furthest_m)

        self._looks.add(depth.header, reading, frame_id=self._frame_id)


def main() -> None:
    """Run the node until ROS shuts down; exit with a message if it cannot start."""
    run_node("detections_2d_to_world", lambda: ImageDetections(read_parameters(Settings)))
