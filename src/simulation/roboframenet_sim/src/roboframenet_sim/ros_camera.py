"""The topics of a simulated person and of the depth camera that sees the person."""

import math
import sys
import threading
from dataclasses import dataclass
from typing import Optional, Sequence

import numpy as np
import rospy
from geometry_msgs.msg import PoseStamped
from sensor_msgs.msg import PointCloud2, PointField
from std_msgs.msg import ColorRGBA, Header, String
from visualization_msgs.msg import Marker

from roboframenet_ros.parameters import Parameters, parameter
from roboframenet_ros.ros_publishing import publish
from roboframenet_sim.base import Pose
from roboframenet_sim.person import Person, PersonAct, PersonSettings
from roboframenet_sim.point_cloud import Camera, Cylinder, render

POINT_STEP_BYTES = 16
"""x, y, z and four bytes of padding, as the drivers of depth cameras send it."""


@dataclass(frozen=True)
class CameraSettings(Parameters):
    """Private parameters of the camera and of the person, checked.

    Attributes:
        camera_width_px: width of the point cloud
        camera_height_px: height of the point cloud
        camera_rate_hz: rate of the point cloud
        camera_frame: frame of the point cloud
        person: whether there is a person in front of the robot
        person_distance_m: from the robot to the person's skin, at first and after COME
        person_path_m: length of the walk
        person_radius_m: radius of the two bends of the walk
        person_speed_m_per_s: speed of the walk

    Raises:
        ParameterError: a value out of its range
    """

    camera_width_px: int = parameter(160, least=2, most=4096)
    camera_height_px: int = parameter(120, least=2, most=4096)
    camera_rate_hz: float = parameter(10.0, least=0.1, most=60.0)
    camera_frame: str = parameter("camera_depth_optical_frame")
    person: bool = parameter(False)
    person_distance_m: float = parameter(PersonSettings.distance_m, above=0.0)
    person_path_m: float = parameter(PersonSettings.path_m, above=0.0)
    person_radius_m: float = parameter(PersonSettings.radius_m, above=0.0)
    person_speed_m_per_s: float = parameter(PersonSettings.speed_m_per_s, above=0.0)

    @property
    def walk(self) -> PersonSettings:
        """How the person walks."""
        return PersonSettings(
            distance_m=self.person_distance_m,
            path_m=self.person_path_m,
            radius_m=self.person_radius_m,
            speed_m_per_s=self.person_speed_m_per_s,
        )


def message_of_cloud(cloud: np.ndarray, *, header: Header) -> PointCloud2:
    """Pack an organised cloud.

    Args:
        cloud: (height, width, 3) array of float32
        header: stamp and optical frame
    """
    height, width = cloud.shape[:2]
    packed = np.zeros((height, width, POINT_STEP_BYTES // 4), dtype=np.float32)
    packed[..., :3] = cloud
    return PointCloud2(
        header=header,
        height=height,
        width=width,
        is_bigendian=sys.byteorder == "big",
        is_dense=False,
        fields=[
            PointField(name=name, offset=4 * index, datatype=PointField.FLOAT32, count=1)
            for index, name in enumerate("xyz")
        ],
        point_step=POINT_STEP_BYTES,
        row_step=POINT_STEP_BYTES * width,
        data=packed.tobytes(),
    )


class RosPerson:
    """The person and the camera.

    Subscribes:
        ``person/act`` (std_msgs/String): stand, walk, leave, come
    Publishes:
        ``person/pose`` (geometry_msgs/PoseStamped) and ``person/marker`` (visualization_msgs/Marker) while present,
        ``camera/depth/points`` (sensor_msgs/PointCloud2) while there are subscribers
    """

    def __init__(
        self, settings: CameraSettings, *, person: Optional[Person], fixed_frame: str, robot: Pose, walls: np.ndarray
    ) -> None:
        self._frame = settings.camera_frame
        self._camera = Camera(width_px=settings.camera_width_px, height_px=settings.camera_height_px)
        self._period_s = 1.0 / settings.camera_rate_hz
        self._person = person
        self._fixed_frame = fixed_frame
        self._robot = robot
        self._walls = walls
        self._lock = threading.Lock()
        self._since_image_s = math.inf
        self._cloud = rospy.Publisher("camera/depth/points", PointCloud2, queue_size=1)
        self._pose = rospy.Publisher("person/pose", PoseStamped, queue_size=1)
        self._marker = rospy.Publisher("person/marker", Marker, queue_size=1)
        self._subscriber = rospy.Subscriber("person/act", String, self._take_order, queue_size=10)

    def _take_order(self, message: String) -> None:
        names = [act.value for act in PersonAct]
        if message.data not in names or self._person is None:
            rospy.logwarn("person/act: %r; expected one of %s, with ~person true", message.data, ", ".join(names))
            return
        with self._lock:
            self._person.order(PersonAct(message.data), robot=self._robot)
        rospy.loginfo("person: %s", message.data)

    def bodies(self) -> Sequence[Cylinder]:
        """Return the body of the person; none while there is no person."""
        with self._lock:
            person = self._person
            if person is None or not person.is_present:
                return ()
            pose, settings = person.pose, person.settings
        return (Cylinder(pose.x_m, pose.y_m, settings.body_radius_m, settings.height_m),)

    def step(self, duration_s: float, stamp: rospy.Time, *, robot: Pose) -> None:
        """Advance the time.

        Args:
            duration_s: duration of the step in seconds
            stamp: stamp of the messages
            robot: present pose of the robot
        """
        with self._lock:
            self._robot = robot
            if self._person is not None:
                self._person.step(duration_s)
        body = next(iter(self.bodies()), None)
        self._since_image_s += duration_s
        if self._since_image_s + 1e-9 < self._period_s:
            return
        # A delay of less than a picture is carried over, so that the mean rate is right.
        self._since_image_s = min(self._since_image_s - self._period_s, self._period_s)
        if body is not None:
            self._show(body, stamp)
        if self._cloud.get_num_connections():
            cloud = render(self._camera, pose=robot, person=body, walls=self._walls)
            publish(self._cloud, message_of_cloud(cloud, header=Header(stamp=stamp, frame_id=self._frame)))

    def _show(self, body: Cylinder, stamp: rospy.Time) -> None:
        pose = PoseStamped(header=Header(stamp=stamp, frame_id=self._fixed_frame))
        pose.pose.position.x, pose.pose.position.y, pose.pose.orientation.w = body.x_m, body.y_m, 1.0
        publish(self._pose, pose)
        if not self._marker.get_num_connections():
            return
        marker = Marker(
            header=pose.header,
            ns="person",
            type=Marker.CYLINDER,
            action=Marker.ADD,
            color=ColorRGBA(r=0.9, g=0.5, b=0.2, a=0.8),
            lifetime=rospy.Duration(1.0),
        )
        marker.pose = pose.pose
        marker.pose.position.z = body.height_m / 2.0
        marker.scale.x = marker.scale.y = 2.0 * body.radius_m
        marker.scale.z = body.height_m
        publish(self._marker, marker)
