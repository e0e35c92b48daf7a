"""Lists, and beginnings of sentences."""

import pytest

from roboframenet_ros.spoken_text import join_with_and, join_with_or, with_capital


@pytest.mark.parametrize(
    ("parts", "listed"), [([], ""), (["a"], "a"), (["a", "b"], "a or b"), (["a", "b", "c"], "a, b or c")]
)
def test_parts_are_joined_as_a_person_says_them(parts, listed):
    assert join_with_or(parts) == listed
    assert join_with_and(iter(parts)) == listed.replace(" or ", " and ")


@pytest.mark.parametrize(("text", "begun"), [("", ""), ("the mug of Anna", "The mug of Anna"), ("2 mugs", "2 mugs")])
def test_a_sentence_begins_with_a_capital(text, begun):
    assert with_capital(text) == begun
