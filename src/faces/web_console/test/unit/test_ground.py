"""Poses, paths and the picture of a map."""

import math
import struct
import zlib

import numpy as np
import pytest

from web_console.ground import Localization, Pose, heading_of, map_png, thinned


def close(pose, x_m, y_m, heading_rad):
    return (pose.x_m, pose.y_m, pose.heading_rad) == pytest.approx((x_m, y_m, heading_rad), abs=1e-3)


def test_poses_compose_and_invert():
    pose = Pose(1.0, 2.0, math.pi / 2)
    assert close(pose.compose(Pose(1.0, 0.0, 0.0)), 1.0, 3.0, math.pi / 2)
    assert close(pose.compose(pose.inverse()), 0.0, 0.0, 0.0)


def test_heading_of_a_quaternion():
    assert heading_of(0.0, 0.0, math.sin(1.0), math.cos(1.0)) == pytest.approx(2.0)


def test_odometry_alone():
    where = Localization()
    assert where.pose() is None
    where.moved(Pose(1.0, 0.0, 0.5), "odom")
    assert close(where.pose(), 1.0, 0.0, 0.5) and where.pose().frame == "odom"


def test_localization_corrects_odometry():
    where = Localization()
    where.moved(Pose(1.0, 0.0, 0.0), "odom")
    where.localized(Pose(5.0, 5.0, math.pi / 2), "map")
    where.moved(Pose(2.0, 0.0, 0.0), "odom")
    assert close(where.pose(), 5.0, 6.0, math.pi / 2) and where.pose().frame == "map"


def test_localization_before_odometry():
    where = Localization()
    where.localized(Pose(5.0, 5.0, 0.0), "map")
    assert close(where.pose(), 5.0, 5.0, 0.0)
    where.moved(Pose(1.0, 0.0, 0.0), "odom")
    where.moved(Pose(2.0, 0.0, 0.0), "odom")
    assert close(where.pose(), 6.0, 5.0, 0.0)


def test_only_motion_is_news():
    where = Localization()
    where.moved(Pose(0.0, 0.0, 0.0), "odom")
    assert where.news() is not None
    where.moved(Pose(0.0001, 0.0, 0.0), "odom")
    assert where.news() is None
    where.moved(Pose(0.0, 0.0, 0.1), "odom")
    assert where.news().heading_rad == pytest.approx(0.1)


def test_slow_motion_is_news_in_the_end():
    where = Localization()
    told = []
    for step in range(100):
        where.moved(Pose(0.001 * step, 0.0, 0.0), "odom")
        told.append(where.news())
    assert sum(one is not None for one in told) > 10


def test_paths_are_thinned_and_keep_their_ends():
    points = thinned([(float(x), 0.0) for x in range(10_000)] + [(math.nan, 0.0), (math.inf, 1.0)])
    assert 100 < len(points) <= 402
    assert (points[0].x_m, points[-1].x_m) == (0.0, 9999.0)
    assert thinned([]) == ()


def read_png(data):
    """Return the palette indices of a picture."""
    assert data.startswith(b"\x89PNG\r\n\x1a\n")
    chunks, at = {}, 8
    while at < len(data):
        size, name = struct.unpack(">I4s", data[at : at + 8])
        chunks[name] = data[at + 8 : at + 8 + size]
        assert struct.unpack(">I", data[at + 8 + size : at + 12 + size])[0] == zlib.crc32(name + chunks[name])
        at += 12 + size
    width, height = struct.unpack(">II", chunks[b"IHDR"][:8])
    rows = np.frombuffer(zlib.decompress(chunks[b"IDAT"]), dtype=np.uint8).reshape(height, width + 1)
    return rows[:, 1:].tolist()


def test_map_is_a_picture_with_north_up():
    cells = np.array([[0, 100, -1], [0, 0, 49]], dtype=np.int8)
    assert read_png(map_png(cells)) == [[1, 1, 1], [1, 2, 0]]


def test_large_maps_are_drawn_smaller_and_keep_thin_walls():
    cells = np.zeros((40, 4000), dtype=np.int8)
    cells[20, :] = 100
    drawn = np.array(read_png(map_png(cells)))
    assert drawn.shape[1] <= 1600
    assert (drawn == 2).any(axis=0).all()
