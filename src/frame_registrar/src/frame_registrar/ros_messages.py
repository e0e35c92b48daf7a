"""Converts between messages and the values of the core."""

from typing import Iterable, List, Optional, Sequence, Tuple

from roboframenet_msgs.msg import (
    Clause,
    EmptyFrameElement,
    EmptySemanticFrame,
    FileProblem,
    FileProblems,
    FilledSemanticFrameList,
    FilledSemanticFrameListList,
    LexicalUnitReading,
    Plan,
    PlanCandidate,
    PlanNode,
)

from frame_registrar.search import Candidate, Reading
from semantic_frames import Problem
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


def to_plan(
    clauses: Sequence[Clause], text: str, found: Sequence[Sequence[Candidate]], joined: Optional[Plan] = None
) -> Plan:
    """Return the plan of a command.

    Args:
        clauses: of the command
        text: of the whole command
        found: candidates of each clause
        joined: how the clauses are joined; None or without nodes if they are done one after the other
    Raises:
        ValueError: the plan that joins them has another number of clauses
    """
    leaves = [_to_leaf(clause.words or text, candidates) for clause, candidates in zip(clauses, found)]
    if joined is not None and joined.nodes:
        places = [place for place, node in enumerate(joined.nodes) if node.kind == PlanNode.DO]
        if len(places) != len(leaves):
            raise ValueError(f"the plan joins {len(places)} clauses, and the command has {len(leaves)}")
        nodes = list(joined.nodes)
        for place, leaf in zip(places, leaves):
            nodes[place] = leaf
        return Plan(nodes=nodes, beginning=joined.beginning)
    if len(leaves) == 1:
        return Plan(nodes=leaves)
    root = PlanNode(kind=PlanNode.SEQUENCE, label=text, children=list(range(1, len(leaves) + 1)))
    return Plan(nodes=[root] + leaves)


def _to_leaf(label: str, candidates: Sequence[Candidate]) -> PlanNode:
    shared = SharedArguments()
    return PlanNode(
        kind=PlanNode.DO,
        label=label,
        candidates=[
            PlanCandidate(
                frames=[frame_to_message(frame) for frame in candidate.frames],
                coverage=candidate.coverage,
                preference=candidate.preference,
                arguments=shared.positions(candidate.frames),
            )
            for candidate in candidates
        ],
        arguments=shared.messages,
    )


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


def to_file_problems(problems: Tuple[Problem, ...]) -> FileProblems:
    """Return problems of files as a message."""
    return FileProblems(
        problems=[
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
    )
