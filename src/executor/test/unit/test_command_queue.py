"""Which command runs, in every order of events."""

import random

import pytest

from executor import command_queue
from executor.command_queue import Cause, CommandKey, CommandQueue, Order, Preempt, Start, Supersede


def order(name, stamp_ns):
    return Order(key=CommandKey(command_id=name, stamp_ns=stamp_ns), job=name)


def submit(queue, name, stamp_ns, now_ns=10**9):
    return command_queue.submit(queue, order(name, stamp_ns), now_ns=now_ns)


def stop(queue, stop_stamp_ns, now_ns=10**9):
    return command_queue.stop(queue, stop_stamp_ns, now_ns=now_ns)


A, B, C = order("a", 1), order("b", 2), order("c", 3)


def test_first_command_starts():
    queue, actions = submit(CommandQueue(), "a", 1)
    assert actions == (Start(A),)
    assert command_queue.finish(queue) == (CommandQueue(), ())


def test_newer_command_preempts_first_and_starts_afterwards():
    queue, actions = submit(CommandQueue(running=A), "b", 2)
    assert actions == (Preempt(A, Cause.NEW_COMMAND),)
    assert queue.cause is Cause.NEW_COMMAND
    queue, actions = command_queue.finish(queue)
    assert actions == (Start(B),)
    assert queue == CommandQueue(running=B)


def test_older_command_is_superseded():
    assert submit(CommandQueue(running=B), "a", 1) == (CommandQueue(running=B), (Supersede(A, Cause.NEW_COMMAND),))


def test_same_stamp_the_later_arrival_wins():
    _, actions = submit(CommandQueue(running=A), "b", 1)
    assert isinstance(actions[0], Preempt)


def test_only_the_newest_of_many_waits():
    queue, _ = submit(CommandQueue(running=A), "b", 2)
    queue, actions = submit(queue, "c", 3)
    assert actions == (Supersede(B, Cause.NEW_COMMAND),)
    queue, actions = submit(queue, "late", 2)
    assert actions == (Supersede(order("late", 2), Cause.NEW_COMMAND),)
    assert command_queue.finish(queue)[1] == (Start(C),)


def test_order_for_a_free_robot_begins_only_then_and_gives_way_to_any_command():
    late = Order(key=CommandKey("late", 9), job="late", begins_when_free=True)
    queue, actions = command_queue.submit(CommandQueue(), late, now_ns=10**9)
    assert actions == (Start(late),)
    _, actions = submit(queue, "a", 1)
    assert actions == (Preempt(late, Cause.NEW_COMMAND),)
    for busy in (CommandQueue(running=A), CommandQueue(running=A, cause=Cause.STOPPED), queue):
        other = Order(key=CommandKey("other", 10), job="other", begins_when_free=True)
        assert command_queue.submit(busy, other, now_ns=10**9) == (busy, (Supersede(other, Cause.NOT_FREE),))


def test_stop_ends_what_was_said_before_it():
    queue, actions = stop(CommandQueue(running=A, cause=Cause.NEW_COMMAND, waiting=B), 2)
    assert actions == (Supersede(B, Cause.STOPPED),)
    assert (queue.waiting, queue.cause) == (None, Cause.STOPPED)
    assert command_queue.finish(queue)[1] == ()


def test_stop_preempts_what_runs_once():
    queue, actions = stop(CommandQueue(running=A), 5)
    assert actions == (Preempt(A, Cause.STOPPED),)
    assert stop(queue, 6)[1] == ()


def test_stop_leaves_what_was_said_later():
    queue, actions = stop(CommandQueue(running=B), 1)
    assert actions == () and queue.running == B


@pytest.mark.parametrize("stamp_ns,is_refused", [(4, True), (5, True), (6, False)])
def test_commands_up_to_the_stop_are_refused(stamp_ns, is_refused):
    queue, _ = stop(CommandQueue(), 5)
    queue, _ = stop(queue, 3)
    _, actions = submit(queue, "x", stamp_ns)
    assert isinstance(actions[0], Supersede if is_refused else Start)


def test_stop_is_forgotten_when_the_clock_was_set_back():
    queue, _ = stop(CommandQueue(), 5_000)
    _, actions = submit(queue, "x", 10, now_ns=11)
    assert isinstance(actions[0], Start)


def test_one_command_can_be_cancelled_wherever_it_is():
    queue, actions = command_queue.cancel(CommandQueue(running=A, cause=Cause.NEW_COMMAND, waiting=B), "b")
    assert actions == (Supersede(B, Cause.STOPPED),)
    assert queue.cause is Cause.NEW_COMMAND
    queue, actions = command_queue.cancel(CommandQueue(running=A), "a")
    assert actions == (Preempt(A, Cause.STOPPED),)
    queue, actions = command_queue.cancel(CommandQueue(running=A), "c")
    assert actions == ()
    assert submit(queue, "c", 3)[1] == (Supersede(C, Cause.STOPPED),)


def test_cancelled_ids_are_bounded():
    queue = CommandQueue()
    for index in range(3000):
        queue, _ = command_queue.cancel(queue, f"id{index % 1500}")
    assert len(queue.cancelled_ids) == 1000
    assert len(set(queue.cancelled_ids)) == 1000


def test_every_order_is_answered_once_and_one_runs_at_a_time():
    for seed in range(300):
        lots = random.Random(seed)
        queue, count, running, ends = CommandQueue(), 0, None, []
        for step in range(200):
            what = lots.random()
            if what < 0.5 and step < 150:
                count += 1
                queue, actions = submit(queue, f"c{count}", lots.randrange(1000), now_ns=2000)
            elif what < 0.6 and step < 150:
                queue, actions = stop(queue, lots.randrange(1000))
            elif what < 0.65 and step < 150:
                queue, actions = command_queue.cancel(queue, f"c{lots.randrange(1, count + 2)}")
            elif running is not None:
                ends.append(running)
                running = None
                queue, actions = command_queue.finish(queue)
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
            queue, actions = command_queue.finish(queue)
            for action in actions:
                running = action.order.key.command_id
        assert sorted(ends) == sorted(f"c{index}" for index in range(1, count + 1)), f"seed {seed}"


def test_command_from_before_the_clock_was_set_back_is_older_than_a_new_one():
    hour_ns = 3600 * 10**9
    old = order("old", hour_ns)
    queue, actions = submit(CommandQueue(running=old), "new", 5 * 10**9, now_ns=5 * 10**9)
    assert actions == (Preempt(old, Cause.NEW_COMMAND),)
    assert queue.waiting == order("new", 5 * 10**9)


def test_stop_ends_a_command_from_before_the_clock_was_set_back():
    old = order("old", 3600 * 10**9)
    _, actions = stop(CommandQueue(running=old), 5 * 10**9, now_ns=5 * 10**9)
    assert actions == (Preempt(old, Cause.STOPPED),)


def test_stop_leaves_a_command_that_was_said_just_after_it():
    _, actions = stop(CommandQueue(running=order("after", 5 * 10**9 + 1000)), 5 * 10**9, now_ns=5 * 10**9)
    assert actions == ()
