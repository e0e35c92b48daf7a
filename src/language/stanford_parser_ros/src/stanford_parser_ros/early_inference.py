"""Which runtime answers: ONNX Runtime until Stanza is loaded, and Stanza where ONNX Runtime has nothing to compute."""

import ctypes
import threading
import time
from pathlib import Path
from typing import Callable, Sequence

from stanford_parser_ros.inference import Inference, ModelError, StanzaInference
from stanford_parser_ros.joint.inference import JointInference
from utterance_passes.trees.tree import DependencyTree
from utterance_passes.trees.vocabulary import NamedWord


class EarlyInference:
    """One runtime answers until another is loaded, which answers from then on.

    Both give the same trees. Any thread may call.
    """

    def __init__(
        self,
        first: Inference,
        load: Callable[[], Inference],
        *,
        on_loaded: Callable[[float], None],
        on_failed: Callable[[ModelError], None],
    ) -> None:
        """Begin to load the second runtime, in a thread.

        Args:
            first: what answers at once
            load: loads the other one; it may raise ModelError, and the first one stays
            on_loaded: called with the seconds that this took
            on_failed: called with the reason
        """
        self._now = first
        self._load = load
        self._on_loaded, self._on_failed = on_loaded, on_failed
        threading.Thread(target=self._run, name="loading", daemon=True).start()

    def parse(self, text: str) -> DependencyTree:
        """See :meth:`Inference.parse`."""
        return self._now.parse(text)

    def with_named_words(self, tree: DependencyTree, named: Sequence[NamedWord]) -> DependencyTree:
        """See :meth:`Inference.with_named_words`."""
        return self._now.with_named_words(tree, named)

    def _run(self) -> None:
        begin_s = time.monotonic()
        try:
            self._now = self._load()
        except ModelError as error:
            self._on_failed(error)
        else:
            _give_back_memory()
            self._on_loaded(time.monotonic() - begin_s)


def _give_back_memory() -> None:
    """Return the memory of the first runtime to the system, about 35 MB; the C library would keep it."""
    trim = getattr(ctypes.CDLL(None), "malloc_trim", None)
    if trim is not None:
        trim(0)


def load_stanza(
    *,
    model_dir: Path,
    package: str,
    threads: int,
    on_loaded: Callable[[float], None],
    on_failed: Callable[[ModelError], None],
) -> Inference:
    """Load Stanza, and have ONNX Runtime answer meanwhile where it can, or for good where Stanza cannot be loaded.

    Args:
        model_dir: folder of the models
        package: name of a package in that folder
        threads: of torch and ONNX Runtime
        on_loaded: called, from another thread, with the seconds that it took when Stanza is loaded later
        on_failed: called, from another thread, with the reason when it cannot be loaded later
    Raises:
        ModelError: neither can be loaded; it says why Stanza cannot
    """

    def load() -> StanzaInference:
        return StanzaInference(model_dir=model_dir, package=package, threads=threads)

    try:
        first = JointInference(model_dir=model_dir, package=package, threads=threads)
    except ModelError:
        return load()  # it says what is wrong
    return EarlyInference(first, load, on_loaded=on_loaded, on_failed=on_failed)


def load_onnx(*, model_dir: Path, package: str, threads: int, on_failed: Callable[[ModelError], None]) -> Inference:
    """Load the joint model, or Stanza where that cannot be loaded.

    Args:
        model_dir: folder of the models
        package: name of a package in that folder
        threads: of ONNX Runtime
        on_failed: called with the reason why Stanza answers
    Raises:
        ModelError: neither can be loaded; it says why ONNX Runtime cannot
    """
    try:
        return JointInference(model_dir=model_dir, package=package, threads=threads)
    except ModelError as error:
        try:
            stanza = StanzaInference(model_dir=model_dir, package=package, threads=threads)
        except ModelError:  # not installed, mostly
            raise error from None
        on_failed(error)
        return stanza
