"""Updates of what is known: what they add, replace, leave and refuse."""

from dataclasses import replace

import pytest

from world_model import Pose, Relation, WorldObject
from world_model.knowledge import Change, Knowledge, Update

TABLE = WorldObject("table_1", category="table")
MUG = WorldObject(
    "mug_1",
    category="mug",
    attributes=("red",),
    relations=(Relation("on", "table_1"), Relation("of", "anna")),
    states=("full",),
)


def updated(knowledge: Knowledge, update: Update, now_s: float = 10.0) -> Change:
    change = knowledge.plan(update, now_s)
    assert isinstance(change, Change), change
    knowledge.apply(change)
    return change


def test_new_object_is_added_with_the_time() -> None:
    knowledge = Knowledge()
    updated(knowledge, Update((MUG,)))
    assert knowledge.objects == {"mug_1": replace(MUG, stamp_s=10.0)}


def test_empty_fields_leave_what_is_known() -> None:
    knowledge = Knowledge([TABLE, MUG])
    updated(knowledge, Update((WorldObject("mug_1", states=("empty", "dirty")),)))
    mug = knowledge.objects["mug_1"]
    assert (mug.category, mug.attributes, mug.relations) == (MUG.category, MUG.attributes, MUG.relations)
    assert mug.states == ("empty", "dirty")


@pytest.mark.parametrize("said", [{"pose": Pose("map", 1.0, 2.0)}, {"relations": (Relation("in", "box_1"),)}])
def test_another_place_replaces_the_whole_place_and_not_the_owner(said: dict) -> None:
    knowledge = Knowledge([replace(MUG, pose=Pose("map", 0.0, 0.0))])
    updated(knowledge, Update((WorldObject("mug_1", **said),)))
    mug = knowledge.objects["mug_1"]
    assert mug.pose == said.get("pose")
    assert mug.relations == (Relation("of", "anna"), *said.get("relations", ()))


def test_older_news_is_left_out() -> None:
    knowledge = Knowledge()
    updated(knowledge, Update((replace(MUG, stamp_s=9.0),)))
    assert updated(knowledge, Update((WorldObject("mug_1", states=("empty",), stamp_s=8.0),))).is_empty
    assert knowledge.objects["mug_1"].states == ("full",)


def test_replacing_forgets_everything_else() -> None:
    knowledge = Knowledge([MUG])
    updated(knowledge, Update((WorldObject("mug_1", category="cup"),), replaces=True))
    assert knowledge.objects["mug_1"] == WorldObject("mug_1", category="cup", stamp_s=10.0)


def test_missing_object_has_no_place() -> None:
    knowledge = Knowledge([MUG])
    updated(knowledge, Update(missing=("mug_1", "unknown")))
    assert knowledge.objects["mug_1"].relations == (Relation("of", "anna"),)
    assert set(knowledge.objects) == {"mug_1"}


def test_object_that_is_gone_takes_the_relations_to_it_along() -> None:
    knowledge = Knowledge([TABLE, MUG])
    change = updated(knowledge, Update(gone=("table_1",)))
    assert knowledge.objects["mug_1"].relations == (Relation("of", "anna"),)
    assert "table_1" not in knowledge.objects
    # A restart with the same file does not bring it back.
    assert Knowledge([TABLE, MUG], change.learned).objects == knowledge.objects
    updated(knowledge, Update((TABLE,)))
    assert "table_1" in knowledge.objects


def test_learned_object_that_is_gone_is_forgotten() -> None:
    knowledge = Knowledge()
    updated(knowledge, Update((MUG,)))
    assert updated(knowledge, Update(gone=("mug_1",))).forgotten == ("mug_1",)
    assert knowledge.objects == {}


def test_update_with_a_mistake_is_refused_as_a_whole() -> None:
    knowledge = Knowledge()
    wrong = (replace(MUG, id="a mug"), replace(MUG, source="file"), replace(MUG, pose=Pose("map", float("nan"), 0.0)))
    refused = knowledge.plan(Update((TABLE, *wrong), gone=("",)), 1.0)
    assert [one.position for one in refused] == [1, 2, 3, 4]
    assert knowledge.objects == {}


def test_too_much_is_refused() -> None:
    many = tuple(WorldObject(f"thing_{number}") for number in range(5001))
    refused = Knowledge().plan(Update(many), 1.0)
    assert refused[0].position is None
