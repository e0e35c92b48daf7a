"""The file of vectors that set-up computes for the examples of the shipped lexical units: the first search is quick."""

import zipfile
from pathlib import Path
from typing import TYPE_CHECKING, Dict, Mapping

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

#: Its name, in the folder of the encoder.
VECTORS_FILE = "vectors.npz"


def write_vectors(path: Path, vectors: Mapping[str, "NDArray[np.float32]"]) -> None:
    """Write the vectors of texts, with 16 bits; there must be at least one."""
    np.savez(path, texts=np.array(list(vectors)), rows=np.stack(list(vectors.values())).astype(np.float16))


def read_vectors(path: Path) -> Dict[str, "NDArray[np.float32]"]:
    """Read the vectors of texts; none if there is no such file, or it cannot be read: they are computed again."""
    try:
        with np.load(path, allow_pickle=False) as content:
            texts, rows = content["texts"].tolist(), content["rows"]
    except (OSError, EOFError, ValueError, KeyError, zipfile.BadZipFile):
        return {}
    return dict(zip(texts, rows))
