"""The sentence encoder: a vector of length 1 for each text, near those of texts that mean the same."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING, List, Sequence

import numpy as np

from stanford_parser_ros.checked_folder import read_checked
from stanford_parser_ros.joint.pieces import PieceVocabulary
from stanford_parser_ros.onnx_session import onnx_session

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Vectors = NDArray[np.float32]

#: The files of its folder.
NETWORK, PIECES = "encoder.onnx", "pieces.txt"
#: Inputs and output of the network.
NUMBERS, MASK, VECTORS = "numbers", "mask", "vectors"
#: Pieces of a text that are read, without those of start and end.
MOST_PIECES = 126
#: Texts that are encoded at a time, which bounds the memory.
_MOST_TEXTS = 32


def made_folder() -> Path:
    """Return where set-up makes the encoder: in the Python environment of this program."""
    return Path(sys.prefix) / "share" / "roboframenet" / "sentence_encoder"


class Encoder:
    """The encoder; one thread uses it at a time."""

    def __init__(self, folder: Path) -> None:
        """
        Args:
            folder: that set-up has made
        Raises:
            ModelError: a file is missing or another than was made, or ONNX Runtime is not installed
        """
        contents = read_checked(folder, (NETWORK, PIECES))
        self._vocabulary = PieceVocabulary(contents[PIECES].decode("utf-8").splitlines())
        self._session = onnx_session(folder / NETWORK)

    def vectors(self, texts: Sequence[str]) -> "Vectors":
        """Return the vector of each text, one row each; there must be at least one text."""
        # Texts of like lengths are encoded together: the others of a group are filled up to the longest.
        numbered = [self._numbers(text) for text in texts]
        order = sorted(range(len(texts)), key=lambda place: len(numbered[place]))
        groups = [order[start : start + _MOST_TEXTS] for start in range(0, len(order), _MOST_TEXTS)]
        found = np.concatenate([self._encoded([numbered[place] for place in group]) for group in groups])
        rows: Vectors = np.empty_like(found)
        rows[order] = found
        return rows

    def _numbers(self, text: str) -> List[int]:
        vocabulary = self._vocabulary
        return [vocabulary.start, *vocabulary.of_word(text)[:MOST_PIECES], vocabulary.end]

    def _encoded(self, group: Sequence[Sequence[int]]) -> "Vectors":
        longest = max(map(len, group))
        numbers = np.zeros((len(group), longest), np.int64)
        mask = np.zeros((len(group), longest), np.float32)
        for row, pieces in enumerate(group):
            numbers[row, : len(pieces)] = pieces
            mask[row, : len(pieces)] = 1.0
        (vectors,) = self._session.run([VECTORS], {NUMBERS: numbers, MASK: mask})
        return np.asarray(vectors, np.float32)
