"""Converts between messages and the values of the core."""

from typing import Iterable, List, Sequence, Tuple

from roboframenet_msgs.msg import (
    Clause,
    EmptyFrameElement,
    EmptySemanticFrame,
    FileProblem,
    FileProblems,
    FilledFrameElement,
    FilledSemanticFrame,
    FilledSemanticFrameList,
    FilledSemanticFrameListList,
    Plan,
    PlanCandidate,
    PlanNode,
)

from frame_registrar.filling import FilledFrame
from frame_registrar.search import Argument, Candidate, Reading
from semantic_frames import Problem
from semantic_frames.frame import SemanticFrame


def to_clauses(clauses: Iterable[Clause]) -> List[List[Reading]]:
    """Return the clauses of a command as values."""
    return [[_to_reading(reading) for reading in clause.readings] for clause in clauses]


def _to_reading(message: object) -> Reading:
    values = {value.name: value for value in message.values}
    arguments = []
    for element in message.lexical_unit.frame_elements:
        value = values.get(element.name)
        arguments.append(
            Argument(
                name=element.name,
                text=element.argument,
                items=tuple(value.items) if value else (),
                conjunction=value.conjunction if value else "",
            )
        )
    return Reading(
        frame_name=message.lexical_unit.frame_name,
        arguments=tuple(arguments),
        coverage=message.coverage,
        preference=message.preference,
    )


def to_plan(clauses: Sequence[Clause], text: str, found: Sequence[Sequence[Candidate]]) -> Plan:
    """Return the plan of a command.

    Args:
        clauses: of the command
        text: of the whole command
        found: candidates of each clause
    """
    leaves = [
        PlanNode(
            kind=PlanNode.DO,
            label=clause.words or text,
            candidates=[
                PlanCandidate(
                    frames=_to_frames(candidate.frames),
                    coverage=candidate.coverage,
                    preference=candidate.preference,
                )
                for candidate in candidates
            ],
        )
        for clause, candidates in zip(clauses, found)
    ]
    if len(leaves) == 1:
        return Plan(nodes=leaves)
    root = PlanNode(kind=PlanNode.SEQUENCE, label=text, children=list(range(1, len(leaves) + 1)))
    return Plan(nodes=[root] + leaves)


def to_frame_lists(sequences: Iterable[Sequence[FilledFrame]]) -> FilledSemanticFrameListList:
    """Return sequences of frames as the 2012 message."""
    return FilledSemanticFrameListList(
        frame_lists=[FilledSemanticFrameList(frames=_to_frames(frames)) for frames in sequences]
    )


def _to_frames(frames: Iterable[FilledFrame]) -> List[FilledSemanticFrame]:
    return [
        FilledSemanticFrame(
            name=frame.name,
            frame_elements=[FilledFrameElement(name=name, argument=argument) for name, argument in frame.arguments],
            action_server_topics=[frame.server],
        )
        for frame in frames
    ]


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
