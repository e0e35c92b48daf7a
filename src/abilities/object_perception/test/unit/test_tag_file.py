"""Files of tags, and the objects that their tags show."""

import math
from pathlib import Path

import pytest

from checked_files import FileRefused
from object_perception.geometry import Transform, of_roll_pitch_yaw
from object_perception.tag_file import SeenTag, load_tag_file, sightings_of_tags

CONFIG = Path(__file__).parents[2] / "config" / "tags.yaml"
#: The camera of a robot at a height of 1 m that looks along x of the world.
CAMERA = Transform((0.0, 0.0, 1.0), of_roll_pitch_yaw(-math.pi / 2.0, 0.0, -math.pi / 2.0))
#: A tag as the camera sees it when it faces it: its x to the right, its y up, its z towards the camera.
FACING = of_roll_pitch_yaw(math.pi, 0.0, 0.0)


def test_the_shipped_file_is_read() -> None:
    found = load_tag_file(CONFIG.read_text("utf-8"), str(CONFIG))
    assert {number: one.about.id for number, one in found.items()} == {7: "fridge_1", 11: "box_1", 12: "box_1"}
    assert found[7].about.category == "fridge" and found[11].about.attributes == ("blue",)


def test_a_tag_shows_where_its_object_stands() -> None:
    known = load_tag_file(CONFIG.read_text("utf-8"), str(CONFIG))
    tag = SeenTag(7, Transform((0.1, -0.2, 2.0), FACING))
    (one,) = sightings_of_tags([tag], known, CAMERA, score=0.85, world_frame="map")
    pose = one.about.pose
    # The tag is 1.2 m above the floor, on the front of the fridge, whose middle is 0.3 m behind it.
    assert pose is not None
    assert (pose.x_m, pose.y_m, pose.z_m) == pytest.approx((2.3, -0.1, 0.0))
    assert (one.about.id, one.score) == ("fridge_1", 0.85)


def test_two_tags_of_one_object_agree() -> None:
    known = load_tag_file(CONFIG.read_text("utf-8"), str(CONFIG))
    front = SeenTag(11, Transform((0.0, 0.0, 2.0), FACING))
    # From behind: the camera sees the back 0.2 m further.
    back = SeenTag(12, Transform((0.0, 0.0, 2.2), of_roll_pitch_yaw(math.pi, 0.0, 0.0)))
    turned_back = SeenTag(12, Transform(back.place.position, of_roll_pitch_yaw(math.pi, math.pi, 0.0)))
    one, other = sightings_of_tags([front, turned_back], known, CAMERA, score=0.8, world_frame="map")
    assert one.about.pose is not None and other.about.pose is not None
    first, second = one.about.pose, other.about.pose
    assert (first.x_m, first.y_m, first.z_m) == pytest.approx((second.x_m, second.y_m, second.z_m))
    assert math.cos(first.heading_rad - second.heading_rad) == pytest.approx(1.0)


def test_an_unknown_tag_and_a_wrong_pose_are_left_out() -> None:
    known = load_tag_file(CONFIG.read_text("utf-8"), str(CONFIG))
    tags = [
        SeenTag(99, Transform((0.0, 0.0, 1.0), FACING)),
        SeenTag(7, Transform((math.nan, 0.0, 1.0), FACING)),
        SeenTag(7, Transform((0.0, 0.0, 1.0), (0.0, 0.0, 0.0, 0.0))),
    ]
    assert sightings_of_tags(tags, known, CAMERA, score=0.85, world_frame="map") == []


@pytest.mark.parametrize(
    "text, code",
    [
        ("things: {}", "UNKNOWN_KEY"),
        ("objects: {a b: {tags: {1: }}}", "NOT_AN_OBJECT"),
        ("objects: {a: {size: [1, 1]}}", "MISSING_KEY"),
        ("objects: {a: {size: [1, 1], tags: {1: }}}", "NOT_A_SIZE"),
        ("objects: {a: {tags: {one: }}}", "NOT_A_TAG"),
        ("objects: {a: {tags: {70000: }}}", "NOT_A_TAG"),
        ("objects: {a: {tags: {1: {x: far}}}}", "NOT_A_NUMBER"),
        ("objects: {a: {tags: {1: }}, b: {tags: {1: }}}", "DUPLICATE_TAG"),
        ("objects: {a: {sort: animal, tags: {1: }}}", "UNKNOWN_VALUE"),
    ],
)
def test_mistakes_are_told(text: str, code: str) -> None:
    with pytest.raises(FileRefused) as refused:
        load_tag_file(text, "tags.yaml")
    assert code in {problem.code for problem in refused.value.problems}
