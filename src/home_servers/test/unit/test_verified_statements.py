"""What the robot makes sure of and checks: denials, opposites and places."""

import os

import pytest
from direct_body import DirectBody

from home_servers.body import CannotDo
from home_servers.looking import inspect, verify
from home_servers.skills import Skills
from home_servers.statements import statement_of
from roboframenet_sim.home_engine import Home
from roboframenet_sim.home_file import load_home_file
from roboframenet_sim.home_truth import truth_of
from typed_arguments import FilledFrame, TypedArgument

HOME_FILE = os.path.join(os.path.dirname(__file__), "..", "..", "..", "roboframenet_sim", "config", "home.yaml")


@pytest.mark.parametrize(
    ("text", "about", "state", "place", "flags"),
    [
        ("the door is closed", "the door", "closed", "", ""),
        ("that the door is not open", "the door", "open", "", "negated"),
        ("the stove isn't on", "the stove", "on", "", "negated"),
        ("no lights are on", "lights", "on", "", "denied all"),
        ("none of the doors is open", "the doors", "open", "", "denied all"),
        ("all the lights are off", "the lights", "off", "", "all"),
        ("nobody is in the garage", "person", "", "the garage", "denied all"),
        ("that there is nothing on the table", "thing", "", "the table", "denied all"),
        ("there is no one in the hall", "person", "", "the hall", "denied all"),
        ("Anna is in the kitchen", "anna", "", "the kitchen", ""),
    ],
)
def test_statement(text, about, state, place, flags):
    found = statement_of(text)
    names = ("denied", found.is_denied), ("negated", found.is_negated), ("all", found.is_of_all)
    said = " ".join(name for name, holds in names if holds)
    assert (found.about.text, found.state, found.place.text, said) == (about, state, place, flags)


@pytest.mark.parametrize(
    "text",
    ["nobody enters the kitchen", "nothing falls", "not all doors are open", "the lights in the hall are on", "is"],
)
def test_other_clauses_are_no_statements(text):
    assert statement_of(text) is None


def body_with(**changes):
    plan, state = load_home_file(HOME_FILE)
    home = Home(plan, state)
    home.change(reason="test", **changes)
    return home, DirectBody(home, most_s=900.0)


def frame_of(name, **texts):
    return FilledFrame(name, tuple(TypedArgument(element, text) for element, text in texts.items()))


def test_nobody_is_somewhere():
    _, body = body_with()
    verify(Skills(body, speaker="alice"), frame_of("verifying", content="nobody is in the garage"))
    assert body.said == ["I see nobody in the garage."]


def test_somebody_is_where_nobody_shall_be():
    _, body = body_with()
    with pytest.raises(CannotDo, match=r"^I see Bob in the office\.$"):
        verify(Skills(body, speaker="alice"), frame_of("verifying", content="that nobody is in the office"))


@pytest.mark.parametrize("content", ["no stove is on", "the stove is not on", "that the stove isn't on"])
def test_what_shall_not_be_on_is_switched_off(content):
    home, body = body_with(stove={"is_on": True})
    verify(Skills(body, speaker="alice"), frame_of("verifying", content=content))
    assert truth_of(home.plan, home.state)["stove.is_on"] is False


def test_what_is_not_of_some_state_is_left_open():
    _, body = body_with()
    with pytest.raises(CannotDo, match="not know what is not"):
        verify(Skills(body, speaker="alice"), frame_of("verifying", content="the table is not red"))


@pytest.mark.parametrize(
    ("ground", "state", "said"),
    [
        ("nobody", "is in the office", "No, I see Bob in the office."),
        ("nobody", "there is in the garage", "Yes, I see nobody in the garage."),
        ("the garage door", "is not open", "No, the garage door is open."),
        ("the garage door", "is not closed", "Yes, the garage door is not closed."),
    ],
)
def test_denied_state_is_inspected(ground, state, said):
    _, body = body_with()
    inspect(Skills(body, speaker="alice"), frame_of("inspecting", ground=ground, desired_state=state))
    assert body.said == [said]
