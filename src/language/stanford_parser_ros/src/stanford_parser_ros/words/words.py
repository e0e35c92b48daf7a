"""Splits texts into words, and finds their dictionary forms."""

from pathlib import Path
from typing import List, NamedTuple, Sequence, Tuple

from stanford_parser_ros.model_error import ModelError
from stanford_parser_ros.onnx_session import onnx_session
from stanford_parser_ros.words.lemmas import Lemmatizer
from stanford_parser_ros.words.tokens import Expander, Tokenizer
from stanford_parser_ros.words.word_folder import CUTS, ENDS, LEMMA, read_word_folder

#: Folder of words beside those of Stanza's models.
FOLDER = "words"


class Split(NamedTuple):
    """The words of a text.

    Attributes:
        forms: the words
        spans: positions of the first character of each, and behind its last
    """

    forms: List[str]
    spans: List[Tuple[int, int]]


class Words:
    """The tokenizer, the expander of multi-word tokens, and the lemmatizer of a Stanza package."""

    def __init__(self, folder: Path, *, package: str = "default") -> None:
        """
        Args:
            folder: of words
            package: of which they have to be; ``default`` is any
        Raises:
            ModelError: a file is missing or another than was packed, or ONNX Runtime is not installed
        """
        files = read_word_folder(folder)
        if package not in ("default", files.package):
            raise ModelError(
                f"{folder} holds words of the package '{files.package}', not of '{package}': export them with "
                "'python3 -m joint_parser export-words', or set ~runtime to stanza"
            )
        self._tokenizer = Tokenizer(files, onnx_session(folder / ENDS))
        self._expander = Expander(files, onnx_session(folder / CUTS))
        self._lemmatizer = Lemmatizer(files, onnx_session(folder / LEMMA))

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
