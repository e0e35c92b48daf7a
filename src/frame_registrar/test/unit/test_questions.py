"""A plan is a question when its likeliest readings are; what is less likely is not done in place of an answer."""

from typing import Optional, Tuple

import pytest
from roboframenet_msgs.msg import FilledSemanticFrame, Plan, PlanCandidate, PlanNode

from frame_registrar.ros_candidate_topics import question_of

Candidates = Tuple[Tuple[int, str], ...]


def plan_of(*clauses: Candidates) -> Plan:
    """Return a sequence of clauses, each with the preferences and frames of its candidates."""
    leaves = [
        PlanNode(
            kind=PlanNode.DO,
            candidates=[
                PlanCandidate(frames=[FilledSemanticFrame(name=name)], preference=preference)
                for preference, name in clause
            ],
        )
        for clause in clauses
    ]
    root = PlanNode(kind=PlanNode.SEQUENCE, children=list(range(1, len(leaves) + 1)))
    return Plan(nodes=[root, *leaves])


@pytest.mark.parametrize(
    ("clauses", "expected"),
    [
        ((((0, "being_named"),),), (("being_named",),)),
        ((((0, "being_named"), (1, "being_in_category")),), (("being_named",),)),
        ((((1, "being_in_category"), (0, "being_named")),), (("being_named",),)),
        ((((0, "being_in_category"), (1, "being_named")),), None),
        ((((0, "being_named"), (0, "being_in_category")),), None),
        ((((0, "being_named"),), ((0, "going"),)), None),
        ((((0, "being_named"),), ((0, "question_of_time"),)), (("being_named",), ("question_of_time",))),
        ((), None),
    ],
)
def test_question(clauses: Tuple[Candidates, ...], expected: Optional[Tuple[Tuple[str, ...], ...]]) -> None:
    plan = plan_of(*clauses)
    found = question_of(plan, {"being_named", "question_of_time"}.__contains__)
    assert plan == plan_of(*clauses)
    names = None if found is None else [[one.frames[0].name for one in node.candidates] for node in found.nodes[1:]]
    assert names == (None if expected is None else [list(one) for one in expected])
