"""Parses with a packaged model, offline, for the scores and the tests."""

from pathlib import Path
from typing import Any, Dict, List, Sequence

from .conllu import Sentence, Word
from .errors import TrainingError

PACKAGE = "command"
PROCESSORS = ("tokenize", "mwt", "pos", "lemma", "depparse")
#: Folder of the joint model beside a package.
JOINT = "joint"


def processors_of(folder: Path, *, pretokenized: bool = False) -> Dict[str, str]:
    """Return what each of Stanza's processors loads: the package, or the joint model where it lies in the folder."""
    found = {name: "default" for name in PROCESSORS if not (pretokenized and name == "mwt")}
    if (folder / JOINT).is_dir():
        from stanford_parser_ros.joint.stanza_variants import register

        found.update(register(folder / JOINT))
    return found


class Parser:
    """Stanza's pipeline over a model folder, one thread, no network."""

    def __init__(self, folder: Path, pretokenized: bool = False) -> None:
        """Load the package; ``pretokenized``: texts come as words and are not split again.

        Raises TrainingError when the folder holds no package.
        """
        if not (folder / "resources.json").is_file():
            raise TrainingError(f"{folder}: no resources.json there; expected a packaged model (see 'pack')")
        import stanza  # slow to import: only where a model is used
        import torch

        torch.set_num_threads(1)
        self._run = stanza.Pipeline(
            "en",
            dir=str(folder),
            package=None,
            processors=processors_of(folder, pretokenized=pretokenized),
            download_method=None,
            use_gpu=False,
            tokenize_pretokenized=pretokenized,
            tokenize_no_ssplit=not pretokenized,
            logging_level="ERROR",
        )

    def words(self, sentences: Sequence[Sequence[str]]) -> List[Sentence]:
        """Trees of sentences given as words."""
        return [_converted(sentence) for sentence in self._run([list(words) for words in sentences]).sentences]

    def text(self, text: str) -> Sentence:
        """The tree of one command."""
        return _converted(self._run(text).sentences[0])


def _converted(sentence: Any) -> Sentence:  # a Stanza object, which has no types
    return Sentence(
        tuple(
            Word(word.text, word.lemma or "_", word.upos, word.xpos or "_", word.feats or "_", word.head, word.deprel)
            for word in sentence.words
        )
    )
