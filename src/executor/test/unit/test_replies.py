"""What the person is told."""

import pytest

from executor import goal_tracking as tracking
from executor.command_queue import Cause
from executor.goal_tracking import GoalDeadlines, GoalStatusCode
from executor.replies import ClauseRun, ReplyOutcome, ending_of_malformed, ending_of_run, ending_of_unstarted


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
    tracking.ask_preempt(tracking.send("turn", GoalDeadlines(), now_s=0.0), now_s=0.0), now_s=9.0
).goal


@pytest.mark.parametrize(
    "outcome,goals,cause,error,expected,code,part",
    [
        ("succeeded", [DONE], None, "", ReplyOutcome.DONE, "DONE", "Done."),
        ("succeeded", [ABORTED, DONE], None, "", ReplyOutcome.DONE, "DONE", "walk aborted: no odometry"),
        ("succeeded", [DONE], Cause.NEW_COMMAND, "", ReplyOutcome.DONE, "DONE", "Done."),
        ("aborted", [ABORTED], None, "", ReplyOutcome.FAILED, "ALL_CANDIDATES_FAILED", "walk aborted: no odometry"),
        ("aborted", [ABORTED], Cause.STOPPED, "", ReplyOutcome.SUPERSEDED, "STOPPED", "Stopped."),
        ("preempted", [PREEMPTED], Cause.NEW_COMMAND, "", ReplyOutcome.SUPERSEDED, "NEW_COMMAND", "newer command"),
        ("preempted", [PREEMPTED], Cause.STOPPED, "", ReplyOutcome.SUPERSEDED, "STOPPED", "Stopped."),
        ("preempted", [ORPHAN], Cause.STOPPED, "", ReplyOutcome.SUPERSEDED, "STOPPED", "turn did not end on cancel"),
        ("preempted", [TAKEN], None, "", ReplyOutcome.SUPERSEDED, "STOPPED", "Another client cancelled it: turn was"),
        ("", [ABORTED], None, "KeyError: 1", ReplyOutcome.FAILED, "STAGE_ERROR", "KeyError: 1"),
    ],
)
def test_end_of_a_run(outcome, goals, cause, error, expected, code, part):
    ending = ending_of_run(outcome, [ClauseRun("turn left", outcome, tuple(goals))], cause=cause, error=error)
    assert (ending.outcome, ending.code) == (expected, code)
    assert part in ending.sentence


PINGED = ClauseRun("Ping", "succeeded", (DONE,))
LATE = ClauseRun("turn left", "succeeded", (ABORTED, DONE))
FAILED = ClauseRun("wave at Alice", "aborted", (ABORTED, goal(GoalStatusCode.REJECTED, text="no arm", server="wave")))
NOT_BEGUN = ClauseRun("go home", "")


@pytest.mark.parametrize(
    "outcome,clauses,cause,error,code,sentence",
    [
        ("succeeded", [PINGED, PINGED], None, "", "DONE", "Done."),
        ("succeeded", [PINGED, LATE], None, "", "DONE", "Done, after walk aborted: no odometry."),
        (
            "aborted",
            [PINGED, FAILED],
            None,
            "",
            "ALL_CANDIDATES_FAILED",
            (
                'I did "Ping", but I could not do "wave at Alice": walk aborted: no odometry; '
                "wave rejected the goal: no arm."
            ),
        ),
        # What went wrong in a clause that was done in the end is not why the other one failed.
        (
            "aborted",
            [PINGED, LATE, FAILED, NOT_BEGUN],
            None,
            "",
            "ALL_CANDIDATES_FAILED",
            (
                'I did "Ping" and "turn left", but I could not do "wave at Alice": walk aborted: no odometry; '
                'wave rejected the goal: no arm. I did not begin "go home".'
            ),
        ),
        (
            "aborted",
            [FAILED, NOT_BEGUN, NOT_BEGUN],
            None,
            "",
            "ALL_CANDIDATES_FAILED",
            (
                'I could not do "wave at Alice": walk aborted: no odometry; wave rejected the goal: no arm. '
                'I did not begin "go home" and "go home".'
            ),
        ),
        (
            "preempted",
            [PINGED, ClauseRun("turn left", "preempted", (PREEMPTED,))],
            Cause.NEW_COMMAND,
            "",
            "NEW_COMMAND",
            'A newer command took its place. Before that, I did "Ping".',
        ),
        (
            "preempted",
            [ClauseRun("turn left", "preempted", (PREEMPTED,)), NOT_BEGUN],
            Cause.STOPPED,
            "",
            "STOPPED",
            "Stopped.",
        ),
        (
            "preempted",
            [PINGED, ClauseRun("turn left", "preempted", (TAKEN,))],
            None,
            "",
            "STOPPED",
            'Another client cancelled it: turn was preempted. Before that, I did "Ping".',
        ),
        (
            "",
            [PINGED, NOT_BEGUN],
            None,
            "KeyError: 1",
            "STAGE_ERROR",
            'The state machine broke: KeyError: 1. Before that, I did "Ping".',
        ),
    ],
)
def test_what_was_done_of_several_clauses_is_said(outcome, clauses, cause, error, code, sentence):
    ending = ending_of_run(outcome, clauses, cause=cause, error=error)
    assert (ending.code, ending.sentence) == (code, sentence)


@pytest.mark.parametrize("cause", list(Cause))
def test_commands_that_never_began(cause):
    ending = ending_of_unstarted(cause)
    assert (ending.outcome, ending.code) == (ReplyOutcome.SUPERSEDED, cause.value) and ending.sentence


def test_malformed_plan():
    assert ending_of_malformed("no frames").code == "STAGE_ERROR"
