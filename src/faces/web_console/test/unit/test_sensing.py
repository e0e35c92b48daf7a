"""Images of cameras become pictures for a browser; numbers of messages are found by their types."""

import math
import struct
import types
import zlib

import numpy as np
import pytest

from web_console.sensing import (
    LONGEST_SIDE,
    NoPicture,
    camera_name,
    compressed_picture,
    number_of,
    picture_of,
    sources_of,
)


def pixels_of(png):
    """Read a PNG as this module writes it: width, height, and the pixels of its rows."""
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    at, data = 8, b""
    while at < len(png):
        (length,) = struct.unpack(">I", png[at : at + 4])
        name, body = png[at + 4 : at + 8], png[at + 8 : at + 8 + length]
        assert struct.unpack(">I", png[at + 8 + length : at + 12 + length]) == (zlib.crc32(name + body),)
        if name == b"IHDR":
            width, height, _, colour = struct.unpack(">IIBB", body[:10])
        elif name == b"IDAT":
            data += body
        at += 12 + length
    depth = {2: 3, 0: 1}[colour]
    rows = np.frombuffer(zlib.decompress(data), dtype=np.uint8).reshape(height, 1 + width * depth)
    assert not rows[:, 0].any()
    return width, height, rows[:, 1:].reshape(height, width, depth).tolist()


@pytest.mark.parametrize(
    ("encoding", "data", "pixel"),
    [
        ("rgb8", b"\x01\x02\x03", [1, 2, 3]),
        ("bgr8", b"\x01\x02\x03", [3, 2, 1]),
        ("rgba8", b"\x01\x02\x03\xff", [1, 2, 3]),
        ("bgra8", b"\x01\x02\x03\xff", [3, 2, 1]),
        ("mono8", b"\x07", [7]),
    ],
)
def test_encodings(encoding, data, pixel):
    # Two pixels in a row, which has three more bytes at its end.
    row = 2 * data + b"\x00\x00\x00"
    png = picture_of(encoding=encoding, width=2, height=2, step=len(row), data=2 * row)
    assert pixels_of(png) == (2, 2, [[pixel, pixel], [pixel, pixel]])


def test_large_images_become_small():
    width, height = 1280, 720
    data = np.zeros((height, width, 3), dtype=np.uint8)
    data[:, :, 0] = np.arange(width) % 256
    png = picture_of(encoding="rgb8", width=width, height=height, step=3 * width, data=data.tobytes())
    wide, high, pixels = pixels_of(png)
    assert (wide, high) == (427, 240) and wide <= LONGEST_SIDE
    assert pixels[5][7] == [21, 0, 0]


@pytest.mark.parametrize(
    ("said", "problem"),
    [
        ({"encoding": "16UC1"}, "16UC1"),
        ({"encoding": "yuv422"}, "yuv422"),
        ({"data": b"short"}, "5 bytes"),
        ({"width": 0}, "0 by 2"),
        ({"step": 2}, "pixels"),
    ],
)
def test_what_is_no_picture(said, problem):
    image = {"encoding": "rgb8", "width": 2, "height": 2, "step": 6, "data": bytes(12), **said}
    with pytest.raises(NoPicture, match=problem):
        picture_of(**image)


def test_compressed_pictures_are_passed_on():
    assert compressed_picture(b"\xff\xd8\xff\xe0rest") == ("image/jpeg", b"\xff\xd8\xff\xe0rest")
    assert compressed_picture(b"\x89PNG")[0] == "image/png"
    with pytest.raises(NoPicture):
        compressed_picture(b"<svg onload=alert(1)>")


@pytest.mark.parametrize(
    ("topic", "name"),
    [
        ("/front_camera/rgb/image_raw/compressed", "front camera"),
        ("/camera/color/image_raw", "camera"),
        ("/robot1/wrist/image", "robot1 wrist"),
        ("/image", "image"),
    ],
)
def test_cameras_have_names_for_persons(topic, name):
    assert camera_name(topic) == name


def test_what_can_be_looked_at():
    kinds = {
        "/front/image_raw": "sensor_msgs/Image",
        "/front/image_raw/compressed": "sensor_msgs/CompressedImage",
        "/old/image": "sensor_msgs/Image",
        "/odom": "nav_msgs/Odometry",
        "/battery": "sensor_msgs/BatteryState",
        "/text": "std_msgs/String",
    }
    found = sources_of(kinds, [topic for topic in kinds if topic != "/old/image"])
    assert [(one.topic, one.label) for one in found if not one.path] == [("/front/image_raw/compressed", "front")]
    labels = [one.label for one in found if one.path]
    assert "battery: charge" in labels and "odom: forward speed (m/s)" in labels
    assert not [label for label in labels if "text" in label]


def message(**parts):
    return types.SimpleNamespace(**parts)


def test_numbers_of_messages():
    half = math.sqrt(0.5)
    odometry = message(pose=message(pose=message(orientation=message(x=0.0, y=0.0, z=half, w=half))))
    assert number_of(odometry, "pose.pose.orientation") == 90.0
    assert number_of(message(data=True), "data") == 1.0
    assert number_of(message(data=float("nan")), "data") is None
