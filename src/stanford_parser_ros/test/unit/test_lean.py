"""The lean runtime gives the trees of Stanza: those that are recorded."""

import itertools
import pickle
import random
import zipfile
from pathlib import Path
from typing import Dict, List

import numpy as np
import pytest

from roboframenet_testing.recorded_parses import Key, key_of_text, read_shipped_recording, render_recording
from stanford_parser_ros.inference import ModelError, shipped_model_dir
from stanford_parser_ros.lean.inference import LeanInference
from stanford_parser_ros.lean.model_files import UnreadableModel, read_model_file
from stanford_parser_ros.lean.spanning_tree import heads_of_best_tree
from utterance_passes.tree import DependencyTree

#: Recorded parses of each kind (of a text, of given tags) that ``make test`` compares, at most.
SAMPLE = 200
SEED = 13


@pytest.fixture(scope="module")
def lean() -> LeanInference:
    return LeanInference(model_dir=shipped_model_dir())


@pytest.fixture(scope="module")
def recorded() -> Dict[Key, DependencyTree]:
    return read_shipped_recording()


def answers(models: LeanInference, recorded: Dict[Key, DependencyTree]) -> Dict[Key, DependencyTree]:
    return {
        key: models.parse(key[0]) if key == key_of_text(key[0]) else models.reparse(tree)
        for key, tree in recorded.items()
    }


def test_a_sample_of_the_recorded_parses_is_what_the_lean_runtime_says(
    lean: LeanInference, recorded: Dict[Key, DependencyTree]
) -> None:
    first = sorted(key for key in recorded if key == key_of_text(key[0]))
    second = sorted(set(recorded) - set(first))
    chance = random.Random(SEED)
    keys = [*chance.sample(first, SAMPLE), *chance.sample(second, min(SAMPLE, len(second)))]
    sample = {key: recorded[key] for key in keys}
    assert render_recording(answers(lean, sample)) == render_recording(sample)


@pytest.mark.acceptance
def test_all_recorded_parses_are_what_the_lean_runtime_says(
    lean: LeanInference, recorded: Dict[Key, DependencyTree]
) -> None:
    assert render_recording(answers(lean, recorded)) == render_recording(recorded)


def trees(size: int) -> List[List[int]]:
    """All trees of a root and some words with one word on the root, as heads."""
    found = []
    for heads in itertools.product(range(size), repeat=size - 1):
        if heads.count(0) != 1:
            continue
        reached = {0}
        for _ in range(size):
            reached |= {word for word, head in enumerate(heads, 1) if head in reached}
        if len(reached) == size:
            found.append([0, *heads])
    return found


def test_the_best_tree_is_the_best_of_all_trees() -> None:
    chance = np.random.default_rng(SEED)
    for size in (2, 3, 4, 5):
        every = trees(size)
        for _ in range(60):
            scores = -(chance.random((size, size)) ** 3) * 20.0
            best = max(every, key=lambda tree: sum(scores[word, tree[word]] for word in range(1, size)))
            assert heads_of_best_tree(scores) == best


def test_model_files_hold_data_only(tmp_path: Path) -> None:
    class Harm:
        def __reduce__(self) -> object:
            return (Path.touch, (tmp_path / "harmed",))

    path = tmp_path / "model.pt"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("model/data.pkl", pickle.dumps({"model": Harm()}, protocol=2))
    with pytest.raises(UnreadableModel, match="asks for"):
        read_model_file(path)
    assert not (tmp_path / "harmed").exists()


@pytest.mark.parametrize("content", [b"", b"no model", pickle.dumps(3), pickle.dumps([1, 2])[:-1]])
def test_broken_model_files_are_one_clear_error(content: bytes, tmp_path: Path) -> None:
    path = tmp_path / "model.pt"
    path.write_bytes(content)
    with pytest.raises(UnreadableModel, match="model"):
        read_model_file(path)


def test_models_of_another_kind_are_left_to_stanza(tmp_path: Path) -> None:
    for file in sorted(shipped_model_dir().rglob("*.*")):
        copy = tmp_path / file.relative_to(shipped_model_dir())
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.symlink_to(file)
    LeanInference(model_dir=tmp_path)
    (tmp_path / "en" / "constituency").mkdir()
    (tmp_path / "en" / "constituency" / "x.pt").write_bytes(b"")
    with pytest.raises(ModelError, match="runtime to stanza"):
        LeanInference(model_dir=tmp_path)
    with pytest.raises(ModelError, match="runtime to stanza"):
        LeanInference(model_dir=shipped_model_dir(), package="other")
    (tmp_path / "en" / "constituency" / "x.pt").unlink()
    (tmp_path / "en" / "pos" / "command.pt").unlink()
    (tmp_path / "en" / "pos" / "command.pt").symlink_to(tmp_path / "en" / "lemma" / "command.pt")
    with pytest.raises(ModelError, match="runtime to stanza"):
        LeanInference(model_dir=tmp_path)
