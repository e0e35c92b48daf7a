"""Packs trained models into a folder that Stanza's own constructor loads offline."""

import hashlib
import json
import shutil
from dataclasses import dataclass
from pathlib import Path
from typing import Dict, List, Tuple

from .errors import TrainingError

PACKAGE = "command"
LIMIT = 25 * 1024 * 1024  # bytes: what a repository should carry
# processor -> trained file; vectors stay fp32, because Stanza uses them unchanged
_SOURCES: Tuple[Tuple[str, str, bool], ...] = (
    ("pretrain", "vectors.pt", False),
    ("tokenize", "tokenizer.pt", True),
    ("mwt", "mwt.pt", True),
    ("pos", "tagger.pt", True),
    ("lemma", "lemma.pt", True),
    ("depparse", "parser.pt", True),
)
_WITH_VECTORS = ("pos", "depparse")


@dataclass(frozen=True)
class Packed:
    """One file of the package: its path under the folder, its size in bytes, its md5."""

    path: str
    size: int
    md5: str


def halved(node: object) -> object:
    """Return a checkpoint with its 32-bit tensors as 16-bit ones; loading converts them back."""
    import torch

    if isinstance(node, torch.Tensor):
        return node.half() if node.dtype == torch.float32 else node
    if isinstance(node, dict):
        return type(node)((key, halved(value)) for key, value in node.items())
    if isinstance(node, list):
        return [halved(value) for value in node]
    if isinstance(node, tuple) and type(node) is tuple:
        return tuple(halved(value) for value in node)
    return node


def without_folders(settings: Dict[str, object]) -> Dict[str, object]:
    """Return the settings of a training with the names of its files only: where they lay says nothing to others."""

    def name_of(value: object) -> object:
        if not isinstance(value, str) or not value.startswith("/"):
            return value
        return ";".join(Path(path).name for path in value.split(";"))

    return {key: name_of(value) for key, value in settings.items()}


def resources(md5s: Dict[str, str]) -> Dict[str, object]:
    """Return Stanza's index of a model folder for one English package; ``md5s`` by processor."""
    processors: Dict[str, object] = {}
    for processor, _, _ in _SOURCES:
        entry: Dict[str, object] = {"md5": md5s[processor]}
        if processor in _WITH_VECTORS:
            entry["dependencies"] = [{"model": "pretrain", "package": PACKAGE}]
        processors[processor] = {PACKAGE: entry}
    default = {processor: PACKAGE for processor, _, _ in _SOURCES if processor != "pretrain"}
    english: Dict[str, object] = {"lang_name": "English", "packages": {"default": default, PACKAGE: default}}
    english.update(processors)
    return {"en": english}


def pack(trained: Path, target: Path, versions: Dict[str, str]) -> List[Packed]:
    """Write the package; the manifest holds ``versions``, sizes and md5s.

    Raises TrainingError when a trained file is missing or the package is too large.
    """
    import torch

    packed: List[Packed] = []
    md5s: Dict[str, str] = {}
    for processor, source, small in _SOURCES:
        path = trained / source
        if not path.is_file():
            raise TrainingError(f"{path}: no such file; train the {processor} model first")
        place = target / "en" / processor
        place.mkdir(parents=True, exist_ok=True)
        out = place / (PACKAGE + ".pt")
        if small:
            checkpoint = torch.load(str(path), map_location="cpu", weights_only=True)
            checkpoint.pop("optimizer_state_dict", None)
            checkpoint["config"] = without_folders(checkpoint["config"])
            torch.save(halved(checkpoint), str(out), _use_new_zipfile_serialization=True)
        else:
            shutil.copyfile(str(path), str(out))
        digest = hashlib.md5(out.read_bytes()).hexdigest()
        md5s[processor] = digest
        packed.append(Packed(f"en/{processor}/{PACKAGE}.pt", out.stat().st_size, digest))
    total = sum(entry.size for entry in packed)
    if total > LIMIT:
        raise TrainingError(f"the package is {total} bytes, the limit is {LIMIT}; use fewer vectors")
    (target / "resources.json").write_text(json.dumps(resources(md5s), indent=2) + "\n", encoding="utf-8")
    manifest = {
        "package": PACKAGE,
        "versions": versions,
        "bytes": total,
        "files": [{"path": entry.path, "bytes": entry.size, "md5": entry.md5} for entry in packed],
    }
    (target / "manifest.json").write_text(json.dumps(manifest, indent=2) + "\n", encoding="utf-8")
    return packed
