"""What the tests of all packages share: the tiers, and the corpora of the acceptance tests."""

import os
from pathlib import Path

import pytest

TIERS = ("acceptance", "reliability")


def pytest_sessionfinish(session: pytest.Session, exitstatus: int) -> None:
    """A package without a test of the tier that was asked for is no failure."""
    if exitstatus == pytest.ExitCode.NO_TESTS_COLLECTED and session.config.getoption("markexpr") in TIERS:
        session.exitstatus = pytest.ExitCode.OK


@pytest.fixture(scope="session")
def corpora() -> Path:
    """The folder of corpora; a test that needs it is skipped where none is given."""
    folder = os.environ.get("ROBOFRAMENET_DATA", "")
    if not folder:
        pytest.skip("no folder of corpora is given: make acceptance DATA=folder")
    return Path(folder)
