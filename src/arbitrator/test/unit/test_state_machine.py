"""What the machine of a procedure does, with steps whose outcome is given."""
import pytest
import smach

from arbitrator.procedure import FilledFrame, Procedure, Sequence
from arbitrator.state_machine import build_state_machine, candidate_label, step_label


class Step(smach.State):
    """Writes down that it ran and gives the outcome of its frame."""

    def __init__(self, frame, outcomes_by_frame, log):
        super().__init__(outcomes=["succeeded", "aborted", "preempted"])
        self._name, self._answers, self._log = frame.name, outcomes_by_frame, log

    def execute(self, userdata):
        self._log.append(self._name)
        return self._answers.get(self._name, "succeeded")


def run(sequences, outcomes_by_frame):
    procedure = Procedure(sequences=tuple(
        Sequence(frames=tuple(FilledFrame(name=name, frame_elements=(), server="server") for name in names))
        for names in sequences))
    log = []
    machine = build_state_machine(procedure, lambda frame: Step(frame, outcomes_by_frame, log))
    return machine.execute(), log


@pytest.mark.parametrize("sequences,outcomes,result,log", [
    ([["a"]], {}, "succeeded", ["a"]),
    ([["a", "b"]], {}, "succeeded", ["a", "b"]),
    ([["a"], ["b"]], {}, "succeeded", ["a"]),
    ([["a"], ["b"]], {"a": "aborted"}, "succeeded", ["a", "b"]),
    ([["a", "b"], ["c", "d"]], {"b": "aborted"}, "succeeded", ["a", "b", "c", "d"]),
    ([["a", "b"], ["a", "d"]], {"b": "aborted"}, "succeeded", ["a", "b", "a", "d"]),
    ([["a"], ["b"]], {"a": "aborted", "b": "aborted"}, "aborted", ["a", "b"]),
    ([["a", "b"], ["c"]], {"a": "preempted"}, "preempted", ["a"]),
    ([["a"], ["b", "c"], ["d"]], {"a": "aborted", "c": "preempted"}, "preempted", ["a", "b", "c"]),
    ([["a", "a"]], {}, "succeeded", ["a", "a"]),
])
def test_machine(sequences, outcomes, result, log):
    assert run(sequences, outcomes) == (result, log)


def test_labels_hold_no_slash():
    frame = FilledFrame(name="turning", frame_elements=(), server="/robot/turn")
    assert "/" not in step_label(0, frame) + candidate_label(0)
