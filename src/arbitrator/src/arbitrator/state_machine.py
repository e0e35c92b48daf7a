"""The SMACH state machine that a procedure means."""
from typing import Callable

import smach

from arbitrator.procedure import FilledFrame, Procedure, Sequence

OUTCOMES = ("succeeded", "aborted", "preempted")


def candidate_label(index: int) -> str:
    """Label of a sequence in the machine; `index` counts from 0."""
    return f"candidate_{index + 1}"


def step_label(index: int, frame: FilledFrame) -> str:
    """Label of a frame in the machine of its sequence; `index` counts from 0.

    Slashes would read as levels of the machine in the paths that SMACH publishes.
    """
    return f"{index + 1}_{frame.name}_by_{frame.server.strip('/').replace('/', '.')}"


def _build_sequence(sequence: Sequence, make_step: Callable[[FilledFrame], smach.State]) -> smach.StateMachine:
    machine = smach.StateMachine(outcomes=list(OUTCOMES))
    labels = [step_label(index, frame) for index, frame in enumerate(sequence.frames)]
    followers = labels[1:] + ["succeeded"]
    with machine:
        for label, follower, frame in zip(labels, followers, sequence.frames):
            smach.StateMachine.add(
                label, make_step(frame),
                transitions={"succeeded": follower, "aborted": "aborted", "preempted": "preempted"})
    return machine


def build_state_machine(procedure: Procedure, make_step: Callable[[FilledFrame], smach.State]) -> smach.StateMachine:
    """Build the machine of a procedure: one sub-machine for each sequence.

    A frame that fails ends its sequence; the next sequence starts from its first frame. The first sequence whose
    frames all succeed ends the machine. A preempted frame ends everything.

    Args:
        procedure: what to carry out
        make_step: makes the state of one frame, with the outcomes succeeded, aborted and preempted

    Returns:
        a machine with the outcomes succeeded, aborted and preempted

    SMACH keeps a stack of open machines for its class: build in one thread at a time.
    """
    machine = smach.StateMachine(outcomes=list(OUTCOMES))
    labels = [candidate_label(index) for index in range(len(procedure.sequences))]
    followers = labels[1:] + ["aborted"]
    subs = [_build_sequence(sequence, make_step) for sequence in procedure.sequences]
    with machine:
        for label, follower, sub in zip(labels, followers, subs):
            smach.StateMachine.add(
                label, sub, transitions={"succeeded": "succeeded", "aborted": follower, "preempted": "preempted"})
    return machine
