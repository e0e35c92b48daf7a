"""The search for candidates."""

import itertools
import math
import random
from typing import Dict, List, Sequence, Tuple, Union

import pytest

from frame_registrar import sequence_finder
from frame_registrar.filling import spoken_limit
from frame_registrar.graph import FrameGraph
from frame_registrar.search import Candidate, Reading, Refusal, combinations, search
from semantic_frames import load_frame
from semantic_frames.frame import Quantity
from typed_arguments import Source, TypedArgument

MOVING = """
name: moving
frame_elements:
  - {name: direction, is_core: True, default: forward}
  - {name: distance, is_core: True, quantity: length, unit_element: unit, maximum: 20 metres}
  - {name: unit, is_core: True}
children:
  - name: moving_forward
    frame_element_relations:
      - {parent_name: distance, child_name: distance}
      - {parent_name: direction, child_value: [forward, Forwards]}
  - name: moving_backward
    frame_element_relations:
      - {parent_name: distance, child_name: distance}
      - {parent_name: direction, child_value: backward}
"""


def graph_of(*texts: str, servers: Tuple[Tuple[str, str], ...] = ()) -> FrameGraph:
    graph = FrameGraph()
    for text in texts:
        graph.add(load_frame(text, "x.yaml"))
    for name, server in servers:
        graph.register(name, server)
    return graph


def reading(frame: str, coverage: float = 1.0, **arguments: str) -> Reading:
    return Reading(frame, tuple(TypedArgument(name, text) for name, text in arguments.items()), coverage)


def listed(conjunction: str, relation: str = "under") -> TypedArgument:
    """A list of two things."""
    members = (TypedArgument(text="the mug"), TypedArgument(text="the plate", relation="behind"))
    text = f"the mug {conjunction} the plate"
    return TypedArgument("theme", text, relation=relation, members=members, conjunction=conjunction)


def moving_graph() -> FrameGraph:
    return graph_of(
        MOVING,
        "name: moving_forward\nframe_elements: [{name: distance}]",
        "name: moving_backward\nframe_elements: [{name: distance}]",
        servers=(("moving_forward", "forward_server"), ("moving_backward", "backward_server")),
    )


def only(found: Union[Tuple[Tuple[Candidate, ...], ...], Refusal]) -> Tuple[Candidate, ...]:
    """Candidates of the only clause."""
    assert not isinstance(found, Refusal), found
    (candidates,) = found
    return candidates


def servers_of(found: Union[Tuple[Tuple[Candidate, ...], ...], Refusal]) -> List[Tuple[str, ...]]:
    """Servers of each candidate of the only clause."""
    return [tuple(frame.server for frame in candidate.frames) for candidate in only(found)]


@pytest.mark.parametrize(
    "direction, server",
    [("forward", "forward_server"), ("FORWARDS", "forward_server"), ("backward", "backward_server")],
)
def test_value_condition_chooses_the_child(direction: str, server: str) -> None:
    found = search(
        moving_graph(), [[reading("moving", direction=direction, distance="3", unit="feet")]], max_candidates=9
    )
    assert servers_of(found) == [(server,)]
    assert only(found)[0].frames[0].texts == (("distance", "3"),)


def test_default_fills_what_was_not_said() -> None:
    found = search(moving_graph(), [[reading("moving", distance="3", unit="feet")]], max_candidates=9)
    assert servers_of(found) == [("forward_server",)]


@pytest.mark.parametrize(
    "arguments, code",
    [
        ({"distance": "3", "unit": "kilometres"}, "LIMIT"),
        ({"distance": "1e400", "unit": "metres"}, "LIMIT"),
        ({"distance": "3", "unit": "parsecs"}, "VALUE_NOT_ALLOWED"),
        ({"unit": "metres"}, "MISSING_ELEMENT"),
        ({"distance": "3", "unit": "metres", "direction": "sideways"}, "VALUE_NOT_ALLOWED"),
    ],
)
def test_refusal_tells_why(arguments: Dict[str, str], code: str) -> None:
    refusal = search(moving_graph(), [[reading("moving", **arguments)]], max_candidates=9)
    assert isinstance(refusal, Refusal) and refusal.code == code and refusal.sentence


def test_limit_is_in_the_sentence() -> None:
    refusal = search(moving_graph(), [[reading("moving", distance="3", unit="kilometres")]], max_candidates=9)
    assert isinstance(refusal, Refusal) and "20 metres" in refusal.sentence


def test_unknown_frame_is_refused() -> None:
    refusal = search(FrameGraph(), [[reading("flying")]], max_candidates=9)
    assert isinstance(refusal, Refusal) and refusal.code == "UNKNOWN_FRAME"


def test_no_server_names_what_would_do() -> None:
    refusal = search(graph_of("name: a\nchildren: [{name: b}]\n", "name: b\n"), [[reading("a")]], max_candidates=9)
    assert isinstance(refusal, Refusal) and '"a" or "b"' in refusal.sentence


def test_own_servers_come_before_children_and_each_is_a_candidate() -> None:
    graph = graph_of("name: a\nchildren: [{name: b}]\n", "name: b\n", servers=(("b", "s3"), ("a", "s1"), ("a", "s2")))
    assert servers_of(search(graph, [[reading("a")]], max_candidates=9)) == [("s1",), ("s2",), ("s3",)]


def test_sequence_gives_all_combinations_in_order() -> None:
    graph = graph_of(
        "name: a\nchildren: [[{name: b}, {name: c}]]\n",
        "name: b\n",
        "name: c\n",
        servers=(("b", "b1"), ("b", "b2"), ("c", "c1"), ("c", "c2")),
    )
    assert servers_of(search(graph, [[reading("a")]], max_candidates=9)) == [
        ("b1", "c1"),
        ("b1", "c2"),
        ("b2", "c1"),
        ("b2", "c2"),
    ]


def sequence_of(names: Sequence[str]) -> str:
    """YAML of the frames that do a task one after the other."""
    return f"[{', '.join(f'{{name: {name}}}' for name in names)}]"


def test_search_is_lazy_and_bounded() -> None:
    names = [f"m{index}" for index in range(40)]
    graph = graph_of(
        f"name: a\nchildren: [{sequence_of(names)}]\n",
        *[f"name: {name}\n" for name in names],
        servers=tuple((name, f"{name}_{index}") for name in names for index in range(2)),
    )
    assert len(only(search(graph, [[reading("a")]], max_candidates=64))) == 64


def test_sequence_with_one_member_that_nobody_can_do_ends_at_once() -> None:
    names = [f"m{index}" for index in range(60)]
    graph = graph_of(
        f"name: a\nchildren: [{sequence_of([*names, 'last'])}]\n",
        "name: last\n",
        *[f"name: {name}\n" for name in names],
        servers=tuple((name, f"{name}_{index}") for name in names for index in range(2)),
    )
    refusal = search(graph, [[reading("a")]], max_candidates=64)
    assert isinstance(refusal, Refusal) and 'registered for "a" or "last".' in refusal.sentence


def test_frames_that_several_roads_lead_to_are_one_candidate() -> None:
    graph = graph_of(
        "name: a\nchildren: [{name: b}, {name: c}]\n",
        "name: b\nchildren: [{name: d}]\n",
        "name: c\nchildren: [{name: d}]\n",
        "name: d\n",
        servers=(("d", "s"),),
    )
    assert servers_of(search(graph, [[reading("a"), reading("a", 0.5)]], max_candidates=9)) == [("s",)]


def test_limit_of_a_child_is_told() -> None:
    graph = graph_of(
        "name: p\nframe_elements: [{name: d}]\nchildren:\n  - name: c\n    frame_element_relations:\n"
        "      - {parent_name: d, child_name: d}\n",
        "name: c\nframe_elements: [{name: d, quantity: length, maximum: 20}]\n",
        servers=(("c", "s"),),
    )
    refusal = search(graph, [[reading("p", d="30 metres")]], max_candidates=9)
    assert isinstance(refusal, Refusal) and refusal.code == "LIMIT" and "20 metres" in refusal.sentence


def test_value_that_no_child_stands_for_is_told_with_those_that_do() -> None:
    refusal = search(
        moving_graph(), [[reading("moving", distance="3", unit="metres", direction="sideways")]], max_candidates=9
    )
    assert isinstance(refusal, Refusal) and '"sideways", only forward, Forwards or backward' in refusal.sentence


def test_child_that_is_meant_but_has_no_server_is_what_is_missing() -> None:
    graph = moving_graph()
    graph.set_dead(frozenset(["backward_server"]))
    refusal = search(graph, [[reading("moving", distance="3", unit="metres", direction="backward")]], max_candidates=9)
    assert isinstance(refusal, Refusal) and refusal.code == "NO_SERVER"
    assert 'registered for "moving" or "moving_backward".' in refusal.sentence


def test_child_without_a_file_is_named_as_missing() -> None:
    refusal = search(graph_of("name: a\nchildren: [{name: b}]\n"), [[reading("a")]], max_candidates=9)
    assert isinstance(refusal, Refusal) and '"a" or "b"' in refusal.sentence


def test_graph_too_large_to_look_at_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sequence_finder, "MOST_FRAMES", 2)
    texts = [f"name: f{index}\nchildren: [{{name: f{index + 1}}}]\n" for index in range(5)] + ["name: f5\n"]
    graph = graph_of(*texts, servers=(("f5", "s"),))
    refusal = search(graph, [[reading("f0")]], max_candidates=9)
    assert isinstance(refusal, Refusal) and refusal.code == "TOO_MANY_CANDIDATES"


@pytest.mark.parametrize("clauses", [[], [[]]])
def test_nothing_understood_is_a_refusal(clauses: List[List[Reading]]) -> None:
    refusal = search(moving_graph(), clauses, max_candidates=9)
    assert isinstance(refusal, Refusal) and refusal.code == "NO_READING"


def test_higher_coverage_comes_first() -> None:
    graph = graph_of("name: a\n", "name: b\n", servers=(("a", "a1"), ("b", "b1")))
    found = search(graph, [[reading("a", 0.5), reading("b", 1.0)]], max_candidates=9)
    assert servers_of(found) == [("b1",), ("a1",)]


def test_likelier_reading_comes_first_whatever_it_covers() -> None:
    graph = graph_of("name: a\n", "name: b\n", servers=(("a", "a1"), ("b", "b1"), ("b", "b2")))
    readings = [Reading("a", preference=1), Reading("b", coverage=0.5)]
    found = search(graph, [readings], max_candidates=9)
    assert servers_of(found) == [("b1",), ("b2",), ("a1",)]
    assert [candidate.preference for candidate in only(found)] == [0, 0, 1]
    assert servers_of(search(graph, [readings], max_candidates=2)) == [("b1",), ("b2",)]


def test_items_of_or_are_alternatives_of_one_reading() -> None:
    said = listed("or")
    graph = graph_of(TAKING % "repeat", servers=(("taking", "s"),))
    found = search(graph, [[Reading("taking", (said,), preference=3)]], max_candidates=9)
    assert [candidate.preference for candidate in only(found)] == [3, 3]


def test_frames_of_two_readings_are_of_the_likelier() -> None:
    graph = graph_of("name: a\nchildren: [{name: b}]\n", "name: b\n", servers=(("b", "s"),))
    found = search(graph, [[Reading("a", preference=1), Reading("b")]], max_candidates=9)
    assert [(candidate.frames[0].name, candidate.preference) for candidate in only(found)] == [("b", 0)]


def test_each_clause_has_its_own_candidates() -> None:
    graph = graph_of("name: a\n", "name: b\n", servers=(("a", "a1"), ("a", "a2"), ("b", "b1"), ("b", "b2")))
    found = search(graph, [[reading("a")], [reading("b")]], max_candidates=2)
    assert not isinstance(found, Refusal)
    assert [servers_of((candidates,)) for candidates in found] == [[("a1",), ("a2",)], [("b1",), ("b2",)]]
    told_in_2012 = [[frame.server for frame in frames] for frames in combinations(found, 3)]
    assert told_in_2012 == [["a1", "b1"], ["a1", "b2"], ["a2", "b1"]]


def test_many_clauses_cost_no_product() -> None:
    graph = graph_of("name: a\n", servers=tuple(("a", f"a{number}") for number in range(64)))
    found = search(graph, [[reading("a")]] * 40, max_candidates=64)
    assert not isinstance(found, Refusal)
    assert [len(candidates) for candidates in found] == [64] * 40
    assert len(combinations(found, 64)) == 64


def test_clause_that_nobody_can_do_refuses_the_sentence() -> None:
    graph = graph_of("name: a\n", "name: b\n", servers=(("a", "a1"),))
    assert isinstance(search(graph, [[reading("a")], [reading("b")]], max_candidates=9), Refusal)


TAKING = "name: taking\nframe_elements: [{name: theme, is_core: True}]\non_list: %s\n"


@pytest.mark.parametrize(
    "policy, conjunction, expected",
    [
        ("repeat", "and", [["the mug", "the plate"]]),
        ("together", "and", [["the mug and the plate"]]),
        ("repeat", "or", [["the mug"], ["the plate"]]),
        ("together", "or", [["the mug"], ["the plate"]]),
    ],
)
def test_lists(policy: str, conjunction: str, expected: List[List[str]]) -> None:
    graph = graph_of(TAKING % policy, servers=(("taking", "s"),))
    said = listed(conjunction)
    found = search(graph, [[Reading("taking", (said,))]], max_candidates=9)
    assert [[frame.text("theme") for frame in candidate.frames] for candidate in only(found)] == expected


@pytest.mark.parametrize("relation", ["between", "among"])
def test_what_lies_between_several_things_lies_in_one_place(relation: str) -> None:
    graph = graph_of(TAKING % "repeat", servers=(("taking", "s"),))
    found = search(graph, [[Reading("taking", (listed("and", relation),))]], max_candidates=9)
    assert [[frame.text("theme") for frame in candidate.frames] for candidate in only(found)] == [
        ["the mug and the plate"]
    ]


def brute_force(
    children: Dict[str, List[List[str]]], servers: Dict[str, List[str]], name: str
) -> List[Tuple[str, ...]]:
    """All realisations, those that several roads lead to repeated, by writing out every product."""
    found = [(server,) for server in servers.get(name, [])]
    for sequence in children.get(name, []):
        parts = [brute_force(children, servers, child) for child in sequence]
        found += [tuple(itertools.chain(*combination)) for combination in itertools.product(*parts)]
    return found


@pytest.mark.parametrize("seed", range(30))
def test_search_finds_what_brute_force_finds(seed: int) -> None:
    chance = random.Random(seed)
    names = [f"f{index}" for index in range(6)]
    children = {
        name: [
            [chance.choice(names[index + 1 :]) for _ in range(chance.randint(1, 2))]
            for _ in range(chance.randint(0, 2))
        ]
        for index, name in enumerate(names[:-1])
    }
    servers = {name: [f"{name}_{index}" for index in range(chance.randint(0, 2))] for name in names}
    texts = [
        f"name: {name}\n"
        + (
            f"children: [{', '.join(sequence_of(sequence) for sequence in children[name])}]\n"
            if children.get(name)
            else ""
        )
        for name in names
    ]
    graph = graph_of(*texts, servers=tuple((name, server) for name in names for server in servers[name]))
    expected = list(dict.fromkeys(brute_force(children, servers, "f0")))
    found = search(graph, [[reading("f0")]], max_candidates=100000)
    assert (servers_of(found) if not isinstance(found, Refusal) else []) == expected, f"seed {seed}"


@pytest.mark.parametrize("step", [1, -1])
def test_chain_that_is_deeper_than_the_stack_is_searched(step: int) -> None:
    depth = 3000
    chain = [f"name: f{number}\nchildren: [{{name: f{number + 1}}}]" for number in range(depth)]
    graph = graph_of(*chain[::step], f"name: f{depth}", servers=((f"f{depth}", "last"),))
    (candidate,) = only(search(graph, [[reading("f0")]], max_candidates=64))
    assert [(frame.name, frame.server) for frame in candidate.frames] == [(f"f{depth}", "last")]
    graph.set_dead(frozenset(["last"]))
    refusal = search(graph, [[reading("f0")]], max_candidates=64)
    assert isinstance(refusal, Refusal) and refusal.code == "NO_SERVER"


def test_long_sequence_is_searched() -> None:
    length = 2000
    members = ", ".join(f"{{name: m{number}}}" for number in range(length))
    graph = graph_of(f"name: all\nchildren: [[{members}]]", *(f"name: m{number}" for number in range(length)))
    for number in range(length):
        graph.register(f"m{number}", "server")
    (candidate,) = only(search(graph, [[reading("all")]], max_candidates=64))
    assert [frame.name for frame in candidate.frames] == [f"m{number}" for number in range(length)]


def test_alternatives_come_in_the_order_of_the_files() -> None:
    graph = graph_of(
        "name: whole\nchildren:\n  - [{name: a}, {name: b}]\n  - {name: c}",
        "name: a",
        "name: b",
        "name: c",
        servers=(("a", "a1"), ("a", "a2"), ("b", "b1"), ("b", "b2"), ("c", "c1"), ("whole", "w")),
    )
    candidates = only(search(graph, [[reading("whole")]], max_candidates=64))
    assert [" ".join(frame.server for frame in candidate.frames) for candidate in candidates] == [
        "w",
        "a1 b1",
        "a1 b2",
        "a2 b1",
        "a2 b2",
        "c1",
    ]


PLACING = """
name: placing
frame_elements: [{name: goal, is_core: True}]
children:
  - - name: going
      frame_element_relations: [{parent_name: goal, child_name: goal, relation: to}]
    - name: releasing
      frame_element_relations: [{parent_name: goal, child_name: goal}]
"""


@pytest.mark.parametrize("relation, is_done", [("on", True), ("next_to", True), ("under", False), ("", True)])
def test_relation_that_a_frame_cannot_express_is_refused(relation: str, is_done: bool) -> None:
    graph = graph_of(
        PLACING,
        "{name: going, frame_elements: [{name: goal, relations: [to]}]}",
        "{name: releasing, frame_elements: [{name: goal, relations: ['on', next_to]}]}",
        servers=(("going", "base"), ("releasing", "arm")),
    )
    said = TypedArgument("goal", "the table", relation=relation)
    found = search(graph, [[Reading("placing", (said,))]], max_candidates=9)
    if is_done:
        going, releasing = only(found)[0].frames
        assert (going.arguments[0].relation, releasing.arguments[0].relation) == ("to", relation)
    else:
        assert found == Refusal(
            "VALUE_NOT_ALLOWED",
            'The goal cannot be "under the table", only on or next to something.',
        )


def test_default_has_its_measure_and_says_that_it_is_one() -> None:
    graph = graph_of(
        "{name: turning, frame_elements: [{name: angle, default: '90', quantity: angle, unit_element: unit},"
        " {name: unit, default: degrees}]}",
        servers=(("turning", "base"),),
    )
    angle = only(search(graph, [[Reading("turning")]], max_candidates=9))[0].frames[0].find("angle")
    assert angle is not None and angle.source is Source.DEFAULT
    assert angle.si == pytest.approx(1.5707963)


def test_member_of_a_list_keeps_the_relation_that_was_said_once() -> None:
    graph = graph_of(TAKING % "repeat", servers=(("taking", "s"),))
    found = only(search(graph, [[Reading("taking", (listed("and"),))]], max_candidates=9))
    assert [frame.arguments[0].relation for frame in found[0].frames] == ["under", "behind"]


@pytest.mark.parametrize("positions, is_done", [((2,), True), ((3,), False)])
def test_a_refused_value_gives_way_only_to_a_reading_of_the_same_words(
    positions: Tuple[int, ...], is_done: bool
) -> None:
    graph = graph_of(
        "name: going\nframe_elements: [{name: goal, is_core: True, relations: [to]}]",
        "name: looking\nframe_elements: [{name: place}]",
        servers=(("going", "going"), ("looking", "looking")),
    )
    goal = TypedArgument("goal", "the hedge", relation="under", head="hedge", head_position=2, positions=(1, 2))
    place = TypedArgument("place", "the hedge", head="hedge", head_position=positions[0], positions=positions)
    found = search(graph, [[Reading("going", (goal,)), Reading("looking", (place,), preference=1)]], max_candidates=9)
    assert isinstance(found, Refusal) is not is_done
    assert is_done or (isinstance(found, Refusal) and found.code == "VALUE_NOT_ALLOWED")


@pytest.mark.parametrize(
    "si, quantity, words",
    [
        (300.0, Quantity.DURATION, "5 minutes"),
        (90.0, Quantity.DURATION, "90 seconds"),
        (3600.0, Quantity.DURATION, "1 hour"),
        (0.5, Quantity.DURATION, "0.5 seconds"),
        (20.0, Quantity.LENGTH, "20 metres"),
        (math.pi, Quantity.ANGLE, "180 degrees"),
        (12.0, Quantity.NUMBER, "12"),
    ],
)
def test_limit_is_told_in_a_unit_that_people_use(si: float, quantity: Quantity, words: str) -> None:
    assert spoken_limit(si, quantity) == words
