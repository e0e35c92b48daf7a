"""The models: what they answer about a text, and how they are loaded."""

import os
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Dict, List, Protocol, Sequence

from stanford_parser_ros.model_error import ModelError as ModelError
from stanford_parser_ros.stanza_attributes import ALTERNATIVES
from utterance_passes.trees.tree import DependencyTree, Word
from utterance_passes.trees.vocabulary import NamedWord

PROCESSORS = "tokenize,mwt,pos,lemma,depparse"
#: Folder of the joint model beside those of a package; where it is, tags, heads and relations come from it.
JOINT = "joint"
#: Used where the package has it: official packages do, the shipped one does not.
CONSTITUENCY = "constituency"
#: Parsed once at start: the first sentence costs several times as much as the others.
WARM_UP = "Turn left 120 degrees."


class Inference(Protocol):
    """What the models know; the passes do the rest. Tests have recorded answers in its place."""

    def parse(self, text: str) -> DependencyTree:
        """Split a text into words, tag them, and parse them as one sentence.

        Args:
            text: with at least one letter or digit
        Returns:
            its Universal Dependencies; positions of characters are those of this text
        """

    def with_named_words(self, tree: DependencyTree, named: Sequence[NamedWord]) -> DependencyTree:
        """Parse the words of a tree again, so that some of them are what lexical units say.

        Args:
            tree: as :meth:`parse` returned it
            named: those words, at least one
        Returns:
            the tree; the same where the models do not tell their scores
        """


@dataclass(frozen=True)
class LoadTimes:
    """Times of the steps of loading, in seconds.

    Attributes:
        torch_s: importing torch
        stanza_s: importing Stanza
        models_s: reading the models
        warm_up_s: the first parse
    """

    torch_s: float
    stanza_s: float
    models_s: float
    warm_up_s: float

    @property
    def total_s(self) -> float:
        """The sum."""
        return self.torch_s + self.stanza_s + self.models_s + self.warm_up_s


_HINT = "leave ~model_dir empty for the models that are shipped, or download a package with Stanza beforehand"


def check_is_folder(folder: Path) -> None:
    """Check that there is a folder of models.

    Raises:
        ModelError: there is none
    """
    if not folder.is_dir():
        raise ModelError(f"no model folder {folder} ({_HINT})")


def check_model_folder(folder: Path, package: str) -> None:
    """Check that a folder holds a Stanza package of English; what the joint model does need not be in it.

    Raises:
        ModelError: the folder holds none
    """
    check_is_folder(folder)
    if not (folder / "resources.json").is_file():
        raise ModelError(f"{folder} holds no resources.json, so it is no folder of Stanza models ({_HINT})")
    by_joint = ("pos", "depparse") if (folder / JOINT).is_dir() else ()
    for processor in PROCESSORS.split(","):
        if processor not in by_joint and not any((folder / "en" / processor).glob("*.pt")):
            raise ModelError(f"{folder} holds no model for '{processor}' of the package '{package}' ({_HINT})")


def processors_of(folder: Path, package: str, *, threads: int = 1) -> Dict[str, str]:
    """Return what each of Stanza's processors loads: a package of a folder, or the joint model where that lies in it.

    Args:
        folder: of the models
        package: name of a package in it
        threads: of ONNX Runtime
    Raises:
        ModelError: the joint model is there, and cannot be loaded
    """
    found = dict.fromkeys(PROCESSORS.split(","), package)
    if any((folder / "en" / CONSTITUENCY).glob("*.pt")):
        found[CONSTITUENCY] = package
    if (folder / JOINT).is_dir():
        from stanford_parser_ros.joint.stanza_variants import register

        found.update(register(folder / JOINT, threads=threads))
    return found


def shipped_model_dir() -> Path:
    """Return the folder of the shipped models: that of the source tree of this module, or that of the ROS package.

    Raises:
        ModelError: there is neither
    """
    beside = Path(os.path.realpath(__file__)).parents[2] / "models"
    if beside.is_dir():
        return beside
    import rospkg  # only an install space needs it

    try:
        return Path(rospkg.RosPack().get_path("stanford_parser_ros")) / "models"
    except rospkg.ResourceNotFound as error:
        raise ModelError(
            f"no model folder {beside}, and no ROS package stanford_parser_ros: source the setup file of the workspace"
        ) from error


class StanzaInference:
    """The answers of one Stanza package; nothing is ever downloaded.

    Where the joint model lies in the folder, tags, heads and relations are its own.
    """

    def __init__(self, *, model_dir: Path, package: str = "default", threads: int = 1) -> None:
        """
        Args:
            model_dir: folder with ``resources.json`` and ``en/``, as Stanza lays it out
            package: name of a package in that folder
            threads: of torch and ONNX Runtime; one is fastest and steadiest for single short sentences
        Raises:
            ModelError: the models are missing, or Stanza is not installed
        """
        check_model_folder(model_dir, package)
        started = time.monotonic()
        try:
            import torch

            torch_done = time.monotonic()
            import stanza
        except ImportError as error:
            raise ModelError(
                f"Stanza is not installed for {sys.executable} ({error}): run 'make stanza' in RoboFrameNet's clone, "
                "and build with -DPYTHON_EXECUTABLE=CLONE/.venv/bin/python"
            ) from error
        torch.set_num_threads(threads)
        self._inference_mode: Any = torch.inference_mode
        stanza_done = time.monotonic()
        processors = processors_of(model_dir, package, threads=threads)
        try:
            self._pipeline: Any = stanza.Pipeline(
                "en",
                dir=str(model_dir),
                package=None,
                processors=processors,
                download_method=None,
                use_gpu=False,
                tokenize_no_ssplit=True,
                logging_level="ERROR",
            )
        except Exception as error:  # boundary: Stanza raises many kinds of errors for a broken file
            raise ModelError(
                f"the models in {model_dir} (package '{package}') cannot be loaded: {type(error).__name__}: {error}"
            ) from error
        models_done = time.monotonic()
        self.parse(WARM_UP)
        self.load_times = LoadTimes(
            torch_s=torch_done - started,
            stanza_s=stanza_done - torch_done,
            models_s=models_done - stanza_done,
            warm_up_s=time.monotonic() - models_done,
        )

    def parse(self, text: str) -> DependencyTree:
        """See :meth:`Inference.parse`."""
        with self._inference_mode():
            return _to_tree(text, self._pipeline(text).sentences[0])

    def with_named_words(self, tree: DependencyTree, named: Sequence[NamedWord]) -> DependencyTree:
        """See :meth:`Inference.with_named_words`."""
        return tree


def _to_tree(text: str, sentence: Any) -> DependencyTree:
    words: List[Word] = []
    for token in sentence.tokens:
        at = token.start_char
        for word in token.words:
            # The words of a multi-word token ("don't") get consecutive positions when their letters match the text.
            start = at if text[at : at + len(word.text)] == word.text else token.start_char
            end = start + len(word.text) if start == at else token.end_char
            at = min(end, token.end_char)
            words.append(
                Word(
                    index=word.id,
                    form=word.text,
                    lemma=word.lemma or word.text,
                    upos=word.upos or "X",
                    xpos=word.xpos or "",
                    feats=word.feats or "",
                    head=word.head,
                    deprel=word.deprel,
                    start_character=start,
                    end_character=end,
                )
            )
    constituency = getattr(sentence, CONSTITUENCY, None)
    return DependencyTree(
        text=text,
        words=tuple(words),
        brackets=str(constituency) if constituency is not None else "",
        alternatives=getattr(sentence, ALTERNATIVES, ()),
    )
