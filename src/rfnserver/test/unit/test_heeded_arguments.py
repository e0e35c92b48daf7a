"""What a server that makes goals of frames takes into account."""

from typing import Any, Dict, Tuple

import pytest

from rfnserver.goal_binding import BindingError, BoundElement, plan_goal
from rfnserver.goal_types import GoalField
from rfnserver.heeding import heeded_by, listed_elements, refusal_of, unheeded_argument
from rfnserver.registration import FrameFit
from semantic_frames.server_profile import HeededElement
from semantic_frames.server_statement import stated_profile
from typed_arguments import Measure, Source, TypedArgument

SPEEDS = {"SPEED_SLOW": 0, "SPEED_FAST": 2}
FIELDS = (
    GoalField("order", "int32", {}),
    GoalField("planner", "string", {}),
    GoalField("position", "float64", {}),
    GoalField("force", "float64", {}),
)
OPENING = (BoundElement("container_portal", is_core=True), BoundElement("manner", is_core=False))


def test_extra_thematic_element_that_is_mapped_is_heeded() -> None:
    own = ["goal", "duration"]
    elements = [BoundElement("goal", is_core=True), BoundElement("duration", is_core=False)]
    mapping = {
        "planner": "goal",
        "force": {"element": "manner", "values": {"slow": 1, "quick": 2}, "default": "slow"},
        "order": "degree",
    }
    plan = plan_goal(FIELDS, elements, mapping=mapping)
    assert plan.unheeded == ("duration",)
    assert heeded_by(plan, own) == (HeededElement("Manner", values=("slow", "quick")), HeededElement("Degree"))
    table = HeededElement("manner", values=("slow", "quick"))
    assert heeded_by(plan, ["manner"]) == (table, HeededElement("Degree"))
    constants = plan_goal([GoalField("speed", "uint8", SPEEDS)], [], mapping={"speed": "manner"})
    assert heeded_by(constants, []) == (HeededElement("Manner", values=("slow", "fast")),)
    with pytest.raises(BindingError, match="no element 'maner'"):
        plan_goal(FIELDS, elements, mapping={**mapping, "order": "maner"})


@pytest.mark.parametrize(
    "mapping, expected",
    [
        ({"position": {"element": "part", "values": {"the Gripper": 1, "hand": 2}}}, {"values": ("gripper", "hand")}),
        ({"planner": "part"}, None),
        ({"order": "part.count"}, None),
        ({"order": {"element": "part.relation", "values": {"in": 1, "under": 2}}}, {"relations": ("in", "under")}),
        ({"order": {"element": "part.relation", "values": {"wherever": 1}}}, None),
        (
            {
                "position": {"element": "part", "values": {"gripper": 1, "hand": 2}},
                "force": {"element": "part", "values": {"hand": 2, "arm": 3}},
                "planner": "part",
            },
            {"values": ("hand",)},
        ),
    ],
)
def test_table_says_what_the_server_takes_of_an_element(mapping: Dict[str, Any], expected: Any) -> None:
    plan = plan_goal(FIELDS, [BoundElement("part", is_core=True)], mapping=mapping)
    assert heeded_by(plan, ["part"]) == (() if expected is None else (HeededElement("part", **expected),))


def test_what_follows_from_a_frame_is_added_to_what_the_server_states() -> None:
    stated = stated_profile({"heeds": {"Manner": ["slow"]}, "unheeded": ["area"], "occupies": ["base"]})
    manner = HeededElement("Manner", values=("quick",))
    fit = FrameFit(is_known=True, heeds=(manner, HeededElement("Degree")), unheeded=("area", "speed"))
    profile = fit.added_to(stated)
    assert [heeded.name for heeded in profile.heeds] == ["Manner", "Degree"]
    assert profile.heeds[0].values == ("slow",)
    assert (profile.unheeded, profile.occupies) == (("area", "speed"), ("base",))


def lost(*arguments: TypedArgument, heeded: Tuple[str, ...] = (), **keys: Any) -> str:
    found = unheeded_argument(arguments, heeded, **{"defaults": {}, **keys})
    return "" if found is None else refusal_of(found)


def typed(name: str, text: str, **attributes: Any) -> TypedArgument:
    return TypedArgument(name=name, text=text, **attributes)


def test_what_was_said_and_is_not_taken_is_refused_in_the_words_of_the_person() -> None:
    order, duration = typed("order", "3"), typed("hold_time", "ten seconds")
    refusal = 'I cannot take the hold time "ten seconds" into account when I do that.'
    assert lost(order, duration, heeded=("order",)) == refusal
    assert lost(order, heeded=("order",)) == ""
    # Nobody said a default, or what was inferred.
    assert lost(order, duration, heeded=("order",), defaults={"hold_time": "ten seconds"}) == ""
    for source in (Source.DEFAULT, Source.INFERRED):
        assert lost(typed("hold_time", "ten seconds", source=source)) == ""
    assert lost(typed("agent", "you")) == ""


@pytest.mark.parametrize("said, unit", [("feet", "foot"), ("degrees", "degree"), ("m", "metre")])
def test_unit_of_a_measure_is_heeded(said: str, unit: str) -> None:
    measured = typed("distance", "3", measure=Measure("length", unit=unit, si=0.9))
    spoken = typed("unit", said)
    assert lost(measured, spoken, heeded=("distance",)) == ""
    assert f'the unit "{said}"' in lost(typed("distance", "3"), spoken, heeded=("distance",))
    assert 'the unit "inches"' in lost(measured, typed("unit", "inches"), heeded=("distance",))


@pytest.mark.parametrize(
    "heeds, argument, is_lost",
    [
        ({"container_portal": ["gripper"]}, typed("container_portal", "the gripper", head="gripper"), False),
        ({"container_portal": ["gripper"]}, typed("container_portal", "the window", head="window"), True),
        ({"Manner": ["slow"]}, typed("manner", "slowly"), False),
        ({"Manner": ["slow"]}, typed("manner", "quickly"), True),
        # Whoever lists no words has to read them.
        (["container_portal"], typed("container_portal", "the gripper"), True),
        ({"container_portal": {"most": 1}}, typed("container_portal", "the gripper"), True),
    ],
)
def test_element_with_a_list_of_words_need_not_be_read(heeds: Any, argument: TypedArgument, is_lost: bool) -> None:
    assert bool(lost(argument, profile=stated_profile({"heeds": heeds}))) is is_lost


def test_element_with_a_list_of_words_need_not_fill_a_field() -> None:
    listed = listed_elements(stated_profile({"heeds": {"container_portal": ["gripper"], "manner": None}}))
    assert list(listed) == ["container_portal"]
    plan = plan_goal(FIELDS, OPENING, mapping={"position": {"value": 1}}, ignored_elements=listed)
    assert plan.unheeded == ("manner",)
    with pytest.raises(BindingError, match="list in 'heeds' what it may be"):
        plan_goal(FIELDS, OPENING, mapping={"position": {"value": 1}})
