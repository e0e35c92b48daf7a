"""Profiles of servers: statements, checks, what they heed, messages."""

import re
from typing import Any, Dict

import pytest

from semantic_frames.frame_file import load_frame
from semantic_frames.ros_server_profile import profile_from_message, profile_to_message
from semantic_frames.server_profile import AS_IN_2012, HeededElement, Purpose, ServerProfile, profile_problems
from semantic_frames.server_statement import ProfileError, stated_profile
from typed_arguments import TypedArgument

FRAME = load_frame(
    """
    name: putting
    frame_elements:
      - {name: theme, is_core: True}
      - {name: goal, relations: ["on", in, under]}
      - {name: side, values: [left, right]}
      - {name: speed}
    """,
    "putting.yaml",
)
STATEMENT: Dict[str, Any] = {
    "purpose": "watches",
    "heeds": {"Manner": ["slow", "quick"], "Degree": None, "goal": {"relations": ["on"], "most": 2}},
    "unheeded": ["speed"],
    "occupies": ["base", "arms"],
    "settings": [{"node": "planner", "name": "max_vel_x", "value": 0.2}],
    "longest_goal_s": 60,
    "longest_silence_s": "5",
    "robot": "pr2",
}


def test_statement_becomes_a_profile_and_survives_the_message() -> None:
    profile = stated_profile(STATEMENT)
    assert profile.purpose is Purpose.WATCHES
    assert profile.heeds[0] == HeededElement("Manner", values=("slow", "quick"))
    assert (profile.longest_goal_s, profile.longest_silence_s) == (60.0, 5.0)
    assert profile.settings[0].value == "0.2"
    assert profile_problems(profile, FRAME) == ()
    assert profile_from_message(profile_to_message(profile)) == profile
    assert stated_profile({}) == AS_IN_2012 == profile_from_message(profile_to_message(AS_IN_2012))
    assert stated_profile({"heeds": ["Manner"], "occupies": "nothing"}).occupies == ("nothing",)


@pytest.mark.parametrize(
    "statement, problem",
    [
        ({"purpos": "acts"}, "did you mean 'purpose'"),
        ({"purpose": "looks"}, "acts or watches, found 'looks'"),
        ({"purpose": []}, "acts or watches"),
        ({"heeds": 3}, "heeds: expected a list of texts"),
        ({"heeds": {"Manner": {"value": ["slow"]}}}, "did you mean 'values'"),
        ({"heeds": {"theme": {"most": "many"}}}, "heeds.theme.most: expected a number of things"),
        ({"occupies": [1]}, "occupies: expected texts, found 1"),
        ({"longest_goal_s": -1}, "longest_goal_s: expected seconds, 0 or more, found -1"),
        ({"settings": [{"node": "planner"}]}, "settings: expected node, name and value"),
        ({"robot": 3}, "robot: expected a text"),
    ],
)
def test_wrong_statement_is_refused(statement: Dict[str, Any], problem: str) -> None:
    with pytest.raises(ProfileError, match=problem):
        stated_profile(statement)


@pytest.mark.parametrize(
    "statement, problem",
    [
        ({"heeds": ["Maner"]}, "heeds 'Maner': the frame putting has no such element.*did you mean 'Manner'"),
        ({"heeds": ["gaol"]}, "did you mean 'goal'"),
        ({"heeds": {"goal": {"relations": ["behind"]}}}, "relation 'behind' is unknown, expected one of on, in, under"),
        ({"heeds": {"theme": {"relations": ["nextto"]}}}, "did you mean 'next_to'"),
        ({"heeds": {"theme": {"semantic_types": ["Contaner"]}}}, "did you mean 'Container'"),
        ({"heeds": {"side": ["up"]}}, "value 'up' is unknown, expected one of left, right"),
        ({"unheeded": ["theme"]}, "cannot be carried out without its core element"),
        ({"unheeded": ["Manner"]}, "has no such element"),
        ({"unheeded": ["goal"], "heeds": ["goal"]}, "also states that it heeds it"),
        ({"occupies": ["nothing", "base"]}, "'nothing' stands alone"),
        ({"settings": [{"node": "", "name": "x", "value": 1}]}, "expected a node, a name"),
        ({"heeds": ["Manner"] * 201}, "201 entries, expected at most 200"),
    ],
)
def test_profile_that_does_not_fit_is_refused(statement: Dict[str, Any], problem: str) -> None:
    (found,) = profile_problems(stated_profile(statement), FRAME)
    assert re.search(problem, found), found


def test_names_of_an_unknown_frame_are_not_checked() -> None:
    assert profile_problems(stated_profile({"heeds": ["anything"], "unheeded": ["other"]}), None) == ()


def test_other_actions_and_odd_numbers_of_the_wire_are_refused() -> None:
    (problem,) = profile_problems(ServerProfile(action_type="move_base_msgs/MoveBaseAction"), FRAME)
    assert "FilledSemanticFrameAction" in problem
    (problem,) = profile_problems(ServerProfile(longest_goal_s=-1.0), FRAME)
    assert "longest_goal" in problem
    (problem,) = profile_problems(ServerProfile(heeds=(HeededElement("goal", most=-2),)), FRAME)
    assert "most" in problem


@pytest.mark.parametrize(
    "heeded, argument, expected",
    [
        (HeededElement("manner", values=("quick",)), TypedArgument(text="quickly"), True),
        (HeededElement("manner", values=("gentle", "steady")), TypedArgument(text="gently"), True),
        (HeededElement("manner", values=("gentle", "steady")), TypedArgument(text="steadily"), True),
        (HeededElement("manner", values=("slow",)), TypedArgument(text="quickly"), False),
        (HeededElement("manner", values=("Slow",)), TypedArgument(text="very slowly", lemma="slowly"), True),
        (HeededElement("goal", relations=("on",)), TypedArgument(text="the table", relation="under"), False),
        (HeededElement("goal", relations=("on",)), TypedArgument(text="the table"), True),
        (HeededElement("goal", semantic_types=("Container",)), TypedArgument(semantic_type="Cookware"), True),
        (HeededElement("goal", semantic_types=("Container",)), TypedArgument(semantic_type="Human"), False),
        (HeededElement("theme", most=1), TypedArgument(text="two mugs", count=2), False),
        (HeededElement("theme", most=2), TypedArgument(text="two mugs", count=2), True),
        (
            HeededElement("goal", relations=("on",)),
            TypedArgument(relation="under", members=(TypedArgument(text="a"), TypedArgument(text="b", relation="on"))),
            False,
        ),
    ],
)
def test_what_a_server_heeds(heeded: HeededElement, argument: TypedArgument, expected: bool) -> None:
    assert heeded.fits(argument) is expected


def test_server_of_2012_heeds_what_its_frame_declares_and_nothing_else() -> None:
    assert AS_IN_2012.heeds_argument(TypedArgument("goal", "the table", relation="under"), FRAME)
    assert not AS_IN_2012.heeds_argument(TypedArgument("manner", "slowly"), FRAME)
    assert stated_profile({"heeds": ["Manner"]}).heeds_argument(TypedArgument("manner", "slowly"), FRAME)
    assert not stated_profile({"unheeded": ["goal"]}).heeds_argument(TypedArgument("goal", "the table"), FRAME)
