"""Parses from the first second on: the lean runtime answers until Stanza is loaded, or where the joint model is not."""

import ctypes
import importlib.util
import threading
import time
from pathlib import Path
from typing import Callable, Optional, Union

from stanford_parser_ros.inference import Inference, ModelError, StanzaInference
from utterance_passes.tree import DependencyTree


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

    def reparse(self, tree: DependencyTree) -> DependencyTree:
        """See :meth:`Inference.reparse`."""
        return self._now.reparse(tree)

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


def lean_first(model_dir: Path, package: str) -> Optional[Inference]:
    """Load the lean runtime for the time until Stanza is loaded.

    Returns:
        None where Stanza is not installed or the lean runtime does not know the models: Stanza then says what is wrong
    """
    if not all(map(importlib.util.find_spec, ("torch", "stanza"))):
        return None
    try:
        from stanford_parser_ros.lean.inference import LeanInference

        return LeanInference(model_dir=model_dir, package=package)
    except (ModelError, ImportError):
        return None


def load_stanza(
    *,
    model_dir: Path,
    package: str,
    threads: int,
    on_loaded: Callable[[float], None],
    on_failed: Callable[[ModelError], None],
) -> Union[StanzaInference, EarlyInference]:
    """Load Stanza, and have the lean runtime answer meanwhile where it can.

    Args:
        model_dir: folder of the models
        package: name of a package in that folder
        threads: of torch
        on_loaded: called, from another thread, with the seconds that it took when Stanza is loaded later
        on_failed: called, from another thread, with the reason when it cannot be loaded later
    Raises:
        ModelError: neither can be loaded
    """

    def load() -> StanzaInference:
        return StanzaInference(model_dir=model_dir, package=package, threads=threads)

    first = lean_first(model_dir, package)
    return load() if first is None else EarlyInference(first, load, on_loaded=on_loaded, on_failed=on_failed)


def load_onnx(*, model_dir: Path, package: str, threads: int, on_failed: Callable[[ModelError], None]) -> Inference:
    """Load the joint model, or the lean runtime where that cannot be loaded.

    Args:
        model_dir: folder of the models, with ``joint`` in it
        package: name of a package in that folder
        threads: of ONNX Runtime
        on_failed: called with the reason why the lean runtime answers
    Raises:
        ModelError: neither can be loaded
    """
    from stanford_parser_ros.joint.inference import JointInference

    try:
        return JointInference(model_dir=model_dir, package=package, threads=threads)
    except ModelError as error:
        from stanford_parser_ros.lean.inference import LeanInference

        lean = LeanInference(model_dir=model_dir, package=package)
        on_failed(error)
        return lean
