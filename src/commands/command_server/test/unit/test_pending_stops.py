"""Stops and what the stop server says of them meet in any order."""

import pytest

from command_server.pending_stops import PendingStops


@pytest.fixture
def commands(clock):
    return PendingStops(timeout_s=1.0, now=clock)


def say(commands, command_id="mine", *, is_action=False, heard_s=None):
    return commands.hear_stop(command_id, "stop", stamp_ns=7, is_action=is_action, heard_s=heard_s)


def overdue(commands):
    """Carry out what is silent, and see what is overdue."""
    commands.take_silent(brake_s=0.0)
    return [stop.command_id for stop in commands.take_overdue()]


def test_reply_answers_the_stop_that_came_before(commands, clock):
    assert say(commands) is None
    assert commands.hear_reply("theirs", "stop").command_id == "mine"
    clock.now_s += 5.0
    assert not overdue(commands)


def test_reply_may_come_first(commands):
    assert commands.hear_reply("goal", "stop") is None
    assert say(commands, "goal", is_action=True) == "goal"


def test_goal_takes_only_the_reply_with_its_id(commands):
    assert commands.hear_reply("other", "stop") is None
    assert say(commands, "goal", is_action=True) is None


def test_each_of_many_stops_takes_one_reply(commands, clock):
    for index in range(50):
        say(commands, f"mine{index}")
    for index in range(49):
        assert commands.hear_reply(f"theirs{index}", "stop") is not None
    clock.now_s += 2.0
    assert overdue(commands) == ["mine49"]
    assert not overdue(commands)


def test_old_reply_does_not_answer_a_new_stop(commands, clock):
    commands.hear_reply("theirs", "stop")
    clock.now_s += 0.6
    assert say(commands) is None


def test_reply_is_early_by_the_time_at_which_the_stop_was_heard(commands, clock):
    commands.hear_reply("theirs", "stop")
    clock.now_s += 0.6
    assert say(commands, heard_s=clock.now_s - 0.5) == "theirs"


def test_late_reply_to_a_stop_that_was_answered_here_does_not_answer_the_next_one(commands, clock):
    say(commands, "first")
    clock.now_s += 1.0
    assert overdue(commands) == ["first"]
    assert commands.hear_reply("late", "stop") is None
    assert say(commands, "second") is None
    clock.now_s += 1.0
    assert overdue(commands) == ["second"]


def test_late_reply_while_the_next_stop_waits_answers_one_of_them(commands, clock):
    say(commands, "first")
    clock.now_s += 1.0
    assert overdue(commands) == ["first"]
    say(commands, "second")
    assert commands.hear_reply("late", "stop").command_id == "second"
    assert commands.hear_reply("later", "stop") is None  # the two stops have had three answers: none is kept
    assert say(commands, "third") is None


def silent(commands, *, brake_s=0.5):
    return [stop.command_id for stop in commands.take_silent(brake_s=brake_s)]


def test_stop_without_a_report_is_carried_out_here_once(commands, clock):
    say(commands)
    assert not silent(commands)
    assert commands.next_deadline_s() == pytest.approx(100.15)
    clock.now_s += 0.2
    (stop,) = commands.take_silent(brake_s=0.5)
    assert (stop.command_id, stop.stamp_ns) == ("mine", 7)
    assert not silent(commands)
    assert commands.next_deadline_s() == pytest.approx(101.0)
    clock.now_s += 0.9
    assert overdue(commands) == ["mine"]


@pytest.mark.parametrize("is_early", [True, False])
def test_report_confirms_and_gives_time_for_the_reply(commands, clock, is_early):
    if is_early:
        assert commands.hear_report("theirs", "stop") is None
        say(commands)
    else:
        say(commands)
        clock.now_s += 0.1
        assert commands.hear_report("theirs", "stop").command_id == "mine"
    clock.now_s += 0.95
    assert not silent(commands)
    assert not commands.take_overdue()


def test_report_without_a_reply_is_carried_out_here_before_it_is_answered(commands, clock):
    say(commands)
    commands.hear_report("theirs", "stop")
    clock.now_s += 1.0
    assert silent(commands, brake_s=0.5) == ["mine"]
    clock.now_s += 0.4
    assert not commands.take_overdue()
    clock.now_s += 0.2
    assert [stop.command_id for stop in commands.take_overdue()] == ["mine"]


def test_report_of_a_stop_that_is_carried_out_here_names_it(commands, clock):
    say(commands)
    clock.now_s += 0.2
    assert silent(commands) == ["mine"]
    assert commands.hear_report("theirs", "stop").command_id == "mine"
    clock.now_s += 0.9
    assert not overdue(commands)
    clock.now_s += 0.2
    assert silent(commands) == ["mine"]  # the stop server has died meanwhile


def test_reports_confirm_one_stop_each(commands, clock):
    say(commands, "first")
    say(commands, "second")
    commands.hear_report("theirs", "stop")
    clock.now_s += 0.2
    assert silent(commands) == ["second"]


def test_stop_server_is_not_blamed_while_this_process_does_not_run(commands, clock):
    say(commands)
    clock.now_s += 60.0
    commands.postpone(60.0)
    assert not overdue(commands)


def test_goal_without_an_id_of_its_own_is_matched_by_its_words(commands):
    say(commands, "made_up_here", is_action=True)
    assert commands.hear_reply("made_up_there", "stop").command_id == "made_up_here"
