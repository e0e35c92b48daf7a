"""What SMACH logs, and where."""

import contextlib
import subprocess
import sys

import pytest

import smach


@pytest.fixture
def said():
    """What is logged, as (level, text)."""
    lines = []

    def logger(level):
        return lambda text, *args: lines.append((level, str(text) % args if args else str(text)))

    before = [getattr(smach.log._loggers, name) for name in ("info", "warn", "debug", "error")]
    smach.set_loggers(*(logger(level) for level in ("info", "warn", "debug", "error")))
    with contextlib.ExitStack() as stack:
        stack.callback(smach.set_loggers, *before)
        yield lines


def give(outcome="done"):
    return smach.CBState(lambda ud: outcome, outcomes=[outcome])


def test_messages_take_arguments_and_keep_percent_signs(said):
    smach.loginfo("i 100%")
    smach.logwarn("%s is %d", "w", 3)
    smach.logdebug("%s", "d")
    smach.logerr("e")
    assert said == [("info", "i 100%"), ("warn", "w is 3"), ("debug", "d"), ("error", "e")]


def test_each_transition_is_logged(said):
    machine = smach.StateMachine(["done"])
    with machine:
        smach.StateMachine.add("A", give(), {"done": "B"})
        smach.StateMachine.add("B", give())
    machine.execute()
    assert ("info", "State machine transitioning 'A':'done'-->'B'") in said
    assert ("info", "State machine terminating 'B':'done':'done'") in said


def test_outcomes_of_a_concurrence_are_logged(said):
    both = smach.Concurrence(["done"], "done")
    with both:
        smach.Concurrence.add("A", give())
    both.execute()
    assert ("info", "Concurrent Outcomes: {'A': 'done'}") in said


@pytest.mark.parametrize("count", [2, 3])
def test_sequence_names_a_state_that_nothing_leads_from_unless_it_is_the_last(said, count):
    sequence = smach.Sequence(["succeeded", "stuck"], "succeeded")
    with sequence:
        for label, outcome in [("A", "succeeded"), ("B", "stuck"), ("C", "succeeded")][:count]:
            smach.Sequence.add(label, give(outcome))
    assert [text for level, text in said if level == "error"] == (
        ["State 'B' has no outcome 'succeeded': nothing leads from it to 'C'."] if count == 3 else []
    )
    assert sequence.execute() == "stuck"


def test_mistakes_that_do_not_stop_a_machine_are_logged(said):
    def write(userdata):
        userdata.other = 1
        return "strange"

    both = smach.Concurrence(["done"], "done", outcome_cb=lambda outcomes: "surprise")
    with both:
        smach.Concurrence.add("A", give())
        smach.Concurrence.add("A", smach.CBState(write, outcomes=["done"]))
    both.execute()
    for level, words in (("warn", "'A'"), ("error", "'other'"), ("error", "'strange'"), ("error", "'surprise'")):
        assert any(found == level and words in text for found, text in said), words


PROGRAM = """
import smach
machine = smach.StateMachine(["done"])
with machine:
    smach.StateMachine.add("ONLY", smach.CBState(lambda ud: "done", outcomes=["done"]))
smach.loginfo("%d%%", 50)
machine.execute()
"""


FILE_ALONE = """
import logging
logging.getLogger().addHandler(logging.FileHandler({path!r}))
logging.getLogger().setLevel(logging.INFO)
"""


def run(program):
    return subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60, check=True)


@pytest.mark.parametrize(
    "setup,is_printed", [("", True), ("import logging; logging.basicConfig(level=logging.WARNING)", False)]
)
def test_program_that_sets_up_no_logging_prints_the_transitions(setup, is_printed):
    printed = run(setup + PROGRAM).stdout
    assert ("State machine terminating 'ONLY':'done':'done'" in printed) == is_printed
    assert ("50%" in printed.splitlines()) == is_printed


def test_program_whose_log_is_a_file_alone_prints_the_transitions_too(tmp_path):
    path = tmp_path / "log"
    run_result = run(FILE_ALONE.format(path=str(path)) + PROGRAM + "smach.logwarn('odd')")
    for text in (run_result.stdout, path.read_text()):
        assert "State machine terminating 'ONLY':'done':'done'" in text and "50%" in text.splitlines()
    assert run_result.stderr.splitlines() == ["odd"] and "odd" in path.read_text()
