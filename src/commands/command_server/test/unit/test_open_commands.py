"""Every command is closed exactly once."""

import random

import pytest

from command_server.open_commands import (
    RESTARTED,
    STAGES,
    CommandText,
    Ending,
    OpenCommands,
    Outcome,
    refusal_of_delay,
    refusal_of_text,
    stage_after,
    stamp_after,
)


@pytest.fixture
def commands(clock):
    return OpenCommands(dict.fromkeys(STAGES, 2.0), now=clock)


def make_command(name, stamp_ns=0):
    return CommandText(command_id=name, stamp_ns=stamp_ns, text=f"text of {name}")


def ending(name, outcome=Outcome.DONE):
    return Ending(command=make_command(name), outcome=outcome, stage="executor", code=outcome.name, sentence="x")


def test_first_final_event_wins_and_later_ones_are_dropped(commands):
    commands.open(make_command("a"))
    assert commands.finish(ending("a")).outcome == Outcome.DONE
    assert commands.finish(ending("a", Outcome.FAILED)) is None
    assert not commands.open_commands


def test_ending_of_a_command_that_nobody_opened_is_dropped(commands):
    assert commands.finish(ending("stranger")) is None
    assert not commands.progress("stranger", "executor")


def test_reply_carries_the_command_as_it_was_opened(commands):
    commands.open(make_command("a", stamp_ns=5))
    assert commands.finish(ending("a")).command.stamp_ns == 5


def test_same_id_twice_is_an_error(commands):
    commands.open(make_command("a"))
    with pytest.raises(ValueError, match="'a'"):
        commands.open(make_command("a"))


@pytest.mark.parametrize(
    "passed,silent",
    [([], STAGES[0]), (STAGES[:1], STAGES[1]), (STAGES[:2], STAGES[2]), (STAGES[:4], STAGES[4]), (STAGES, STAGES[4])],
)
def test_the_silent_stage_is_named(commands, clock, passed, silent):
    commands.open(make_command("a"))
    for stage in passed:
        clock.now_s += 1.5
        assert not commands.condemn_silent(timeout_s=1.0)
        commands.progress("a", stage)
    clock.now_s += 1.99
    assert not commands.condemn_silent(timeout_s=1.0)
    clock.now_s += 0.02
    (entry,) = commands.condemn_silent(timeout_s=1.0)
    assert entry.may_have_started == (silent == "executor")
    assert not commands.condemn_silent(timeout_s=1.0)
    end = commands.finish_condemned("a", "It stands.")
    assert (end.outcome, end.code, end.stage) == (Outcome.FAILED, "STAGE_SILENT", silent)
    assert end.sentence == f"{silent} did not answer within 2 s. It stands."
    assert commands.finish_condemned("a") is None


def test_the_executor_may_have_the_plan_before_the_arbitrator_tells_of_it(commands):
    commands.open(make_command("a"))
    planned = []
    for stage in STAGES[:-1]:
        planned.append(commands.get("a").may_be_planned)
        commands.progress("a", stage)
    assert planned == [False, False, False, True]
    assert commands.get("a").may_be_planned


def test_condemned_command_does_not_come_back_to_life(commands, clock):
    commands.open(make_command("a"))
    clock.now_s += 2.0
    commands.condemn_silent(timeout_s=1.0)
    assert commands.progress("a", "executor")
    assert not commands.overdue_condemned()
    clock.now_s += 1.0
    assert commands.overdue_condemned() == ["a"]


def test_command_that_was_done_before_it_was_cancelled_is_done(commands, clock):
    commands.open(make_command("a"))
    clock.now_s += 2.0
    commands.condemn_silent(timeout_s=1.0)
    assert commands.finish(ending("a", Outcome.DONE)).outcome == Outcome.DONE


def test_executor_that_stops_a_condemned_command_does_not_answer_it(commands, clock):
    commands.open(make_command("a"))
    clock.now_s += 2.0
    commands.condemn_silent(timeout_s=1.0)
    assert commands.finish(ending("a", Outcome.SUPERSEDED)) is None
    assert commands.finish_condemned("a").code == "STAGE_SILENT"


def test_command_without_a_verdict_is_not_closed_as_cancelled(commands):
    commands.open(make_command("a"))
    assert commands.finish_condemned("a") is None
    assert commands.get("a") is not None


def test_nobody_is_silent_while_this_process_does_not_run(commands, clock):
    commands.open(make_command("a"))
    clock.now_s += 60.0
    commands.postpone(60.0)
    assert not commands.condemn_silent(timeout_s=1.0)
    clock.now_s += 2.0
    assert commands.condemn_silent(timeout_s=1.0)


def test_executor_keeps_a_command_alive(commands, clock):
    commands.open(make_command("a"))
    for _ in range(50):
        clock.now_s += 1.0
        commands.progress("a", "executor")
        assert not commands.condemn_silent(timeout_s=1.0)
    assert commands.get("a").is_with_executor


def test_late_event_of_an_earlier_stage_changes_nothing(commands, clock):
    commands.open(make_command("a"))
    commands.progress("a", "arbitrator")
    before = commands.get("a")
    clock.now_s += 1.0
    assert commands.progress("a", "stanford_parser_ros")
    assert commands.get("a") == before
    assert not before.is_with_executor


def test_event_of_a_stranger_does_not_prolong(commands):
    commands.open(make_command("a"))
    before = commands.get("a")
    assert not commands.progress("a", "somebody_else")
    assert commands.get("a") == before


def test_stop_ends_what_was_said_before_it_and_nothing_later(commands):
    for name, stamp_ns in (("before", 10), ("same", 20), ("later", 21)):
        commands.open(make_command(name, stamp_ns))
    ends = commands.finish_stopped(20)
    assert [end.command.command_id for end in ends] == ["before", "same"]
    assert {(end.outcome, end.code) for end in ends} == {(Outcome.SUPERSEDED, "STOPPED")}
    assert [entry.command.command_id for entry in commands.open_commands] == ["later"]


def test_next_deadline(commands, clock):
    assert commands.next_deadline_s() is None
    commands.open(make_command("a"))
    clock.now_s += 1.0
    commands.open(make_command("b"))
    assert commands.next_deadline_s() == 102.0


@pytest.mark.parametrize("text,code", [("", "EMPTY_TEXT"), (" \t\n", "EMPTY_TEXT"), ("x" * 11, "TEXT_TOO_LONG")])
def test_texts_that_are_no_commands(text, code):
    found, sentence = refusal_of_text(text, max_length=10)
    assert found == code and sentence


def test_a_goal_that_was_long_on_its_way_is_refused():
    assert refusal_of_delay(3.0, longest_s=3.0) is None
    assert refusal_of_delay(12.4, longest_s=3.0) == (
        "LATE",
        "That was said 12 s ago. Say it again if you still want it.",
    )


def test_text_of_the_greatest_length_passes():
    assert refusal_of_text("x" * 10, max_length=10) is None


def test_command_of_the_last_run_is_cancelled_and_answered(commands, clock):
    commands.adopt(make_command("a"), timeout_s=3.0)
    assert commands.get("a").may_have_started
    clock.now_s += 2.9
    assert not commands.condemn_silent(timeout_s=1.0)
    assert not commands.overdue_condemned()
    clock.now_s += 0.2
    assert commands.overdue_condemned() == ["a"]
    end = commands.finish_condemned("a", "It stands.")
    assert (end.code, end.outcome) == ("RESTARTED", Outcome.FAILED)
    assert end.sentence == f"{RESTARTED.sentence} It stands."


def test_stage_after():
    assert [stage_after(stage) for stage in STAGES] == list(STAGES[1:]) + [STAGES[-1]]


def test_any_order_of_events_gives_one_reply_each(clock):
    for seed in range(200):
        lots = random.Random(seed)
        commands = OpenCommands(dict.fromkeys(STAGES, 2.0), now=clock)
        replies = []
        names = [f"c{index}" for index in range(5)]
        for stamp_ns, name in enumerate(names):
            commands.open(make_command(name, stamp_ns))
        for _ in range(40):
            step, name = lots.randrange(4), lots.choice(names)
            if step == 0:
                end = commands.finish(ending(name, lots.choice(list(Outcome))))
                replies += [end] if end else []
            elif step == 1:
                commands.progress(name, lots.choice(STAGES))
            elif step == 2:
                clock.now_s += lots.random()
                commands.condemn_silent(timeout_s=1.0)
                replies += filter(None, [commands.finish_condemned(name)])
            elif lots.random() < 0.1:
                replies += commands.finish_stopped(lots.randrange(5))
        clock.now_s += 10.0
        commands.condemn_silent(timeout_s=1.0)
        replies += filter(
            None, [commands.finish_condemned(entry.command.command_id) for entry in commands.open_commands]
        )
        assert sorted(end.command.command_id for end in replies) == names, f"seed {seed}"


@pytest.mark.parametrize(
    "arrival_ns,last_ns,stamp_ns",
    [(5, 0, 5), (5, 5, 6), (4, 5, 6), (0, 10_000_000_000, 0), (9_500_000_000, 10_000_000_000, 10_000_000_001)],
)
def test_stamps_of_commands_grow_unless_the_clock_is_set_back(arrival_ns, last_ns, stamp_ns):
    assert stamp_after(arrival_ns, last_ns) == stamp_ns
