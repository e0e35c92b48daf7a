"""The lean runtime answers until Stanza is loaded."""

import threading
from pathlib import Path
from typing import List
from unittest import mock

import pytest

from roboframenet_testing import wait_until
from stanford_parser_ros import early_inference
from stanford_parser_ros.early_inference import EarlyInference, lean_first, load_stanza
from stanford_parser_ros.inference import ModelError, shipped_model_dir
from stanford_parser_ros.lean.inference import LeanInference
from utterance_passes.tree import DependencyTree


class Says:
    """A runtime whose trees hold its name."""

    def __init__(self, name: str) -> None:
        self._name = name

    def parse(self, text: str) -> DependencyTree:
        return DependencyTree(text=self._name, words=())

    def reparse(self, tree: DependencyTree) -> DependencyTree:
        return self.parse(tree.text)


def no_failure(error: ModelError) -> None:
    raise AssertionError(error)


def test_the_second_runtime_answers_once_it_is_loaded() -> None:
    may_load, times = threading.Event(), []

    def load() -> Says:
        assert may_load.wait(60.0)
        return Says("second")

    early = EarlyInference(Says("first"), load, on_loaded=times.append, on_failed=no_failure)
    assert early.parse("Turn.").text == "first"
    may_load.set()
    wait_until(lambda: bool(times))
    assert early.parse("Turn.").text == "second"
    assert early.reparse(early.parse("Turn.")).text == "second"


def test_the_first_runtime_stays_when_the_second_cannot_be_loaded() -> None:
    reasons: List[ModelError] = []

    def load() -> Says:
        raise ModelError("no memory")

    early = EarlyInference(Says("first"), load, on_loaded=lambda _: None, on_failed=reasons.append)
    wait_until(lambda: bool(reasons))
    assert early.parse("Turn.").text == "first"
    assert str(reasons[0]) == "no memory"


def test_the_shipped_models_are_there_at_once() -> None:
    assert isinstance(lean_first(shipped_model_dir(), "default"), LeanInference)


def test_without_stanza_nothing_answers_in_its_place() -> None:
    with mock.patch.object(early_inference.importlib.util, "find_spec", lambda name: None):
        assert lean_first(shipped_model_dir(), "default") is None


def test_models_that_nothing_can_load_are_one_clear_error(tmp_path: Path) -> None:
    with pytest.raises(ModelError, match="nowhere"):
        load_stanza(
            model_dir=tmp_path / "nowhere",
            package="default",
            threads=1,
            on_loaded=lambda _: None,
            on_failed=no_failure,
        )
