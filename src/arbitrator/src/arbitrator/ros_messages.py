"""Converts plans between messages and values."""

from dataclasses import fields
from typing import Iterable, List

from roboframenet_msgs import msg

from arbitrator.plan import Candidate, FilledElement, FilledFrame, Plan, as_procedure
from arbitrator.plan_nodes import CARRIED_OUT, Kind, Node, from_nodes, to_nodes

#: Fields of a node that this module reads. The frames hold the arguments as strings.
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
        candidates = tuple(candidate_from_message(candidate) for candidate in message.candidates)
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


def candidate_from_message(message: msg.PlanCandidate) -> Candidate:
    """Turn a message into a value; raises ValueError for a malformed candidate or frame."""
    return Candidate(
        frames=tuple(frame_from_message(frame) for frame in message.frames),
        coverage=message.coverage,
        preference=message.preference,
    )


def frame_from_message(message: msg.FilledSemanticFrame) -> FilledFrame:
    """Turn a message into a value.

    Raises:
        ValueError: the frame has no name, or does not name exactly one action server
    """
    servers = list(message.action_server_topics)
    if len(servers) != 1:
        raise ValueError(f"frame {message.name!r} must name exactly one action server, got {servers}")
    return FilledFrame(
        name=message.name,
        server=servers[0],
        frame_elements=tuple(FilledElement(element.name, element.argument) for element in message.frame_elements),
    )


def plan_to_message(plan: Plan) -> msg.Plan:
    """Turn a value into a message."""
    return msg.Plan(
        nodes=[
            msg.PlanNode(
                kind=node.kind,
                label=node.label,
                children=list(node.children),
                candidates=[candidate_to_message(candidate) for candidate in node.candidates],
            )
            for node in to_nodes(plan)
        ]
    )


def candidate_to_message(candidate: Candidate) -> msg.PlanCandidate:
    """Turn a value into a message."""
    return msg.PlanCandidate(
        frames=_frames_to_messages(candidate.frames), coverage=candidate.coverage, preference=candidate.preference
    )


def frame_to_message(frame: FilledFrame) -> msg.FilledSemanticFrame:
    """Turn a value into a message."""
    return msg.FilledSemanticFrame(
        name=frame.name,
        action_server_topics=[frame.server],
        frame_elements=[
            msg.FilledFrameElement(name=element.name, argument=element.argument) for element in frame.frame_elements
        ],
    )


def procedure_to_message(plan: Plan) -> msg.Procedure:
    """Return the procedure of 2012 of a plan."""
    return msg.Procedure(
        frame_lists=[msg.FilledSemanticFrameList(frames=_frames_to_messages(frames)) for frames in as_procedure(plan)]
    )


def _frames_to_messages(frames: Iterable[FilledFrame]) -> List[msg.FilledSemanticFrame]:
    return [frame_to_message(frame) for frame in frames]
