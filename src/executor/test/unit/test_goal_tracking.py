"""Every way in which a goal can go and end."""

import random
from dataclasses import replace

import pytest

from executor import goal_tracking as tracking
from executor.goal_tracking import GoalDeadlines, GoalStatusCode, Outcome, Phase

DEADLINES = GoalDeadlines(acceptance_s=5.0, silence_s=4.0, preempt_s=3.0, cancel_period_s=1.0, result_s=2.0)


def sent():
    return tracking.send("turn_server", DEADLINES, now_s=100.0)


def accepted():
    return tracking.hear_status(sent(), GoalStatusCode.ACTIVE, now_s=101.0)


def result(goal, status, success=None, text="", now_s=102.0):
    return tracking.hear_result(goal, status, success=success, text=text, now_s=now_s)


def test_status_numbers_are_those_of_actionlib():
    messages = pytest.importorskip("actionlib_msgs.msg")
    for code in GoalStatusCode:
        assert getattr(messages.GoalStatus, code.name) == code.value


def test_mapping_of_terminal_states_is_total():
    assert set(tracking.OUTCOME_OF_STATUS) == tracking.TERMINAL_STATUSES
    assert (
        set(GoalStatusCode)
        - {GoalStatusCode.PENDING, GoalStatusCode.ACTIVE, GoalStatusCode.PREEMPTING, GoalStatusCode.RECALLING}
        == tracking.TERMINAL_STATUSES
    )


@pytest.mark.parametrize(
    "status,success,outcome,reason",
    [
        (GoalStatusCode.SUCCEEDED, True, Outcome.SUCCEEDED, ""),
        (GoalStatusCode.SUCCEEDED, False, Outcome.FAILED, "its result says that it did not succeed"),
        (GoalStatusCode.SUCCEEDED, None, Outcome.FAILED, "sent no result"),
        (GoalStatusCode.ABORTED, False, Outcome.FAILED, "aborted: wheel stuck"),
        (GoalStatusCode.ABORTED, True, Outcome.FAILED, "aborted: wheel stuck"),
        (GoalStatusCode.REJECTED, None, Outcome.FAILED, "rejected the goal: wheel stuck"),
        (GoalStatusCode.LOST, None, Outcome.FAILED, "lost the goal: wheel stuck"),
        (GoalStatusCode.PREEMPTED, None, Outcome.TAKEN_AWAY, "was preempted: wheel stuck"),
        (GoalStatusCode.RECALLED, None, Outcome.TAKEN_AWAY, "was cancelled before it began: wheel stuck"),
        (GoalStatusCode.ACTIVE, True, Outcome.FAILED, "not terminal"),
        (99, True, Outcome.FAILED, "99"),
    ],
)
def test_result_ends_the_goal(status, success, outcome, reason):
    goal = result(accepted(), status, success, "wheel stuck.")
    assert goal.is_ended
    assert goal.outcome is outcome
    assert reason in goal.reason


@pytest.mark.parametrize("status", sorted(tracking.TERMINAL_STATUSES - {GoalStatusCode.SUCCEEDED}))
def test_whatever_ends_a_goal_that_we_cancelled_is_a_preemption(status):
    goal = result(tracking.ask_preempt(accepted(), now_s=101.5), status, False)
    assert goal.outcome is Outcome.PREEMPTED


def test_success_that_comes_in_spite_of_the_cancel_is_a_success():
    goal = result(tracking.ask_preempt(accepted(), now_s=101.5), GoalStatusCode.SUCCEEDED, True)
    assert goal.outcome is Outcome.SUCCEEDED


def test_ended_goal_changes_no_more():
    goal = result(accepted(), GoalStatusCode.SUCCEEDED, True)
    later = result(goal, GoalStatusCode.ABORTED)
    later = tracking.ask_preempt(tracking.hear_status(later, GoalStatusCode.LOST, now_s=200.0), now_s=201.0)
    assert (later.outcome, later.reason, later.phase) == (goal.outcome, goal.reason, Phase.ENDED)
    assert not tracking.tick(later, now_s=1e9).is_cancel_due
    assert tracking.next_deadline_s(later) == float("inf")


def run_clock(goal, now_s, *, until_s):
    """Tick at each deadline; returns the goal and when cancels went out."""
    cancels = []
    while not goal.is_ended:
        now_s = max(now_s, tracking.next_deadline_s(goal))
        if now_s > until_s:
            break
        step = tracking.tick(goal, now_s=now_s)
        goal = step.goal
        if step.is_cancel_due:
            cancels.append(now_s)
    return goal, cancels


def test_goal_that_nobody_accepts_is_cancelled_and_fails():
    goal, cancels = run_clock(sent(), 100.0, until_s=200.0)
    assert goal.outcome is Outcome.FAILED
    assert "did not accept the goal within 5 s" in goal.reason and "did not end on cancel" in goal.reason
    assert cancels == [105.0, 106.0, 107.0]
    assert goal.is_orphaned


def test_silent_server_fails_and_is_cancelled():
    goal, cancels = run_clock(accepted(), 101.0, until_s=200.0)
    assert goal.outcome is Outcome.FAILED
    assert "was silent for 4 s" in goal.reason
    assert cancels[0] == 105.0


def test_time_in_which_nobody_listened_is_no_silence():
    goal = tracking.postpone(accepted(), 60.0)
    step = tracking.tick(goal, now_s=161.0 + DEADLINES.silence_s - 0.1)
    assert step.goal.phase is Phase.ACCEPTED and not step.is_cancel_due
    assert tracking.tick(step.goal, now_s=161.0 + DEADLINES.silence_s).goal.phase is Phase.CANCELLING


def test_result_that_is_unread_is_not_missing():
    goal = tracking.postpone(tracking.hear_status(accepted(), GoalStatusCode.SUCCEEDED, now_s=102.0), 60.0)
    goal = tracking.tick(goal, now_s=162.5).goal
    assert result(goal, GoalStatusCode.SUCCEEDED, True, now_s=162.6).outcome is Outcome.SUCCEEDED


def test_signs_keep_a_long_goal_alive():
    goal = accepted()
    for second in range(102, 300):
        goal = tracking.hear_sign(goal, now_s=float(second))
        step = tracking.tick(goal, now_s=second + 0.9)
        assert not step.is_cancel_due and step.goal.phase is Phase.ACCEPTED
        goal = step.goal


def test_goal_that_stays_pending_fails():
    goal = tracking.hear_status(sent(), GoalStatusCode.PENDING, now_s=101.0)
    goal, cancels = run_clock(goal, 101.0, until_s=200.0)
    assert goal.outcome is Outcome.FAILED and "did not accept" in goal.reason
    assert cancels[0] == 105.0


def test_silent_server_that_comes_back_to_obey_the_cancel_has_failed_all_the_same():
    goal = tracking.tick(accepted(), now_s=106.0).goal
    goal = result(goal, GoalStatusCode.PREEMPTED, now_s=107.0)
    assert (goal.outcome, goal.reason, goal.is_orphaned) == (Outcome.FAILED, "was silent for 4 s", False)


def test_silent_server_that_comes_back_with_success_has_done_it():
    goal = tracking.tick(accepted(), now_s=106.0).goal
    assert result(goal, GoalStatusCode.SUCCEEDED, True, now_s=107.0).outcome is Outcome.SUCCEEDED


def test_ignored_cancel_is_repeated_and_then_reported():
    goal, cancels = run_clock(tracking.ask_preempt(accepted(), now_s=110.0), 110.0, until_s=200.0)
    assert cancels == [110.0, 111.0, 112.0]
    assert goal.outcome is Outcome.PREEMPTED
    assert goal.is_orphaned and "did not end on cancel within 3 s" in goal.reason


def test_terminal_status_without_result_is_waited_for_and_then_counted():
    goal = tracking.hear_status(accepted(), GoalStatusCode.SUCCEEDED, now_s=102.0)
    assert goal.phase is Phase.CONCLUDING
    assert result(goal, GoalStatusCode.SUCCEEDED, True, now_s=103.0).outcome is Outcome.SUCCEEDED
    ended, cancels = run_clock(goal, 102.0, until_s=200.0)
    assert ended.outcome is Outcome.FAILED and "sent no result" in ended.reason
    assert not cancels


@pytest.mark.parametrize(
    "status,outcome",
    [
        (GoalStatusCode.ABORTED, Outcome.FAILED),
        (GoalStatusCode.REJECTED, Outcome.FAILED),
        (GoalStatusCode.PREEMPTED, Outcome.TAKEN_AWAY),
        (GoalStatusCode.RECALLED, Outcome.TAKEN_AWAY),
    ],
)
def test_other_terminal_status_without_result(status, outcome):
    goal, _ = run_clock(tracking.hear_status(accepted(), status, now_s=102.0), 102.0, until_s=200.0)
    assert goal.outcome is outcome


def test_unknown_status_fails():
    goal = tracking.hear_status(accepted(), 42, now_s=102.0)
    assert goal.outcome is Outcome.FAILED and "42" in goal.reason


def test_preempt_before_acceptance_cancels_at_once():
    goal = tracking.ask_preempt(sent(), now_s=100.5)
    assert tracking.tick(goal, now_s=100.5).is_cancel_due


def test_goals_that_were_never_sent():
    assert tracking.fail_unsent("s", DEADLINES, "is not running", now_s=0.0).outcome is Outcome.FAILED
    assert tracking.preempt_unsent("s", DEADLINES, now_s=0.0).outcome is Outcome.PREEMPTED


def test_failures_are_described_in_the_words_of_the_servers():
    goals = [
        result(accepted(), GoalStatusCode.ABORTED, text="no odometry"),
        result(accepted(), GoalStatusCode.SUCCEEDED, True),
        tracking.fail_unsent("arm", DEADLINES, "is not running", now_s=0.0),
    ]
    assert tracking.describe_failures(goals) == "no odometry; the program for it is not running."
    assert tracking.describe_failures(goals[1:2]) == ""


@pytest.mark.parametrize("name", ["acceptance_s", "silence_s", "preempt_s", "cancel_period_s", "result_s"])
@pytest.mark.parametrize("value", [0.0, -1.0, float("inf"), float("nan")])
def test_wrong_deadlines_are_refused(name, value):
    with pytest.raises(ValueError, match=name):
        GoalDeadlines(**{name: value})


def test_whatever_happens_a_goal_ends_in_bounded_time_once_it_is_to_end():
    for seed in range(500):
        lots = random.Random(seed)
        goal, now_s = sent(), 100.0
        for _ in range(lots.randrange(12)):
            now_s += lots.random() * 2.0
            what = lots.randrange(4)
            if what == 0:
                goal = tracking.hear_status(goal, lots.randrange(11), now_s=now_s)
            elif what == 1:
                goal = tracking.hear_sign(goal, now_s=now_s)
            elif what == 2:
                goal = tracking.tick(goal, now_s=now_s).goal
            else:
                goal = tracking.ask_preempt(goal, now_s=now_s)
        goal = tracking.ask_preempt(goal, now_s=now_s)
        goal, _ = run_clock(goal, now_s, until_s=now_s + 10.0)
        assert goal.is_ended and goal.outcome is not None, f"seed {seed}"
        assert goal.outcome is not Outcome.SUCCEEDED, f"seed {seed}"


def test_silent_process_is_asked_whether_it_lives_once_in_a_while():
    goal = accepted()
    asked = []
    for tenth in range(1010, 1040):
        step = tracking.tick(goal, now_s=tenth / 10.0)
        goal = step.goal
        if step.is_question_due:
            asked.append(tenth / 10.0)
    assert asked == [102.0, 103.0]


def test_server_that_speaks_is_not_asked():
    goal = accepted()
    for second in range(102, 110):
        assert not tracking.tick(goal, now_s=second - 0.1).is_question_due
        goal = tracking.hear_sign(goal, now_s=float(second))


def test_death_ends_the_goal_at_once_and_nothing_is_cancelled():
    goal = tracking.hear_death(accepted(), now_s=103.0)
    assert (goal.outcome, goal.reason, goal.is_orphaned) == (Outcome.FAILED, "has died", False)
    assert not tracking.tick(goal, now_s=1e9).is_cancel_due


def test_death_while_it_is_cancelled_is_a_preemption():
    goal = tracking.hear_death(tracking.ask_preempt(accepted(), now_s=102.0), now_s=103.0)
    assert (goal.outcome, goal.is_orphaned) == (Outcome.PREEMPTED, False)


def test_death_after_a_terminal_status_does_not_change_it():
    goal = tracking.hear_status(accepted(), GoalStatusCode.ABORTED, now_s=102.0)
    assert tracking.hear_death(goal, now_s=102.5).reason == "aborted"


def test_goal_that_never_ends_is_cancelled_at_its_limit():
    deadlines = replace(DEADLINES, execution_s=60.0)
    goal = tracking.hear_status(tracking.send("turn", deadlines, now_s=0.0), GoalStatusCode.ACTIVE, now_s=1.0)
    for second in range(1, 61):
        goal = tracking.hear_sign(goal, now_s=float(second))
        assert goal.phase is Phase.ACCEPTED
    step = tracking.tick(tracking.hear_sign(goal, now_s=61.0), now_s=61.0)
    assert step.is_cancel_due
    ended = tracking.hear_result(step.goal, GoalStatusCode.PREEMPTED, success=False, text="", now_s=62.0)
    assert (ended.outcome, ended.reason) == (Outcome.FAILED, "did not end within 60 s")


def test_sentence_gives_a_handful_of_reasons_once_and_counts_the_others():
    goals = [result(accepted(), GoalStatusCode.ABORTED, text=f"reason {number}") for number in range(64)]
    assert tracking.describe_failures(goals).endswith("reason 5; and 58 more.")
    assert tracking.describe_failures(goals[:1] * 3) == "reason 0."
