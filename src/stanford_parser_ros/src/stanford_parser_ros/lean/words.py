"""Splits texts into words, and finds their dictionary forms: what the lean runtime and the joint one share."""

import json
from pathlib import Path
from typing import Any, Callable, Dict, List, NamedTuple, Sequence, Tuple

from stanford_parser_ros.inference import PROCESSORS, ModelError
from stanford_parser_ros.lean.lemmatizer import Lemmatizer
from stanford_parser_ros.lean.model_files import UnreadableModel, read_model_file
from stanford_parser_ros.lean.tokenizer import Expander, Tokenizer

HINT = "set ~runtime to stanza for it"


class Split(NamedTuple):
    """The words of a text.

    Attributes:
        forms: the words
        spans: positions of the first character of each, and behind its last
    """

    forms: List[str]
    spans: List[Tuple[int, int]]


class Words:
    """The tokenizer, the expander of multi-word tokens, and the lemmatizer of a package."""

    def __init__(self, files: Dict[str, Path]) -> None:
        """
        Args:
            files: of the models, from :func:`model_files`
        Raises:
            ModelError: one cannot be loaded
        """
        self._tokenizer: Tokenizer = load_model(files["tokenize"], Tokenizer)
        self._expander: Expander = load_model(files["mwt"], Expander)
        self._lemmatizer: Lemmatizer = load_model(files["lemma"], Lemmatizer)

    def split(self, text: str) -> Split:
        """Split a text, one sentence, into words; "don't" is two."""
        forms: List[str] = []
        spans: List[Tuple[int, int]] = []
        for token in self._tokenizer.tokens(text):
            words = self._expander.words(token.text) if token.is_compound else [token.text]
            at = token.start
            for form in words:
                start = at if text[at : at + len(form)] == form else token.start
                end = start + len(form) if start == at else token.end
                at = min(end, token.end)
                forms.append(form)
                spans.append((start, end))
        return Split(forms, spans)

    def lemmas(self, forms: Sequence[str], upos: Sequence[str]) -> List[str]:
        """Return the dictionary form of each word; "_" where there is none."""
        return [self._lemmatizer.lemma(form, tag) or "_" for form, tag in zip(forms, upos)]


def model_files(model_dir: Path, package: str) -> Dict[str, Path]:
    """Return the file of each model of a package, and that of the word vectors.

    Raises:
        ModelError: the folder has no such package
    """
    try:
        english = json.loads((model_dir / "resources.json").read_text(encoding="utf-8"))["en"]
        names = dict(english["packages"][package])
        for processor in ("pos", "depparse"):
            for needed in english[processor][names[processor]].get("dependencies", ()):
                names[needed["model"]] = needed["package"]
        return {kind: model_dir / "en" / kind / f"{names[kind]}.pt" for kind in (*PROCESSORS.split(","), "pretrain")}
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise ModelError(f"{model_dir / 'resources.json'} names no package '{package}' ({error!r}); {HINT}") from error


def load_model(path: Path, make: Callable[[Dict[str, Any]], Any]) -> Any:
    """Read a model file and make something of it.

    Raises:
        ModelError: the file cannot be read, or holds a model of another form
    """
    try:
        return make(read_model_file(path))
    except (UnreadableModel, OSError) as error:
        raise ModelError(f"the lean runtime cannot load {path}: {error}; {HINT}") from error
    except (KeyError, ValueError) as error:
        raise ModelError(f"{path} holds a model that the lean runtime does not know ({error}); {HINT}") from error
