"""Which runtime answers: ONNX Runtime until Stanza is loaded, and Stanza where ONNX Runtime cannot."""

import subprocess
import sys
import threading
from pathlib import Path
from typing import List, Sequence
from unittest import mock

import pytest

from roboframenet_testing import wait_until
from stanford_parser_ros.early_inference import EarlyInference, load_onnx, load_stanza
from stanford_parser_ros.inference import JOINT, PROCESSORS, ModelError, processors_of, shipped_model_dir
from utterance_passes.trees.tree import DependencyTree
from utterance_passes.trees.vocabulary import NamedWord


class Says:
    """A runtime whose trees hold its name."""

    def __init__(self, name: str) -> None:
        self._name = name

    def parse(self, text: str) -> DependencyTree:
        return DependencyTree(text=self._name, words=())

    def with_named_words(self, tree: DependencyTree, named: Sequence[NamedWord]) -> DependencyTree:
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
    assert early.with_named_words(early.parse("Turn."), ()).text == "second"


def test_the_first_runtime_stays_when_the_second_cannot_be_loaded() -> None:
    reasons: List[ModelError] = []

    def load() -> Says:
        raise ModelError("no memory")

    early = EarlyInference(Says("first"), load, on_loaded=lambda _: None, on_failed=reasons.append)
    wait_until(lambda: bool(reasons))
    assert early.parse("Turn.").text == "first"
    assert str(reasons[0]) == "no memory"


MODULE = "stanford_parser_ros.early_inference."
ONNX, STANZA = MODULE + "JointInference", MODULE + "StanzaInference"


def broken(reason: str) -> mock.Mock:
    return mock.Mock(side_effect=ModelError(reason))


@mock.patch(STANZA, broken("Stanza is not installed"))
@mock.patch(ONNX, mock.Mock(return_value=Says("onnx")))
def test_onnx_runtime_answers_for_good_where_stanza_cannot_be_loaded() -> None:
    reasons: List[ModelError] = []
    found = load_stanza(
        model_dir=Path("models"), package="default", threads=1, on_loaded=lambda _: None, on_failed=reasons.append
    )
    wait_until(lambda: bool(reasons))
    assert found.parse("Turn.").text == "onnx"
    assert str(reasons[0]) == "Stanza is not installed"


@mock.patch(STANZA, mock.Mock(return_value=Says("stanza")))
@mock.patch(ONNX, broken("no words"))
def test_a_package_without_the_joint_model_waits_for_stanza() -> None:
    found = load_stanza(
        model_dir=Path("models"), package="gum", threads=1, on_loaded=lambda _: None, on_failed=no_failure
    )
    assert found.parse("Turn.").text == "stanza"


@mock.patch(STANZA, mock.Mock(return_value=Says("stanza")))
@mock.patch(ONNX, mock.Mock(return_value=Says("onnx")))
def test_onnx_runtime_needs_no_stanza() -> None:
    found = load_onnx(model_dir=Path("models"), package="default", threads=1, on_failed=no_failure)
    assert found.parse("Turn.").text == "onnx"


@mock.patch(STANZA, mock.Mock(return_value=Says("stanza")))
@mock.patch(ONNX, broken("cut"))
def test_stanza_answers_where_onnx_runtime_cannot() -> None:
    reasons: List[ModelError] = []
    found = load_onnx(model_dir=Path("models"), package="default", threads=1, on_failed=reasons.append)
    assert found.parse("Turn.").text == "stanza"
    assert [str(reason) for reason in reasons] == ["cut"]


@mock.patch(STANZA, broken("Stanza is not installed"))
@mock.patch(ONNX, broken("cut"))
def test_where_nothing_answers_the_reason_is_that_of_onnx_runtime() -> None:
    with pytest.raises(ModelError, match=r"^cut$"):
        load_onnx(model_dir=Path("models"), package="default", threads=1, on_failed=no_failure)


def test_models_that_nothing_can_load_are_one_clear_error(tmp_path: Path) -> None:
    with pytest.raises(ModelError, match=r"no model folder .*nowhere"):
        load_stanza(
            model_dir=tmp_path / "nowhere",
            package="default",
            threads=1,
            on_loaded=lambda _: None,
            on_failed=no_failure,
        )
    with pytest.raises(ModelError, match=r"no model folder .*nowhere"):
        load_onnx(model_dir=tmp_path / "nowhere", package="default", threads=1, on_failed=no_failure)


def test_stanza_reads_a_package_as_it_is_where_no_joint_model_lies(tmp_path: Path) -> None:
    assert processors_of(tmp_path, "gum") == dict.fromkeys(PROCESSORS.split(","), "gum")


def test_stanza_does_not_fall_back_to_other_weights_where_the_joint_model_is_broken(tmp_path: Path) -> None:
    pytest.importorskip("stanza", reason="'make stanza' installs it")
    (tmp_path / JOINT).mkdir()
    with pytest.raises(ModelError, match=r"manifest.json.*git checkout"):
        processors_of(tmp_path, "default")


def test_onnx_runtime_imports_neither_torch_nor_stanza() -> None:
    program = (
        "import sys\n"
        "sys.modules['torch'] = sys.modules['stanza'] = None\n"
        "from pathlib import Path\n"
        "from stanford_parser_ros.joint.inference import JointInference as Models\n"
        f"print(len(Models(model_dir=Path({str(shipped_model_dir())!r})).parse('Turn left.').words))\n"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True, timeout=120.0)
    assert done.stdout == "3\n"
