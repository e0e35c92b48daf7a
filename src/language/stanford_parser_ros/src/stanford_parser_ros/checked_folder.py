"""Folders of model files, checked by the sums in their manifest."""

import hashlib
import json
from pathlib import Path
from typing import Dict, Sequence

from stanford_parser_ros.model_error import ModelError

MANIFEST = "manifest.json"
_HINT = "fetch it again with 'git checkout -- src/language/stanford_parser_ros/models'"


def read_checked(folder: Path, names: Sequence[str]) -> Dict[str, bytes]:
    """Read the files of a folder.

    Args:
        folder: with a manifest
        names: of the files
    Raises:
        ModelError: a file is missing, or is not the one that was packed
    """
    manifest = _read(folder / MANIFEST)
    try:
        sums = {entry["path"]: entry["sha256"] for entry in json.loads(manifest)["files"]}
    except (ValueError, KeyError, TypeError) as error:
        raise ModelError(f"{folder / MANIFEST} names no files with their sums ({error!r}); {_HINT}") from error
    contents: Dict[str, bytes] = {}
    for name in names:
        contents[name] = _read(folder / name)
        found = hashlib.sha256(contents[name]).hexdigest()
        if found != sums.get(name):
            raise ModelError(
                f"{folder / name}: SHA-256 is {found}, and {MANIFEST} says {sums.get(name, 'nothing of it')}; {_HINT}"
            )
    return contents


def _read(path: Path) -> bytes:
    try:
        return path.read_bytes()
    except OSError as error:
        raise ModelError(f"a model file is missing: {error}; {_HINT}") from error


def write_manifest(folder: Path, names: Sequence[str]) -> None:
    """Write the sums of files into the manifest of their folder."""
    entries = []
    for name in names:
        content = (folder / name).read_bytes()
        entries.append({"path": name, "bytes": len(content), "sha256": hashlib.sha256(content).hexdigest()})
    manifest = {"files": entries, "bytes": sum(int(str(entry["bytes"])) for entry in entries)}
    (folder / MANIFEST).write_text(json.dumps(manifest, indent=1) + "\n", encoding="utf-8")
