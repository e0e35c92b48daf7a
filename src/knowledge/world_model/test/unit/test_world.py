"""What a snapshot tells: names, categories, rooms and relations."""

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from world_model import Pose, Relation, Sort, World, WorldObject
from world_model.names import known_names
from world_model.world import MOST_OBJECTS, NEAR_M, snapshot
from world_model.world_file import load_world_file

HOME = """
places:
  kitchen: {x: 0, y: 0, size: [4, 4], names: [cooking place]}
  hall: {x: 5, y: 0, size: [4, 4]}
  home:
doors:
  kitchen_door: {category: door, to: [kitchen, hall], states: [closed]}
things:
  coffee_table: {x: 1, y: 1, in: kitchen}
  tray_1: {on: coffee_table}
  mug_1: {on: tray_1, attributes: [red]}
  mug_2: {x: 5, y: 1}
  sofa_1: {beside: coffee_table}
  chair_1: {in: hall}
  reading_lamp: {category: lamp, in: hall}
persons:
  anna: {in: hall, names: [Mrs. Miller]}
  rose: {}
"""


@pytest.fixture(scope="module")
def world() -> World:
    return snapshot("1", {one.id: one for one in load_world_file(HOME, "home.yaml")})


def ids(objects) -> set:
    return {one.id for one in objects}


@pytest.mark.parametrize(
    "noun, expected",
    [
        ("mug", {"mug_1", "mug_2"}),
        ("container", {"mug_1", "mug_2", "tray_1"}),
        ("table", {"coffee_table"}),
        ("couch", {"sofa_1"}),
        ("furniture", {"sofa_1", "chair_1", "coffee_table"}),
        ("person", {"anna", "rose"}),
        ("light", {"reading_lamp"}),
        ("unicorn", set()),
    ],
)
def test_noun_stands_for_objects_of_its_kind(world: World, noun: str, expected: set) -> None:
    assert ids(world.kinds_of(noun)) == expected


def test_names_are_found_in_any_case(world: World) -> None:
    assert ids(world.named("Mrs.  miller")) == {"anna"}
    assert ids(world.named("the kitchen")) == set()


@pytest.mark.parametrize(
    "name, room",
    [
        ("mug_1", "kitchen"),
        ("mug_2", "hall"),
        ("sofa_1", "kitchen"),
        ("anna", "hall"),
        ("rose", None),
        ("hall", "hall"),
    ],
)
def test_room_follows_from_what_carries_an_object_or_from_its_pose(world: World, name: str, room: str) -> None:
    found = world.room_of(world.by_id[name])
    assert (found.id if found else None) == room


@pytest.mark.parametrize(
    "one, relation, other, expected",
    [
        ("mug_1", "on", "coffee_table", True),
        ("mug_1", "in", "kitchen", True),
        ("mug_1", "in", "coffee_table", False),
        ("mug_2", "in", "kitchen", False),
        ("coffee_table", "on", "mug_1", False),
        ("coffee_table", "under", "tray_1", True),
        ("coffee_table", "near", "sofa_1", True),
        ("tray_1", "near", "mug_2", False),
    ],
)
def test_relations_of_place(world: World, one: str, relation: str, other: str, expected: bool) -> None:
    assert world.stands(world.by_id[one], relation, world.by_id[other]) is expected


def test_things_on_each_other_in_a_circle_have_no_room() -> None:
    world = World(
        "1", (WorldObject("a", relations=(Relation("on", "b"),)), WorldObject("b", relations=(Relation("on", "a"),)))
    )
    assert world.room_of(world.by_id["a"]) is None
    assert world.stands(world.by_id["a"], "on", world.by_id["b"])


def test_names_of_persons_are_told_and_nouns_keep_their_types(world: World) -> None:
    assert dict(known_names(world)) == {
        "anna": ("Human",),
        "mrs. miller": ("Human",),
        "rose": ("Human",),
        "cooking place": ("Room", "Location"),
    }


def test_snapshot_is_bounded_and_keeps_places_and_what_was_seen_last() -> None:
    known = {f"thing_{number}": WorldObject(f"thing_{number}", stamp_s=float(number)) for number in range(MOST_OBJECTS)}
    known["anna"] = WorldObject("anna", Sort.PERSON)
    world = snapshot("1", known)
    assert len(world.objects) == MOST_OBJECTS
    assert world.left_out == 1
    assert world.get("anna") is not None
    assert world.get("thing_0") is None


def test_robot_is_in_the_room_of_its_pose(world: World) -> None:
    robot = WorldObject("robot", Sort.ROBOT, pose=Pose("map", 4.0, 0.0))
    assert world.room_of(robot).id == "hall"
    assert world.room_of(replace(robot, pose=Pose("odom", 4.0, 0.0))) is None


#: A whole number of square edges apart, floats may fall into either square.
COORDINATES_M = st.integers(-16, 16).map(lambda quarters: quarters / 4.0)
POSES = st.builds(Pose, st.sampled_from(["map", "odom"]), COORDINATES_M, COORDINATES_M)


@given(st.lists(POSES, min_size=2, max_size=12), st.integers(1, 12))
def test_what_is_near_is_found_among_few_and_among_many(poses: list, count: int) -> None:
    world = snapshot("1", {f"cup_{number}": WorldObject(f"cup_{number}", pose=p) for number, p in enumerate(poses)})
    reference, few = world.objects[0], world.objects[-count:]
    near = {one.id for one in world.objects if one is not reference and reference.pose.distance_m(one.pose) <= NEAR_M}
    assert world.at("near", [reference]) == near
    assert ids(few) & world.at("near", [reference], few) == ids(few) & near


@given(st.lists(st.none() | POSES, max_size=8), st.none() | POSES)
def test_the_nearest_comes_first_and_what_has_no_pose_last(poses: list, robot: Pose) -> None:
    known = {f"cup_{number}": WorldObject(f"cup_{number}", pose=pose) for number, pose in enumerate(poses)}
    world = snapshot("1", {**known, "robot": WorldObject("robot", Sort.ROBOT, pose=robot)})
    cups = tuple(one for one in world.objects if one.sort is Sort.THING)
    far = [float("inf") if robot is None or cup.pose is None else robot.distance_m(cup.pose) for cup in cups]
    assert world.nearest_first(cups) == tuple(cup for _, cup in sorted(zip(far, cups), key=lambda pair: pair[0]))
