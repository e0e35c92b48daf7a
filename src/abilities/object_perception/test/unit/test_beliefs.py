"""Sightings become objects: merged, told when they are sure, missed when they are gone."""

from dataclasses import replace
from typing import Iterable, List, Tuple

import pytest

from object_perception.beliefs import Beliefs, BeliefSettings, Sighting, sighting_of
from world_model.knowledge import Knowledge, Update
from world_model.world_object import Pose, Relation, Sort, WorldObject

SETTINGS = BeliefSettings(evidence_period_s=0.0)


class All:
    """A look that shows everything."""

    def shows(self, point: Tuple[float, float, float]) -> bool:
        return True


class Nothing:
    def shows(self, point: Tuple[float, float, float]) -> bool:
        return False


def seen(category: str, x: float, y: float, z: float = 0.8, *, score: float = 0.9) -> Sighting:
    return sighting_of(category, score, Pose("map", x, y, z), (0.1, 0.1, 0.1))


class Watched:
    """Beliefs with the world that hears them."""

    def __init__(self, settings: BeliefSettings = SETTINGS, of_file: Iterable[WorldObject] = ()) -> None:
        self.beliefs = Beliefs(settings, "camera")
        self.world = Knowledge(of_file)
        self.now_s = 100.0
        self.updates: List[Update] = []

    def hear(self, update: Update) -> None:
        if update.objects or update.missing or update.gone:
            self.updates.append(update)
            change = self.world.plan(update, self.now_s)
            assert not isinstance(change, tuple), change
            self.world.apply(change)

    def look(self, *sightings: Sighting, view: object = None, times: int = 1, period_s: float = 0.1) -> None:
        for _ in range(times):
            self.now_s += period_s
            self.hear(self.beliefs.see(sightings, view or All(), self.now_s))  # type: ignore[arg-type]
            self.hear(self.beliefs.know(tuple(self.world.objects.values())))

    @property
    def placed(self) -> List[str]:
        return sorted(name for name, one in self.world.objects.items() if one.is_placed)


def test_one_sighting_is_not_enough() -> None:
    watched = Watched()
    watched.look(seen("mug", 1.0, 0.0))
    assert watched.placed == []
    watched.look(seen("mug", 1.02, 0.0))
    assert watched.placed == ["camera/mug_1"]
    (one,) = watched.world.objects.values()
    assert (one.category, one.sort, one.source) == ("mug", Sort.THING, "camera")
    assert one.pose is not None and one.pose.x_m == pytest.approx(1.01)


def test_a_flicker_is_never_told() -> None:
    watched = Watched()
    watched.look(seen("mug", 1.0, 0.0))
    watched.look(times=5)
    assert watched.updates == []


def test_what_is_unsure_is_no_sighting() -> None:
    watched = Watched()
    watched.look(seen("mug", 1.0, 0.0, score=0.49), times=20)
    assert watched.updates == []


def test_images_that_follow_quickly_are_one_piece_of_evidence() -> None:
    watched = Watched(replace(SETTINGS, evidence_period_s=1.0))
    watched.look(seen("mug", 1.0, 0.0), times=9)
    assert watched.placed == []
    watched.look(seen("mug", 1.0, 0.0), times=3)
    assert watched.placed == ["camera/mug_1"]


def test_a_detector_that_misses_now_and_then_loses_nothing() -> None:
    watched = Watched(replace(SETTINGS, evidence_period_s=0.5))
    for number in range(200):
        watched.look(*([seen("mug", 1.0, 0.0)] if number % 5 == 0 else []))
    assert watched.placed == ["camera/mug_1"] and not any(one.missing for one in watched.updates)


def test_two_things_beside_each_other_stay_two() -> None:
    watched = Watched()
    for shift in (0.0, 0.02, -0.02, 0.01):
        watched.look(seen("mug", 1.0, 0.1 + shift), seen("mug", 1.0, -0.05 + shift))
    assert watched.placed == ["camera/mug_1", "camera/mug_2"]
    places = {one.pose.y_m for one in watched.world.objects.values() if one.pose}
    assert sorted(places) == pytest.approx([-0.05, 0.1], abs=0.03)


def test_things_of_other_categories_are_others() -> None:
    watched = Watched()
    watched.look(seen("mug", 1.0, 0.0), seen("bowl", 1.0, 0.0), times=3)
    assert watched.placed == ["camera/bowl_1", "camera/mug_1"]


def test_a_large_thing_is_one_though_its_middle_wanders() -> None:
    watched = Watched()
    for y in (0.0, 0.6, 0.1, 0.5):
        watched.look(sighting_of("sofa", 0.9, Pose("map", 3.0, y), (2.0, 0.9, 0.8)))
    assert watched.placed == ["camera/sofa_1"]


def test_what_stays_is_told_rarely() -> None:
    watched = Watched()
    watched.look(seen("mug", 1.0, 0.0), times=60)
    assert len(watched.updates) == 1
    watched.look(seen("mug", 1.0, 0.0), times=50)
    assert len(watched.updates) == 2


def test_what_is_gone_is_missing_and_comes_back_by_its_name() -> None:
    watched = Watched()
    watched.look(seen("mug", 1.0, 0.0), times=4)
    watched.look(times=3)
    assert watched.placed == ["camera/mug_1"]
    watched.look(times=3)
    assert watched.placed == [] and "camera/mug_1" in watched.world.objects
    watched.look(seen("mug", 3.0, 2.0), times=4)
    assert watched.placed == ["camera/mug_1"]


def test_what_no_look_could_show_is_not_missed() -> None:
    watched = Watched()
    watched.look(seen("mug", 1.0, 0.0), times=4)
    watched.look(view=Nothing(), times=100)
    assert watched.placed == ["camera/mug_1"]


def test_what_nobody_saw_for_long_is_missing() -> None:
    watched = Watched(replace(SETTINGS, forget_after_s=60.0))
    watched.look(seen("mug", 1.0, 0.0), times=4)
    watched.now_s += 59.0
    watched.hear(watched.beliefs.pass_time(watched.now_s))
    assert watched.placed == ["camera/mug_1"]
    watched.now_s += 2.0
    watched.hear(watched.beliefs.pass_time(watched.now_s))
    assert watched.placed == []


def test_a_thing_that_somebody_named_keeps_its_name() -> None:
    cup = WorldObject("annas_mug", category="mug", attributes=("red",), pose=Pose("map", 1.0, 0.1), source="file")
    watched = Watched(of_file=[cup])
    watched.look(seen("mug", 1.1, 0.0), view=Nothing())
    watched.look(seen("mug", 1.1, 0.0), times=3)
    assert watched.placed == ["annas_mug"]
    one = watched.world.objects["annas_mug"]
    assert one.attributes == ("red",) and one.pose is not None and one.pose.z_m == pytest.approx(0.8)
    watched.look(times=8)
    assert watched.placed == []


def test_a_thing_of_the_file_that_was_never_seen_is_not_missed() -> None:
    watched = Watched(of_file=[WorldObject("table_1", category="table", pose=Pose("map", 1.0, 0.0))])
    watched.look(times=20)
    assert watched.updates == []


def test_a_restart_goes_on_with_the_same_things() -> None:
    watched = Watched()
    watched.look(seen("mug", 1.0, 0.0), seen("mug", 2.0, 0.0), times=4)
    watched.beliefs = Beliefs(SETTINGS, "camera")
    watched.hear(watched.beliefs.know(tuple(watched.world.objects.values())))
    watched.look(seen("mug", 1.0, 0.0), seen("mug", 2.0, 0.0), times=3)
    assert watched.placed == ["camera/mug_1", "camera/mug_2"]
    watched.look(seen("mug", 1.0, 0.0), times=8)
    assert watched.placed == ["camera/mug_1"]
    watched.beliefs = Beliefs(SETTINGS, "camera")
    watched.hear(watched.beliefs.know(tuple(watched.world.objects.values())))
    watched.look(seen("mug", 1.0, 0.0), seen("mug", 5.0, 0.0), times=3)
    assert watched.placed == ["camera/mug_1", "camera/mug_2"]


def test_what_the_robot_took_is_left_to_whoever_holds_it() -> None:
    watched = Watched()
    watched.look(seen("mug", 1.0, 0.0), times=4)
    held = WorldObject("camera/mug_1", relations=(Relation("held_by", "robot"),), source="gripper")
    watched.now_s += 0.1
    watched.hear(Update((held,)))
    watched.look(times=10)
    one = watched.world.objects["camera/mug_1"]
    assert one.related("held_by") == ("robot",)


def test_what_was_forgotten_is_found_anew() -> None:
    watched = Watched()
    watched.look(seen("mug", 1.0, 0.0), times=4)
    watched.hear(Update(gone=("camera/mug_1",)))
    watched.hear(watched.beliefs.know(()))
    watched.look(seen("mug", 1.0, 0.0), times=3)
    assert len(watched.placed) == 1


def test_two_cameras_that_find_a_thing_at_once_agree_on_one() -> None:
    watched = Watched()
    other = WorldObject("a_camera/mug_1", category="mug", pose=Pose("map", 1.0, 0.05, 0.8), source="a_camera")
    watched.look(seen("mug", 1.0, 0.0))
    watched.hear(Update((replace(other, stamp_s=watched.now_s),)))
    watched.look(seen("mug", 1.0, 0.0), times=4)
    assert watched.placed == ["a_camera/mug_1"]
    watched.look(times=10)
    assert watched.placed == []


def test_a_known_thing_is_where_it_was_seen_last() -> None:
    watched = Watched()
    fridge = WorldObject("fridge_1", category="fridge", pose=Pose("map", 0.0, 0.0))
    watched.look(Sighting(fridge, 0.85), times=3)
    moved = replace(fridge, pose=Pose("map", 4.0, 0.0))
    watched.look(Sighting(moved, 0.85), times=2)
    pose = watched.world.objects["fridge_1"].pose
    assert pose is not None and pose.x_m == pytest.approx(4.0)
