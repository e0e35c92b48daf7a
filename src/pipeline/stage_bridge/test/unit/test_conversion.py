"""What is made of the answers of a stage outside."""

from typing import Any, List

import pytest
from roboframenet_msgs.msg import (
    Clause,
    CommandLexicalUnits,
    FilledFrameElement,
    FilledLexicalUnit,
    FilledLexicalUnitList,
    FilledSemanticFrame,
    FilledSemanticFrameList,
    FrameCallback,
    FrameServers,
    LexicalUnitReading,
    Plan,
    PlanCandidate,
    PlanNode,
    Procedure,
    ServerProfile,
)

from stage_bridge.ros_conversion import (
    MOST_SEQUENCES,
    NoAnswer,
    NotIn2012,
    WrongAnswer,
    candidates_of,
    clause_of,
    frames_sent,
    ordered_plan,
    registered_in,
    units_sent,
)
from typed_arguments import TypedArgument
from typed_arguments.ros_messages import to_message

REGISTERED = frozenset({("turning", "slow"), ("turning", "quick"), ("pinging", "ping")})


def frame(name: str, *servers: str, **arguments: str) -> FilledSemanticFrame:
    elements = [FilledFrameElement(element, argument) for element, argument in arguments.items()]
    return FilledSemanticFrame(name, elements, list(servers))


def procedure(*sequences: List[FilledSemanticFrame]) -> Procedure:
    return Procedure([FilledSemanticFrameList(frames) for frames in sequences])


def servers(candidates: List[PlanCandidate]) -> List[List[str]]:
    return [[one.action_server_topics[0] for one in candidate.frames] for candidate in candidates]


SLOW, QUICK = frame("turning", "/slow", direction="left"), frame("turning", "/quick", direction="left")
ONE = PlanNode(
    kind=PlanNode.DO,
    label="turn left",
    candidates=[PlanCandidate([SLOW], 1.0, 0, [0], []), PlanCandidate([QUICK], 1.0, 0, [0], [])],
    arguments=[to_message(TypedArgument(name="direction", text="left"))],
)


def test_units_become_one_clause_of_alternatives() -> None:
    answer = FilledLexicalUnitList([FilledLexicalUnit("pinging", "poke", []), FilledLexicalUnit("mooing", "poke", [])])
    clause = clause_of(answer, "poke")
    assert [reading.lexical_unit.frame_name for reading in clause.readings] == ["pinging", "mooing"]
    assert (clause.words, clause.readings[0].coverage) == ("poke", 1.0)


@pytest.mark.parametrize(
    "unit",
    [
        FilledLexicalUnit("", "poke", []),
        FilledLexicalUnit("pinging", "poke", [FilledFrameElement("", "x")]),
        FilledLexicalUnit("pinging", "poke", [FilledFrameElement("theme", "x" * 1001)]),
        FilledLexicalUnit("pinging", "poke", [FilledFrameElement("theme", "x")] * 33),
    ],
)
def test_units_that_are_wrong_are_refused(unit: FilledLexicalUnit) -> None:
    with pytest.raises(WrongAnswer):
        clause_of(FilledLexicalUnitList([unit]), "poke")


def test_nothing_is_no_answer() -> None:
    for take in (lambda: clause_of(FilledLexicalUnitList(), "poke"), lambda: candidates_of(Procedure(), REGISTERED)):
        with pytest.raises(NoAnswer):
            take()


def test_a_frame_with_several_servers_becomes_several_candidates() -> None:
    answer = procedure([frame("pinging", "ping"), frame("turning", "slow", "/quick")])
    assert servers(candidates_of(answer, REGISTERED)) == [["ping", "slow"], ["ping", "/quick"]]


@pytest.mark.parametrize(
    "answer",
    [
        procedure([frame("turning", "/ping")]),
        procedure([frame("turning", "/unknown")]),
        procedure([frame("turning")]),
        procedure([]),
        procedure([frame("pinging", "ping")] * 21),
        procedure(*[[frame("pinging", "ping")]] * (MOST_SEQUENCES + 1)),
    ],
)
def test_sequences_that_are_wrong_are_refused(answer: Procedure) -> None:
    with pytest.raises(WrongAnswer):
        candidates_of(answer, REGISTERED)


def test_an_arbitrator_orders_and_leaves_out() -> None:
    sent = Plan(nodes=[ONE], beginning=Plan.BESIDE)
    lists = frames_sent(sent).frame_lists
    assert servers(ordered_plan(sent, Procedure(lists[::-1]), REGISTERED, "x").nodes[0].candidates) == [
        ["/quick"],
        ["/slow"],
    ]
    only = ordered_plan(sent, Procedure(lists[1:]), REGISTERED, "x")
    # Typed arguments stay, and so does the way in which the plan begins.
    assert (servers(only.nodes[0].candidates), only.beginning) == ([["/quick"]], Plan.BESIDE)
    assert [argument.name for argument in only.nodes[0].arguments] == ["direction"]


def test_an_arbitrator_invents_nothing() -> None:
    with pytest.raises(WrongAnswer, match="no registrar found: pinging"):
        ordered_plan(Plan(nodes=[ONE]), procedure([frame("pinging", "ping")]), REGISTERED, "x")
    with pytest.raises(WrongAnswer):
        ordered_plan(Plan(nodes=[ONE]), procedure([frame("turning", "/slow", direction="right")]), REGISTERED, "x")


def test_several_clauses_become_sequences() -> None:
    ping = PlanNode(
        kind=PlanNode.DO, label="ping", candidates=[PlanCandidate([frame("pinging", "/ping")], 1.0, 0, [], [])]
    )
    sent = Plan(nodes=[PlanNode(kind=PlanNode.SEQUENCE, label="x", children=[1, 2]), ONE, ping])
    lists = frames_sent(sent).frame_lists
    plan = ordered_plan(sent, Procedure(lists[::-1]), REGISTERED, "x")
    assert servers(plan.nodes[0].candidates) == [["/quick", "/ping"], ["/slow", "/ping"]]


def test_what_2012_cannot_say_is_not_sent() -> None:
    repeated = Plan(nodes=[PlanNode(kind=PlanNode.REPEAT, label="x", count=2, most=2, children=[1]), ONE])
    reading = Clause(words="x", readings=[LexicalUnitReading()])
    for take in (
        lambda: frames_sent(repeated),
        lambda: units_sent(CommandLexicalUnits(clauses=[reading, reading])),
        lambda: units_sent(CommandLexicalUnits(clauses=[reading], plan=repeated)),
    ):
        with pytest.raises(NotIn2012):
            take()


def test_servers_that_watch_or_are_dead_carry_nothing_out() -> None:
    def callback(server: str, is_alive: bool, purpose: Any) -> FrameCallback:
        return FrameCallback("turning", server, is_alive, ServerProfile(purpose=purpose))

    message = FrameServers(
        callbacks=[
            callback("/slow", True, ServerProfile.ACTS),
            callback("/dead", False, ServerProfile.ACTS),
            callback("/watch", True, ServerProfile.WATCHES),
        ]
    )
    assert registered_in(message) == {("turning", "slow")}
