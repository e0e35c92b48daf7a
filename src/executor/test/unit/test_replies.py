"""What the person is told."""
import pytest

from executor import goal_tracking as tracking
from executor.command_desk import Cause
from executor.goal_tracking import GoalDeadlines, GoalStatusCode
from executor.replies import ReplyOutcome, ending_of_malformed, ending_of_run, ending_of_unstarted


def goal(status, success=None, text="", is_asked=False, server="turn"):
    value = tracking.send(server, GoalDeadlines(), now_s=0.0)
    if is_asked:
        value = tracking.ask_preempt(value, now_s=0.0)
    return tracking.hear_result(value, status, success=success, text=text, now_s=1.0)


DONE = goal(GoalStatusCode.SUCCEEDED, True)
ABORTED = goal(GoalStatusCode.ABORTED, text="no odometry", server="walk")
TAKEN = goal(GoalStatusCode.PREEMPTED)
PREEMPTED = goal(GoalStatusCode.PREEMPTED, is_asked=True)
ORPHAN = tracking.tick(
    tracking.ask_preempt(tracking.send("turn", GoalDeadlines(), now_s=0.0), now_s=0.0), now_s=9.0).goal


@pytest.mark.parametrize("outcome,goals,cause,error,expected,code,part", [
    ("succeeded", [DONE], None, "", ReplyOutcome.DONE, "DONE", "Done."),
    ("succeeded", [ABORTED, DONE], None, "", ReplyOutcome.DONE, "DONE", "walk aborted: no odometry"),
    ("succeeded", [DONE], Cause.NEW_COMMAND, "", ReplyOutcome.DONE, "DONE", "Done."),
    ("aborted", [ABORTED], None, "", ReplyOutcome.FAILED, "ALL_CANDIDATES_FAILED", "walk aborted: no odometry"),
    ("aborted", [ABORTED], Cause.STOPPED, "", ReplyOutcome.SUPERSEDED, "STOPPED", "Stopped."),
    ("preempted", [PREEMPTED], Cause.NEW_COMMAND, "", ReplyOutcome.SUPERSEDED, "NEW_COMMAND", "newer command"),
    ("preempted", [PREEMPTED], Cause.STOPPED, "", ReplyOutcome.SUPERSEDED, "STOPPED", "Stopped."),
    ("preempted", [ORPHAN], Cause.STOPPED, "", ReplyOutcome.SUPERSEDED, "STOPPED", "turn did not end on cancel"),
    ("preempted", [TAKEN], None, "", ReplyOutcome.SUPERSEDED, "STOPPED", "Somebody else cancelled it: turn was"),
    ("", [ABORTED], None, "KeyError: 1", ReplyOutcome.FAILED, "STAGE_ERROR", "KeyError: 1"),
])
def test_end_of_a_run(outcome, goals, cause, error, expected, code, part):
    ending = ending_of_run(outcome, goals, cause=cause, error=error)
    assert (ending.outcome, ending.code) == (expected, code)
    assert part in ending.sentence


@pytest.mark.parametrize("cause", list(Cause))
def test_commands_that_never_began(cause):
    ending = ending_of_unstarted(cause)
    assert (ending.outcome, ending.code) == (ReplyOutcome.SUPERSEDED, cause.value) and ending.sentence


def test_malformed_procedure():
    assert ending_of_malformed("no frames").code == "STAGE_ERROR"
