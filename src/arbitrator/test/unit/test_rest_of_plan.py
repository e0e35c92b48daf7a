"""What is left of a plan that was stopped: with what was done before it makes the whole, and nothing twice."""

import logging
import math
from collections import Counter
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from test_machine_means_the_plan import COMMON, cases
from virtual_plans import Attempt, Stage, VirtualClock, World

import smach
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
)
from arbitrator.rest_of_plan import Progress
from typed_arguments import FilledFrame, Measure, TypedArgument

FAR = math.inf


@pytest.fixture(autouse=True, scope="module")
def silence():
    smach.set_loggers(*[lambda *words: None] * 4)
    yield
    smach.set_loggers(logging.info, logging.warning, logging.debug, logging.error)


def do(name, *arguments):
    return Do(name, (Candidate((FilledFrame(name=name, arguments=arguments, server="server"),)),))


def watched(name):
    return Condition(name, (Candidate((FilledFrame(name=name, server="watcher"),)),))


def run(plan, world):
    """Carry out a plan; returns the stage and what is left."""
    clock = VirtualClock()
    progress = Progress(plan, now=clock.now_s)
    stage = Stage(plan, world, clock, also_observe=progress.hear)
    stage.result = stage.run(clock.at)
    return stage, progress.rest()


def done(stage):
    return Counter(text.split()[1] for _, text in stage.log if text.startswith("goal") and text.endswith("succeeded"))


def stopped(plan, at_s, **attempts):
    """Stop a plan at a time; each frame takes a second unless something else is said."""
    return run(plan, World(attempts, {}, preempt_s=at_s))


A, B, C = do("a"), do("b"), do("c")


@pytest.mark.parametrize(
    ("plan", "at_s", "left", "said"),
    [
        (A, 0.5, A, '"a"'),
        (A, 1.5, None, None),
        (InSequence("all", (A, B, C)), 0.5, InSequence("all", (A, B, C)), '"a", "b" and "c"'),
        (InSequence("all", (A, B, C)), 1.5, InSequence("all", (B, C)), '"b" and "c"'),
        (InSequence("all", (A, B, C)), 2.5, C, '"c"'),
        (InParallel("all", (InSequence("ab", (A, B)), C)), 1.5, InParallel("all", (B,)), '"b"'),
        (Repeat("all", A, 3, 3), 0.5, Repeat("all", A, 3, 3), '"a" 3 times'),
        (Repeat("all", A, 3, 3), 1.5, Repeat("all", A, 2, 2), '"a" 2 times'),
        (Repeat("all", A, 2, 2), 1.5, A, '"a"'),
        (Repeat("all", A), 5.5, Repeat("all", A), '"a"'),
        (
            Repeat("all", InSequence("ab", (A, B)), 3, 3),
            3.5,
            InSequence("all", (B, Repeat("all", InSequence("ab", (A, B)), 1, 1))),
            '"b" and "a" and "b"',
        ),
        (If("all", watched("x"), InSequence("ab", (A, B)), C), 1.5, B, '"b"'),
        (Until("all", InSequence("ab", (A, B)), None, 10.0), 1.5, Until("all", B, None, 8.5), '"all"'),
        (Wait("w", None, 4.0), 1.0, Wait("w", None, 3.0), '"w"'),
        (InSequence("all", (A, B), Limit(5.0, True)), 1.5, InSequence("all", (B,), Limit(3.5, True)), '"b"'),
    ],
)
def test_what_is_left(plan, at_s, left, said):
    _, rest = stopped(plan, at_s)
    assert (None if rest is None else (rest.plan, rest.said)) == (None if left is None else (left, said))


def test_what_has_failed_is_not_tried_again():
    _, rest = stopped(Fallback("all", (A, B, C)), 1.5, a=(Attempt(1.0, "aborted"),))
    assert rest.plan == Fallback("all", (B, C))
    assert rest.said == '"b" or else "c"'


def test_an_amount_that_was_interrupted_begins_anew():
    drive = do("drive", TypedArgument("distance", "two metres", measure=Measure("length", "two metres", 2.0, "m", 2.0)))
    assert stopped(InSequence("all", (drive, A)), 0.5)[1].said == '"drive" from its beginning and "a"'
    assert stopped(InSequence("all", (A, drive)), 0.5)[1].said == '"a" and "drive"'


@settings(max_examples=150, derandomize=True, **COMMON)
@given(cases("do sequence parallel any_order repeat wait", is_plain=True), st.floats(0.0, 60.0))
def test_what_was_done_and_what_is_left_are_the_whole(case, stop_s):
    plan, world = case
    whole, nothing = run(plan, replace(world, preempt_s=FAR))
    assert nothing is None
    first, rest = run(plan, replace(world, preempt_s=stop_s))
    total = done(first)
    if rest is not None:
        total += done(run(rest.plan, replace(world, preempt_s=FAR))[0])
    # A clause of several frames begins anew as a whole.
    for name, count in done(whole).items():
        assert count <= total[name] <= count + 1
