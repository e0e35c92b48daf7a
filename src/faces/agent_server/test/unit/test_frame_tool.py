"""A frame as a tool."""

import math

from agent_cases import frames, servers, tools

from agent_server.frame_tool import OWN_TOOLS, frame_tools
from agent_server.own_tools import OWN


def test_what_no_server_carries_out_is_no_tool() -> None:
    assert sorted(tools()) == [
        "bringing",
        "frame_stop",
        "photographing",
        "saying",
        "switching_device",
        "turning",
        "unlocking",
        "waiting",
    ]
    assert frame_tools(frames(), {}) == {}


def test_tools_come_and_go_with_servers() -> None:
    left = servers()
    del left["turning"]
    assert set(tools()) - set(frame_tools(frames(), left)) == {"turning"}


def test_amounts_have_types_units_and_limits() -> None:
    angle = tools()["turning"].schema["properties"]["angle"]
    assert (angle["type"], angle["unit"]) == ("number", "rad")
    assert math.isclose(angle["maximum"], 2 * math.pi)
    assert math.isclose(angle["minimum"], -2 * math.pi)
    duration = tools()["waiting"].schema["properties"]["duration"]
    assert (duration["unit"], duration["minimum"], duration["maximum"]) == ("s", 0.0, 3600.0)


def test_values_are_an_enumeration() -> None:
    properties = tools()["turning"].schema["properties"]
    assert properties["direction"]["enum"] == ["left", "right"]
    # What a server states, in single words where there are some.
    assert properties["manner"]["enum"] == ["slow", "quick"]


def test_core_elements_without_a_default_are_required() -> None:
    schema = tools()["turning"].schema
    assert schema["required"] == ["direction"]
    assert schema["additionalProperties"] is False


def test_units_and_what_nobody_heeds_are_no_properties() -> None:
    properties = tools()["turning"].schema["properties"]
    assert "angle_unit" not in properties
    assert "theme" not in properties


def test_relations_of_the_server_are_offered() -> None:
    goal = tools()["bringing"].schema["properties"]["goal"]
    assert goal["anyOf"][1]["properties"]["relation"]["enum"] == ["on", "in"]
    assert goal["anyOf"][0]["semanticTypes"] == ["Physical_object", "Location"]


def test_a_tool_says_that_a_person_must_say_yes() -> None:
    assert "A person must say yes first." in tools()["unlocking"].description
    assert "where the device is stove or oven" in tools()["switching_device"].description
    assert tools()["unlocking"].may_want_yes
    assert tools()["switching_device"].may_want_yes
    assert not tools()["turning"].may_want_yes


def test_names_of_own_tools_are_kept_from_frames() -> None:
    assert tuple(OWN) == OWN_TOOLS
