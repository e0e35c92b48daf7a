"""Updates of what is known: what they add, replace, leave and refuse."""

from dataclasses import replace

import pytest

from world_model import Pose, Relation, Sort, WorldObject
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


SEEN = WorldObject("mug_1", relations=(Relation("on", "table_1"),), states=("full",))
YESTERDAY_S, TODAY_S = 1.7e9, 1.7001e9


def after_a_run(*told: WorldObject, now_s: float = YESTERDAY_S) -> Knowledge:
    """Return what the next run knows after one that was told of objects."""
    change = Knowledge([TABLE, MUG]).plan(Update(told or (SEEN,)), now_s, YESTERDAY_S)
    assert isinstance(change, Change), change
    return Knowledge([TABLE, MUG], change.learned)


def test_what_an_earlier_run_learned_has_the_time_of_day_and_the_file_has_none() -> None:
    known = after_a_run().objects
    assert known["mug_1"].related("on") == ("table_1",)
    assert (known["mug_1"].place_of_before_s, known["mug_1"].states_of_before_s) == (YESTERDAY_S, YESTERDAY_S)
    assert (known["table_1"].place_of_before_s, known["table_1"].states_of_before_s) == (0.0, 0.0)


def test_places_and_doors_stay_where_they_are() -> None:
    room = WorldObject("kitchen", Sort.PLACE, pose=Pose("map", 1.0, 2.0))
    assert after_a_run(room).objects["kitchen"].place_of_before_s == 0.0


@pytest.mark.parametrize("now_s", [0.0, 3.0, TODAY_S])
def test_this_run_is_newer_whatever_its_clock(now_s: float) -> None:
    knowledge = after_a_run()
    change = knowledge.plan(Update((WorldObject("mug_1", relations=(Relation("held_by", "anna"),)),)), now_s, TODAY_S)
    assert isinstance(change, Change)
    knowledge.apply(change)
    mug = knowledge.objects["mug_1"]
    assert (mug.related("held_by"), mug.place_of_before_s) == (("anna",), 0.0)
    # Nobody has looked into it in this run.
    assert (mug.states, mug.states_of_before_s) == (("full",), YESTERDAY_S)


def test_states_of_two_runs_are_not_mixed() -> None:
    knowledge = after_a_run(WorldObject("mug_1", states=("full", "dirty")))
    updated(knowledge, Update((WorldObject("mug_1", states=("empty",)),)))
    mug = knowledge.objects["mug_1"]
    assert (mug.states, mug.states_of_before_s) == (("empty",), 0.0)


def test_clock_that_goes_back_begins_a_run() -> None:
    knowledge = Knowledge([TABLE, MUG])
    for now_s, holder in ((500.0, "anna"), (499.5, "ben"), (2.0, "table_1"), (3.0, "shelf_1")):
        one = WorldObject("mug_1", relations=(Relation("on", holder),), stamp_s=now_s)
        change = knowledge.plan(Update((one,)), now_s, YESTERDAY_S)
        assert isinstance(change, Change)
        knowledge.apply(change)
        # The second is only a late message of the same clock.
        assert knowledge.objects["mug_1"].related("on") == ("anna" if holder == "ben" else holder,)


def test_stamp_of_another_clock_is_no_stamp_of_the_future() -> None:
    knowledge = Knowledge([TABLE, MUG])
    updated(knowledge, Update((replace(SEEN, stamp_s=YESTERDAY_S),)), now_s=10.0)
    updated(knowledge, Update((WorldObject("mug_1", states=("empty",), stamp_s=11.0),)), now_s=11.0)
    assert knowledge.objects["mug_1"].states == ("empty",)


def test_forgetting_leaves_what_the_file_says() -> None:
    knowledge = Knowledge([TABLE, MUG])
    updated(knowledge, Update((SEEN, WorldObject("cup_1")), gone=("table_1",)))
    knowledge.apply(knowledge.forget())
    assert knowledge.objects == Knowledge([TABLE, MUG]).objects
