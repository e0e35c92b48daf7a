"""Calls: what is malformed is refused with its reason, and what is not becomes arguments of the frame."""

import math
from dataclasses import replace
from typing import Any, Mapping

import pytest
from agent_cases import WORLD, tools

from agent_server.filled_call import FilledCall, filled_call
from agent_server.refused import CallRefused
from semantic_frames.frame import UnknownPolicy
from typed_arguments import TypedArgument
from world_model import World


def call(name: str, arguments: object, world: World = WORLD) -> FilledCall:
    return filled_call(tools()[name], arguments, world)


def by_name(filled: FilledCall) -> Mapping[str, TypedArgument]:
    return {one.name: one for one in filled.arguments}


@pytest.mark.parametrize(
    ("name", "arguments", "code", "says"),
    [
        ("turning", [], "MALFORMED", "not an object"),
        ("turning", "left", "MALFORMED", "not an object"),
        ("turning", {}, "MISSING_ELEMENT", "direction must be given"),
        ("bringing", {"goal": "kitchen"}, "MISSING_ELEMENT", "theme must be given"),
        ("turning", {"direction": "up"}, "VALUE_NOT_ALLOWED", "only left or right"),
        ("turning", {"direction": 3}, "WRONG_TYPE", "must be a text"),
        ("turning", {"direction": None}, "WRONG_TYPE", "must be a text"),
        ("turning", {"direction": ["left"]}, "WRONG_TYPE", "must be a text"),
        ("turning", {"direction": {"thing": "left"}}, "WRONG_TYPE", "must be a text"),
        ("turning", {"direction": "left", "angle": "90 degrees"}, "WRONG_TYPE", "must be a number"),
        ("turning", {"direction": "left", "angle": True}, "WRONG_TYPE", "must be a number"),
        ("turning", {"direction": "left", "angle": 7.0}, "LIMIT", "the limit is 6.28"),
        ("turning", {"direction": "left", "angle": -7.0}, "LIMIT", "less than I may do"),
        ("turning", {"direction": "left", "angle": math.nan}, "LIMIT", "not a finite number"),
        ("turning", {"direction": "left", "angle": 10**400}, "LIMIT", "not a finite number"),
        ("turning", {"direction": "left", "velocity": 3}, "UNKNOWN_ELEMENT", "no argument 'velocity'"),
        ("turning", {"direction": "left", "angle_unit": "turns"}, "UNKNOWN_ELEMENT", "no argument 'angle_unit'"),
        ("turning", {"direction": "left", "begin": "yesterday"}, "VALUE_NOT_ALLOWED", "only now, after or beside"),
        ("waiting", {"duration": 3601}, "LIMIT", "the limit is 3600 s"),
        ("saying", {"message": ""}, "EMPTY_TEXT", "is empty"),
        ("saying", {"message": " \t"}, "EMPTY_TEXT", "is empty"),
        ("saying", {"message": "a" * 501}, "TEXT_TOO_LONG", "at most 500"),
        ("saying", {"message": "hello\nopen the door"}, "VALUE_NOT_ALLOWED", "cannot be printed"),
        (
            "bringing",
            {"theme": "red mug", "goal": {"thing": "kitchen", "relation": "through"}},
            "VALUE_NOT_ALLOWED",
            "on",
        ),
        ("bringing", {"theme": "red mug", "goal": {"relation": "in"}}, "MISSING_ELEMENT", "thing must be given"),
        ("bringing", {"theme": "red mug", "goal": {"thing": "kitchen", "x": 1}}, "UNKNOWN_ELEMENT", "'x'"),
        ("bringing", {"theme": "mug"}, "AMBIGUOUS", "mug_1"),
    ],
)
def test_malformed_calls_are_refused_with_the_reason(name: str, arguments: Any, code: str, says: str) -> None:
    with pytest.raises(CallRefused) as refused:
        call(name, arguments)
    assert refused.value.code == code
    assert says in str(refused.value)


def test_an_amount_is_a_measure_in_si_units() -> None:
    filled = by_name(call("turning", {"direction": "left", "angle": 1.5}))
    assert filled["angle"].measure is not None
    assert (filled["angle"].text, filled["angle"].measure.kind, filled["angle"].si) == ("1.5", "angle", 1.5)
    assert filled["angle_unit"].text == "radians"
    waiting = by_name(call("waiting", {"duration": 3}))
    assert (waiting["duration"].text, waiting["duration"].si) == ("3 seconds", 3.0)


def test_an_id_means_its_object() -> None:
    theme = by_name(call("bringing", {"theme": "mug_1"}))["theme"]
    assert (theme.referents, theme.head, theme.text) == (("mug_1",), "mug", "the red mug")


def test_words_mean_the_object_that_they_describe() -> None:
    assert by_name(call("bringing", {"theme": "the blue mug"}))["theme"].referents == ("mug_2",)


def test_a_relation_travels_with_its_thing() -> None:
    goal = by_name(call("bringing", {"theme": "mug_1", "goal": {"thing": "kitchen", "relation": "in"}}))["goal"]
    assert (goal.relation, goal.referents, goal.words) == ("in", ("kitchen",), "in the kitchen")


@pytest.mark.parametrize(("policy", "is_refused"), [(UnknownPolicy.REFUSE, True), (UnknownPolicy.ASK, False)])
def test_what_the_robot_does_not_know_is_asked_about_or_refused(policy: UnknownPolicy, is_refused: bool) -> None:
    tool = tools()["bringing"]
    tool = replace(tool, frame=replace(tool.frame, on_unknown=policy))
    if is_refused:
        with pytest.raises(CallRefused) as refused:
            filled_call(tool, {"theme": "the umbrella"}, WORLD)
        assert refused.value.code == "UNKNOWN_THING"
    else:
        assert filled_call(tool, {"theme": "the umbrella"}, WORLD).doubts


def test_an_argument_of_another_type_is_doubted() -> None:
    (doubt,) = call("bringing", {"theme": "Anna"}).doubts
    assert doubt == '"Anna" is a person, and the theme is a thing.'
    assert not call("bringing", {"theme": "mug_1"}).doubts


@pytest.mark.parametrize(
    ("name", "arguments", "is_doubted"),
    [
        ("unlocking", {"lock": "the front door"}, True),
        ("switching_device", {"device": "stove", "operational_state": "on"}, True),
        ("switching_device", {"device": "the stove", "operational_state": "on"}, True),
        ("switching_device", {"device": "the gas stove thing", "operational_state": "on"}, True),
        ("photographing", {"represented": "anna"}, True),
        ("photographing", {"represented": "Anna"}, True),
        ("photographing", {"represented": "the woman"}, True),
        ("photographing", {"represented": "Zxqvy"}, True),
        ("photographing", {"represented": "the red mug"}, False),
        ("photographing", {}, False),
    ],
)
def test_what_wants_a_yes(name: str, arguments: Any, is_doubted: bool) -> None:
    assert bool(call(name, arguments).doubts) is is_doubted


def test_a_label_that_gives_orders_is_an_argument_and_nothing_else() -> None:
    filled = call("bringing", {"theme": "evil"})
    assert filled.frame_name == "bringing"
    assert [one.name for one in filled.arguments] == ["theme"]
    assert filled.arguments[0].referents == ("evil",)


def test_words_that_are_said_are_no_object() -> None:
    message = by_name(call("saying", {"message": "kitchen"}))["message"]
    assert (message.text, message.referents) == ("kitchen", ())


def test_when_a_call_begins() -> None:
    assert call("turning", {"direction": "left"}).beginning == "REPLACE"
    assert call("turning", {"direction": "left", "begin": "after"}).beginning == "FOLLOW"
    assert call("turning", {"direction": "left", "begin": "beside"}).beginning == "BESIDE"


def test_a_call_in_words() -> None:
    filled = call("turning", {"direction": "left", "angle": 1.5})
    assert filled.words == "turning (direction: left, angle: 1.5 radians, angle unit: radians)"
