"""A clock that stands still until a test moves it."""

import pytest


class Clock:
    """Returns `now_s` when called, seconds."""

    def __init__(self):
        self.now_s = 100.0

    def __call__(self):
        return self.now_s


@pytest.fixture
def clock():
    return Clock()
