"""Whether a process did not run."""

from roboframenet_ros.suspension import SuspensionWatch
from roboframenet_testing import Clock


def test_turns_in_time_are_no_suspension():
    clock = Clock()
    watch = SuspensionWatch(longest_turn_s=1.0, now=clock)
    for _ in range(3):
        clock.now_s += 0.9
        assert not watch.is_just_awake(within_s=0.5)
        assert watch.turn() == 0.0
    assert not watch.is_just_awake(within_s=0.5)


def test_long_turn_is_one_until_a_while_after():
    clock = Clock()
    watch = SuspensionWatch(longest_turn_s=1.0, now=clock)
    clock.now_s += 7.0
    assert watch.is_just_awake(within_s=0.5)  # before the loop has turned
    assert watch.turn() == 7.0
    clock.now_s += 0.4
    assert watch.is_just_awake(within_s=0.5)
    assert watch.turn() == 0.0
    clock.now_s += 0.2
    assert not watch.is_just_awake(within_s=0.5)
