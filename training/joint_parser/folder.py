"""What a prepared folder holds besides sentences: the encoder, the labels, the pieces."""

import json
from pathlib import Path
from typing import Dict, Tuple

import numpy as np
from numpy.typing import NDArray

from joint_parser.data import Labels
from stanford_parser_ros.joint.pieces import PieceVocabulary


def read_encoder(path: Path) -> Dict[str, "NDArray[np.float32]"]:
    """Read what :func:`joint_parser.preparing.prepare` wrote."""
    with np.load(path, allow_pickle=False) as stored:
        found = {name: stored[name].astype(np.float32) for name in stored.files}
    found["pieces.weight"] = found.pop("pieces.numbers") * found.pop("pieces.scale")
    return found


def read_folder(folder: Path) -> Tuple[Labels, PieceVocabulary]:
    """Return the labels and pieces of a prepared folder."""
    content = json.loads((folder / "labels.json").read_text(encoding="utf-8"))
    labels = Labels(*(tuple(content[kind]) for kind in ("upos", "xpos", "feats", "deprel")))
    return labels, PieceVocabulary((folder / "pieces.txt").read_text(encoding="utf-8").splitlines())
