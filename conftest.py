"""Shared by the tests of all packages: the tiers, and the corpora of the acceptance tests."""

import os
from pathlib import Path

import pytest

TIERS = ("acceptance", "reliability")


def pytest_sessionfinish(session: pytest.Session, exitstatus: int) -> None:
    """Let a package without a test of the chosen tier pass."""
    if exitstatus == pytest.ExitCode.NO_TESTS_COLLECTED and session.config.getoption("markexpr") in TIERS:
        session.exitstatus = pytest.ExitCode.OK


@pytest.fixture(scope="session")
def corpora() -> Path:
    """The folder of corpora; without one, the test that needs it is skipped."""
    folder = os.environ.get("ROBOFRAMENET_DATA", "")
    if not folder:
        pytest.skip("no folder of corpora is given: make acceptance DATA=folder")
    return Path(folder)
