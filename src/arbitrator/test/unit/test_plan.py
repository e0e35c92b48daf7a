"""Plans: as values, as the nodes that travel, as the procedure of 2012."""

import io

import pytest
import rospy
from roboframenet_msgs import msg

from arbitrator.plan import (
    MOST_COMBINATIONS,
    Candidate,
    Do,
    InSequence,
    as_procedure,
    describe,
)
from arbitrator.plan_nodes import MOST_FRAMES, MOST_LEVELS, MOST_NODES, Kind, Node, from_nodes, to_nodes
from arbitrator.ros_messages import plan_from_message, plan_to_message, procedure_to_message
from typed_arguments import FilledFrame, TypedArgument


def frame(name, server="server"):
    theme = TypedArgument("theme", "the mug", head="mug", relation="under", quantifier="the")
    goal = TypedArgument("goal", "the hall")
    return FilledFrame(name=name, arguments=(theme, goal), server=server)


def way(*names, preference=0):
    return Candidate(frames=tuple(frame(name) for name in names), coverage=0.75, preference=preference)


PING = Do("Ping", (way("pinging"),))
WAVE = Do("wave at Alice", (way("waving"), way("bowing", "waving", preference=1)))
TURN = Do("turn left", (way("turning"),))
PLANS = [PING, InSequence("Ping and wave", (PING, WAVE)), InSequence("a", (InSequence("b", (PING, WAVE)), TURN, PING))]
SEQUENCE, DO = Kind.SEQUENCE, Kind.DO


@pytest.mark.parametrize("plan", PLANS)
def test_plan_travels_there_and_back(plan):
    assert from_nodes(to_nodes(plan)) == plan
    assert plan_from_message(plan_to_message(plan)) == plan
    buffer = io.BytesIO()
    plan_to_message(plan).serialize(buffer)
    assert plan_from_message(msg.Plan().deserialize(buffer.getvalue())) == plan


def test_kinds_are_those_of_the_message():
    assert {kind.name: kind.value for kind in Kind} == {
        name: value
        for name, value in vars(msg.PlanNode).items()
        if name.isupper() and isinstance(value, int) and name not in ("HOLDS", "BEGINS")
    }


def do(**changes):
    return Node(**{"kind": DO, "label": "x", "candidates": (way("turning"),), **changes})


def join(*children, **changes):
    return Node(**{"kind": SEQUENCE, "label": "x", "children": children, **changes})


@pytest.mark.parametrize(
    "nodes,part",
    [
        ([], "no nodes"),
        ([do()] * (MOST_NODES + 1), f"may have {MOST_NODES}"),
        ([do(candidates=(way("turning"),) * (MOST_FRAMES + 1))], f"may have {MOST_FRAMES}"),
        ([join(1)], "no such node"),
        ([join(-1)], "no such node"),
        ([join(1), join(2**30)], "no such node"),
        ([join(0)], "the root for a child"),
        ([join(1), join(0)], "the root for a child"),
        ([join(1, 1), do()], "node 1 of the plan has two parents: 0 and 0"),
        ([join(1, 2), join(2), do()], "node 2 of the plan has two parents"),
        ([do(), join(1)], "nodes 1 of the plan are not reached from its root"),
        ([join(1), do(), join(3), join(2)], "nodes 2, 3 of the plan are not reached from its root"),
        ([do(), do()], "are not reached from its root"),
        ([join()], "node 0 of the plan is wrong: a sequence has no children"),
        ([join(1), do(candidates=())], "node 1 of the plan is wrong: a clause has no candidates"),
        ([join(1), do(children=(2,)), do()], "node 1 of the plan carries out a clause, and cannot have children"),
        ([join(1, candidates=(way("turning"),)), do()], "node 0 of the plan joins clauses, and cannot have candidates"),
        ([do(kind=0)], "is of the kind 0; nothing carries out other kinds than 1 (DO), 2 (SEQUENCE)"),
        ([join(1, kind=77), do()], "is of the kind 77; nothing"),
        *[
            (
                [join(1), join(2, kind=kind), do()],
                f"node 1 of the plan is of the kind {kind.value} ({kind.name}); nothing",
            )
            for kind in Kind
            if kind not in (DO, SEQUENCE)
        ],
        ([join(index + 1) for index in range(MOST_LEVELS)] + [do()], f"more than {MOST_LEVELS} levels"),
        ([join(index + 1) for index in range(MOST_NODES - 1)] + [do()], f"more than {MOST_LEVELS} levels"),
    ],
)
def test_what_is_no_tree_is_refused_with_the_reason(nodes, part):
    with pytest.raises(ValueError) as raised:
        from_nodes(nodes)
    assert part in str(raised.value)


def test_deepest_plan_that_is_allowed():
    nodes = [join(index + 1) for index in range(MOST_LEVELS - 1)] + [do()]
    assert to_nodes(from_nodes(nodes)) == tuple(nodes)


def message_of(candidate):
    return msg.Plan(nodes=[msg.PlanNode(kind=DO, label="x", candidates=[candidate])])


@pytest.mark.parametrize(
    "message,part",
    [
        (msg.Plan(), "no nodes"),
        (msg.Plan(nodes=[msg.PlanNode()]), "kind 0"),
        (message_of(msg.PlanCandidate()), "node 0 of the plan is wrong: a candidate has no frames"),
        (message_of(msg.PlanCandidate(frames=[msg.FilledSemanticFrame(name="a")])), "exactly one action server"),
        (
            message_of(msg.PlanCandidate(frames=[msg.FilledSemanticFrame(name="a", action_server_topics=["b", "c"])])),
            "exactly one action server",
        ),
        (message_of(msg.PlanCandidate(frames=[msg.FilledSemanticFrame(action_server_topics=["b"])])), "no name"),
        (
            message_of(
                msg.PlanCandidate(
                    frames=[msg.FilledSemanticFrame(name="a", action_server_topics=["b"])], coverage=float("nan")
                )
            ),
            "coverage",
        ),
        (
            message_of(
                msg.PlanCandidate(frames=[msg.FilledSemanticFrame(name="a", action_server_topics=["b"])], preference=-1)
            ),
            "preference",
        ),
    ],
)
def test_malformed_message_is_refused_with_the_reason(message, part):
    with pytest.raises(ValueError) as raised:
        plan_from_message(message)
    assert part in str(raised.value)


UNREAD = [
    ("after", [1]),
    ("count", 2),
    ("most", 3),
    ("duration", rospy.Duration(1)),
    ("period", rospy.Duration(1)),
    ("limit", rospy.Duration(60)),
    ("is_limit_said", True),
    ("when", msg.TimeExpression(kind="time", value="T08:00")),
    ("trigger", msg.PlanNode.BEGINS),
    ("is_negated", True),
    ("robot", "beta"),
]


def test_each_field_of_a_node_is_read_or_refused():
    read = {"kind", "label", "children", "candidates", "arguments"}
    assert set(msg.PlanNode.__slots__) == read | {name for name, _ in UNREAD}


@pytest.mark.parametrize("name,value", UNREAD)
def test_what_a_kind_has_no_use_for_is_refused_and_not_ignored(name, value):
    message = plan_to_message(InSequence("Ping and turn", (PING, TURN)))
    setattr(message.nodes[1], name, value)
    with pytest.raises(ValueError) as raised:
        plan_from_message(message)
    assert f"node 1 of the plan sets {name}; a DO has no use for it" in str(raised.value)


@pytest.mark.parametrize("beginning", [msg.Plan.FOLLOW, msg.Plan.BESIDE])
def test_plan_that_does_not_replace_what_runs_is_refused(beginning):
    message = plan_to_message(PING)
    message.beginning = beginning
    with pytest.raises(ValueError) as raised:
        plan_from_message(message)
    assert "REPLACE" in str(raised.value)


def test_empty_values_are_refused():
    for make in (
        lambda: Candidate(frames=()),
        lambda: Do("x", ()),
        lambda: InSequence("x", ()),
        lambda: Candidate(frames=(FilledFrame(name="", server="s"),)),
        lambda: Candidate(frames=(FilledFrame(name="f"),)),
    ):
        with pytest.raises(ValueError):
            make()


def test_procedure_of_2012_holds_the_frames_of_all_clauses():
    plan = InSequence("all", (PING, WAVE, TURN))
    assert [[frame.name for frame in frames] for frames in as_procedure(plan)] == [
        ["pinging", "waving", "turning"],
        ["pinging", "bowing", "waving", "turning"],
    ]
    assert procedure_to_message(PING).frame_lists[0].frames[0].action_server_topics == ["server"]


def test_procedure_of_2012_is_bounded_where_clauses_multiply():
    many = Do("many", tuple(way(f"frame{index}") for index in range(200)))
    assert len(as_procedure(many)) == 200
    assert len(as_procedure(InSequence("all", (many,) * 20))) == MOST_COMBINATIONS


@pytest.mark.parametrize(
    "plan,sentence",
    [
        (PING, "1 candidate, pinging by server."),
        (WAVE, "2 candidates, first waving by server."),
        (
            InSequence("x", (PING, WAVE)),
            '"Ping": 1 candidate, pinging by server; then "wave at Alice": 2 candidates, first waving by server.',
        ),
    ],
)
def test_plan_in_words(plan, sentence):
    assert describe(plan) == sentence


def test_candidates_share_the_typed_arguments_of_a_node():
    (node,) = plan_to_message(Do("bow and wave", (way("bowing", "waving"), way("waving")))).nodes
    assert len(node.arguments) == 1  # the same theme three times; a goal that has only its text travels as a string
    assert [list(candidate.arguments) for candidate in node.candidates] == [[0, -1, 0, -1], [0, -1]]


@pytest.mark.parametrize(
    "positions, reason",
    [([0], "1 positions"), ([1, -1], "argument 1 of 1"), ([-2, -1], "argument -2 of 1"), ([-1, 0], "'the hall'")],
)
def test_positions_of_arguments_that_do_not_fit_are_refused(positions, reason):
    message = plan_to_message(PING)
    message.nodes[0].candidates[0].arguments = positions
    with pytest.raises(ValueError, match=reason):
        plan_from_message(message)
