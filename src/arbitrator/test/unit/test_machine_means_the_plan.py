"""Random plans in random worlds: the SMACH machine does what the reference interpreter says.

Every run is under one preemption, at any time; servers fail, are slow to end or do not heed cancels, sources answer
late, change, and die.
"""

import itertools
import logging
import math
import threading

import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from reference_interpreter import Interpreter
from virtual_plans import Attempt, QuickClock, Source, World, run_on, run_virtually

import smach
from arbitrator.plan import (
    AllOf,
    AnyOf,
    Candidate,
    Condition,
    Do,
    Fallback,
    If,
    InAnyOrder,
    InParallel,
    InSequence,
    Limit,
    Repeat,
    Trigger,
    Until,
    Wait,
    While,
)
from arbitrator.plan_nodes import from_nodes, to_nodes
from typed_arguments import FilledFrame

DEEPEST = 4
KINDS = "do sequence fallback parallel any_order if until for while repeat wait"
OUTCOMES = st.sampled_from(("succeeded", "succeeded", "succeeded", "aborted", "preempted"))


@pytest.fixture(autouse=True, scope="module")
def silence():
    """Transitions of thousands of machines are no news."""
    smach.set_loggers(*[lambda *words: None] * 4)
    yield
    smach.set_loggers(logging.info, logging.warning, logging.debug, logging.error)


def _primes():
    known = []
    number = 1
    while True:
        number += 1
        if all(number % prime for prime in known):
            known.append(number)
            yield number


class Draw:
    """Draws the parts of a case. No two times, nor sums of times, are equal: at each instant one thing happens."""

    def __init__(self, draw, kinds=KINDS, *, is_plain=False):
        """`is_plain`: without conditions, limits and endless repetitions, and everything succeeds."""
        self.draw = draw
        self.kinds, self.is_plain = kinds, is_plain
        self.primes = _primes()
        self.names = 0
        self.world = World({}, {})

    def chance(self, of):
        return self.draw(st.integers(0, of - 1)) == 0

    def time(self, most):
        return self.draw(st.integers(1, 4 * most)) / 4 + math.sqrt(next(self.primes)) % 1 / 8

    def name(self, kind):
        self.names += 1
        return f"{kind}{self.names}"

    def limit(self):
        return Limit(self.time(10)) if not self.is_plain and self.chance(5) else Limit()

    def frame(self):
        name = self.name("f")
        self.world.attempts[name] = tuple(
            Attempt(
                self.time(5),
                "succeeded" if self.is_plain else self.draw(OUTCOMES),
                cancel_s=0.0 if self.chance(2) else self.time(1),
                heeds_cancel=not self.chance(6),
            )
            for _ in range(self.draw(st.integers(1, 3)))
        )
        return FilledFrame(name=name, server="server")

    def do(self):
        candidates = tuple(
            Candidate(tuple(self.frame() for _ in range(self.draw(st.sampled_from((1, 1, 2))))))
            for _ in range(self.draw(st.sampled_from((1, 1, 2))))
        )
        return Do(self.name("do"), candidates, self.limit())

    def condition(self, *, may_begin, level=0):
        trigger = Trigger.BEGINS if may_begin and self.chance(3) else Trigger.HOLDS
        is_negated = self.chance(3)
        if level < 2 and self.chance(4):
            children = tuple(
                self.condition(may_begin=False, level=level + 1) for _ in range(self.draw(st.integers(1, 3)))
            )
            kind = AllOf if self.chance(2) else AnyOf
            return kind(self.name("c"), children, trigger, is_negated)
        name = self.name("s")
        at_s, changes = 0.0, []
        is_true = self.chance(2)
        if not self.chance(4):
            changes.append((-1.0, is_true))
        for _ in range(self.draw(st.integers(0, 4))):
            at_s += self.time(8)
            is_true = not is_true
            changes.append((at_s, is_true))
        if self.chance(5):
            changes.append((at_s + self.time(8), "its sensor is silent"))
        self.world.sources[name] = Source(tuple(changes), answer_s=self.time(1) if self.chance(2) else 0.0)
        watcher = FilledFrame(name=name, server="watcher")
        return Condition(self.name("c"), (Candidate((watcher,)),), trigger, is_negated)

    def children(self, level):
        return tuple(self.plan(level + 1) for _ in range(self.draw(st.integers(1, 3))))

    def after(self, count):
        if self.chance(2):
            return ()
        order = self.draw(st.permutations(range(count)))
        return tuple(
            tuple(sorted(before for before in order[: order.index(place)] if self.chance(2))) for place in range(count)
        )

    def plan(self, level=0):
        kinds = "do wait" if level >= DEEPEST else self.kinds
        kind = self.draw(st.sampled_from(kinds.split()))
        label = self.name(kind)
        if kind == "do":
            return self.do()
        if kind == "sequence":
            return InSequence(label, self.children(level), self.limit())
        if kind == "fallback":
            return Fallback(label, self.children(level), self.limit())
        if kind == "parallel":
            children = self.children(level)
            count = 0 if self.is_plain else self.draw(st.integers(0, len(children)))
            return InParallel(label, children, count, self.limit())
        if kind == "any_order":
            children = self.children(level)
            after = self.after(len(children))
            return InAnyOrder(label, children, after if any(after) else (), self.limit())
        if kind == "if":
            otherwise = self.plan(level + 1) if self.chance(2) else None
            return If(label, self.condition(may_begin=False), self.plan(level + 1), otherwise, self.limit())
        if kind == "until":
            return Until(label, self.plan(level + 1), self.condition(may_begin=True), limit=self.limit())
        if kind == "for":
            return Until(label, self.plan(level + 1), None, self.time(8), self.limit())
        if kind == "while":
            return While(label, self.condition(may_begin=False), self.plan(level + 1), self.limit())
        if kind == "repeat":
            count = self.draw(st.integers(int(self.is_plain), 3))
            most = self.draw(st.sampled_from((0, count, count + 2)))
            return Repeat(
                label, self.plan(level + 1), count, most, self.time(4) if self.chance(3) else 0.0, self.limit()
            )
        if self.is_plain or self.chance(3):
            return Wait(label, None, self.time(5), self.limit())
        return Wait(label, self.condition(may_begin=True), limit=self.limit())


@st.composite
def cases(draw, kinds=KINDS, *, is_plain=False):
    drawing = Draw(draw, kinds, is_plain=is_plain)
    plan = drawing.plan()
    drawing.world.preempt_s = drawing.time(40)
    return plan, drawing.world


def by_instant(log):
    return sorted((round(at_s, 6), text) for at_s, text in log)


def check(case):
    plan, world = case
    assert from_nodes(to_nodes(plan)) == plan
    reference = Interpreter(plan, world)
    result = reference.run()
    stage = run_virtually(plan, world)
    assert by_instant(stage.log) == by_instant(reference.log)
    assert stage.result == result
    check_that_nothing_is_left(stage)


def check_that_nothing_is_left(stage):
    assert not stage.running, "a goal was left running"
    assert not stage.watched, "a condition was left watched"
    assert not [thread for thread in threading.enumerate() if thread.name.startswith("concurrence_")]


COMMON = {"deadline": None, "database": None, "suppress_health_check": list(HealthCheck)}


@settings(max_examples=300, derandomize=True, **COMMON)
@given(cases())
def test_machine_does_what_the_reference_says(case):
    check(case)


@pytest.mark.acceptance
@settings(max_examples=10_000, **COMMON)
@given(cases())
def test_machine_does_what_the_reference_says_in_ten_thousand_cases(case):
    check(case)


# On the real clock, instants have to be further apart than a busy machine is late; a later one gets more attempts.
FACTOR, MARGIN_S, ATTEMPTS = 20.0, 1.5, 3


@pytest.mark.acceptance
@settings(max_examples=200, **COMMON)
@given(cases())
def test_machine_does_what_the_reference_says_on_the_real_clock(case):
    plan, world = case
    reference = Interpreter(plan, world)
    result = reference.run()
    # Also the first that would have come after the end.
    instants = [0.0, *reference.instants, min(at_s for at_s in reference.wakes if at_s > reference.now_s)]
    assume(not reference.has_race)
    assume(all(later - earlier >= MARGIN_S for earlier, later in zip(instants, instants[1:])))
    groups = itertools.groupby(by_instant(reference.log), key=lambda entry: entry[0])
    expected = [sorted(text for _, text in group) for _, group in groups]
    for _ in range(ATTEMPTS):
        stage = run_on(QuickClock(FACTOR), plan, world)
        check_that_nothing_is_left(stage)
        told = [text for _, text in stage.log]
        heard = [sorted(told.pop(0) for _ in group if told) for group in expected]
        if (heard, told, stage.result) == (expected, [], result):
            return
    assert (heard, told, stage.result) == (expected, [], result)
