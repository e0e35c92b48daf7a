"""Which command runs, in every order of events."""

import random

import pytest

from executor import command_queue
from executor.command_queue import Beginning, Cause, CommandKey, CommandQueue, Order, Preempt, Running, Start, Supersede


def order(name, stamp_ns):
    return Order(key=CommandKey(command_id=name, stamp_ns=stamp_ns), job=name)


def submit(queue, name, stamp_ns, now_ns=10**9):
    return command_queue.submit(queue, order(name, stamp_ns), now_ns=now_ns)


def stop(queue, stop_stamp_ns, now_ns=10**9):
    return command_queue.stop(queue, stop_stamp_ns, now_ns=now_ns)


A, B, C = order("a", 1), order("b", 2), order("c", 3)
NAV, BASE, VOICE = frozenset(["base", "head"]), frozenset(["base"]), frozenset(["voice"])


def running(one, cause=None, *waiting):
    return CommandQueue(running=(Running(one, cause),), waiting=waiting)


def begun(name, stamp_ns, beginning, resources=None):
    return Order(CommandKey(name, stamp_ns), name, beginning, resources)


def offer(queue, one):
    return command_queue.submit(queue, one, now_ns=10**9)


def test_first_command_starts():
    queue, actions = submit(CommandQueue(), "a", 1)
    assert actions == (Start(A),)
    assert command_queue.finish(queue, "a") == (CommandQueue(), ())


def test_newer_command_preempts_first_and_starts_afterwards():
    queue, actions = submit(running(A), "b", 2)
    assert actions == (Preempt(A, Cause.NEW_COMMAND),)
    assert queue.cause_of("a") is Cause.NEW_COMMAND
    queue, actions = command_queue.finish(queue, "a", is_done=False)
    assert actions == (Start(B),)
    assert queue == running(B)


def test_older_command_is_superseded():
    assert submit(running(B), "a", 1) == (running(B), (Supersede(A, Cause.NEW_COMMAND),))


def test_same_stamp_the_later_arrival_wins():
    _, actions = submit(running(A), "b", 1)
    assert isinstance(actions[0], Preempt)


def test_only_the_newest_of_many_waits():
    queue, _ = submit(running(A), "b", 2)
    queue, actions = submit(queue, "c", 3)
    assert actions == (Supersede(B, Cause.NEW_COMMAND),)
    queue, actions = submit(queue, "late", 2)
    assert actions == (Supersede(order("late", 2), Cause.NEW_COMMAND),)
    assert command_queue.finish(queue, "a")[1] == (Start(C),)


def test_order_for_a_free_robot_begins_only_then_and_gives_way_to_any_command():
    late = begun("late", 9, Beginning.WHEN_FREE)
    queue, actions = offer(CommandQueue(), late)
    assert actions == (Start(late),)
    _, actions = submit(queue, "a", 1)
    assert actions == (Preempt(late, Cause.NEW_COMMAND),)
    other = begun("other", 10, Beginning.WHEN_FREE)
    for busy in (running(A), running(A, Cause.STOPPED), queue):
        assert offer(busy, other) == (busy, (Supersede(other, Cause.NOT_FREE),))


def test_what_follows_begins_when_everything_before_it_has_ended():
    then, last = begun("then", 2, Beginning.FOLLOW), begun("last", 3, Beginning.FOLLOW)
    assert offer(CommandQueue(), then)[1] == (Start(then),)
    queue, actions = offer(running(A), then)
    assert actions == ()
    queue, _ = offer(queue, last)
    queue, actions = command_queue.finish(queue, "a")
    assert actions == (Start(then),)
    queue, actions = command_queue.finish(queue, "then")
    assert actions == (Start(last),)
    # A new command takes the place of all of them.
    queue, _ = offer(running(A, None, then), last)
    assert submit(queue, "new", 4)[1] == (
        Supersede(then, Cause.NEW_COMMAND),
        Supersede(last, Cause.NEW_COMMAND),
        Preempt(A, Cause.NEW_COMMAND),
    )


def test_what_follows_does_not_begin_when_what_it_follows_has_failed():
    then, last = begun("then", 2, Beginning.FOLLOW), begun("last", 3, Beginning.FOLLOW)
    queue, actions = command_queue.finish(running(A, None, then, last), "a", is_done=False)
    assert actions == (Supersede(then, Cause.NOT_BEGUN), Supersede(last, Cause.NOT_BEGUN))
    assert queue == CommandQueue()
    assert command_queue.finish(running(A, Cause.NEW_COMMAND, B, then), "a", is_done=False)[1] == (Start(B),)


@pytest.mark.parametrize(
    ("first", "second", "is_begun"),
    [
        (BASE, VOICE, True),
        (NAV, BASE, False),
        (None, VOICE, False),
        (VOICE, None, False),
        (None, frozenset(), True),
        (frozenset(), None, True),
        (None, None, False),
    ],
)
def test_what_runs_beside_something_needs_other_resources(first, second, is_begun):
    one, other = begun("a", 1, Beginning.REPLACE, first), begun("b", 2, Beginning.BESIDE, second)
    queue, actions = offer(running(one), other)
    assert actions == ((Start(other),) if is_begun else (Supersede(other, Cause.NOT_BESIDE, one),))
    assert len(queue.running) == (2 if is_begun else 1)


def test_all_that_runs_is_preempted_for_a_new_command_and_for_a_stop():
    one, other = begun("a", 1, Beginning.REPLACE, BASE), begun("b", 2, Beginning.BESIDE, VOICE)
    queue, _ = offer(running(one), other)
    replaced, actions = submit(queue, "c", 3)
    assert actions == (Preempt(one, Cause.NEW_COMMAND), Preempt(other, Cause.NEW_COMMAND))
    replaced, actions = command_queue.finish(replaced, "a", is_done=False)
    assert actions == ()
    assert command_queue.finish(replaced, "b", is_done=False)[1] == (Start(C),)
    assert stop(queue, 2)[1] == (Preempt(one, Cause.STOPPED), Preempt(other, Cause.STOPPED))
    assert command_queue.cancel(queue, "b")[1] == (Preempt(other, Cause.STOPPED),)


def test_what_waits_and_what_runs_is_bounded():
    queue = running(A)
    for number in range(command_queue.MOST_WAITING):
        queue, actions = offer(queue, begun(f"c{number}", 2 + number, Beginning.FOLLOW))
        assert actions == ()
    late = begun("late", 100, Beginning.FOLLOW)
    assert offer(queue, late)[1] == (Supersede(late, Cause.TOO_MANY),)


def test_stop_ends_what_was_said_before_it():
    queue, actions = stop(running(A, Cause.NEW_COMMAND, B), 2)
    assert actions == (Supersede(B, Cause.STOPPED),)
    assert (queue.waiting, queue.cause_of("a")) == ((), Cause.STOPPED)
    assert command_queue.finish(queue, "a")[1] == ()


def test_stop_preempts_what_runs_once():
    queue, actions = stop(running(A), 5)
    assert actions == (Preempt(A, Cause.STOPPED),)
    assert stop(queue, 6)[1] == ()


def test_stop_leaves_what_was_said_later():
    queue, actions = stop(running(B), 1)
    assert actions == () and queue.running == (Running(B),)


@pytest.mark.parametrize("stamp_ns,is_refused", [(4, True), (5, True), (6, False)])
def test_commands_up_to_the_stop_are_refused(stamp_ns, is_refused):
    queue, _ = stop(CommandQueue(), 5)
    queue, _ = stop(queue, 3)
    _, actions = submit(queue, "x", stamp_ns)
    assert isinstance(actions[0], Supersede if is_refused else Start)


def test_stop_is_forgotten_when_the_clock_was_set_back():
    queue, _ = stop(CommandQueue(), 5_000_000_000)
    _, actions = submit(queue, "x", 10, now_ns=11)
    assert isinstance(actions[0], Start)


def test_one_command_can_be_cancelled_wherever_it_is():
    queue, actions = command_queue.cancel(running(A, Cause.NEW_COMMAND, B), "b")
    assert actions == (Supersede(B, Cause.STOPPED),)
    assert queue.cause_of("a") is Cause.NEW_COMMAND
    queue, actions = command_queue.cancel(running(A), "a")
    assert actions == (Preempt(A, Cause.STOPPED),)
    queue, actions = command_queue.cancel(running(A), "c")
    assert actions == ()
    assert submit(queue, "c", 3)[1] == (Supersede(C, Cause.STOPPED),)


def test_cancelled_ids_are_bounded():
    queue = CommandQueue()
    for index in range(3000):
        queue, _ = command_queue.cancel(queue, f"id{index % 1500}")
    assert len(queue.cancelled_ids) == 1000
    assert len(set(queue.cancelled_ids)) == 1000


def test_every_order_is_answered_once_and_only_what_shares_nothing_runs_together():
    for seed in range(300):
        lots = random.Random(seed)
        queue, count, at_work, ends = CommandQueue(), 0, {}, []
        for step in range(400):
            what = lots.random()
            actions = ()
            if what < 0.5 and step < 150:
                count += 1
                resources = lots.choice([None, BASE, VOICE, NAV, frozenset()])
                one = begun(f"c{count}", lots.randrange(1000), lots.choice(list(Beginning)), resources)
                queue, actions = command_queue.submit(queue, one, now_ns=2000)
            elif what < 0.6 and step < 150:
                queue, actions = stop(queue, lots.randrange(1000))
            elif what < 0.65 and step < 150:
                queue, actions = command_queue.cancel(queue, f"c{lots.randrange(1, count + 2)}")
            elif at_work:
                name = lots.choice(sorted(at_work))
                ends.append(name)
                del at_work[name]
                queue, actions = command_queue.finish(queue, name, is_done=lots.random() < 0.7)
            for action in actions:
                name = action.order.key.command_id
                if isinstance(action, Start):
                    for other in at_work.values():
                        assert action.order.shared_with(other) == frozenset(), f"seed {seed}"
                    at_work[name] = action.order
                elif isinstance(action, Preempt):
                    assert name in at_work, f"seed {seed}"
                else:
                    ends.append(name)
        assert not at_work, f"seed {seed}"
        assert sorted(ends) == sorted(f"c{index}" for index in range(1, count + 1)), f"seed {seed}"


def test_command_from_before_the_clock_was_set_back_is_older_than_a_new_one():
    hour_ns = 3600 * 10**9
    old = order("old", hour_ns)
    queue, actions = submit(running(old), "new", 5 * 10**9, now_ns=5 * 10**9)
    assert actions == (Preempt(old, Cause.NEW_COMMAND),)
    assert queue.waiting == (order("new", 5 * 10**9),)


def test_stop_ends_a_command_from_before_the_clock_was_set_back():
    old = order("old", 3600 * 10**9)
    _, actions = stop(running(old), 5 * 10**9, now_ns=5 * 10**9)
    assert actions == (Preempt(old, Cause.STOPPED),)


def test_stop_leaves_a_command_that_was_said_just_after_it():
    _, actions = stop(running(order("after", 5 * 10**9 + 1000)), 5 * 10**9, now_ns=5 * 10**9)
    assert actions == ()


@pytest.mark.parametrize(
    "now_ns, pause_s",
    [(10**9, 0.06), (10**9 + 40_000_000, 0.02), (10**9 + 60_000_000, 0.0), (10**9 - 4, 0.06), (10**9 - 2_000_000, 0.0)]
    + [(10**10, 0.0)],
)
def test_no_goal_is_sent_right_after_a_stop(now_ns, pause_s):
    stopped, _ = stop(CommandQueue(), 10**9)
    after = command_queue.after_stop(stopped, now_ns=now_ns)
    assert after.pause_s == pytest.approx(pause_s)
    # The clock of a simulator may stand during the pause, and the stamp of the stop be some nanoseconds ahead of it.
    assert after.stamp_ns == (10**9 + command_queue.PAUSE_AFTER_STOP_NS if pause_s else 0)
    assert command_queue.after_stop(CommandQueue(), now_ns=now_ns) == command_queue.AfterStop()
