"""Detections as sightings: boxes in images with depths, and boxes in space."""

import math
from dataclasses import dataclass
from typing import List, Optional, Sequence, Tuple

from object_perception.beliefs import Sighting, sighting_of
from object_perception.camera import Camera, Depths, depth_in_box
from object_perception.geometry import Transform, Vector, about_z, upright_box
from world_model.world_object import Pose

#: In a list of labels: the detector has a class that the robot need not know.
NO_LABEL = "-"
#: A class and its score.
Hypothesis = Tuple[int, float]


@dataclass(frozen=True)
class BoxInImage:
    """A detection in an image: centre and edges in pixels, and what it may be."""

    column: float
    row: float
    width: float
    height: float
    hypotheses: Tuple[Hypothesis, ...]


@dataclass(frozen=True)
class BoxInSpace:
    """A detection in space: a box in the frame of the sensor, and what it may be."""

    center: Transform
    size_m: Vector
    hypotheses: Tuple[Hypothesis, ...]


def best(hypotheses: Sequence[Hypothesis], labels: Sequence[str]) -> Optional[Tuple[str, float]]:
    """Return the label and the score of the best hypothesis; None if it has no label, or no score.

    Args:
        hypotheses: of one detection
        labels: by the number of the class
    """
    scored = [(score, number) for number, score in hypotheses if 0.0 <= score <= 1.0]
    if not scored:
        return None
    score, number = max(scored)
    if not 0 <= number < len(labels) or labels[number] == NO_LABEL:
        return None
    return labels[number], score


def sightings_in_image(
    boxes: Sequence[BoxInImage],
    camera: Camera,
    depths: Depths,
    place: Transform,
    *,
    labels: Sequence[str],
    world_frame: str,
) -> List[Sighting]:
    """Return what an image with depths shows. Boxes without a depth are left out.

    The place of a thing is the front that the camera sees; width and height are those of its box.

    Args:
        boxes: the detections
        camera: that took the image
        depths: of the same image
        place: where its optical frame is in the world
        labels: what the classes are called
        world_frame: name of the frame of the world
    """
    found = []
    for box in boxes:
        label = best(box.hypotheses, labels)
        if label is None:
            continue
        depth_m = depth_in_box(depths, box.column, box.row, box.width, box.height)
        if depth_m is None:
            continue
        x, y, z = place.of_point(camera.point_at(box.column, box.row, depth_m))
        width_m, height_m = box.width * depth_m / camera.focal_x, box.height * depth_m / camera.focal_y
        heading = math.atan2(y - place.position[1], x - place.position[0])
        pose = Pose(world_frame, x, y, z - height_m / 2.0, about_z(heading))
        # How deep it is, a single look does not show: as deep as wide.
        found.append(sighting_of(*label, pose, (width_m, width_m, height_m)))
    return found


def sightings_in_space(
    boxes: Sequence[BoxInSpace], place: Transform, *, labels: Sequence[str], world_frame: str
) -> List[Sighting]:
    """Return what boxes in the frame of a sensor are in the world.

    Args:
        boxes: the detections
        place: where the frame of the sensor is in the world
        labels: what the classes are called
        world_frame: name of the frame of the world
    """
    found = []
    for box in boxes:
        label = best(box.hypotheses, labels)
        # A detector that knows of no turn may leave it empty.
        center = box.center if any(box.center.turn) else Transform(box.center.position)
        if label is None or not center.is_rigid or not all(math.isfinite(edge) and edge >= 0.0 for edge in box.size_m):
            continue
        upright = upright_box(place.then(center), box.size_m)
        x, y, z = upright.bottom
        found.append(sighting_of(*label, Pose(world_frame, x, y, z, about_z(upright.heading_rad)), upright.size_m))
    return found
