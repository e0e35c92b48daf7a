#!/usr/bin/env python3
"""Makes the bags that the tests replay: a robot looks at a table for twelve seconds, and drives half a metre meanwhile.

    make_bags.py FOLDER      writes image.bag, space.bag and tags.bag

Each bag has the same scene: two mugs on a table, and a wall behind. The second mug is taken away at 6 s and stands
elsewhere from 9.5 s on; something hides the first one for a while. Each has the noise of its detector: places that vary
by a centimetre, looks that miss, things that are not there, detections that are unsure.
"""

import math
import random
import sys
from pathlib import Path
from typing import Any, Dict, Iterator, List, Optional, Tuple

import genpy
import numpy as np
import rosbag
from ar_track_alvar_msgs.msg import AlvarMarker, AlvarMarkers
from geometry_msgs.msg import Pose, Quaternion, TransformStamped, Vector3
from sensor_msgs.msg import CameraInfo, Image
from tf2_msgs.msg import TFMessage
from vision_msgs.msg import (
    Detection2D,
    Detection2DArray,
    Detection3D,
    Detection3DArray,
    ObjectHypothesisWithPose,
)

from object_perception.camera import Camera
from object_perception.geometry import Transform, Vector, of_roll_pitch_yaw

#: ROS time at which the bags begin, seconds.
BEGIN_S = 1000.0
LENGTH_S = 12.0
RATE_HZ = 10
CAMERA = Camera(100.0, 100.0, 80.0, 60.0, 160, 120)
#: The optical frame on the robot.
MOUNT = Transform((0.1, 0.0, 1.0), of_roll_pitch_yaw(-math.pi / 2.0, 0.0, -math.pi / 2.0))
WALL_M = 4.5
MUG, BOTTLE, PERSON = 0, 1, 2
#: What is hidden by nothing that stands further away.
SIZE: Vector = (0.1, 0.1, 0.12)
FIRST: Vector = (2.5, 0.2, 0.8)
SECOND: Vector = (2.5, -0.3, 0.8)
ELSEWHERE: Vector = (2.6, 0.6, 0.8)
TAG_OF = {"first": 3, "second": 4}


def robot_at(time_s: float) -> Transform:
    """Return where the base is: it drives half a metre between 2 s and 4 s."""
    return Transform((min(max(time_s - 2.0, 0.0), 2.0) * 0.25, 0.0, 0.0))


def things_at(time_s: float) -> Dict[str, Vector]:
    """Return the middle of the bottom of what stands there."""
    found = {"first": FIRST}
    if time_s < 6.0:
        found["second"] = SECOND
    elif time_s >= 9.5:
        found["second"] = ELSEWHERE
    return found


def is_hidden(name: str, time_s: float) -> bool:
    """Whether somebody stands before a thing."""
    return name == "first" and 7.0 <= time_s < 9.0


def looks() -> Iterator[Tuple[float, Transform, random.Random]]:
    """Yield the times of the images, where the camera is, and the noise."""
    noise = random.Random(7)
    for number in range(int(LENGTH_S * RATE_HZ)):
        time_s = number / RATE_HZ
        yield time_s, robot_at(time_s).then(MOUNT), noise


def stamp_of(time_s: float) -> genpy.Time:
    return genpy.Time.from_sec(BEGIN_S + time_s)


def transform(parent: str, child: str, where: Transform, time_s: float) -> TransformStamped:
    message = TransformStamped(child_frame_id=child)
    message.header.frame_id, message.header.stamp = parent, stamp_of(time_s)
    message.transform.translation, message.transform.rotation = Vector3(*where.position), Quaternion(*where.turn)
    return message


def write_transforms(bag: rosbag.Bag) -> None:
    """Write tf: the camera stands on the base, and the base drives in the map."""
    static = TFMessage([transform("base_link", "camera_optical_frame", MOUNT, 0.0)])
    # Once a second: whoever listens late to a bag has no latched message.
    for number in range(int(LENGTH_S)):
        bag.write("/tf_static", static, stamp_of(float(number)))
    for number in range(int(LENGTH_S * 50)):
        time_s = number / 50.0
        bag.write("/tf", TFMessage([transform("map", "base_link", robot_at(time_s), time_s)]), stamp_of(time_s))


def hypothesis(label: int, score: float) -> ObjectHypothesisWithPose:
    return ObjectHypothesisWithPose(id=label, score=score)


def seen_by(camera: Transform, time_s: float, noise: random.Random) -> List[Tuple[int, float, Vector]]:
    """Return label, score and middle, in the frame of the camera, of what a detector reports."""
    found: List[Tuple[int, float, Vector]] = []
    for name, (x, y, z) in things_at(time_s).items():
        # One look in ten misses.
        if not is_hidden(name, time_s) and noise.random() > 0.1:
            shift = [noise.gauss(0.0, 0.01) for _ in range(3)]
            middle = (x + shift[0], y + shift[1], z + SIZE[2] / 2.0 + shift[2])
            found.append((MUG, noise.uniform(0.7, 0.95), camera.inverse().of_point(middle)))
    if abs(time_s - 3.0) < 0.01:
        found.append((BOTTLE, 0.8, (0.2, -0.1, 1.5)))  # for one image only
    if noise.random() < 0.5:
        found.append((PERSON, 0.35, (-0.3, 0.0, 2.0)))  # unsure
    return found


def depths_at(camera: Transform, time_s: float) -> "np.ndarray[Any, Any]":
    """Return what the depth camera measures: a wall, the mugs before it, and who stands before the first one."""
    depths = np.full((CAMERA.height, CAMERA.width), WALL_M - camera.position[0])
    for name, (x, y, z) in things_at(time_s).items():
        middle = camera.inverse().of_point((x, y, z + SIZE[2] / 2.0))
        box = box_of(middle)
        if box is not None:
            fill(depths, box, middle[2])
            if is_hidden(name, time_s):
                left, top, width, height = box
                fill(depths, (left - 10.0, top - 30.0, width + 20.0, height + 60.0), 0.8)
    return depths


def box_of(middle: Vector) -> Optional[Tuple[float, float, float, float]]:
    """Return left, top, width and height in the image of a thing of the size of a mug."""
    pixel = CAMERA.pixel_of(middle)
    if pixel is None:
        return None
    width, height = CAMERA.focal_x * SIZE[1] / middle[2], CAMERA.focal_y * SIZE[2] / middle[2]
    return pixel[0] - width / 2.0, pixel[1] - height / 2.0, width, height


def fill(depths: "np.ndarray[Any, Any]", box: Tuple[float, float, float, float], depth_m: float) -> None:
    left, top, width, height = box
    rows = slice(max(math.floor(top), 0), max(math.ceil(top + height), 0))
    depths[rows, max(math.floor(left), 0) : max(math.ceil(left + width), 0)] = depth_m


def write_image_bag(path: Path) -> None:
    """Write detections in images, with depth images and the calibration of the camera."""
    with rosbag.Bag(str(path), "w", compression=rosbag.Compression.BZ2) as bag:
        write_transforms(bag)
        for time_s, camera, noise in looks():
            stamp = stamp_of(time_s)
            depths = (depths_at(camera, time_s) * 1000.0).astype("<u2")
            depth = Image(height=CAMERA.height, width=CAMERA.width, encoding="16UC1", step=2 * CAMERA.width)
            depth.data = depths.tobytes()
            info = CameraInfo(height=CAMERA.height, width=CAMERA.width, distortion_model="plumb_bob")
            info.K = [CAMERA.focal_x, 0.0, CAMERA.center_x, 0.0, CAMERA.focal_y, CAMERA.center_y, 0.0, 0.0, 1.0]
            detections = Detection2DArray()
            for label, score, middle in seen_by(camera, time_s, noise):
                box = box_of(middle)
                if box is None:
                    continue
                left, top, width, height = box
                one = Detection2D(results=[hypothesis(label, score)])
                one.bbox.center.x, one.bbox.center.y = left + width / 2.0, top + height / 2.0
                one.bbox.size_x, one.bbox.size_y = width, height
                detections.detections.append(one)
            for message in (depth, info, detections):
                message.header.frame_id, message.header.stamp = "camera_optical_frame", stamp
            bag.write("/camera/camera_info", info, stamp)
            bag.write("/camera/depth", depth, stamp)
            bag.write("/camera/detections", detections, stamp)


def write_space_bag(path: Path) -> None:
    """Write detections in space."""
    with rosbag.Bag(str(path), "w", compression=rosbag.Compression.BZ2) as bag:
        write_transforms(bag)
        for time_s, camera, noise in looks():
            detections = Detection3DArray()
            detections.header.frame_id, detections.header.stamp = "camera_optical_frame", stamp_of(time_s)
            for label, score, middle in seen_by(camera, time_s, noise):
                one = Detection3D(header=detections.header, results=[hypothesis(label, score)])
                one.bbox.center = Pose(orientation=Quaternion(0.0, 0.0, 0.0, 1.0))
                one.bbox.center.position.x, one.bbox.center.position.y, one.bbox.center.position.z = middle
                one.bbox.size = Vector3(SIZE[0], SIZE[2], SIZE[1])
                detections.detections.append(one)
            bag.write("/camera/detections", detections, stamp_of(time_s))


def write_tag_bag(path: Path) -> None:
    """Write what ar_track_alvar reports of the tags on the mugs; its list has an empty header."""
    facing = of_roll_pitch_yaw(math.pi, 0.0, 0.0)
    with rosbag.Bag(str(path), "w", compression=rosbag.Compression.BZ2) as bag:
        write_transforms(bag)
        for time_s, camera, noise in looks():
            markers = AlvarMarkers()
            for name, (x, y, z) in things_at(time_s).items():
                if is_hidden(name, time_s) or noise.random() < 0.1:
                    continue
                # On the front of the mug, in the middle of its height.
                front = (x - SIZE[0] / 2.0 + noise.gauss(0.0, 0.005), y, z + SIZE[2] / 2.0)
                markers.markers.append(marker(TAG_OF[name], camera.inverse().of_point(front), facing, time_s))
            if abs(time_s - 3.0) < 0.01:
                markers.markers.append(marker(5, (0.2, 0.0, 1.0), facing, time_s))  # read wrongly, once
            bag.write("/ar_pose_marker", markers, stamp_of(time_s))


def marker(number: int, position: Vector, turn: Tuple[float, float, float, float], time_s: float) -> AlvarMarker:
    message = AlvarMarker(id=number)
    message.header.frame_id, message.header.stamp = "camera_optical_frame", stamp_of(time_s)
    message.pose.pose.orientation = Quaternion(*turn)
    message.pose.pose.position.x, message.pose.pose.position.y, message.pose.pose.position.z = position
    return message


def main(folder: Path) -> None:
    """Write the three bags."""
    folder.mkdir(parents=True, exist_ok=True)
    write_image_bag(folder / "image.bag")
    write_space_bag(folder / "space.bag")
    write_tag_bag(folder / "tags.bag")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
