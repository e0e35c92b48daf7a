"""From treebanks, units and the encoder's package to the folder that a training reads."""

import json
from pathlib import Path
from typing import Dict, List

import numpy as np

from command_models import generate, mining, treebanks
from command_models.conllu import read
from command_models.constructions import corpus, units
from command_models.lexicon import evaluation_words
from joint_parser import encoder
from joint_parser.data import Example, Labels, example, write_examples


def prepare(
    *,
    ewt: Path,
    childes: Path,
    domains: Path,
    package: Path,
    out: Path,
    seed: int,
    taught: int = 20000,
    most: int = 20000,
) -> Dict[str, int]:
    """Write the folder of a training; return the numbers of sentences and pieces.

    Raises:
        TrainingError: an input is missing or another
    """
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
                *generate.training(6000, seed, mined),
                *generate.elaborate(4000, seed + 1, mined),
                *corpus.taught(taught, seed + 2, mined, verbs),
            )
        ],
        "scored": [example(one, one.comment("construction")) for one in corpus.scored(seed + 3, verbs)],
        "scored-taught": [
            example(one, one.comment("construction")) for one in corpus.scored(seed + 4, verbs, 15, taught_too=True)
        ],
    }
    for name, examples in sets.items():
        write_examples(out / f"{name}.xz", examples)
    labels = Labels.of(sets["ewt-train"])
    arrays, pieces = encoder.read_package(package)
    words = (form for name in ("ewt-train", "childes", "generated") for one in sets[name] for form in one.form)
    kept = encoder.kept_pieces(pieces, words, most)
    (out / "labels.json").write_text(json.dumps(labels.as_json(), indent=1) + "\n", encoding="utf-8")
    (out / "pieces.txt").write_text("\n".join(pieces[number] for number in kept) + "\n", encoding="utf-8")
    _write_encoder(out / "encoder.npz", encoder.initial_weights(arrays, kept))
    return {**{name: len(examples) for name, examples in sets.items()}, "pieces": len(kept)}


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
