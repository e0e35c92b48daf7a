"""Results of actions and responses of services: whether it worked, and why not."""

from types import SimpleNamespace
from typing import Any, Mapping

import pytest

from rfnserver.goal_types import GoalField
from rfnserver.results import BY_CONVENTION, ResultError, ResultNames, ResultVerdict, plan_result

CODES = {"SUCCESSFUL": 0, "INVALID_GOAL": -1, "PATH_TOLERANCE_VIOLATED": -4}


def fields(constants: Mapping[str, Any] = {}, **types: str) -> Any:
    return [GoalField(name.replace("__", "."), type_name, constants) for name, type_name in types.items()]


TRAJECTORY = fields(CODES, error_code="int32", error_string="string")
SERVICE = fields(success="bool", message="string")


def verdict(read: Any, names: ResultNames = BY_CONVENTION, **values: Any) -> ResultVerdict:
    return plan_result(read, names).read(SimpleNamespace(**values))


@pytest.mark.parametrize("name", ["success", "is_success", "succeeded"])
def test_bool_says_whether_it_worked(name: str) -> None:
    read = fields(**{name: "bool"})
    assert verdict(read, **{name: True}) == ResultVerdict()
    assert verdict(read, **{name: False}) == ResultVerdict(is_done=False)


@pytest.mark.parametrize("name", ["message", "status", "error_string", "text"])
def test_string_says_why_not(name: str) -> None:
    read = fields(success="bool", **{name: "string"})
    assert verdict(read, success=False, **{name: " no cube "}).reason == "no cube"
    # Nobody asked what a server that has done it says.
    assert verdict(read, success=True, **{name: "OK"}) == ResultVerdict(reason="OK")


@pytest.mark.parametrize(
    "values, is_done, reason",
    [
        ({"error_code": 0, "error_string": ""}, True, ""),
        ({"error_code": -1, "error_string": "3 is out of range"}, False, "3 is out of range"),
        ({"error_code": -4, "error_string": ""}, False, "path tolerance violated"),
        ({"error_code": 77, "error_string": ""}, False, "error 77"),
    ],
)
def test_error_code_counts_where_its_message_declares_success(values: Any, is_done: bool, reason: str) -> None:
    read = verdict(TRAJECTORY, **values)
    assert (read.is_done, read.reason) == (is_done, reason)
    assert verdict(fields(error_code="int32"), error_code=3).is_done


def test_error_code_may_be_a_message_with_its_constants() -> None:
    read = [
        GoalField("error_code", "moveit_msgs/MoveItErrorCodes", {}),
        *fields({"SUCCESS": 1}, error_code__val="int32"),
    ]
    assert verdict(read, error_code=SimpleNamespace(val=1)).is_done
    assert not verdict(read, error_code=SimpleNamespace(val=0)).is_done


@pytest.mark.parametrize(
    "names, values, expected",
    [
        ({"success_field": "done"}, {"done": False, "success": True}, ResultVerdict(is_done=False)),
        ({"success_field": ""}, {"success": False}, ResultVerdict()),
        ({"success_field": "done"}, {"done": True, "success": False}, ResultVerdict()),
        ({"error_field": {"name": "code", "ok": 7}}, {"code": 7, "success": False}, ResultVerdict()),
        ({"error_field": {"name": "code", "ok": "7"}}, {"code": 8}, ResultVerdict(False, reason="error 8")),
        ({"error_field": "code"}, {"code": 0}, ResultVerdict()),
        ({"text_field": "note"}, {"success": True, "note": "two cubes"}, ResultVerdict(text="two cubes")),
        ({"text_field": ""}, {"success": False, "message": "no"}, ResultVerdict(is_done=False)),
    ],
)
def test_other_fields_can_be_named(names: Any, values: Any, expected: ResultVerdict) -> None:
    read = fields(success="bool", done="bool", code="int32", note="string", message="string")
    blank = {"success": True, "done": True, "code": 0, "note": "", "message": ""}
    assert verdict(read, ResultNames(**names), **{**blank, **values}) == expected


def test_result_that_says_nothing_is_done() -> None:
    assert verdict(fields(sequence="int32[]", success="bool[]", status="uint8")) == ResultVerdict()
    assert plan_result(SERVICE).read(None) == ResultVerdict()


@pytest.mark.parametrize(
    "names, reason",
    [
        ({"success_field": "succes"}, "success_field: there is no field 'succes', .*did you mean 'success'"),
        ({"success_field": "message"}, "success_field: 'message' is a string"),
        ({"text_field": "success"}, "text_field: 'success' is a bool, expected one of message"),
        ({"error_field": {"name": "code"}}, "error_field: there is no field 'code'"),
        ({"error_field": {"nam": "code"}}, "error_field: expected name and ok, found the key nam"),
        ({"error_field": {"ok": 0}}, "error_field: expected name and ok, found no name"),
    ],
)
def test_fields_that_do_not_exist_are_named(names: Any, reason: str) -> None:
    with pytest.raises(ResultError, match=reason):
        plan_result(SERVICE, ResultNames(**names))
