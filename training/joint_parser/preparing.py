"""From treebanks, units and the encoder's package to the folder that a training reads."""

import json
from pathlib import Path
from typing import Dict, List, Optional

import numpy as np

from command_models import generate, mining, treebanks
from command_models.conllu import read
from command_models.constructions import corpus, units
from command_models.errors import TrainingError
from command_models.lexicon import evaluation_words
from joint_parser import encoder, packaged
from joint_parser.data import Example, Labels, example, write_examples

#: Of the sentences for scoring, which no option changes.
_SCORED_SEED = 20265


def prepare(
    *,
    ewt: Path,
    childes: Path,
    domains: Path,
    out: Path,
    seed: int,
    package: Optional[Path] = None,
    start: Optional[Path] = None,
    taught: int = 20000,
    most: int = 20000,
) -> Dict[str, int]:
    """Write the folder of a training; return the numbers of sentences and pieces.

    Args:
        ewt, childes, domains: folders of treebanks and units
        out: is made
        seed: of the generated sentences; those for scoring are always the same
        package: of the encoder, for a training from the beginning
        start: packaged model that the training goes on from, instead of the package
        taught: generated sentences of constructions; half as many commands come beside them
        most: pieces that are kept
    Raises:
        TrainingError: an input is missing or another
    """
    if (package is None) == (start is None):
        raise TrainingError("name the encoder's package or a model to start from; expected one of the two")
    out.mkdir(parents=True, exist_ok=True)
    parts = treebanks.written(ewt)
    verbs = units.read_units(domains)
    mined = mining.mine([parts.train], evaluation_words())
    sets: Dict[str, List[Example]] = {
        "ewt-train": [example(one, "ewt") for one in read(parts.train)],
        "ewt-dev": [example(one, "ewt") for one in read(parts.dev)],
        "ewt-test": [example(one, "ewt") for one in read(parts.test)],
        "childes": [
            example(treebanks.as_written(one), "childes") for one in treebanks.spoken(childes, frozenset(), seed)
        ],
        "generated": [
            example(one, "generated")
            for one in (
                *generate.training(taught * 3 // 10, seed, mined),
                *generate.elaborate(taught * 2 // 10, seed + 1, mined),
                *corpus.taught(taught, seed + 2, mined, verbs),
            )
        ],
        "scored": [example(one, one.comment("construction")) for one in corpus.scored(_SCORED_SEED, verbs)],
        "scored-taught": [
            example(one, one.comment("construction"))
            for one in corpus.scored(_SCORED_SEED + 1, verbs, 15, taught_too=True)
        ],
    }
    for name, examples in sets.items():
        write_examples(out / f"{name}.xz", examples)
    if start is not None:
        files = packaged.read_files(start)
        labels, pieces = Labels(**files.labels), list(files.pieces)
        weights = packaged.read_weights(start)
    elif package is not None:
        labels = Labels.of(sets["ewt-train"])
        arrays, all_pieces = encoder.read_package(package)
        words = (form for name in ("ewt-train", "childes", "generated") for one in sets[name] for form in one.form)
        kept = encoder.kept_pieces(all_pieces, words, most)
        pieces, weights = [all_pieces[number] for number in kept], encoder.initial_weights(arrays, kept)
    (out / "labels.json").write_text(json.dumps(labels.as_json(), indent=1) + "\n", encoding="utf-8")
    (out / "pieces.txt").write_text("\n".join(pieces) + "\n", encoding="utf-8")
    _write_encoder(out / "encoder.npz", weights)
    return {**{name: len(examples) for name, examples in sets.items()}, "pieces": len(pieces)}


def _write_encoder(path: Path, weights: encoder.Arrays) -> None:
    """Write the weights with 16 bits, and those of the pieces with 8 bits and a scale for each."""
    packed: Dict[str, np.ndarray[object, np.dtype[np.generic]]] = {}
    for name, values in weights.items():
        if name == "pieces.weight":
            scale = np.abs(values).max(axis=1, keepdims=True) / 127.0 + 1e-12
            packed["pieces.numbers"] = np.round(values / scale).astype(np.int8)
            packed["pieces.scale"] = scale.astype(np.float32)
        else:
            packed[name] = values.astype(np.float16)
    new = path.with_suffix(".new")
    with new.open("wb") as stream:
        np.savez_compressed(stream, **packed)
    new.replace(path)  # what is there is whole
