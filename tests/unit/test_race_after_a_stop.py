"""What is sent right after a stop: the executor waits as long as whoever brakes is in doubt."""

from executor.command_queue import PAUSE_AFTER_STOP_NS
from robot_stop.braking import RACE_NS


def test_goals_of_later_commands_are_sent_behind_the_race() -> None:
    assert PAUSE_AFTER_STOP_NS > RACE_NS
