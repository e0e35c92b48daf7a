"""Procedures between messages and values."""
from typing import List

from roboframenet_msgs import msg

from arbitrator.policy import Candidate
from arbitrator.procedure import FilledElement, FilledFrame, Procedure, Sequence


def frame_from_message(message: msg.FilledSemanticFrame) -> FilledFrame:
    """Turn a message into a value.

    Raises:
        ValueError: the frame has no name, or does not name exactly one action server
    """
    servers = list(message.action_server_topics)
    if len(servers) != 1:
        raise ValueError(f"frame {message.name!r} must name exactly one action server, got {servers}")
    return FilledFrame(
        name=message.name, server=servers[0],
        frame_elements=tuple(FilledElement(element.name, element.argument) for element in message.frame_elements))


def sequence_from_message(message: msg.FilledSemanticFrameList) -> Sequence:
    """Turn a message into a value; raises ValueError like `frame_from_message` and for an empty sequence."""
    return Sequence(frames=tuple(frame_from_message(frame) for frame in message.frames))


def procedure_from_message(message: msg.Procedure) -> Procedure:
    """Turn a message into a value; raises ValueError like `sequence_from_message` and for an empty procedure."""
    return Procedure(sequences=tuple(sequence_from_message(entry) for entry in message.frame_lists))


def candidates_from_message(message: msg.CommandSemanticFrames) -> List[Candidate]:
    """Turn the registrar's message into candidates.

    Raises:
        ValueError: as many coverages and preferences as candidates are expected; or a candidate is malformed
    """
    frame_lists = message.candidates.frame_lists
    if not len(frame_lists) == len(message.coverage) == len(message.preference):
        raise ValueError(f"{len(frame_lists)} candidates with {len(message.coverage)} coverages and "
                         f"{len(message.preference)} preferences")
    return [Candidate(sequence=sequence_from_message(frames), coverage=coverage, preference=preference)
            for frames, coverage, preference in zip(frame_lists, message.coverage, message.preference)]


def frame_to_message(frame: FilledFrame) -> msg.FilledSemanticFrame:
    """Turn a value into a message."""
    return msg.FilledSemanticFrame(
        name=frame.name, action_server_topics=[frame.server],
        frame_elements=[msg.FilledFrameElement(name=element.name, argument=element.argument)
                        for element in frame.frame_elements])


def procedure_to_message(procedure: Procedure) -> msg.Procedure:
    """Turn a value into a message."""
    return msg.Procedure(frame_lists=[
        msg.FilledSemanticFrameList(frames=[frame_to_message(frame) for frame in sequence.frames])
        for sequence in procedure.sequences])
