"""Findings of ``rfn doctor``."""

from roboframenet_tools.finding import clock_finding


def test_one_clock_is_no_problem() -> None:
    assert not clock_finding(["/turtlebot_sim"]).advice


def test_two_clocks_are_told_by_name() -> None:
    finding = clock_finding(["/turtlebot_sim", "/gazebo"])
    assert finding.advice and "/gazebo, /turtlebot_sim" in finding.found
