"""The verdicts of the demonstration."""

import pytest

from roboframenet_demo.script import Interruption, Line, Measured, Observation, judge, read_line
from roboframenet_demo.table import format_table


@pytest.mark.parametrize("turned_rad, is_right", [(2.0944, True), (2.06, True), (2.0, False), (-2.0944, False)])
def test_judge_allows_two_percent(turned_rad: float, is_right: bool) -> None:
    line = Line(text="Turn left 120 degrees.", expected={Measured.TURNED_RAD: 2.0944})
    assert judge(line, "DONE", Observation(turned_rad=turned_rad))[0] is is_right


def test_judge_needs_the_expected_outcome() -> None:
    assert judge(Line(text="Fly."), "REFUSED", Observation()) == (False, "expected DONE")


def test_judge_minds_a_refused_command_that_moved() -> None:
    assert not judge(Line(text="Fly.", outcome="REFUSED"), "REFUSED", Observation(driven_m=0.5))[0]


def test_judge_minds_a_base_that_rolls_on() -> None:
    assert not judge(Line(text="Ping."), "DONE", Observation(is_still=False))[0]


@pytest.mark.parametrize(
    "expected, observation, is_right",
    [
        ({Measured.SAID: "moo"}, Observation(said=("Mooo!",)), True),
        ({Measured.SAID: "moo"}, Observation(), False),
        ({Measured.REACHED: [1.0, 2.0]}, Observation(position_m=(1.1, 2.0)), True),
        ({Measured.REACHED: [1.0, 2.0]}, Observation(position_m=(2.1, 2.0)), False),
        ({Measured.FOLLOWED_M: 1.0}, Observation(driven_m=1.5), True),
        ({Measured.ARM_MOVED_RAD: 0.5}, Observation(arm_moved_rad=0.2), False),
        ({Measured.ARM_OFFSET_RAD: 0.05}, Observation(arm_offset_rad=0.2), False),
        ({Measured.ARM_OFFSET_RAD: 0.05}, Observation(arm_offset_rad=0.01), True),
    ],
)
def test_judge_knows_every_measure(expected: dict, observation: Observation, is_right: bool) -> None:
    assert judge(Line(text="x", expected=expected), "DONE", observation)[0] is is_right


def test_read_line_reads_an_interruption() -> None:
    line = read_line({"say": "Move.", "outcome": "SUPERSEDED", "interrupt": {"say": "Stop.", "after_s": 1}})
    assert line.interruption == Interruption(text="Stop.", after_s=1.0)


@pytest.mark.parametrize("entry", [{"sya": "Move."}, {"say": "x", "expcet": {}}, {"say": "x", "expect": {"turned": 1}}])
def test_read_line_refuses_unknown_keys(entry: dict) -> None:
    with pytest.raises(ValueError):
        read_line(entry)


def test_format_table_wraps_long_cells() -> None:
    assert format_table(["a", "b"], [["one two", "x"]], widths=[3, 1]) == "a    b\n---  -\none  x\ntwo"
