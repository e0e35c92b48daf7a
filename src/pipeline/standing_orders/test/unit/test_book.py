"""The book of standing orders on a virtual clock: due once, never late, one at a time, only if the condition holds."""

from dataclasses import replace
from datetime import datetime, time

import pytest
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, rule

from standing_orders.book import _UNKNOWN, Book, Condition, Rules
from standing_orders.order import StandingOrder
from standing_orders.schedule import After, Daily, Every, Once, next_due_s, utc_s, zone_of

BERLIN = zone_of("Europe/Berlin")
NOW_S = utc_s(datetime(2026, 11, 22, 10), BERLIN)
RULES = Rules(most_orders=3, longest_delay_s=60.0, fresh_s=2.0, pause_s=1.0)
HOLDS, OVER, BLIND = Condition(True), Condition(False), Condition(None, "nobody can tell")


def order(name="a", schedule=None, text="") -> StandingOrder:
    next_s = None if schedule is None else next_due_s(schedule, NOW_S, BERLIN)
    return StandingOrder(name, text or name, "ping", f"I will ping: {name}.", b"", NOW_S, schedule, next_s)


class Clock:
    """A book and two clocks, of which one can be set."""

    def __init__(self, *orders) -> None:
        self.book = Book(orders, BERLIN, RULES, tag="t")
        self.now_s, self.mono_s = NOW_S, 0.0
        self.kept = {one.order_id: one for one in orders}
        self.begun, self.missed = [], []
        #: Whether each command has its reply at once.
        self.is_quick = True

    def turn(self, *, later_s=0.0, set_by_s=0.0, busy_with=None, **conditions):
        self.mono_s += later_s
        self.now_s += later_s + set_by_s
        change = self.book.turn(self.now_s, self.mono_s, busy_with=busy_with, conditions=conditions)
        self.store(change)
        for firing in change.due:
            (self.missed if firing.not_done else self.begun).append((firing.order.order_id, firing.not_done))
        for firing in change.due:
            if not firing.not_done and self.is_quick:
                self.store(self.book.ended(firing.command_id))
        return change

    def store(self, change):
        self.kept.update((one.order_id, one) for one in change.kept)
        for name in change.dropped:
            del self.kept[name]
        assert set(self.kept) == {one.order_id for one in self.book.orders}
        assert tuple(sorted(self.kept.values(), key=lambda one: one.given_s)) == self.book.orders

    def run(self, span_s):
        for _ in range(int(span_s / 30.0)):
            self.turn(later_s=30.0)

    def happened(self, name):
        self.book.happened(name, self.mono_s)

    def restart(self):
        self.book = Book(self.kept.values(), BERLIN, RULES, tag="u")


def test_order_is_done_once_at_its_time():
    clock = Clock(order("a", After(NOW_S + 300.0)))
    clock.turn(later_s=299.0)
    assert not clock.begun
    clock.turn(later_s=1.0)
    clock.turn(later_s=1.0)
    assert (clock.begun, clock.missed, clock.kept) == ([("a", "")], [], {})


def test_order_waits_until_nothing_else_runs_and_is_missed_after_that():
    clock = Clock(order("a", After(NOW_S + 10.0)), order("b", After(NOW_S + 11.0)))
    clock.turn(later_s=12.0, busy_with="I was busy")
    clock.turn(later_s=50.0, busy_with="I was busy")
    clock.turn()
    assert (clock.begun, clock.missed) == ([("a", "")], [])
    clock.turn(later_s=20.0, busy_with="I was busy")
    assert clock.missed == [("b", "I was busy")]
    assert clock.kept == {}


def test_one_order_begins_at_a_time_and_the_one_that_waits_longest_first():
    clock = Clock(order("a", After(NOW_S + 11.0)), order("b", After(NOW_S + 10.0)))
    clock.turn(later_s=10.5, busy_with="I was busy")
    clock.turn(later_s=1.0)
    assert clock.begun == [("b", "")]
    clock.turn()
    assert clock.begun == [("b", ""), ("a", "")]


def test_order_of_a_time_when_the_robot_was_off_is_missed_and_not_done_late():
    clock = Clock(order("a", After(NOW_S + 10.0)), order("b", Daily(time(11))))
    clock.turn()
    clock.now_s, clock.mono_s = clock.now_s + 7200.0, 3.0
    clock.restart()
    clock.turn()
    assert (clock.begun, clock.missed) == ([], [("a", "I was off"), ("b", "I was off")])
    assert set(clock.kept) == {"b"}
    assert clock.kept["b"].next_s == utc_s(datetime(2026, 11, 23, 11), BERLIN)


def test_short_restart_does_not_lose_an_order():
    clock = Clock(order("a", After(NOW_S + 10.0)))
    clock.turn(later_s=11.0, busy_with="I was busy")
    clock.now_s += 20.0
    clock.restart()
    clock.turn()
    assert (clock.begun, clock.missed) == ([("a", "")], [])
    clock.restart()
    clock.turn()
    assert clock.begun == [("a", "")]


def test_order_is_over_when_its_command_has_ended_and_is_not_sent_again():
    clock = Clock(order("a", After(NOW_S + 10.0)))
    clock.is_quick = False
    (sent,) = clock.turn(later_s=10.0).due
    clock.turn(later_s=100.0)
    assert (clock.begun, clock.missed) == ([("a", "")], [])
    clock.restart()
    clock.store(clock.book.left_over([sent.command_id]))
    clock.turn(later_s=10.0)
    assert set(clock.kept) == {"a"}
    clock.restart()
    told = clock.book.left_over([])
    clock.store(told)
    assert [firing.not_done for firing in told.due] == [_UNKNOWN]
    assert clock.kept == {}
    assert clock.book.left_over([]).is_empty
    assert clock.book.ended(sent.command_id).is_empty


def test_event_during_the_command_of_its_order_begins_it_again():
    clock = Clock(order("a"))
    clock.is_quick = False
    clock.happened("a")
    (sent,) = clock.turn(a=HOLDS).due
    clock.happened("a")
    assert not clock.turn(later_s=5.0, a=HOLDS).due
    clock.store(clock.book.ended(sent.command_id))
    assert len(clock.turn(later_s=5.0, a=HOLDS).due) == 1


def test_clock_that_is_set_forward_makes_no_order_late():
    clock = Clock(order("a", Once(datetime(2026, 11, 22, 11))), order("b", After(NOW_S + 300.0)))
    clock.turn()
    clock.turn(later_s=1.0, set_by_s=2 * 3600.0)
    assert (clock.begun, clock.missed) == ([], [("a", "the clock was set forward by 2 hours")])
    clock.turn(later_s=298.0)
    assert clock.begun == []
    clock.turn(later_s=1.0)
    assert clock.begun == [("b", "")]


def test_clock_that_is_set_back_repeats_no_order():
    clock = Clock(order("a", Daily(time(10, 30))), order("b", Every(NOW_S + 600.0, 600.0)))
    clock.run(1860.0)
    assert sorted(clock.begun) == [("a", "")] + 3 * [("b", "")]
    clock.turn(set_by_s=-3600.0)
    clock.run(1800.0)
    assert sorted(clock.begun) == [("a", "")] + 6 * [("b", "")]
    assert clock.missed == []


def test_clock_that_was_a_year_ahead_loses_no_daily_order():
    clock = Clock(replace(order("a", Daily(time(11))), next_s=NOW_S + 366 * 86_400.0))
    clock.now_s += 365 * 86_400.0
    clock.turn()
    clock.turn(set_by_s=-365 * 86_400.0)
    clock.turn(later_s=3600.0)
    assert clock.begun == [("a", "")]


def test_condition_is_checked_at_the_moment_of_the_beginning():
    clock = Clock(order("a"))
    clock.happened("a")
    clock.turn(busy_with="I was busy", a=HOLDS)
    clock.turn(later_s=10.0, a=OVER)
    assert (clock.begun, clock.missed) == ([], [("a", "it was over when I was free")])
    clock.happened("a")
    clock.turn(later_s=10.0, a=HOLDS)
    assert clock.begun == [("a", "")]


def test_event_that_is_over_counts_while_it_is_fresh_and_its_source_lives():
    clock = Clock(order("a"))
    clock.happened("a")
    clock.turn(later_s=0.1, a=OVER)
    assert clock.begun == [("a", "")]
    clock.mono_s += 5.0
    clock.happened("a")
    clock.turn(later_s=0.1, a=BLIND)
    assert clock.missed == [("a", "nobody can tell")]


def test_condition_that_flickers_begins_one_order_a_second():
    clock = Clock(order("a"))
    for _ in range(20):
        clock.happened("a")
        clock.turn(later_s=0.1, a=HOLDS)
    assert len(clock.begun) == 2


def test_stop_suspends_every_order_also_over_a_restart():
    clock = Clock(order("a", After(NOW_S + 10.0)), order("b"), order("c", Every(NOW_S + 20.0, 20.0)))
    clock.happened("b")
    clock.store(clock.book.suspend())
    clock.restart()
    clock.turn(later_s=1.0, b=HOLDS)
    clock.happened("b")
    clock.turn(later_s=10.0, b=HOLDS)
    assert (clock.begun, clock.missed) == ([], [("a", 'you stopped me and did not say "go on"')])
    clock.turn(later_s=100.0, b=HOLDS)
    clock.store(clock.book.resume(clock.now_s))
    clock.turn()
    assert clock.begun == []
    clock.happened("b")
    clock.turn(b=HOLDS)
    clock.turn(later_s=20.0)
    assert clock.begun == [("b", ""), ("c", "")]


def test_orders_are_bounded_and_said_twice_are_one():
    clock = Clock(order("a", text="Whenever the bell rings, ping."), order("b", Daily(time(7)), text="ping daily"))
    assert clock.book.same_as(order("x", text="whenever the bell rings, ping")).order_id == "a"
    assert clock.book.same_as(order("x", Daily(time(7)), text="ping daily")).order_id == "b"
    assert clock.book.same_as(order("x", Daily(time(8)), text="ping daily")) is None
    assert not clock.book.is_full
    clock.store(clock.book.give(order("c", After(NOW_S + 300.0), text="in five minutes")))
    assert clock.book.same_as(order("x", After(NOW_S + 300.0), text="in five minutes")) is None
    assert clock.book.is_full
    clock.store(clock.book.drop(["a", "unknown"]))
    assert not clock.book.is_full


class AnyHistory(RuleBasedStateMachine):
    """Orders, clocks that are set, restarts, stops and busy times in any order."""

    @initialize()
    def begin(self):
        self.clock = Clock()
        self.names = 0
        self.told = []
        self.once = set()

    @rule(kind=st.sampled_from(["span", "clock", "daily", "every", "event"]), span_s=st.floats(1.0, 9000.0))
    def give(self, kind, span_s):
        if self.clock.book.is_full:
            return
        due_s = self.clock.now_s + span_s
        shown = datetime.fromtimestamp(due_s, BERLIN).replace(tzinfo=None)
        schedule = {
            "span": After(due_s),
            "clock": Once(shown),
            "daily": Daily(shown.time()),
            "every": Every(due_s, max(10.0, span_s)),
        }.get(kind)
        self.names += 1
        if kind in ("span", "clock"):
            self.once.add(f"o{self.names}")
        next_s = schedule and next_due_s(schedule, self.clock.now_s, BERLIN)
        one = StandingOrder(f"o{self.names}", "x", "ping", "x", b"", self.clock.now_s, schedule, next_s)
        self.clock.store(self.clock.book.give(one))

    @rule(later_s=st.floats(0.0, 9000.0), set_by_s=st.sampled_from([0.0, 0.0, 3600.0, -3600.0]), is_busy=st.booleans())
    def turn(self, later_s, set_by_s, is_busy):
        before = {one.order_id: one for one in self.clock.book.orders}
        holds = dict.fromkeys(before, HOLDS)
        change = self.clock.turn(later_s=later_s, set_by_s=set_by_s, busy_with="x" if is_busy else None, **holds)
        begun = [firing for firing in change.due if not firing.not_done]
        assert len(begun) <= (0 if is_busy else 1)
        for firing in change.due:
            self.told.append(firing.command_id)
            assert not (before[firing.order.order_id].is_suspended and not firing.not_done)

    @rule()
    def stop(self):
        self.clock.store(self.clock.book.suspend())
        assert all(one.is_suspended for one in self.clock.book.orders)

    @rule()
    def go_on(self):
        self.clock.store(self.clock.book.resume(self.clock.now_s))
        assert not any(one.is_suspended for one in self.clock.book.orders)

    @rule()
    def restart(self):
        self.clock.restart()
        self.clock.book._tag = f"r{len(self.told)}-{self.names}"

    @rule()
    def event(self):
        for one in self.clock.book.orders:
            if one.schedule is None:
                self.clock.happened(one.order_id)

    @invariant()
    def nothing_is_told_twice(self):
        if hasattr(self, "told"):
            assert len(self.told) == len(set(self.told))
            told = [name for name, _ in self.clock.begun + self.clock.missed if name in self.once]
            assert len(told) == len(set(told))
            assert not set(told) & set(self.clock.kept)


AnyHistory.TestCase.settings = settings(max_examples=60, stateful_step_count=40, deadline=None)
TestAnyHistory = AnyHistory.TestCase


@pytest.mark.parametrize("schedule", [After(NOW_S + 10.0), Once(datetime(2026, 11, 22, 10, 0, 10))])
def test_single_order_is_told_exactly_once_whatever_happens(schedule):
    for is_busy in (False, True):
        clock = Clock(order("a", schedule))
        for _ in range(10):
            clock.turn(later_s=20.0, busy_with="x" if is_busy else None)
            clock.restart()
        assert len(clock.begun) + len(clock.missed) == 1
