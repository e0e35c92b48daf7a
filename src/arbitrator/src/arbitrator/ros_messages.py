"""Converts plans between messages and values."""

from typing import Any, Dict, Optional, Sequence, Union

import rospy
from roboframenet_msgs import msg

from arbitrator.plan import Candidate, Plan
from arbitrator.plan_nodes import Node, any_from_nodes, from_nodes, to_nodes
from arbitrator.procedure import as_procedure
from arbitrator.standing import STANDING, AnyOrder
from typed_arguments import TypedArgument
from typed_arguments.ros_messages import (
    SharedArguments,
    frame_to_message,
    frames_from_messages,
    from_message,
    time_from_message,
    time_to_message,
)

#: Fields of a node that are the same in its message.
_SAME = ("kind", "label", "count", "most", "is_limit_said", "trigger", "is_negated")
#: Fields of a node in seconds, and the durations of its message.
_TIMES = {"duration_s": "duration", "period_s": "period", "limit_s": "limit"}
#: Fields of the message that nothing reads yet.
_UNREAD = ("robot",)
_BEGINNINGS = (msg.Plan.REPLACE, msg.Plan.FOLLOW, msg.Plan.BESIDE, msg.Plan.WHEN_FREE)
_NOTHING_SET = msg.PlanNode()


def plan_from_message(message: msg.Plan) -> Plan:
    """Turn a message into a value.

    Raises:
        ValueError: the nodes are not a tree, a candidate is malformed, or a part of the plan is not supported; the text
            says which, and why
    """
    return from_nodes(_nodes_from_message(message))


def any_from_message(message: msg.Plan) -> Union[Plan, AnyOrder]:
    """Turn a message into a plan, or into a standing order.

    Raises:
        ValueError: as :func:`plan_from_message`
    """
    return any_from_nodes(_nodes_from_message(message))


def _nodes_from_message(message: msg.Plan) -> Sequence[Node]:
    if message.beginning not in _BEGINNINGS:
        raise ValueError(f"the plan begins in the way {message.beginning}, and there is no such way")
    return [_node_from_message(position, node) for position, node in enumerate(message.nodes)]


def _node_from_message(position: int, message: msg.PlanNode) -> Node:
    try:
        shared = tuple(from_message(argument) for argument in message.arguments)
        candidates = tuple(candidate_from_message(candidate, shared) for candidate in message.candidates)
    except ValueError as error:
        raise ValueError(f"node {position} of the plan is wrong: {error}") from error
    unread = [name for name in _UNREAD if getattr(message, name) != getattr(_NOTHING_SET, name)]
    if unread:
        raise ValueError(f"node {position} of the plan sets {', '.join(unread)}; nothing reads that yet")
    return Node(
        children=tuple(message.children),
        candidates=candidates,
        after=tuple(message.after),
        when=time_from_message(message.when) if message.when.kind else None,
        **{name: getattr(message, name) for name in _SAME},
        **{name: getattr(message, of_message).to_sec() for name, of_message in _TIMES.items()},
    )


def candidate_from_message(message: msg.PlanCandidate, shared: Sequence[TypedArgument] = ()) -> Candidate:
    """Turn a message into a value.

    Args:
        message: of a node
        shared: typed arguments of the node
    Raises:
        ValueError: a malformed candidate or frame
    """
    return Candidate(
        frames=frames_from_messages(message.frames, shared, message.arguments),
        coverage=message.coverage,
        preference=message.preference,
    )


def plan_to_message(plan: Union[Plan, AnyOrder]) -> msg.Plan:
    """Turn a value into a message."""
    return msg.Plan(nodes=[_node_to_message(node) for node in to_nodes(plan)])


def _node_to_message(node: Node) -> msg.PlanNode:
    shared = SharedArguments()
    candidates = [candidate_to_message(candidate, shared) for candidate in node.candidates]
    same: Dict[str, Any] = {name: getattr(node, name) for name in _SAME}
    if node.when is not None:
        same["when"] = time_to_message(node.when)
    return msg.PlanNode(
        children=list(node.children),
        candidates=candidates,
        arguments=shared.messages,
        after=list(node.after),
        **same,
        **{of_message: rospy.Duration.from_sec(getattr(node, name)) for name, of_message in _TIMES.items()},
    )


def candidate_to_message(candidate: Candidate, shared: SharedArguments) -> msg.PlanCandidate:
    """Turn a value into a message, and add its arguments to those of its node."""
    return msg.PlanCandidate(
        frames=[frame_to_message(frame) for frame in candidate.frames],
        coverage=candidate.coverage,
        preference=candidate.preference,
        arguments=shared.positions(candidate.frames),
    )


def procedure_to_message(plan: Union[Plan, AnyOrder]) -> Optional[msg.Procedure]:
    """Return the procedure of 2012 of a plan; None for what it cannot say."""
    if isinstance(plan, STANDING):
        return None
    sequences = as_procedure(plan)
    if sequences is None:
        return None
    return msg.Procedure(
        frame_lists=[
            msg.FilledSemanticFrameList(frames=[frame_to_message(frame) for frame in frames]) for frames in sequences
        ]
    )
