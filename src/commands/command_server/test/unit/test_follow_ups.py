"""The command behind a stop: after it, once, and only when the robot has stopped."""

import pytest

from command_server.follow_ups import FollowUps
from command_server.open_commands import CommandText, Outcome

STOP = CommandText("text-1", 1_000_000_000, "Stop and come back.")


@pytest.fixture
def follow_ups(clock):
    return FollowUps(pause_s=1.0, now=clock)


def test_id_and_stamp_are_after_the_stop(follow_ups):
    command = follow_ups.add("come back.", stop=STOP, stop_stamp_ns=0)
    assert command.command_id != STOP.command_id and command.text == "come back."
    assert command.stamp_ns > STOP.stamp_ns


def test_report_that_came_before_the_text_counts(follow_ups):
    command = follow_ups.add("come back.", stop=STOP, stop_stamp_ns=STOP.stamp_ns + 3_000_000)
    assert command.stamp_ns > STOP.stamp_ns + 3_000_000


def test_clock_that_was_set_back_does_not(follow_ups):
    command = follow_ups.add("come back.", stop=STOP, stop_stamp_ns=STOP.stamp_ns + 100_000_000_000)
    assert STOP.stamp_ns < command.stamp_ns < STOP.stamp_ns + 1000


def test_it_begins_a_while_after_the_stop_is_answered(follow_ups, clock):
    command = follow_ups.add("come back.", stop=STOP, stop_stamp_ns=0)
    assert follow_ups.take_due() == [] and follow_ups.next_due_s() is None
    assert follow_ups.hear_answer("another", is_stopped=True) == [] and follow_ups.next_due_s() is None
    assert follow_ups.hear_answer(STOP.command_id, is_stopped=True) == []
    assert follow_ups.next_due_s() == 101.0 and follow_ups.take_due() == []
    clock.now_s = 101.0
    assert follow_ups.take_due() == [command] and follow_ups.take_due() == []


def test_it_never_begins_when_the_robot_does_not_stop(follow_ups, clock):
    command = follow_ups.add("come back.", stop=STOP, stop_stamp_ns=0)
    (ending,) = follow_ups.hear_answer(STOP.command_id, is_stopped=False, reason="The wheels go on.")
    assert (ending.command, ending.outcome, ending.code) == (command, Outcome.FAILED, "NOT_STOPPED")
    assert ending.sentence == "I did not start, because the robot has not stopped. The wheels go on."
    clock.now_s = 200.0
    assert follow_ups.take_due() == []


def test_its_own_stop_spares_it_and_sets_its_stamp(follow_ups, clock):
    command = follow_ups.add("come back.", stop=STOP, stop_stamp_ns=0)
    assert follow_ups.spared_by("Stop.", 2_000_000_000) == frozenset()
    stop_stamp_ns = STOP.stamp_ns + 4_000_000
    assert follow_ups.spared_by(STOP.text, stop_stamp_ns) == {command.command_id}
    follow_ups.hear_answer(STOP.command_id, is_stopped=True)
    clock.now_s += 1.0
    (begun,) = follow_ups.take_due()
    assert begun.command_id == command.command_id and begun.stamp_ns > stop_stamp_ns


def test_stop_that_was_said_to_all_robots_spares_it(follow_ups):
    command = follow_ups.add("come back.", stop=STOP, stop_stamp_ns=0)
    stop_stamp_ns = STOP.stamp_ns + 4_000_000
    assert follow_ups.spared_by("Everybody stop.", stop_stamp_ns) == frozenset()
    assert follow_ups.spared_by("Everybody, stop and come back!", stop_stamp_ns) == {command.command_id}


def test_forgotten_one_does_not_begin(follow_ups, clock):
    command = follow_ups.add("come back.", stop=STOP, stop_stamp_ns=0)
    follow_ups.hear_answer(STOP.command_id, is_stopped=True)
    follow_ups.forget(command.command_id)
    follow_ups.forget("never heard of")
    clock.now_s += 10.0
    assert follow_ups.take_due() == []
