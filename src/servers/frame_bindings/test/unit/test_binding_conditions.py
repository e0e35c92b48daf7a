"""Conditions of binding files: how they are written, what is wrong with them, and when they hold."""

import math
from types import SimpleNamespace
from typing import Any, Dict, Tuple

import pytest

from checked_files.problem import FileRefused
from frame_bindings.binding_file import load_bindings
from frame_bindings.condition_file import ConditionBinding, fields_below, path_problem
from frame_bindings.field_conditions import Comparison, FieldCondition, NotComparable, Operand
from semantic_frames.server_statement import stated_profile
from typed_arguments import Measure, TypedArgument

BATTERY = """conditions:
  - frame: being_charged
    name: battery_above
    heeds: {level: above}
    topic: battery_state
    type: sensor_msgs/BatteryState
    field: percentage
    comparison: above
    value: {element: percentage, factor: 0.01}
    timeout_s: 5
"""
BELL = """conditions:
  - frame: ringing
    topic: bell
    type: std_msgs/Empty
    event_s: 0.5
"""
DOORS = """conditions:
  - frame: being_open
    topic: doors
    type: my_home/Doors
    entries: doors
    where: {name: {element: theme.head}}
    field: angle
    comparison: at_least
    value: {element: state, values: {open: 0.5, ajar: 0.1}, default: open}
    of_list: all
"""


def condition_of(text: str) -> ConditionBinding:
    (condition,) = load_bindings(text, "bindings.yaml").conditions
    return condition


def problems(text: str) -> Tuple[Tuple[str, int, str], ...]:
    with pytest.raises(FileRefused) as refused:
        load_bindings(text, "bindings.yaml")
    return tuple((problem.code, problem.line, problem.key) for problem in refused.value.problems)


def arguments(**texts: str) -> Dict[str, TypedArgument]:
    return {name: TypedArgument(name, text, head=text.split()[-1]) for name, text in texts.items()}


def test_condition_on_a_number() -> None:
    battery = condition_of(BATTERY)
    assert (battery.frame_name, battery.name, battery.topic) == ("being_charged", "battery_above", "battery_state")
    assert (battery.timeout_s, battery.event_s) == (5.0, 0.0)
    assert stated_profile(battery.statement).heeds[0].values == ("above",)
    twenty = {"percentage": TypedArgument("percentage", "20", measure=Measure("number", "20", 20.0, "", 20.0))}
    assert battery.condition.holds(SimpleNamespace(percentage=0.21), twenty) is True
    assert battery.condition.holds(SimpleNamespace(percentage=0.20), twenty) is False
    assert battery.condition.holds(SimpleNamespace(percentage=math.nan), twenty) is False


def test_every_message_is_an_event() -> None:
    bell = condition_of(BELL)
    assert (bell.event_s, bell.name) == (0.5, "ringing")
    assert bell.condition.holds(SimpleNamespace(), {}) is True


def doors(**angles: float) -> Any:
    return SimpleNamespace(doors=[SimpleNamespace(name=name, angle=angle) for name, angle in angles.items()])


def test_entry_that_is_meant() -> None:
    condition = condition_of(DOORS).condition
    message = doors(front=1.2, back=0.2)
    assert condition.holds(message, arguments(theme="the front")) is True
    assert condition.holds(message, arguments(theme="the back")) is False
    assert condition.holds(message, arguments(theme="the back", state="ajar")) is True
    with pytest.raises(NotComparable, match='there is no "cellar"'):
        condition.holds(message, arguments(theme="the cellar"))
    with pytest.raises(NotComparable, match='I know no state "locked", only open, ajar'):
        condition.holds(message, arguments(theme="the back", state="locked"))
    with pytest.raises(NotComparable, match="I was not told the theme"):
        condition.holds(message, {})


@pytest.mark.parametrize(
    "comparison, wanted, value, expected",
    [
        ("equals", "true", True, True),
        ("equals", "true", False, False),
        ("equals", "3", 3, True),
        ("equals", "Open", "open ", True),
        ("differs", "open", "closed", True),
        ("below", "1", 0.5, True),
        ("below", "1", 1.0, False),
        ("above", "1", 1.0, False),
        ("at_least", "1", 1.0, True),
        ("at_most", "1", 1.1, False),
        ("contains", "hello", "Oh, Hello!", True),
        ("contains", "hello", "goodbye", False),
    ],
)
def test_comparisons(comparison: str, wanted: str, value: object, expected: bool) -> None:
    condition = FieldCondition(field="data", comparison=Comparison(comparison), operand=Operand(wanted))
    assert condition.holds(SimpleNamespace(data=value), {}) is expected


def test_text_that_is_no_number_cannot_be_compared_as_one() -> None:
    condition = FieldCondition(field="data", comparison=Comparison.BELOW, operand=Operand(element="limit"))
    with pytest.raises(NotComparable, match="no numbers"):
        condition.holds(SimpleNamespace(data=3.0), arguments(limit="soon"))


@pytest.mark.parametrize(
    "is_all, ranges, expected", [(False, (9, 0.3), True), (True, (9, 0.3), False), (True, (), False)]
)
def test_list_of_values(is_all: bool, ranges: Tuple[float, ...], expected: bool) -> None:
    condition = FieldCondition(field="ranges", comparison=Comparison.BELOW, operand=Operand("0.5"), is_all=is_all)
    assert condition.holds(SimpleNamespace(ranges=ranges), {}) is expected


@pytest.mark.parametrize(
    "text, expected",
    [
        (BATTERY.replace("comparison: above", "comparison: greater"), ("UNKNOWN_VALUE", 8, "conditions[0].comparison")),
        (BATTERY.replace("factor: 0.01", "factor: much"), ("NOT_A_NUMBER", 9, "conditions[0].value.factor")),
        (BATTERY.replace("{element: percentage, factor: 0.01}", "high"), ("NOT_A_NUMBER", 9, "conditions[0].value")),
        (
            BATTERY.replace("percentage, factor", "level.colour, factor"),
            ("UNKNOWN_PART", 9, "conditions[0].value.element"),
        ),
        (
            BATTERY.replace("    value: {element: percentage, factor: 0.01}\n", ""),
            ("MISSING_KEY", 8, "conditions[0].value"),
        ),
        (BATTERY.replace("timeout_s: 5", "timeout_s: never"), ("NOT_A_NUMBER", 10, "conditions[0].timeout_s")),
        (BATTERY.replace("topic: battery_state\n    ", ""), ("MISSING_KEY", 2, "conditions[0].topic")),
        (BATTERY.replace("sensor_msgs/BatteryState", "BatteryState"), ("NOT_A_TYPE", 6, "conditions[0].type")),
        (BATTERY.replace("heeds:", "purpose: acts\n    heeds:"), ("UNKNOWN_KEY", 4, "conditions[0].purpose")),
        (BATTERY.replace("field:", "evaluate:"), ("UNKNOWN_KEY", 7, "conditions[0].evaluate")),
        (BELL.replace("event_s: 0.5", "name: bell"), ("MISSING_KEY", 2, "conditions[0].field")),
        (BELL + "    where: {name: x}\n", ("UNKNOWN_KEY", 6, "conditions[0].where")),
        (BELL + BELL.replace("conditions:\n", ""), ("DUPLICATE_NAME", 6, "conditions[1].name")),
        ("{}", ("EMPTY", 1, "file")),
    ],
)
def test_mistakes_are_told_by_line_and_key(text: str, expected: Tuple[str, int, str]) -> None:
    assert expected in problems(text)


def test_field_that_the_type_lacks_is_told_with_a_hint() -> None:
    battery = condition_of(BATTERY)
    problem = path_problem(battery, "field", "percentge", {"header": {"stamp": None}, "percentage": None})
    assert problem is not None
    assert (problem.line, problem.key, problem.hint) == (
        7,
        "conditions battery_above.field",
        "did you mean 'percentage'?",
    )
    assert path_problem(battery, "field", "header.stamp", {"header": {"stamp": None}}) is None
    assert path_problem(battery, "field", "header.stamp.secs", {"header": {"stamp": None}}) is not None
    assert fields_below({"doors": {"name": None}}, "doors") == {"name": None}
