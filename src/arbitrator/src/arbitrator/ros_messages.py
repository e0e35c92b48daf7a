"""Converts plans between messages and values."""

from dataclasses import fields
from typing import Sequence

from roboframenet_msgs import msg

from arbitrator.plan import Candidate, Plan, as_procedure
from arbitrator.plan_nodes import CARRIED_OUT, Kind, Node, from_nodes, to_nodes
from typed_arguments import TypedArgument
from typed_arguments.ros_messages import SharedArguments, frame_to_message, frames_from_messages, from_message

#: Fields of a node that this module reads.
_READ = {field.name for field in fields(Node)} | {"arguments"}
_NOTHING_SET = msg.PlanNode()


def plan_from_message(message: msg.Plan) -> Plan:
    """Turn a message into a value.

    Raises:
        ValueError: the nodes are not a tree, a candidate is malformed, or a part of the plan is not supported; the text
            says which, and why
    """
    if message.beginning != msg.Plan.REPLACE:
        raise ValueError(
            f"the plan begins in the way {message.beginning}; nothing carries out other ways than 0 (REPLACE)"
        )
    return from_nodes([_node_from_message(position, node) for position, node in enumerate(message.nodes)])


def _node_from_message(position: int, message: msg.PlanNode) -> Node:
    try:
        shared = tuple(from_message(argument) for argument in message.arguments)
        candidates = tuple(candidate_from_message(candidate, shared) for candidate in message.candidates)
    except ValueError as error:
        raise ValueError(f"node {position} of the plan is wrong: {error}") from error
    unread = [name for name in message.__slots__ if name not in _READ and _is_set(message, name)]
    if message.kind in CARRIED_OUT and unread:
        raise ValueError(
            f"node {position} of the plan sets {', '.join(unread)}; a {Kind(message.kind).name} has no use for it"
        )
    return Node(kind=message.kind, label=message.label, children=tuple(message.children), candidates=candidates)


def _is_set(message: msg.PlanNode, name: str) -> bool:
    value, nothing = getattr(message, name), getattr(_NOTHING_SET, name)
    # rospy delivers an array of numbers as a tuple.
    return bool(value != nothing and not (nothing == [] and len(value) == 0))


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


def plan_to_message(plan: Plan) -> msg.Plan:
    """Turn a value into a message."""
    return msg.Plan(nodes=[_node_to_message(node) for node in to_nodes(plan)])


def _node_to_message(node: Node) -> msg.PlanNode:
    shared = SharedArguments()
    candidates = [candidate_to_message(candidate, shared) for candidate in node.candidates]
    return msg.PlanNode(
        kind=node.kind,
        label=node.label,
        children=list(node.children),
        candidates=candidates,
        arguments=shared.messages,
    )


def candidate_to_message(candidate: Candidate, shared: SharedArguments) -> msg.PlanCandidate:
    """Turn a value into a message, and add its arguments to those of its node."""
    return msg.PlanCandidate(
        frames=[frame_to_message(frame) for frame in candidate.frames],
        coverage=candidate.coverage,
        preference=candidate.preference,
        arguments=shared.positions(candidate.frames),
    )


def procedure_to_message(plan: Plan) -> msg.Procedure:
    """Return the procedure of 2012 of a plan."""
    return msg.Procedure(
        frame_lists=[
            msg.FilledSemanticFrameList(frames=[frame_to_message(frame) for frame in frames])
            for frames in as_procedure(plan)
        ]
    )
