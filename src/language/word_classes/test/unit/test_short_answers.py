"""A whole utterance as a yes or a no."""

import pytest

from word_classes import agreement, in_words


@pytest.mark.parametrize(
    "text",
    [
        "yes", "Yes yes!", "yep please", "yes, sir", "yes do that", "y", "uh-huh", "That’s what I want.", "okay robot",
        "yes, please do", "\U0001f44d", "\U0001f44d\U0001f3fd", "\U0001f44d thanks",
    ],
)  # fmt: skip
def test_yes(text: str) -> None:
    assert agreement(text) is True


@pytest.mark.parametrize(
    "text",
    ["no", "no no", "nope thanks", "no sir", "n", "not that", "please don't", "\U0001f44e\U0001f3ff", "no, my friend"],
)
def test_no(text: str) -> None:
    assert agreement(text) is False


@pytest.mark.parametrize(
    "text", ["", "please", "yes no", "yes but slowly", "no problem", "yes, turn left", "that is what Bob wants", "sir"]
)
def test_neither(text: str) -> None:
    assert agreement(text) is None


def test_a_thumb_is_written_in_words() -> None:
    assert in_words("\U0001f44d") == "yes"
    assert in_words(" \U0001f44e\U0001f44e ") == "no"
    assert in_words("\U0001f44d\U0001f44e") == "\U0001f44d\U0001f44e"
    assert in_words("go on") == "go on"
