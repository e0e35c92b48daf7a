"""Likeness of texts: the encoder is loaded when it is first needed, and what it computed is kept."""

from pathlib import Path
from typing import Any, List, Sequence

import numpy as np
import pytest

from nearest_meaning.encoder import NETWORK, Encoder, made_folder
from nearest_meaning.likeness import Likeness
from nearest_meaning.vector_file import VECTORS_FILE, read_vectors, write_vectors
from stanford_parser_ros.model_error import ModelError

needs_encoder = pytest.mark.skipif(not (made_folder() / NETWORK).is_file(), reason="set-up has made no encoder")


class Counting:
    """An encoder of letters, which remembers what it was asked."""

    def __init__(self) -> None:
        self.asked: List[str] = []

    def vectors(self, texts: Sequence[str]) -> Any:
        self.asked += texts
        rows = np.array([[text.count(letter) for letter in "abc"] for text in texts], np.float32)
        return rows / np.linalg.norm(rows, axis=1, keepdims=True)


def test_nothing_is_loaded_before_the_first_need(tmp_path: Path) -> None:
    loaded: List[Path] = []

    def load(folder: Path) -> Any:
        loaded.append(folder)
        return Counting()

    likeness = Likeness(tmp_path, load=load)
    assert likeness.of("a", ()) == () and not loaded and not likeness.is_loaded
    assert likeness.of("a", ("a", "b")) == pytest.approx((1.0, 0.0))
    likeness.of("b", ("a", "b"))
    assert loaded == [tmp_path] and likeness.is_loaded


def test_what_is_compared_with_is_encoded_once(tmp_path: Path) -> None:
    encoder: Any = Counting()
    likeness = Likeness(tmp_path, load=lambda _: encoder)
    likeness.of("aab", ("a", "b"))
    likeness.of("c", ("a", "b", "cc"))
    assert sorted(encoder.asked) == ["a", "aab", "b", "c", "cc"]


def test_vectors_that_set_up_computed_are_not_computed_again(tmp_path: Path) -> None:
    write_vectors(tmp_path / VECTORS_FILE, {"a": np.array([0, 1, 0], np.float32)})
    encoder: Any = Counting()
    assert Likeness(tmp_path, load=lambda _: encoder).of("b", ("a",)) == pytest.approx((1.0,))
    assert encoder.asked == ["b"]


@pytest.mark.parametrize("content", [b"", b"no archive", b"PK\x03\x04 cut"])
def test_a_damaged_file_of_vectors_holds_nothing(tmp_path: Path, content: bytes) -> None:
    (tmp_path / VECTORS_FILE).write_bytes(content)
    assert read_vectors(tmp_path / VECTORS_FILE) == {} == read_vectors(tmp_path / "none.npz")


def test_without_an_encoder_nothing_is_compared_and_the_reason_is_told(tmp_path: Path) -> None:
    likeness = Likeness(tmp_path)
    assert likeness.of("a", ("a", "b")) == ()
    assert str(tmp_path) in likeness.problem and not likeness.is_loaded


@needs_encoder
def test_what_means_the_same_is_nearer_than_what_shares_its_words() -> None:
    likeness = Likeness()
    same, shared, other = likeness.of("stroll to the kitchen", ("walk to the kitchen", "clean the kitchen", "wave"))
    assert same > shared > other and likeness.problem == ""


@needs_encoder
def test_the_vector_of_a_text_does_not_depend_on_the_texts_beside_it() -> None:
    encoder = Encoder(made_folder())
    texts = ["go", "bring me the red mug from the shelf in the kitchen", "wave"]
    together, alone = encoder.vectors(texts), np.concatenate([encoder.vectors([text]) for text in texts])
    assert np.abs(together - alone).max() < 1e-4
    assert np.linalg.norm(together, axis=1) == pytest.approx(np.ones(3), abs=1e-4)


@needs_encoder
def test_a_changed_network_is_refused(tmp_path: Path) -> None:
    for file in made_folder().iterdir():
        (tmp_path / file.name).write_bytes(file.read_bytes())
    (tmp_path / NETWORK).write_bytes((tmp_path / NETWORK).read_bytes()[:-1])
    with pytest.raises(ModelError):
        Encoder(tmp_path)
