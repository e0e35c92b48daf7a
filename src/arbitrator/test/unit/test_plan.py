"""Plans: as values, as the nodes that travel, as the procedure of 2012."""

import io

import pytest
import rospy
from roboframenet_msgs import msg

from arbitrator.plan import (
    AllOf,
    AnyOf,
    Candidate,
    Condition,
    Do,
    Fallback,
    If,
    InAnyOrder,
    InParallel,
    InSequence,
    Limit,
    Repeat,
    Trigger,
    Until,
    Wait,
    While,
    walk,
)
from arbitrator.plan_nodes import MOST_FRAMES, MOST_LEVELS, MOST_NODES, Kind, Node, any_from_nodes, from_nodes, to_nodes
from arbitrator.procedure import MOST_COMBINATIONS, as_procedure, describe
from arbitrator.ros_messages import any_from_message, plan_from_message, plan_to_message, procedure_to_message
from arbitrator.standing import At, Whenever
from typed_arguments import FilledFrame, TimeExpression, TypedArgument


def frame(name, server="server"):
    theme = TypedArgument("theme", "the mug", head="mug", relation="under", quantifier="the")
    goal = TypedArgument("goal", "the hall")
    return FilledFrame(name=name, arguments=(theme, goal), server=server)


def way(*names, preference=0):
    return Candidate(frames=tuple(frame(name) for name in names), coverage=0.75, preference=preference)


PING = Do("Ping", (way("pinging"),))
WAVE = Do("wave at Alice", (way("waving"), way("bowing", "waving", preference=1)))
TURN = Do("turn left", (way("turning"),))
SEES = Condition("you see a wall", (way("perceiving"),), Trigger.BEGINS)
CLOSED = Condition("the door is closed", (way("being_in_state"), way("perceiving")), is_negated=True)
BOTH = AllOf("both", (CLOSED, AnyOf("one", (CLOSED, CLOSED), is_negated=True)), Trigger.BEGINS, is_negated=True)
EIGHT = TimeExpression("time", "at eight", "at", "T08:00/T20:00", time_zone="Europe/Berlin")
DAILY = TimeExpression("set", "every day at seven", "every", "T07:00", offset_s=60.0, period_s=86400.0)
ORDERS = [
    At("wave at Alice at eight", WAVE, EIGHT),
    At("x", InSequence("b", (PING, WAVE)), DAILY),
    Whenever("whenever x", BOTH, WAVE),
]
PLANS = [
    PING,
    InSequence("Ping and wave", (PING, WAVE)),
    InSequence("a", (InSequence("b", (PING, WAVE)), TURN, PING)),
    Do("Ping", (way("pinging"),), Limit(3600.0, is_said=True)),
    Fallback("x", (PING, WAVE), Limit(1.5)),
    InParallel("x", (PING, WAVE), 1, Limit(1.5)),
    InAnyOrder("x", (PING, WAVE, TURN), ((), (0, 2), ())),
    InAnyOrder("x", (PING, WAVE)),
    If("x", CLOSED, PING),
    If("x", CLOSED, PING, InSequence("b", (PING, WAVE)), Limit(2.0)),
    Until("x", PING, SEES),
    Until("x", PING, duration_s=600.0),
    Until("x", PING, BOTH, limit=Limit(60.0)),
    While("x", CLOSED, PING),
    Repeat("x", PING, 3, 3),
    Repeat("x", Repeat("y", WAVE, 0, 0, 600.0), 2, 0),
    Wait("x", SEES, limit=Limit(3600.0, is_said=True)),
    Wait("x", duration_s=2.5),
]
SEQUENCE, DO, CONDITION = Kind.SEQUENCE, Kind.DO, Kind.CONDITION


@pytest.mark.parametrize(
    "make,part",
    [
        (lambda: InSequence("x", (PING, CLOSED)), "a sequence has the condition 'the door is closed' in the place of"),
        (lambda: If("x", PING, PING), "an if has a clause in the place of a condition"),
        (lambda: If("x", SEES, PING), "asks whether 'you see a wall' holds, and not when it begins to"),
        (lambda: While("x", SEES, PING), "asks whether 'you see a wall' holds, and not when it begins to"),
        (lambda: AllOf("x", (SEES,)), "asks whether 'you see a wall' holds, and not when it begins to"),
        (lambda: If("x", CLOSED, CLOSED), "an if has the condition"),
        (lambda: If("x", CLOSED, PING, CLOSED), "an if has the condition"),
        (lambda: AnyOf("x", ()), "an any has no children"),
        (lambda: AnyOf("x", (PING,)), "an any has a clause in the place of a condition"),
        (lambda: Condition("x", ()), "a condition has no candidates"),
        (lambda: Condition("x", (way("a", "b"),)), "a candidate of it has several"),
        (lambda: Until("x", PING), "an until ends with a condition or after a time: it needs one of both"),
        (lambda: Until("x", PING, SEES, 3.0), "it needs one of both"),
        (lambda: Until("x", PING, PING), "an until has a clause in the place of a condition"),
        (lambda: Wait("x"), "a wait ends with a condition or after a time: it needs one of both"),
        (lambda: Wait("x", duration_s=-1.0), "finite and 0 s or more, got -1 s"),
        (lambda: Wait("x", duration_s=float("nan")), "finite"),
        (lambda: Repeat("x", PING, 3, 2), "3 to 2 is no number of times"),
        (lambda: Repeat("x", PING, -1), "-1 to 0 is no number of times"),
        (lambda: Repeat("x", PING, 1, 1, float("inf")), "finite"),
        (lambda: Repeat("x", CLOSED), "a repetition has the condition"),
        (lambda: InParallel("x", (PING, WAVE), 3), "3 of 2 children cannot succeed"),
        (lambda: InAnyOrder("x", (PING, WAVE), ((1,), (0,))), "no order fits"),
        (lambda: InAnyOrder("x", (PING, WAVE), ((),)), "1 orders for 2 children"),
        (lambda: Limit(-1.0), "finite and 0 s or more"),
    ],
)
def test_what_means_nothing_is_refused(make, part):
    with pytest.raises(ValueError) as raised:
        make()
    assert part in str(raised.value)


def test_order_is_that_of_the_words_where_it_fits():
    assert InAnyOrder("x", (PING, WAVE, TURN)).order() == (0, 1, 2)
    assert InAnyOrder("x", (PING, WAVE, TURN), ((2,), (), ())).order() == (1, 2, 0)


def test_parts_are_counted_as_they_are_sent():
    for plan in PLANS:
        assert [part.label for part in walk(plan)] == [node.label for node in to_nodes(plan)]


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
        ([do(kind=0)], "is of the kind 0; nothing carries out other kinds than 1 (DO), 2 (SEQUENCE), 3 (PARALLEL)"),
        ([join(1, kind=77), do()], "is of the kind 77; nothing"),
        (
            [join(1), join(2, kind=Kind.AT, when=EIGHT), do()],
            "node 1 of the plan is of the kind AT; a standing order is",
        ),
        (
            [join(1), join(2, 3, kind=Kind.WHENEVER), do(kind=CONDITION), do()],
            "node 1 of the plan is of the kind WHENEV",
        ),
        (
            [join(1, kind=Kind.AT, when=EIGHT), do()],
            "node 0 of the plan is a standing order (AT): nothing is to be",
        ),
        ([join(1, kind=Kind.AT), do()], "node 0 of the plan is wrong: an AT has no time"),
        ([join(1, kind=Kind.AT, when=EIGHT), do(kind=CONDITION)], "a standing order has the condition 'x'"),
        ([join(1, 2, kind=Kind.WHENEVER), do(), do()], "a whenever has something to do in the place of its condition"),
        ([join(1, when=EIGHT), do()], "node 0 of the plan sets when; a SEQUENCE has no use for it"),
        ([join(1, kind=Kind.IF), do()], "node 0 of the plan has 1 children; a IF has 2 to 3"),
        ([join(1, 2, kind=Kind.IF), do(), do()], "node 0 of the plan is wrong: an if has a clause in the place of"),
        ([join(1, 2, kind=Kind.REPEAT), do(), do()], "node 0 of the plan has 2 children; a REPEAT has 1 to 1"),
        ([join(1), do(kind=CONDITION)], "node 0 of the plan is wrong: a sequence has the condition 'x'"),
        ([do(kind=CONDITION)], "node 0 of the plan is a condition, and nothing is to be done"),
        ([do(kind=CONDITION, trigger=7)], "node 0 of the plan is wrong: 7 is not a valid Trigger"),
        ([join(1), do(after=(0,))], "node 1 of the plan sets after; only a child of an ANY_ORDER has a use for it"),
        ([do(after=(0,))], "node 0 of the plan sets after"),
        ([join(1, 2, kind=Kind.ANY_ORDER), do(after=(1,)), do()], "node 1 is to come after node 1, which is none of"),
        ([join(1, 2, kind=Kind.ANY_ORDER), do(after=(9,)), do()], "node 1 is to come after node 9, which is none of"),
        ([join(1, 2, kind=Kind.ANY_ORDER), do(after=(2,)), do(after=(1,))], "node 0 of the plan is wrong: no order"),
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


def test_field_that_nothing_reads_is_refused_and_not_ignored():
    message = plan_to_message(PING)
    message.nodes[0].robot = "beta"
    with pytest.raises(ValueError, match="node 0 of the plan sets robot; nothing reads that yet"):
        plan_from_message(message)


@pytest.mark.parametrize(
    "name,value",
    [
        ("count", 2),
        ("most", 3),
        ("duration", rospy.Duration(1)),
        ("period", rospy.Duration(1)),
        ("trigger", msg.PlanNode.BEGINS),
        ("is_negated", True),
    ],
)
def test_what_a_kind_has_no_use_for_is_refused_and_not_ignored(name, value):
    message = plan_to_message(InSequence("Ping and turn", (PING, TURN)))
    setattr(message.nodes[1], name, value)
    with pytest.raises(ValueError) as raised:
        plan_from_message(message)
    assert f"node 1 of the plan sets {name}; a DO has no use for it" in str(raised.value)


def test_plan_that_begins_in_an_unknown_way_is_refused():
    message = plan_to_message(PING)
    message.beginning = 77
    with pytest.raises(ValueError, match="begins in the way 77"):
        plan_from_message(message)


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


@pytest.mark.parametrize("plan", [plan for plan in PLANS if not isinstance(plan, (Do, InSequence))])
def test_procedure_of_2012_says_nothing_else(plan):
    assert as_procedure(plan) is None and procedure_to_message(InSequence("x", (PING, plan))) is None


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


@pytest.mark.parametrize("order", ORDERS, ids=str)
def test_standing_order_goes_through_its_message_and_is_no_plan(order):
    assert any_from_nodes(to_nodes(order)) == order
    buffer = io.BytesIO()
    plan_to_message(order).serialize(buffer)
    message = msg.Plan().deserialize(buffer.getvalue())
    assert any_from_message(message) == order
    assert procedure_to_message(order) is None
    assert describe(order).startswith("A standing order: ")
    with pytest.raises(ValueError, match="standing order"):
        plan_from_message(message)
