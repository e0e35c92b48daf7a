"""Shared by the tests of all packages: the tiers, recorded parses, and the corpora of the acceptance tests."""

import os
from pathlib import Path
from typing import Any, Iterator, Optional
from unittest import mock

import pytest

TIERS = ("acceptance", "reliability")
#: What ``stanford_parser_ros.model.shipped_parser`` loads the models with.
MODELS = "stanford_parser_ros.model.JointInference"


def pytest_addoption(parser: "pytest.Parser") -> None:
    parser.addoption(
        "--record",
        choices=("anew", "add"),
        help="parse with the models and record their answers ('make record'): anew for all tests, add for some",
    )


def pytest_configure(config: "pytest.Config") -> None:
    config.pluginmanager.register(Parses(config.getoption("record")), "parses")


class Parses:
    """Tests of the tier "test" get recorded answers where others get the models.

    The passes run for real. A test that shows what the models say makes a ``JointInference`` of its own.
    """

    def __init__(self, record: Optional[str]) -> None:
        self._record = record
        self._answers: Any = None

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Iterator[None]:
        if any(item.get_closest_marker(tier) for tier in TIERS):
            yield
        else:
            with mock.patch(MODELS, self._inference):
                yield

    def pytest_sessionfinish(self) -> None:
        if self._record and self._answers is not None:
            from roboframenet_testing.recorded_parses import RECORDING, render_recording

            RECORDING.write_text(render_recording(self._answers.parses), encoding="utf-8")

    def _inference(self, **_settings: object) -> Any:
        if self._answers is None:
            from roboframenet_testing import recorded_parses
            from stanford_parser_ros.inference import shipped_model_dir
            from stanford_parser_ros.joint.inference import JointInference

            known = {} if self._record == "anew" else recorded_parses.read_shipped_recording()
            if self._record:
                models = JointInference(model_dir=shipped_model_dir())
                self._answers = recorded_parses.RecordingInference(models, known)
            else:
                self._answers = recorded_parses.RecordedInference(known)
        return self._answers


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
