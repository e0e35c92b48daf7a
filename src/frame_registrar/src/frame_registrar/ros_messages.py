"""Converts between messages and the values of the core."""

import copy
from typing import Dict, Iterable, List, Optional, Sequence, Tuple

from roboframenet_msgs.msg import (
    Clause,
    EmptyFrameElement,
    EmptySemanticFrame,
    FileProblem,
    FilledSemanticFrameList,
    FilledSemanticFrameListList,
    LexicalUnitReading,
    Plan,
    PlanCandidate,
    PlanNode,
)

from checked_files import Problem
from frame_registrar.search import Conditions, Found, Reading
from semantic_frames.frame import SemanticFrame
from typed_arguments import FilledFrame, TypedArgument
from typed_arguments.ros_messages import SharedArguments, frame_to_message, from_message


def to_clauses(clauses: Iterable[Clause]) -> List[List[Reading]]:
    """Return the clauses of a command as values."""
    return [[_to_reading(reading) for reading in clause.readings] for clause in clauses]


def _to_reading(message: LexicalUnitReading) -> Reading:
    """Raises ValueError if a typed argument is malformed."""
    typed = {argument.name: from_message(argument) for argument in message.arguments}
    return Reading(
        frame_name=message.lexical_unit.frame_name,
        arguments=tuple(
            typed.get(element.name) or TypedArgument(name=element.name, text=element.argument)
            for element in message.lexical_unit.frame_elements
        ),
        coverage=message.coverage,
        preference=message.preference,
    )


#: Nodes that are clauses, and have candidates.
_LEAVES = (PlanNode.DO, PlanNode.CONDITION)


def conditions_in(plan: Plan, clauses: Sequence[Clause]) -> Dict[int, str]:
    """Return the positions of the clauses that a plan watches, with their words."""
    leaves = [node for node in plan.nodes if node.kind in _LEAVES]
    return {
        position: clause.words
        for position, (leaf, clause) in enumerate(zip(leaves, clauses))
        if leaf.kind == PlanNode.CONDITION
    }


def to_plan(clauses: Sequence[Clause], text: str, found: Sequence[Found], joined: Optional[Plan] = None) -> Plan:
    """Return the plan of a command.

    Args:
        clauses: of the command
        text: of the whole command
        found: what was found for each clause
        joined: how the clauses are joined; None or without nodes if they are done one after the other
    Raises:
        ValueError: the plan that joins them has another number of clauses
    """
    words = [clause.words or text for clause in clauses]
    if joined is not None and joined.nodes:
        nodes = [copy.copy(node) for node in joined.nodes]
        places = [place for place, node in enumerate(nodes) if node.kind in _LEAVES]
        if len(places) != len(found):
            raise ValueError(f"the plan joins {len(places)} clauses, and the command has {len(found)}")
        for place, label, of_clause in zip(places, words, found):
            _fill(nodes, place, label, of_clause)
        return Plan(nodes=nodes, beginning=joined.beginning)
    nodes = [PlanNode(kind=PlanNode.DO) for _ in found]
    for place, (label, of_clause) in enumerate(zip(words, found)):
        _fill(nodes, place, label, of_clause)
    beginning = Plan.REPLACE if joined is None else joined.beginning
    if len(nodes) == 1:
        return Plan(nodes=nodes, beginning=beginning)
    root = PlanNode(kind=PlanNode.SEQUENCE, label=text, children=list(range(1, len(nodes) + 1)))
    return Plan(nodes=[root, *nodes], beginning=beginning)


def _fill(nodes: List[PlanNode], place: int, label: str, found: Found) -> None:
    """Give a node its candidates, or children if it is a condition with a list; those are added to the nodes."""
    node = nodes[place]
    node.label = label
    if isinstance(found, Conditions):
        node.kind = PlanNode.ALL if found.is_all else PlanNode.ANY
        node.children = []
        for part in found.parts:
            node.children.append(len(nodes))
            nodes.append(PlanNode(kind=PlanNode.CONDITION))
            _fill(nodes, len(nodes) - 1, label, part)
        return
    shared = SharedArguments()
    node.candidates = [
        PlanCandidate(
            frames=[frame_to_message(frame) for frame in candidate.frames],
            coverage=candidate.coverage,
            preference=candidate.preference,
            arguments=shared.positions(candidate.frames),
        )
        for candidate in found
    ]
    node.arguments = shared.messages


def to_frame_lists(sequences: Iterable[Sequence[FilledFrame]]) -> FilledSemanticFrameListList:
    """Return sequences of frames as the 2012 message."""
    return FilledSemanticFrameListList(
        frame_lists=[
            FilledSemanticFrameList(frames=[frame_to_message(frame) for frame in frames]) for frames in sequences
        ]
    )


def to_empty_frame(frame: SemanticFrame) -> EmptySemanticFrame:
    """Return a frame without arguments as the 2012 message."""
    return EmptySemanticFrame(
        name=frame.name,
        frame_elements=[
            EmptyFrameElement(name=element.name, default=element.default, is_core=element.is_core)
            for element in frame.frame_elements
        ],
    )


def to_file_problems(problems: Tuple[Problem, ...]) -> List[FileProblem]:
    """Return problems of files as messages."""
    return [
        FileProblem(
            code=problem.code,
            path=problem.path,
            line=problem.line,
            key=problem.key,
            found=problem.found,
            expected=problem.expected,
            hint=problem.hint,
        )
        for problem in problems
    ]
