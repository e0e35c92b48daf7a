"""The search for servers that watch conditions."""

from typing import List, Tuple

import pytest

from frame_registrar.graph import FrameGraph
from frame_registrar.search import Conditions, Found, Reading, Refusal, candidates_of, search
from semantic_frames import load_frame
from semantic_frames.server_statement import stated_profile
from typed_arguments import Source, TypedArgument

SEEING = "name: seeing\nframe_elements: [{name: phenomenon, is_core: True}]\n"


def graph_of(*texts: str, acting: Tuple[Tuple[str, str], ...] = (), **watching: str) -> FrameGraph:
    """A graph with servers that act, and with servers that watch, by the name of the server."""
    graph = FrameGraph()
    for text in texts:
        graph.add(load_frame(text, "x.yaml"))
    for frame, server in acting:
        graph.register(frame, server)
    for server, frame in watching.items():
        graph.register(frame, server, stated_profile({"purpose": "watches"}))
    return graph


def seeing(text: str = "a wall", preference: int = 0, **fields: object) -> Reading:
    return Reading("seeing", (TypedArgument("phenomenon", text, **fields),), preference=preference)  # type: ignore[arg-type]


def listed(conjunction: str) -> Reading:
    members = (TypedArgument(text="Anna"), TypedArgument(text="Bob"))
    return seeing(f"Anna {conjunction} Bob", members=members, conjunction=conjunction)


def servers_of(found: Found) -> List[str]:
    return [frame.server for candidate in candidates_of(found) for frame in candidate.frames]


def watched(graph: FrameGraph, *readings: Reading, words: str = "you see a wall") -> Found:
    found = search(graph, [readings], max_candidates=9, conditions={0: words})
    assert not isinstance(found, Refusal), found
    return found[0]


def test_clause_is_done_and_condition_is_watched() -> None:
    graph = graph_of(
        SEEING, "name: driving\n", acting=(("driving", "base"), ("seeing", "looking")), scan="seeing", more="seeing"
    )
    found = search(graph, [[seeing()], [Reading("driving")]], max_candidates=9, conditions={0: "you see a wall"})
    assert not isinstance(found, Refusal)
    assert [servers_of(one) for one in found] == [["scan", "more"], ["base"]]


@pytest.mark.parametrize("words, said", [("you see a wall", 'whether "you see a wall"'), ("", "whether that is so")])
def test_condition_that_nobody_watches_is_refused_by_name(words: str, said: str) -> None:
    graph = graph_of(SEEING, acting=(("seeing", "looking"),))
    refusal = search(graph, [[seeing()]], max_candidates=9, conditions={0: words})
    sentence = f'I understand what you want, but I cannot tell {said}: no server watches "seeing".'
    assert refusal == Refusal("NO_SERVER", sentence)


def test_dead_watcher_is_none() -> None:
    graph = graph_of(SEEING, scan="seeing")
    graph.set_dead(frozenset(["scan"]))
    assert isinstance(search(graph, [[seeing()]], max_candidates=9, conditions={0: ""}), Refusal)


def test_watcher_that_cannot_see_that_is_none() -> None:
    graph = graph_of(SEEING)
    statement = {"purpose": "watches", "heeds": {"phenomenon": {"values": ["wall"]}}}
    graph.register("seeing", "scan", stated_profile(statement))
    refusal = search(graph, [[seeing("Anna")]], max_candidates=9, conditions={0: "you see Anna"})
    assert isinstance(refusal, Refusal)
    assert refusal.code == "VALUE_NOT_ALLOWED"
    assert refusal.sentence == (
        'I understand what you want, but I cannot tell whether "you see Anna": no server can tell that for "Anna".'
    )


def test_watcher_heeds_also_what_the_words_stand_for() -> None:
    """ "The battery is low" says no level: the lexical unit does."""
    graph = graph_of(SEEING)
    for value in ("wall", "door"):
        statement = {"purpose": "watches", "heeds": {"phenomenon": {"values": [value]}}}
        graph.register("seeing", f"{value}_watch", stated_profile(statement))
    assert servers_of(watched(graph, seeing("door", source=Source.DEFAULT))) == ["door_watch"]


@pytest.mark.parametrize("conjunction, is_all", [("and", True), ("or", False)])
def test_each_member_of_a_list_is_watched(conjunction: str, is_all: bool) -> None:
    found = watched(graph_of(SEEING, scan="seeing", more="seeing"), listed(conjunction))
    assert isinstance(found, Conditions) and found.is_all is is_all
    assert [servers_of(part) for part in found.parts] == [["scan", "more"], ["scan", "more"]]
    texts = [candidates_of(part)[0].frames[0].texts for part in found.parts]
    assert texts == [(("phenomenon", "Anna"),), (("phenomenon", "Bob"),)]


def test_list_with_a_member_that_nobody_watches_is_refused() -> None:
    graph = graph_of(SEEING)
    statement = {"purpose": "watches", "heeds": {"phenomenon": {"values": ["Anna"]}}}
    graph.register("seeing", "scan", stated_profile(statement))
    assert isinstance(search(graph, [[listed("or")]], max_candidates=9, conditions={0: ""}), Refusal)


def test_next_reading_counts_only_if_nobody_watches_the_likelier_one() -> None:
    smelling = Reading("smelling", preference=1)
    graph = graph_of(SEEING, "name: smelling\n", scan="seeing", nose="smelling")
    assert servers_of(watched(graph, smelling, seeing())) == ["scan"]
    graph.set_dead(frozenset(["scan"]))
    assert servers_of(watched(graph, smelling, seeing())) == ["nose"]


def test_child_watches_in_place_of_its_parent_but_no_sequence_does() -> None:
    child = "name: noticing\n"
    assert servers_of(watched(graph_of("name: a\nchildren: [{name: noticing}]\n", child, n="noticing"), Reading("a")))
    graph = graph_of("name: a\nchildren: [[{name: noticing}, {name: noticing}]]\n", child, n="noticing")
    refusal = search(graph, [[Reading("a")]], max_candidates=9, conditions={0: "it is so"})
    assert isinstance(refusal, Refusal) and refusal.code == "NO_SERVER"
