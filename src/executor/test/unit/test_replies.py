"""What the person is told."""

import pytest

from arbitrator.node_runs import EndedBy, NodeEvent
from arbitrator.plan import (
    Candidate,
    Condition,
    Do,
    Fallback,
    If,
    InParallel,
    InSequence,
    Limit,
    Repeat,
    Until,
    Wait,
    While,
    walk,
)
from executor import goal_tracking as tracking
from executor.command_queue import Cause
from executor.goal_tracking import GoalDeadlines, GoalStatusCode
from executor.replies import (
    ReplyOutcome,
    ending_of_malformed,
    ending_of_run,
    ending_of_unstarted,
    ending_without_master,
)
from executor.run_record import NodeRecord, RunRecord
from typed_arguments import FilledFrame


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


def do(label):
    return Do(label, (Candidate((FilledFrame(name="turning", server="turn"),)),))


def clause(label, outcome, goals=()):
    """A clause, and what became of it."""
    record = NodeRecord(begun=bool(outcome), done=outcome == "succeeded", outcome=outcome, goals=tuple(goals))
    return do(label), record


@pytest.mark.parametrize(
    "outcome,goals,cause,error,expected,code,part",
    [
        ("succeeded", [DONE], None, "", ReplyOutcome.DONE, "DONE", "Done."),
        ("succeeded", [ABORTED, DONE], None, "", ReplyOutcome.DONE, "DONE", "no odometry"),
        ("succeeded", [DONE], Cause.NEW_COMMAND, "", ReplyOutcome.DONE, "DONE", "Done."),
        ("aborted", [ABORTED], None, "", ReplyOutcome.FAILED, "ALL_CANDIDATES_FAILED", "no odometry"),
        ("aborted", [ABORTED], Cause.STOPPED, "", ReplyOutcome.SUPERSEDED, "STOPPED", "Stopped."),
        ("preempted", [PREEMPTED], Cause.NEW_COMMAND, "", ReplyOutcome.SUPERSEDED, "NEW_COMMAND", "newer command"),
        ("preempted", [PREEMPTED], Cause.STOPPED, "", ReplyOutcome.SUPERSEDED, "STOPPED", "Stopped."),
        ("preempted", [ORPHAN], Cause.STOPPED, "", ReplyOutcome.SUPERSEDED, "STOPPED", "turn did not end on cancel"),
        ("preempted", [TAKEN], None, "", ReplyOutcome.SUPERSEDED, "STOPPED", "Another client cancelled it: turn was"),
        ("", [ABORTED], None, "KeyError: 1", ReplyOutcome.FAILED, "STAGE_ERROR", "KeyError: 1"),
    ],
)
def test_end_of_a_run(outcome, goals, cause, error, expected, code, part):
    plan, record = clause("turn left", outcome, goals)
    ending = ending_of_run(outcome, plan, [record], cause=cause, error=error)
    assert (ending.outcome, ending.code) == (expected, code)
    assert part in ending.sentence


@pytest.mark.parametrize(
    "texts, sentence",
    [
        (["There are four chairs"], "Done. There are four chairs."),
        (["It is noon.", "", "It is noon."], "Done. It is noon."),
        (["I see two cups.", "I see no fork."], "Done. I see two cups. I see no fork."),
        (["the goal is reached"], "Done. The goal is reached."),
    ],
)
def test_the_reply_has_what_the_servers_told(texts, sentence):
    plan, record = clause("tell me", "succeeded", [goal(GoalStatusCode.SUCCEEDED, True, text) for text in texts])
    assert ending_of_run("succeeded", plan, [record], cause=None, error="").sentence == sentence


PINGED = clause("Ping", "succeeded", (DONE,))
LATE = clause("turn left", "succeeded", (ABORTED, DONE))
FAILED = clause("wave at Alice", "aborted", (ABORTED, goal(GoalStatusCode.REJECTED, text="no arm", server="wave")))
NOT_BEGUN = clause("go home", "")


@pytest.mark.parametrize(
    "outcome,clauses,cause,error,code,sentence",
    [
        ("succeeded", [PINGED, PINGED], None, "", "DONE", "Done."),
        ("succeeded", [PINGED, LATE], None, "", "DONE", "Done, though another way failed first: no odometry."),
        (
            "aborted",
            [PINGED, FAILED],
            None,
            "",
            "ALL_CANDIDATES_FAILED",
            ('I did "Ping", but I could not do "wave at Alice": no odometry; no arm.'),
        ),
        # What went wrong in a clause that was done in the end is not why the other one failed.
        (
            "aborted",
            [PINGED, LATE, FAILED, NOT_BEGUN],
            None,
            "",
            "ALL_CANDIDATES_FAILED",
            (
                'I did "Ping" and "turn left", but I could not do "wave at Alice": no odometry; '
                'no arm. I did not begin "go home".'
            ),
        ),
        (
            "aborted",
            [FAILED, NOT_BEGUN, NOT_BEGUN],
            None,
            "",
            "ALL_CANDIDATES_FAILED",
            ('I could not do "wave at Alice": no odometry; no arm. I did not begin "go home" and "go home".'),
        ),
        (
            "preempted",
            [PINGED, clause("turn left", "preempted", (PREEMPTED,))],
            Cause.NEW_COMMAND,
            "",
            "NEW_COMMAND",
            'A newer command took its place. Before that, I did "Ping".',
        ),
        (
            "preempted",
            [clause("turn left", "preempted", (PREEMPTED,)), NOT_BEGUN],
            Cause.STOPPED,
            "",
            "STOPPED",
            "Stopped.",
        ),
        (
            "preempted",
            [PINGED, clause("turn left", "preempted", (TAKEN,))],
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
    plan = InSequence("all", tuple(part for part, _ in clauses))
    records = [NodeRecord(1, 0, outcome), *[record for _, record in clauses]]
    ending = ending_of_run(outcome, plan, records, cause=cause, error=error)
    assert (ending.code, ending.sentence) == (code, sentence)


WALL = Condition("you see a wall", do("x").candidates)
NOT_OPEN = Condition("the door is open", do("x").candidates, is_negated=True)
DRIVE, GREET, HIDE = do("drive"), do("greet her"), do("hide")


def told(plan, *events, outcome="succeeded", goals=None, cause=None):
    """What the person is told after these events: (number, outcome, what ended it, fault)."""
    record = RunRecord(plan)
    for number, how, *rest in events:
        record.hear(NodeEvent(number))
        if how:
            record.hear(NodeEvent(number, how, *rest))
    for number, ended in (goals or {}).items():
        record.hear_goal(number, ended)
    ending = ending_of_run(outcome, plan, record.records(), cause=cause, error="")
    return ending.code, ending.sentence


OK, BAD, CUT = "succeeded", "aborted", "preempted"
UNTIL = Until("drive until you see a wall", DRIVE, WALL)
FAULT = "/scan is silent"


@pytest.mark.parametrize(
    "plan,events,sentence",
    [
        (UNTIL, [(0, OK, EndedBy.CONDITION), (2, CUT)], 'Done. I ended "drive", because "you see a wall" held.'),
        (UNTIL, [(0, OK, EndedBy.CONDITION)], 'Done. I did not begin "drive", because "you see a wall" held.'),
        (UNTIL, [(0, OK), (2, OK)], 'Done. "drive" was over before "you see a wall" held.'),
        (Until("x", DRIVE, None, 600.0), [(0, OK, EndedBy.TIME), (1, CUT)], 'Done. I ended "drive" after 10 minutes.'),
        (Until("x", DRIVE, None, 1.0), [(0, OK, EndedBy.TIME), (1, CUT)], 'Done. I ended "drive" after 1 second.'),
        (Until("x", DRIVE, None, 1.5), [(0, OK), (1, OK)], "Done."),
        (
            While("x", NOT_OPEN, DRIVE),
            [(0, OK, EndedBy.CONDITION), (2, CUT)],
            'Done. I ended "drive", because "the door is open" held.',
        ),
        (
            If("x", WALL, DRIVE),
            [(0, OK, EndedBy.CONDITION)],
            'Done. I did not do "drive", because "you see a wall" did not hold.',
        ),
        (
            If("x", NOT_OPEN, DRIVE),
            [(0, OK, EndedBy.CONDITION)],
            'Done. I did not do "drive", because "the door is open" held.',
        ),
        (
            If("x", WALL, DRIVE, HIDE),
            [(0, OK), (3, OK)],
            'Done. I did "hide", and not "drive", because "you see a wall" did not hold.',
        ),
        (If("x", WALL, DRIVE, HIDE), [(0, OK), (2, OK)], "Done."),
        (Repeat("x", DRIVE, 3, 3), [(0, OK), (1, OK), (1, OK), (1, OK)], 'Done. I did "drive" 3 times.'),
        (Fallback("x", (DRIVE, HIDE)), [(0, OK), (1, BAD), (2, OK)], "Done."),
    ],
)
def test_what_was_done_otherwise_than_said_is_told(plan, events, sentence):
    assert told(plan, *events) == ("DONE", sentence)


WAITING = InSequence("all", (Wait("when you see a wall", WALL, limit=Limit(30.0)), GREET))


FOR_A_TIME = Until("x", DRIVE, None, 2.0)


def cut(text, is_succeeding):
    """A goal that was ended because its time was over."""
    begun = tracking.ask_preempt(tracking.send("walk", GoalDeadlines(), now_s=0.0), now_s=0.0)
    if is_succeeding is not None:
        begun = tracking.hear_feedback(begun, is_succeeding=is_succeeding, now_s=0.5)
    return tracking.hear_result(begun, GoalStatusCode.PREEMPTED, success=False, text=text, now_s=1.0)


@pytest.mark.parametrize(
    "is_succeeding, code, sentence",
    [
        (None, "DONE", 'Done. I ended "drive" after 2 seconds: I moved 0.5 m.'),
        (True, "DONE", 'Done. I ended "drive" after 2 seconds: I moved 0.5 m.'),
        (False, "LIMIT_REACHED", 'I ended "drive" after 2 seconds: I moved 0.5 m.'),
    ],
)
def test_what_was_reached_when_the_time_was_over_is_told(is_succeeding, code, sentence):
    events = [(0, OK, EndedBy.TIME), (1, CUT)]
    assert told(FOR_A_TIME, *events, goals={1: cut("I moved 0.5 m", is_succeeding)}) == (code, sentence)
    # It counts only for what its time ended: this one was over before.
    assert told(FOR_A_TIME, (0, OK), (1, OK), goals={1: cut("", is_succeeding)}) == ("DONE", "Done.")


def test_what_was_done_beside_something_stuck_is_told():
    plan = InSequence("all", (HIDE, FOR_A_TIME))
    events = [(0, OK), (1, OK), (2, OK, EndedBy.TIME), (3, CUT)]
    assert told(plan, *events, goals={3: cut("", False)}) == (
        "LIMIT_REACHED",
        'I ended "drive" after 2 seconds. I did "hide".',
    )


@pytest.mark.parametrize(
    "plan,events,code,sentence",
    [
        (
            UNTIL,
            [(0, BAD, EndedBy.FAULT, FAULT), (2, CUT)],
            "CONDITION_UNKNOWN",
            'I cannot tell whether "you see a wall": /scan is silent. I ended "drive".',
        ),
        (
            InSequence("all", (HIDE, UNTIL, GREET)),
            [(0, BAD), (1, OK), (2, BAD, EndedBy.FAULT, FAULT), (4, CUT)],
            "CONDITION_UNKNOWN",
            (
                'I cannot tell whether "you see a wall": /scan is silent. I ended "drive". Before that, I did "hide". '
                'I did not begin "greet her".'
            ),
        ),
        (
            WAITING,
            [(0, BAD), (1, BAD, EndedBy.LIMIT)],
            "LIMIT_REACHED",
            'I waited, but within 30 seconds "you see a wall" did not hold. I did not begin "greet her".',
        ),
        (
            InParallel("drive and hide", (DRIVE, HIDE), limit=Limit(120.0)),
            [(0, BAD, EndedBy.LIMIT), (1, OK), (2, CUT)],
            "LIMIT_REACHED",
            '"drive and hide" was not done within 2 minutes. I ended "hide". Before that, I did "drive".',
        ),
    ],
)
def test_what_failed_besides_a_clause_is_told(plan, events, code, sentence):
    assert told(plan, *events, outcome="aborted") == (code, sentence)


def test_clause_that_fails_in_its_second_round():
    plan = InSequence("all", (Repeat("x", DRIVE, 3, 3), GREET))
    events = [(0, BAD), (1, BAD), (2, OK), (2, BAD)]
    assert told(plan, *events, outcome="aborted", goals={2: ABORTED}) == (
        "ALL_CANDIDATES_FAILED",
        'I did "drive", but I could not do "drive": no odometry. I did not begin "greet her".',
    )


def test_rounds_before_a_stop_are_told():
    plan = Repeat("x", DRIVE, 0, 0)
    assert told(plan, (0, CUT), (1, OK), (1, OK), (1, CUT), outcome="preempted", cause=Cause.STOPPED) == (
        "STOPPED",
        'Stopped. Before that, I did "drive" 2 times.',
    )


def test_each_node_has_a_record():
    assert len(RunRecord(WAITING).records()) == len(list(walk(WAITING)))


@pytest.mark.parametrize("cause", list(Cause))
def test_commands_that_never_began(cause):
    ending = ending_of_unstarted(cause)
    is_superseded = cause in (Cause.NEW_COMMAND, Cause.STOPPED, Cause.NOT_FREE)
    assert ending.outcome == (ReplyOutcome.SUPERSEDED if is_superseded else ReplyOutcome.FAILED)
    assert ending.code == cause.value and ending.sentence


def test_command_that_cannot_run_beside_another_names_it():
    sentence = ending_of_unstarted(Cause.NOT_BESIDE, blocking="Go to the kitchen.").sentence
    assert sentence == 'I cannot do that beside "Go to the kitchen": both need the same part.'


def test_malformed_plan():
    assert ending_of_malformed("no frames").code == "STAGE_ERROR"


@pytest.mark.parametrize(
    "clauses, told",
    [
        ([PINGED, NOT_BEGUN], 'I did "Ping". I did not begin "go home".'),
        (
            [PINGED, FAILED, NOT_BEGUN],
            ('I did "Ping". I could not do "wave at Alice": no odometry; no arm. I did not begin "go home".'),
        ),
        (
            [clause("turn left", "preempted", (PREEMPTED,)), NOT_BEGUN],
            'I ended "turn left". I did not begin "go home".',
        ),
        # Its machine has begun, and no goal.
        ([PINGED, clause("go home", "preempted")], 'I did "Ping". I did not begin "go home".'),
    ],
)
def test_without_a_master_what_was_done_is_told(clauses, told):
    plan = InSequence("all", tuple(part for part, _ in clauses))
    records = [NodeRecord(begun=1, outcome="preempted"), *(record for _, record in clauses)]
    ending = ending_of_run("preempted", plan, records, cause=None, error="", is_without_master=True)
    assert (ending.outcome, ending.code) == (ReplyOutcome.FAILED, "MASTER_LOST")
    assert ending.sentence == f"The ROS master is gone. {told}"


def test_repetition_that_ends_without_a_master_says_so():
    plan = Repeat("turn left twice", do("turn left"), 2, 2)
    records = [NodeRecord(begun=1, outcome="preempted"), NodeRecord(begun=2, done=1, goals=(DONE,))]
    ending = ending_of_run("preempted", plan, records, cause=None, error="", is_without_master=True)
    assert ending.sentence == 'The ROS master is gone. I did "turn left". I do not repeat "turn left".'


def test_plan_that_was_done_or_stopped_is_told_as_such_without_a_master():
    plan, record = clause("turn left", "succeeded", (DONE,))
    assert ending_of_run("succeeded", plan, [record], cause=None, error="", is_without_master=True).code == "DONE"
    plan, record = clause("turn left", "preempted", (PREEMPTED,))
    stopped = ending_of_run("preempted", plan, [record], cause=Cause.STOPPED, error="", is_without_master=True)
    assert stopped.code == "STOPPED"
    assert ending_without_master().sentence == "The ROS master is gone, so I begin nothing."
