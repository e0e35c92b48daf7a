"""Binding files and what is wrong with them."""

from pathlib import Path
from typing import Tuple

import pytest

from checked_files.problem import FileRefused
from frame_bindings.binding_file import Kind, load_bindings
from rfnserver.results import ResultNames
from semantic_frames.server_profile import HeededElement
from semantic_frames.server_statement import stated_profile

GOOD = """bindings:
  - frame: navigating_to_location
    name: navigation
    action: move_base
    type: move_base_msgs/MoveBaseAction
    fields:
      target_pose: goal
      speed: {element: speed, unit: metre}
    goal_timeout_s: 60
  - frame: lighting
    service: set_light
    type: std_srvs/SetBool
    fields: {data: state}
    success_field: success
    text_field: message
  - frame: speaking
    topic: speech
    type: std_msgs/String
    ignored_elements: [manner]
"""


def problems(text: str) -> Tuple[Tuple[str, int], ...]:
    with pytest.raises(FileRefused) as refused:
        load_bindings(text, "bindings.yaml")
    return tuple((problem.code, problem.line) for problem in refused.value.problems)


def test_bindings_of_each_kind() -> None:
    action, service, topic = load_bindings(GOOD, "bindings.yaml").bindings
    assert (action.kind, action.name, action.target, action.line) == (Kind.ACTION, "navigation", "move_base", 2)
    assert action.fields == {"target_pose": "goal", "speed": {"element": "speed", "unit": "metre"}}
    assert (action.goal_timeout_s, action.server_timeout_s) == (60.0, 5.0)
    assert (service.kind, service.name) == (Kind.SERVICE, "lighting")
    assert service.result_names == ResultNames("success", "message")
    assert action.result_names == ResultNames()
    assert (topic.kind, topic.target, topic.ignored_elements) == (Kind.TOPIC, "speech", ("manner",))


def test_fields_of_a_result() -> None:
    named = 'success_field: ""\n    error_field: {name: error_code, ok: 0}'
    (action, *_) = load_bindings(GOOD.replace("goal_timeout_s: 60", named), "bindings.yaml").bindings
    assert action.result_names == ResultNames(success_field="", error_field={"name": "error_code", "ok": "0"})


def test_statement_of_the_server() -> None:
    stated = "heeds: {Manner: [slow], goal: {relations: [on], most: 1}}\n    occupies: base\n    longest_goal_s: 60"
    (action, *_) = load_bindings(GOOD.replace("goal_timeout_s: 60", stated), "bindings.yaml").bindings
    profile = stated_profile(action.statement)
    goal = HeededElement("goal", relations=("on",), most=1)
    assert profile.heeds == (HeededElement("Manner", values=("slow",)), goal)
    assert (profile.occupies, profile.longest_goal_s) == (("base",), 60.0)


def test_table_of_words() -> None:
    table = "{element: side, values: {left: true, right: false}}"
    (action, *_) = load_bindings(GOOD.replace("target_pose: goal", f"left_arm: {table}"), "bindings.yaml").bindings
    assert action.fields["left_arm"] == {"element": "side", "values": {"left": "true", "right": "false"}}


@pytest.mark.parametrize(
    "old, new, expected",
    [
        ("action: move_base", "", ("NO_TARGET", 2)),
        ("action: move_base", "action: move_base\n    topic: move", ("NO_TARGET", 2)),
        ("move_base_msgs/MoveBaseAction", "MoveBase", ("NOT_A_TYPE", 5)),
        ("move_base_msgs/MoveBaseAction", "move_base_msgs/MoveBaseGoal", ("NOT_A_TYPE", 5)),
        ("goal_timeout_s: 60", "goal_timeout_s: soon", ("NOT_A_NUMBER", 9)),
        ("goal_timeout_s: 60", "goal_timeout_s: -1", ("NOT_A_NUMBER", 9)),
        ("goal_timeout_s: 60", "goal_timeout_s: .inf", ("NOT_A_NUMBER", 9)),
        ("ignored_elements: [manner]", "success_field: x", ("UNKNOWN_KEY", 19)),
        ("text_field: message", "error_field: {name: code, okay: 0}", ("UNKNOWN_KEY", 15)),
        ("text_field: message", "error_field: {ok: 0}", ("MISSING_KEY", 15)),
        ("unit: metre", "units: metre", ("UNKNOWN_KEY", 8)),
        ("name: navigation", "name: speaking", ("DUPLICATE_NAME", 16)),
        ("topic: speech", "topik: speech", ("UNKNOWN_KEY", 17)),
        ("      target_pose: goal", "      speed: goal", ("DUPLICATE_KEY", 8)),
        ("success_field: success", "purpose: looks", ("STATEMENT", 10)),
        ("success_field: success", "heeds: {Manner: {value: slow}}", ("STATEMENT", 10)),
        ("fields: {data: state}", "fields: data", ("WRONG_TYPE", 13)),
        ("fields: {data: state}", "fields: {data: {element: state, values: on}}", ("WRONG_TYPE", 13)),
    ],
)
def test_mistakes_are_found_by_line(old: str, new: str, expected: Tuple[str, int]) -> None:
    assert old in GOOD
    assert expected in problems(GOOD.replace(old, new))


def test_constants_are_values_of_any_form() -> None:
    text = GOOD.replace("    goal_timeout_s: 60\n", "    constants: {poses: [{x: 1.5}, {x: two}], fast: true}\n")
    assert load_bindings(text, "bindings.yaml").bindings[0].constants == {
        "poses": [{"x": 1.5}, {"x": "two"}],
        "fast": True,
    }
    assert problems(GOOD.replace("goal_timeout_s: 60", "constants: [1]")) == (("WRONG_TYPE", 9),)


@pytest.mark.parametrize(
    "path", sorted((Path(__file__).parents[2] / "config").glob("*.yaml")), ids=lambda path: path.name
)
def test_shipped_files_are_read(path: Path) -> None:
    bindings = load_bindings(path.read_text("utf-8"), str(path)).bindings
    assert bindings and all(stated_profile(one.statement) for one in bindings)
