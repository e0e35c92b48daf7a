"""The turtle of turtlesim."""

import math

import pytest

from roboframenet_sim.turtle import FIELD_M, Turtle


def test_it_moves_as_commanded_and_stops_when_nobody_commands() -> None:
    turtle = Turtle()
    start_m = turtle.x_m
    for _ in range(200):
        turtle.drive(1.0, 0.0)
        turtle.step(0.01)
    assert turtle.x_m - start_m == pytest.approx(2.0)
    for _ in range(300):
        turtle.step(0.01)
    assert turtle.x_m - start_m == pytest.approx(3.0, abs=0.02)
    assert turtle.linear_m_per_s == 0.0


def test_it_turns_counterclockwise_and_angles_wrap() -> None:
    turtle = Turtle()
    for _ in range(4):
        turtle.drive(0.0, math.pi / 2.0)
        turtle.step(1.0)
    assert turtle.yaw_rad == pytest.approx(0.0, abs=1e-9)
    turtle.drive(1.0, math.pi / 2.0)
    turtle.step(1.0)
    assert turtle.y_m == pytest.approx(FIELD_M / 2.0 + 1.0)


def test_it_stays_on_the_field() -> None:
    turtle = Turtle()
    turtle.put(100.0, -1.0, 0.0)
    assert (turtle.x_m, turtle.y_m) == (FIELD_M, 0.0)
    turtle.drive(5.0, 0.0)
    turtle.step(1.0)
    assert turtle.x_m == FIELD_M


def test_no_number_stops_it() -> None:
    turtle = Turtle()
    turtle.drive(math.nan, 1.0)
    turtle.step(1.0)
    assert (turtle.x_m, turtle.yaw_rad) == (FIELD_M / 2.0, 0.0)
