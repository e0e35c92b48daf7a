"""How alike texts are in meaning; the encoder is loaded when this is first asked, and not before."""

from pathlib import Path
from typing import TYPE_CHECKING, Callable, Dict, List, Optional, Sequence, Tuple

import numpy as np

from nearest_meaning.encoder import Encoder, made_folder
from nearest_meaning.vector_file import VECTORS_FILE, read_vectors
from stanford_parser_ros.model_error import ModelError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Vector = NDArray[np.float32]
    Vectors = NDArray[np.float32]


class Likeness:
    """Compares texts; one thread uses it at a time.

    Attributes:
        problem: why there is no encoder; empty until it was needed, and if there is one
    """

    def __init__(self, folder: Optional[Path] = None, *, load: Callable[[Path], Encoder] = Encoder) -> None:
        """
        Args:
            folder: of the encoder; None for the one that set-up has made
            load: loads it
        """
        self._folder = folder if folder is not None else made_folder()
        self._load = load
        self._encoder: Optional[Encoder] = None
        self._vectors: Dict[str, Vector] = {}
        self._compared: Tuple[Tuple[str, ...], Optional[Vectors]] = ((), None)
        self.problem = ""

    @property
    def is_loaded(self) -> bool:
        """Whether the encoder is loaded."""
        return self._encoder is not None

    def of(self, text: str, others: Tuple[str, ...]) -> Tuple[float, ...]:
        """Return how like a text is to each of the others: 1 for the same, about 0 for what has nothing to do with it.

        Args:
            text: the text
            others: the texts that it is compared with; their vectors are kept
        Returns:
            nothing if there is no encoder, which :attr:`problem` explains, or no other text
        """
        if not others or not self._is_ready():
            return ()
        return tuple(float(one) for one in self._rows(others) @ self._encoded([text])[0])

    def _is_ready(self) -> bool:
        if self._encoder is None and not self.problem:
            try:
                self._encoder = self._load(self._folder)
                self._vectors = read_vectors(self._folder / VECTORS_FILE)
            except ModelError as error:
                self.problem = str(error)
        return self._encoder is not None

    def _encoded(self, texts: Sequence[str]) -> "Vectors":
        assert self._encoder is not None
        return self._encoder.vectors(texts)

    def _rows(self, texts: Tuple[str, ...]) -> "Vectors":
        """Return the vectors of the texts that are compared with: as a rule, those of the time before."""
        known, rows = self._compared
        if rows is None or (known is not texts and known != texts):
            new: List[str] = [text for text in dict.fromkeys(texts) if text not in self._vectors]
            if new:
                self._vectors.update(zip(new, self._encoded(new)))
            rows = np.stack([self._vectors[text] for text in texts]).astype(np.float32)
            self._compared = (texts, rows)
        return rows
