"""Lists in sentences."""

import pytest

from roboframenet_ros.spoken_lists import join_with_and, join_with_or


@pytest.mark.parametrize(
    ("parts", "listed"), [([], ""), (["a"], "a"), (["a", "b"], "a or b"), (["a", "b", "c"], "a, b or c")]
)
def test_parts_are_joined_as_a_person_says_them(parts, listed):
    assert join_with_or(parts) == listed
    assert join_with_and(iter(parts)) == listed.replace(" or ", " and ")
