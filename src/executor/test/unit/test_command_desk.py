"""Which command runs, in every order of events."""

import random

import pytest

from executor.command_desk import (
    Cause,
    CommandKey,
    Desk,
    Order,
    Preempt,
    Start,
    Supersede,
    command_cancelled,
    command_ended,
    order_arrives,
    stop_heard,
)


def order(name, stamp_ns):
    return Order(key=CommandKey(command_id=name, stamp_ns=stamp_ns), job=name)


def arrive(desk, name, stamp_ns, now_ns=10**9):
    return order_arrives(desk, order(name, stamp_ns), now_ns=now_ns)


A, B, C = order("a", 1), order("b", 2), order("c", 3)


def test_first_command_starts():
    desk, actions = arrive(Desk(), "a", 1)
    assert actions == (Start(A),)
    assert command_ended(desk) == (Desk(), ())


def test_newer_command_preempts_first_and_starts_afterwards():
    desk, actions = arrive(Desk(running=A), "b", 2)
    assert actions == (Preempt(A, Cause.NEW_COMMAND),)
    assert desk.cause is Cause.NEW_COMMAND
    desk, actions = command_ended(desk)
    assert actions == (Start(B),)
    assert desk == Desk(running=B)


def test_older_command_is_superseded():
    assert arrive(Desk(running=B), "a", 1) == (Desk(running=B), (Supersede(A, Cause.NEW_COMMAND),))


def test_same_stamp_the_later_arrival_wins():
    _, actions = arrive(Desk(running=A), "b", 1)
    assert isinstance(actions[0], Preempt)


def test_only_the_newest_of_many_waits():
    desk, _ = arrive(Desk(running=A), "b", 2)
    desk, actions = arrive(desk, "c", 3)
    assert actions == (Supersede(B, Cause.NEW_COMMAND),)
    desk, actions = arrive(desk, "late", 2)
    assert actions == (Supersede(order("late", 2), Cause.NEW_COMMAND),)
    assert command_ended(desk)[1] == (Start(C),)


def test_stop_ends_what_was_said_before_it():
    desk, actions = stop_heard(Desk(running=A, cause=Cause.NEW_COMMAND, waiting=B), 2)
    assert actions == (Supersede(B, Cause.STOPPED),)
    assert (desk.waiting, desk.cause) == (None, Cause.STOPPED)
    assert command_ended(desk)[1] == ()


def test_stop_preempts_what_runs_once():
    desk, actions = stop_heard(Desk(running=A), 5)
    assert actions == (Preempt(A, Cause.STOPPED),)
    assert stop_heard(desk, 6)[1] == ()


def test_stop_leaves_what_was_said_later():
    desk, actions = stop_heard(Desk(running=B), 1)
    assert actions == () and desk.running == B


@pytest.mark.parametrize("stamp_ns,is_refused", [(4, True), (5, True), (6, False)])
def test_commands_up_to_the_stop_are_refused(stamp_ns, is_refused):
    desk, _ = stop_heard(Desk(), 5)
    desk, _ = stop_heard(desk, 3)
    _, actions = arrive(desk, "x", stamp_ns)
    assert isinstance(actions[0], Supersede if is_refused else Start)


def test_stop_is_forgotten_when_the_clock_was_set_back():
    desk, _ = stop_heard(Desk(), 5_000)
    _, actions = arrive(desk, "x", 10, now_ns=11)
    assert isinstance(actions[0], Start)


def test_one_command_can_be_cancelled_wherever_it_is():
    desk, actions = command_cancelled(Desk(running=A, cause=Cause.NEW_COMMAND, waiting=B), "b")
    assert actions == (Supersede(B, Cause.STOPPED),)
    assert desk.cause is Cause.NEW_COMMAND
    desk, actions = command_cancelled(Desk(running=A), "a")
    assert actions == (Preempt(A, Cause.STOPPED),)
    desk, actions = command_cancelled(Desk(running=A), "c")
    assert actions == ()
    assert arrive(desk, "c", 3)[1] == (Supersede(C, Cause.STOPPED),)


def test_cancelled_ids_are_bounded():
    desk = Desk()
    for index in range(3000):
        desk, _ = command_cancelled(desk, f"id{index % 1500}")
    assert len(desk.cancelled_ids) == 1000
    assert len(set(desk.cancelled_ids)) == 1000


def test_every_order_is_answered_once_and_one_runs_at_a_time():
    for seed in range(300):
        lots = random.Random(seed)
        desk, count, running, ends = Desk(), 0, None, []
        for step in range(200):
            what = lots.random()
            if what < 0.5 and step < 150:
                count += 1
                desk, actions = arrive(desk, f"c{count}", lots.randrange(1000), now_ns=2000)
            elif what < 0.6 and step < 150:
                desk, actions = stop_heard(desk, lots.randrange(1000))
            elif what < 0.65 and step < 150:
                desk, actions = command_cancelled(desk, f"c{lots.randrange(1, count + 2)}")
            elif running is not None:
                ends.append(running)
                running = None
                desk, actions = command_ended(desk)
            else:
                actions = ()
            for action in actions:
                if isinstance(action, Start):
                    assert running is None, f"seed {seed}"
                    running = action.order.key.command_id
                elif isinstance(action, Preempt):
                    assert action.order.key.command_id == running, f"seed {seed}"
                else:
                    ends.append(action.order.key.command_id)
        while running is not None:
            ends.append(running)
            running = None
            desk, actions = command_ended(desk)
            for action in actions:
                running = action.order.key.command_id
        assert sorted(ends) == sorted(f"c{index}" for index in range(1, count + 1)), f"seed {seed}"
