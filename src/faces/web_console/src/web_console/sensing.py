"""Camera images as pictures for a browser, and the numbers of messages that can be drawn over time."""

import math
from dataclasses import dataclass
from typing import Any, Dict, Mapping, Optional, Sequence, Tuple

import numpy as np

from web_console.ground import heading_of
from web_console.png import as_png

#: A picture is not larger than this, pixels: a page shows it small.
LONGEST_SIDE = 480
#: Channels of an encoding of sensor_msgs/Image with one byte each, in the order of red, green, blue.
_CHANNELS: Mapping[str, Tuple[int, Tuple[int, ...]]] = {
    "rgb8": (3, (0, 1, 2)),
    "bgr8": (3, (2, 1, 0)),
    "rgba8": (4, (0, 1, 2)),
    "bgra8": (4, (2, 1, 0)),
    "mono8": (1, (0,)),
    "8UC1": (1, (0,)),
    "8UC3": (3, (2, 1, 0)),
}
_MAGIC = {b"\xff\xd8\xff": "image/jpeg", b"\x89PN": "image/png"}

#: Numbers of a message by its type: what they are for persons, and where they stand. A path of two ends is a heading.
NUMBERS: Mapping[str, Mapping[str, str]] = {
    "nav_msgs/Odometry": {
        "x (m)": "pose.pose.position.x",
        "y (m)": "pose.pose.position.y",
        "heading (degrees)": "pose.pose.orientation",
        "forward speed (m/s)": "twist.twist.linear.x",
        "turning speed (rad/s)": "twist.twist.angular.z",
    },
    "geometry_msgs/Twist": {"forward speed (m/s)": "linear.x", "turning speed (rad/s)": "angular.z"},
    "sensor_msgs/BatteryState": {"charge": "percentage", "voltage (V)": "voltage", "current (A)": "current"},
    "sensor_msgs/Range": {"range (m)": "range"},
    "sensor_msgs/Temperature": {"temperature (C)": "temperature"},
    "std_msgs/Float32": {"value": "data"},
    "std_msgs/Float64": {"value": "data"},
    "std_msgs/Int32": {"value": "data"},
    "std_msgs/Bool": {"value": "data"},
}
CAMERAS = ("sensor_msgs/CompressedImage", "sensor_msgs/Image")
_MOST_OFFERED = 60


class NoPicture(ValueError):
    """A message is no picture that a browser can show; the message says why."""


@dataclass(frozen=True)
class Source:
    """A topic, and which of its numbers: none for a camera."""

    topic: str
    kind: str
    label: str
    path: str = ""


def sources_of(types: Mapping[str, str], published: Sequence[str]) -> Tuple[Source, ...]:
    """Return the cameras and then the numbers that somebody publishes, in the order of their names.

    Args:
        types: of the topics, by name
        published: the topics that somebody publishes
    """
    cameras: Dict[str, Source] = {}
    numbers = []
    for topic in sorted(published):
        kind = types.get(topic, "")
        if kind in CAMERAS:
            label = camera_name(topic)
            # The same picture is often there in both ways; the smaller one is taken.
            if label not in cameras or kind == CAMERAS[0]:
                cameras[label] = Source(topic, kind, label)
        for name, path in NUMBERS.get(kind, {}).items():
            numbers.append(Source(topic, kind, f"{topic.strip('/')}: {name}", path))
    return (*list(cameras.values())[:_MOST_OFFERED], *numbers[:_MOST_OFFERED])


def camera_name(topic: str) -> str:
    """Return the name of a camera for persons: "front camera" of /front_camera/rgb/image_raw/compressed."""
    parts = [part for part in topic.split("/") if part]
    words = [part for part in parts if not part.startswith("image") and part not in ("compressed", "rgb", "color")]
    return " ".join(words or parts).replace("_", " ") or "camera"


def number_of(message: Any, path: str) -> Optional[float]:
    """Return a number of a message; None when it is not finite."""
    for name in path.split("."):
        message = getattr(message, name)
    if hasattr(message, "w"):
        value = math.degrees(heading_of(message.x, message.y, message.z, message.w))
    else:
        value = float(message)
    return round(value, 4) if math.isfinite(value) else None


def compressed_picture(data: bytes) -> Tuple[str, bytes]:
    """Return the media type and the data of a compressed picture.

    Raises:
        NoPicture: it is neither JPEG nor PNG
    """
    kind = _MAGIC.get(bytes(data[:3]))
    if kind is None:
        raise NoPicture("it is neither JPEG nor PNG")
    return kind, bytes(data)


def picture_of(*, encoding: str, width: int, height: int, step: int, data: bytes) -> bytes:
    """Return the PNG of an image, smaller when it is large.

    Args:
        encoding: as sensor_msgs/Image names it
        width: pixels
        height: pixels
        step: bytes of a row
        data: the rows

    Raises:
        NoPicture: another encoding, or fewer bytes than it says
    """
    if encoding not in _CHANNELS:
        raise NoPicture(f"its encoding {encoding[:20]!r} cannot be shown, only {', '.join(_CHANNELS)}")
    count, order = _CHANNELS[encoding]
    if not (width > 0 and height > 0 and width * count <= step and step * height <= len(data)):
        raise NoPicture(f"{len(data)} bytes are not {width} by {height} pixels")
    rows = np.frombuffer(data, dtype=np.uint8, count=step * height).reshape(height, step)[:, : width * count]
    every = max(1, math.ceil(max(width, height) / LONGEST_SIDE))
    return as_png(rows.reshape(height, width, count)[::every, ::every][:, :, list(order)], level=1)
