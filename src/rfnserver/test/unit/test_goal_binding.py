"""Goals made of filled frames."""

import math
from typing import Any, Dict

import pytest

from rfnserver.arguments import ArgumentError
from rfnserver.goal_binding import BindingError, BoundElement, goal_values, plan_goal
from rfnserver.goal_types import FILLING_OF_TYPE, Filling, GoalField
from typed_arguments import Measure, TypedArgument

SPEEDS = {"SPEED_SLOW": 0, "SPEED_FAST": 2, "NAVFN": "navfn"}
FIELDS = (
    GoalField("order", "int32", {}),
    GoalField("small", "uint8", {}),
    GoalField("distance", "float64", {}),
    GoalField("angle", "float32", {}),
    GoalField("speed", "uint8", SPEEDS),
    GoalField("planner", "string", SPEEDS),
    GoalField("is_loud", "bool", {}),
    GoalField("pause", "duration", {}),
    GoalField("names", "string[]", {}),
    GoalField("target_pose", "geometry_msgs/PoseStamped", {}),
    GoalField("limits", "robot_msgs/Limits", {}),
    GoalField("limits.force", "float64", {}),
    GoalField("picture", "sensor_msgs/Image", {}),
)


def values(mapping: Dict[str, Any], **arguments: str) -> Dict[str, Any]:
    elements = [BoundElement(name, is_core=False) for name in arguments]
    typed = {name: TypedArgument(name, text) for name, text in arguments.items()}
    return goal_values(plan_goal(FIELDS, elements, mapping=mapping), typed, locate=lambda words: ("at", words))


@pytest.mark.parametrize(
    "mapping, arguments, expected",
    [
        ({}, {"order": "seven"}, {"order": 7}),
        ({}, {"distance": "three feet"}, {"distance": 3 * 0.3048}),
        ({}, {"distance": "3"}, {"distance": 3.0}),
        ({"distance": {"element": "far", "unit_element": "unit"}}, {"far": "2", "unit": "yards"}, {"distance": 1.8288}),
        ({"angle": {"element": "angle", "unit": "degree"}}, {"angle": "one turn"}, {"angle": 360.0}),
        ({"angle": {"element": "angle", "unit": "degree"}}, {"angle": "90"}, {"angle": 90.0}),
        ({}, {"angle": "180 degrees"}, {"angle": math.pi}),
        ({}, {"speed": "fast"}, {"speed": 2}),
        ({}, {"speed": "slowly"}, {"speed": 0}),
        ({}, {"speed": "speed slow"}, {"speed": 0}),
        ({}, {"speed": "1"}, {"speed": 1}),
        ({}, {"planner": "NavFn"}, {"planner": "navfn"}),
        ({}, {"planner": "another"}, {"planner": "another"}),
        ({}, {"is_loud": "yes"}, {"is_loud": True}),
        ({}, {"is_loud": "off"}, {"is_loud": False}),
        ({}, {"pause": "two minutes"}, {"pause": 120.0}),
        ({}, {"names": "ann, bob and carol"}, {"names": ["ann", "bob", "carol"]}),
        ({"target_pose": "goal"}, {"goal": "the office"}, {"target_pose": ("at", "the office")}),
        ({}, {"force": "5"}, {"limits.force": 5.0}),
        ({"order": {"element": "n", "default": "four"}}, {"n": ""}, {"order": 4}),
        ({"order": {"value": 9}}, {}, {"order": 9}),
        (
            {"order": {"element": "shape", "values": {"square": 1, "big triangle": 2}}},
            {"shape": "a square"},
            {"order": 1},
        ),
        ({"order": {"element": "shape", "values": {"Square": 1}, "default": "square"}}, {"shape": ""}, {"order": 1}),
        ({"order": {"element": "shape", "values": {"square": 1}, "default": 7}}, {"shape": ""}, {"order": 7}),
        (
            {
                "is_loud": {"element": "side", "values": {"left": True, "right": False}},
                "planner": {"element": "side", "values": {"left": "navfn", "right": "other"}},
            },
            {"side": "Left"},
            {"is_loud": True, "planner": "navfn"},
        ),
        ({"distance": {"element": "n", "values": {"twice": 2}}}, {"n": "twice"}, {"distance": 2.0}),
        ({}, {"order": ""}, {}),
    ],
)
def test_values(mapping: Dict[str, Any], arguments: Dict[str, str], expected: Dict[str, Any]) -> None:
    assert values(mapping, **arguments) == pytest.approx(expected)


@pytest.mark.parametrize(
    "name, words, reason",
    [
        ("order", "half", "not a whole number"),
        ("order", "banana", "banana"),
        ("small", "256", "between 0 and 255"),
        ("small", "minus one", "between 0 and 255"),
        ("order", "99999999999", "between"),
        ("distance", "far", "far"),
        ("distance", "1e400 metres", ""),
        ("speed", "furious", "none of slow, fast"),
        ("is_loud", "perhaps", "neither yes nor no"),
        ("pause", "three feet", "no duration"),
    ],
)
def test_words_that_do_not_fit_are_refused_by_element(name: str, words: str, reason: str) -> None:
    with pytest.raises(ArgumentError, match=f"{name.replace('_', ' ')}.*{reason}"):
        values({}, **{name: words})


@pytest.mark.parametrize(
    "mapping, core, reason",
    [
        ({"ordre": "n"}, "n", "did you mean 'order'"),
        ({"order": "m"}, "n", "no element 'm'"),
        ({"picture": "n"}, "n", "picture: words cannot fill a sensor_msgs/Image"),
        ({"order": {"element": "n", "units": "metre"}}, "n", "unknown key units"),
        ({"order": {}}, "n", "either 'element' or 'value'"),
        ({"order": {"element": "n", "value": 1}}, "n", "either 'element' or 'value'"),
        ({"order": {"value": "banana"}}, "distance", "order: .*banana"),
        ({"order": {"element": "n", "unit": "parsec"}}, "n", "unit 'parsec'"),
        ({}, "picture", "words cannot fill"),
        ({}, "manner", "'manner' fills no field"),
        ({"order": 7}, "order", "found 7"),
    ],
)
def test_what_cannot_be_mapped_is_said_by_field(mapping: Dict[str, Any], core: str, reason: str) -> None:
    with pytest.raises(BindingError, match=reason):
        plan_goal(FIELDS, [BoundElement(core, is_core=True)], mapping=mapping)


def test_a_name_that_fits_two_fields_has_to_be_mapped() -> None:
    fields = (GoalField("first.speed", "float64", {}), GoalField("second.speed", "float64", {}))
    with pytest.raises(BindingError, match=r"first\.speed and second\.speed"):
        plan_goal(fields, [BoundElement("speed", is_core=True)])
    plan = plan_goal(fields, [BoundElement("speed", is_core=True)], mapping={"second.speed": "speed"})
    assert [source.field.path for source in plan.sources] == ["second.speed"]


@pytest.mark.parametrize(
    "field, words, expected",
    [
        (GoalField("rgb", "int32[3]", {}), "1, 2 and 3", [1, 2, 3]),
        (GoalField("patrolMode", "int8", {"MODE_FAST": 1, "MODE_VERY_SLOW": 2}), "very slow", 2),
        (GoalField("state", "uint8", {"STATE_OPEN": 1, "LIMIT": 9}), "open", 1),
        (GoalField("gripper_state", "uint8", {"OPEN_GRIPPER": 4}), "open", 4),
    ],
)
def test_shapes_of_fields(field: GoalField, words: str, expected: Any) -> None:
    plan = plan_goal([field], [BoundElement(field.element, is_core=True)])
    typed = {field.element: TypedArgument(field.element, words)}
    assert goal_values(plan, typed) == {field.path: expected}


def test_array_of_another_length_is_refused() -> None:
    plan = plan_goal([GoalField("rgb", "int32[3]", {})], [BoundElement("rgb", is_core=True)])
    with pytest.raises(ArgumentError, match="takes 3 values, not 2"):
        goal_values(plan, {"rgb": TypedArgument("rgb", "1 and 2")})


@pytest.mark.parametrize(
    "name, element",
    [("holdTime", "hold_time"), ("maxRPMLimit", "max_rpm_limit"), ("speed_", "speed"), ("Arm2Name", "arm2_name")],
)
def test_elements_are_named_as_elements_are(name: str, element: str) -> None:
    assert GoalField(f"limits.{name}", "string", {}).element == element
    plan = plan_goal([GoalField(f"limits.{name}", "string", {})], [BoundElement(element, is_core=True)])
    assert [source.field.path for source in plan.sources] == [f"limits.{name}"]


def test_message_around_one_value_is_filled() -> None:
    fields = (GoalField("height", "std_msgs/Float64", {}), GoalField("height.data", "float64", {}))
    plan = plan_goal(fields, [BoundElement("height", is_core=True)])
    assert [source.field.path for source in plan.sources] == ["height.data"]


def test_goal_without_fields_fits_a_frame_without_elements() -> None:
    assert plan_goal((), ()).sources == ()


def test_core_elements_can_be_ignored_and_others_need_not_be_mapped() -> None:
    elements = [BoundElement("manner", is_core=True), BoundElement("time", is_core=False)]
    plan = plan_goal(FIELDS, elements, ignored_elements=["manner"])
    assert plan.sources == () and "order" in plan.unfilled
    assert "at their default: order" in str(plan)


def test_every_builtin_type_has_a_filling() -> None:
    assert set(FILLING_OF_TYPE.values()) == set(Filling)
    assert GoalField("x", "char[]", {}).integer_range == (0, 255)
    assert GoalField("x", "int64", {}).integer_range == (-(2**63), 2**63 - 1)


def test_elements_that_fill_no_field_are_named() -> None:
    plan = plan_goal(FIELDS, [BoundElement("order", is_core=True), BoundElement("duration", is_core=False)])
    assert plan.unheeded == ("duration",)
    assert "not heeded: duration" in str(plan)


def test_elements_that_are_ignored_or_units_are_heeded() -> None:
    elements = [BoundElement(name, is_core=False) for name in ("distance", "unit", "manner")]
    mapping = {"distance": {"element": "distance", "unit_element": "unit"}}
    assert plan_goal(FIELDS, elements, mapping=mapping, ignored_elements=["manner"]).unheeded == ()
    assert plan_goal(FIELDS, elements, ignored_elements=["manner"]).unheeded == ("unit",)


def typed(name: str, **attributes: Any) -> TypedArgument:
    return TypedArgument(name=name, **attributes)


@pytest.mark.parametrize(
    "mapping, argument, expected",
    [
        ({"planner": "goal.relation"}, typed("goal", text="the table", relation="under"), {"planner": "under"}),
        ({"order": {"element": "goal.count"}}, typed("goal", text="two mugs", count=2), {"order": 2}),
        (
            {"order": {"element": "goal.count", "default": "one"}},
            typed("goal", text="the mug"),
            {"order": 1},
        ),
        ({"planner": "goal.head"}, typed("goal", text="the red mug", head="mug"), {"planner": "mug"}),
        (
            {"angle": {"element": "goal", "unit": "degree"}},
            typed("goal", text="a bit", measure=Measure("angle", si=math.pi)),
            {"angle": 180.0},
        ),
        (
            {"names": "goal"},
            typed(
                "goal",
                text="salt and pepper and cod",
                members=(typed("", text="salt and pepper"), typed("", text="cod")),
            ),
            {"names": ["salt and pepper", "cod"]},
        ),
        (
            {"limits.force": "goal.si"},
            typed("goal", text="3 feet", measure=Measure("length", si=0.9)),
            {"limits.force": 0.9},
        ),
    ],
)
def test_parts_of_an_argument_fill_fields(mapping: Dict[str, Any], argument: TypedArgument, expected: Any) -> None:
    plan = plan_goal(FIELDS, [BoundElement("goal", is_core=True)], mapping=mapping)
    assert goal_values(plan, {"goal": argument}) == pytest.approx(expected)


@pytest.mark.parametrize("said, force", [("quickly", 2.0), ("slow", 1.0), ("", 1.0)])
def test_table_takes_adverbs_of_its_adjectives(said: str, force: float) -> None:
    mapping = {"limits.force": {"element": "manner", "values": {"slow": 1, "quick": 2}, "default": "slow"}}
    plan = plan_goal(FIELDS, [], mapping=mapping)
    assert goal_values(plan, {"manner": typed("manner", text=said)}) == {"limits.force": force}


def test_unknown_part_is_refused_with_the_likely_one() -> None:
    with pytest.raises(BindingError, match="no part 'relatoin'; did you mean 'relation'"):
        plan_goal(FIELDS, [BoundElement("goal", is_core=True)], mapping={"planner": "goal.relatoin"})
