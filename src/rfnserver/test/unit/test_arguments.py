"""Arguments of filled frames."""

import math
from types import SimpleNamespace

import pytest

from rfnserver.arguments import ArgumentError, angle_rad, argument, duration_s, length_m, number, required


def frame(**arguments: str) -> SimpleNamespace:
    return SimpleNamespace(
        frame_elements=[SimpleNamespace(name=name, argument=text) for name, text in arguments.items()]
    )


def test_argument_of_an_element_that_is_not_there() -> None:
    assert argument(frame(a="x"), "b", "default") == "default"


def test_required_argument_is_missed_by_name() -> None:
    with pytest.raises(ArgumentError, match="distance unit"):
        required(frame(), "distance_unit")


def test_amounts_in_si_units() -> None:
    said = frame(distance="3", distance_unit="feet", angle="120 degrees", time="half an hour", count="two")
    assert length_m(said, "distance", unit_element="distance_unit") == pytest.approx(0.9144)
    assert angle_rad(said, "angle") == pytest.approx(math.radians(120))
    assert duration_s(said, "time") == 1800.0
    assert number(said, "count") == 2.0


@pytest.mark.parametrize("said", [frame(distance="far"), frame(distance="3"), frame(distance="1e400 m"), frame()])
def test_amount_that_cannot_be_used(said: SimpleNamespace) -> None:
    with pytest.raises(ArgumentError):
        length_m(said, "distance")
