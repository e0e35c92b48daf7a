"""What is kept for listeners that connect late."""

import pytest

from roboframenet_ros.recent import Recent
from roboframenet_testing import Clock


def test_values_come_in_the_order_in_which_they_were_added() -> None:
    recent = Recent(max_count=3, max_age_s=5.0)
    assert recent.values() == []
    recent.add("one")
    recent.add("two")
    assert recent.values() == ["one", "two"]
    assert recent.values() == ["one", "two"]


def test_the_oldest_goes_when_there_are_too_many() -> None:
    recent = Recent(max_count=3, max_age_s=5.0)
    for number in range(10):
        recent.add(number)
    assert recent.values() == [7, 8, 9]


def test_what_is_too_old_is_gone() -> None:
    clock = Clock()
    recent = Recent(max_count=3, max_age_s=5.0, now=clock)
    recent.add("one")
    clock.now_s += 3.0
    recent.add("two")
    clock.now_s += 2.0
    assert recent.values() == ["one", "two"]
    clock.now_s += 0.1
    assert recent.values() == ["two"]
    clock.now_s += 100.0
    assert recent.values() == []


@pytest.mark.parametrize("max_count, max_age_s", [(0, 5.0), (-1, 5.0), (3, 0.0), (3, -1.0), (3, float("nan"))])
def test_bounds_are_positive(max_count: int, max_age_s: float) -> None:
    with pytest.raises(ValueError):
        Recent(max_count=max_count, max_age_s=max_age_s)
