"""The folder of the joint model: its files, checked by their sums."""

import hashlib
import json
from pathlib import Path
from typing import Dict, NamedTuple, Tuple

from stanford_parser_ros.inference import ModelError

MANIFEST, NETWORK, LABELS, PIECES = "manifest.json", "parser.onnx", "labels.json", "pieces.txt"
FILES = (NETWORK, LABELS, PIECES)
KINDS = ("upos", "xpos", "feats", "deprel")
_HINT = "fetch it again with 'git checkout -- src/stanford_parser_ros/models', or set ~runtime to stanza"


class JointFiles(NamedTuple):
    """What the folder holds.

    Attributes:
        network: file for ONNX Runtime, which reads it with less memory than its bytes
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
    manifest = _read(folder / MANIFEST)
    try:
        sums = {entry["path"]: entry["sha256"] for entry in json.loads(manifest)["files"]}
    except (ValueError, KeyError, TypeError) as error:
        raise ModelError(f"{folder / MANIFEST} names no files with their sums ({error!r}); {_HINT}") from error
    contents: Dict[str, bytes] = {}
    for name in FILES:
        content = _read(folder / name)
        found = hashlib.sha256(content).hexdigest()
        if name != NETWORK:
            contents[name] = content
        del content
        if found != sums.get(name):
            raise ModelError(
                f"{folder / name}: SHA-256 is {found}, and {MANIFEST} says {sums.get(name, 'nothing of it')}; {_HINT}"
            )
    labels = json.loads(contents[LABELS])
    return JointFiles(
        folder / NETWORK,
        {kind: tuple(labels[kind]) for kind in KINDS},
        tuple(contents[PIECES].decode("utf-8").splitlines()),
    )


def _read(path: Path) -> bytes:
    try:
        return path.read_bytes()
    except OSError as error:
        raise ModelError(f"no joint model: {error}; {_HINT}") from error


def write_manifest(folder: Path) -> None:
    """Write the sums of the files of a folder."""
    entries = []
    for name in FILES:
        content = (folder / name).read_bytes()
        entries.append({"path": name, "bytes": len(content), "sha256": hashlib.sha256(content).hexdigest()})
    manifest = {"files": entries, "bytes": sum(int(str(entry["bytes"])) for entry in entries)}
    (folder / MANIFEST).write_text(json.dumps(manifest, indent=1) + "\n", encoding="utf-8")
