"""Candidates whose servers do not heed what was said are dropped when others do, and refused by name otherwise."""

from typing import Any, Dict, Mapping, Tuple, Union

import pytest

from frame_registrar.graph import FrameGraph
from frame_registrar.search import Candidate, Reading, Refusal, search
from semantic_frames import load_frame
from semantic_frames.server_profile import Purpose
from semantic_frames.server_statement import stated_profile
from typed_arguments import Source, TypedArgument

PUTTING = """
name: putting
frame_elements: [{name: theme, is_core: True}, {name: goal, is_core: True}, {name: area}]
children:
  - - name: going
      frame_element_relations: [{parent_name: goal, child_name: goal, relation: to}]
    - name: releasing
      frame_element_relations: [{parent_name: theme, child_name: theme}]
"""
CHILDREN = ("name: going\nframe_elements: [{name: goal}]", "name: releasing\nframe_elements: [{name: theme}]")
THEME = TypedArgument("theme", "the mug")


def found(servers: Mapping[Tuple[str, str], Dict[str, Any]], *arguments: TypedArgument) -> Any:
    graph = FrameGraph()
    for text in (PUTTING, *CHILDREN):
        graph.add(load_frame(text, "x.yaml"))
    for (frame, server), statement in servers.items():
        assert graph.register(frame, server, stated_profile(statement)) == ()
    return search(graph, [[Reading("putting", (THEME, *arguments))]], max_candidates=64)


def servers_of(outcome: Union[Tuple[Tuple[Candidate, ...], ...], Refusal]) -> Any:
    if isinstance(outcome, Refusal):
        return outcome.code, outcome.sentence
    return [tuple(frame.server for frame in candidate.frames) for candidate in outcome[0]]


def goal(relation: str) -> TypedArgument:
    return TypedArgument("goal", "the table", relation=relation, words=f"{relation} the table")


ON_ONLY = {"heeds": {"goal": {"relations": ["on"]}}}


@pytest.mark.parametrize(
    "relation, servers",
    [("on", [("on_only",), ("any",)]), ("under", [("any",)])],
)
def test_the_server_that_heeds_the_relation_is_taken(relation: str, servers: Any) -> None:
    registered = {("putting", "on_only"): ON_ONLY, ("putting", "any"): {}}
    assert servers_of(found(registered, goal(relation))) == servers


def test_what_no_server_heeds_is_refused_by_name() -> None:
    code, sentence = servers_of(found({("putting", "on_only"): ON_ONLY}, goal("under")))
    assert (code, sentence) == (
        "VALUE_NOT_ALLOWED",
        'The goal cannot be "under the table", only on something.',
    )


QUICKLY = TypedArgument("manner", "quickly", words="quickly")


def test_extra_thematic_argument_goes_to_the_servers_that_heed_it() -> None:
    registered = {("putting", "plain"): {}, ("putting", "quick"): {"heeds": {"Manner": ["quick"]}}}
    outcome = found(registered, goal("on"), QUICKLY)
    assert servers_of(outcome) == [("quick",)]
    assert outcome[0][0].frames[0].find("manner") == QUICKLY
    assert servers_of(found({("putting", "plain"): {}}, goal("on"), QUICKLY)) == (
        "VALUE_NOT_ALLOWED",
        'I can do that, but not "quickly".',
    )


def test_members_of_a_sequence_get_extra_thematic_arguments_if_all_heed_them() -> None:
    manner = {"heeds": ["Manner"]}
    outcome = found({("going", "base"): manner, ("releasing", "arm"): manner}, goal("on"), QUICKLY)
    assert servers_of(outcome) == [("base", "arm")]
    assert [frame.find("manner") for frame in outcome[0][0].frames] == [QUICKLY, QUICKLY]
    refused = found({("going", "base"): manner, ("releasing", "arm"): {}}, goal("on"), QUICKLY)
    assert isinstance(refused, Refusal) and "quickly" in refused.sentence


def test_sequence_that_loses_words_is_dropped_when_a_server_gets_them() -> None:
    area = TypedArgument("area", "the corner")
    children = {("going", "base"): {}, ("releasing", "arm"): {}}
    assert servers_of(found({("putting", "own"): {}, **children}, goal("on"), area)) == [("own",)]
    assert servers_of(found(children, goal("on"), area)) == [("base", "arm")]
    default = TypedArgument("area", "the corner", Source.DEFAULT)
    assert len(servers_of(found({("putting", "own"): {}, **children}, goal("on"), default))) == 2


def test_server_that_watches_does_not_act() -> None:
    code, _ = servers_of(found({("putting", "eye"): {"purpose": "watches"}}, goal("on")))
    assert code == "NO_SERVER"
    graph = FrameGraph()
    graph.register("putting", "eye", stated_profile({"purpose": "watches"}))
    assert (graph.servers("putting"), graph.servers("putting", Purpose.WATCHES)) == ((), ("eye",))


def test_second_registration_replaces_the_profile_and_a_wrong_one_does_not() -> None:
    graph = FrameGraph()
    graph.add(load_frame(PUTTING, "x.yaml"))
    graph.register("putting", "arm", stated_profile(ON_ONLY))
    assert graph.profile("putting", "arm").heeds[0].relations == ("on",)
    (error,) = graph.register("putting", "arm", stated_profile({"heeds": ["gaol"]}))
    assert "did you mean 'goal'" in error
    assert graph.profile("putting", "arm").heeds[0].relations == ("on",)
    graph.register("putting", "arm")
    assert graph.profile("putting", "arm").heeds == ()
    assert graph.registrations() == (("putting", "arm"),)


def test_profile_is_checked_when_the_file_comes_later() -> None:
    graph = FrameGraph()
    assert graph.register("putting", "arm", stated_profile({"heeds": ["gaol"]})) == ()
    graph.add(load_frame(PUTTING, "x.yaml"))
    assert "gaol" in graph.remark("putting", "arm")


TAKING = "name: taking\nframe_elements: [{name: theme, is_core: True, counts: [1], quantifiers: [the, a]}]"


@pytest.mark.parametrize(
    "argument, refused",
    [
        ({"text": "the cup", "quantifier": "the"}, ""),
        ({"text": "cup"}, ""),
        ({"text": "one cup", "count": 1}, ""),
        ({"text": "two cups", "count": 2, "is_plural": True}, "1 thing at a time"),
        ({"text": "the cups", "quantifier": "the", "is_plural": True}, "1 thing at a time"),
        ({"text": "every cup", "quantifier": "every"}, "the or a something"),
    ],
)
def test_what_a_frame_cannot_express_is_refused_by_name(argument: Dict[str, Any], refused: str) -> None:
    graph = FrameGraph()
    graph.add(load_frame(TAKING, "x.yaml"))
    graph.register("taking", "arm")
    said = TypedArgument("theme", words=argument["text"], **argument)
    outcome = search(graph, [[Reading("taking", (said,))]], max_candidates=64)
    if not refused:
        assert servers_of(outcome) == [("arm",)]
        return
    sentence = f'The theme cannot be "{said.text}", only {refused}.'
    assert servers_of(outcome) == ("VALUE_NOT_ALLOWED", sentence)


def test_list_that_is_repeated_is_one_thing_at_a_time() -> None:
    graph = FrameGraph()
    graph.add(load_frame(TAKING, "x.yaml"))
    graph.register("taking", "arm")
    members = (TypedArgument(text="the cup"), TypedArgument(text="the plate"))
    both = TypedArgument("theme", "the cup and the plate", members=members, conjunction="and")
    outcome = search(graph, [[Reading("taking", (both,))]], max_candidates=64)
    assert servers_of(outcome) == [("arm", "arm")]
