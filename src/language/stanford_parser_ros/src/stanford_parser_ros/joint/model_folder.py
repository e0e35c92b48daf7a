"""The folder of the joint model."""

import json
from pathlib import Path
from typing import Dict, NamedTuple, Tuple

from stanford_parser_ros import checked_folder

NETWORK, LABELS, PIECES = "parser.onnx", "labels.json", "pieces.txt"
FILES = (NETWORK, LABELS, PIECES)
KINDS = ("upos", "xpos", "feats", "deprel")


class JointFiles(NamedTuple):
    """What the folder holds.

    Attributes:
        network: file for ONNX Runtime
        labels: of tags and relations, by kind
        pieces: of the encoder
    """

    network: Path
    labels: Dict[str, Tuple[str, ...]]
    pieces: Tuple[str, ...]


def read_joint_folder(folder: Path) -> JointFiles:
    """Read the folder.

    Raises:
        ModelError: a file is missing, or is not the one that was packed
    """
    contents = checked_folder.read_checked(folder, FILES)
    labels = json.loads(contents[LABELS])
    return JointFiles(
        folder / NETWORK,
        {kind: tuple(labels[kind]) for kind in KINDS},
        tuple(contents[PIECES].decode("utf-8").splitlines()),
    )


def write_manifest(folder: Path) -> None:
    """Write the sums of the files of a folder."""
    checked_folder.write_manifest(folder, FILES)
