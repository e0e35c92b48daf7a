"""A clock that stands still until a test moves it."""

import pytest

from roboframenet_testing import Clock


@pytest.fixture
def clock():
    return Clock()
