"""Words and lemmas in ONNX Runtime: those of Stanza, of any text; and files that are not those that were packed."""

import json
import shutil
from pathlib import Path
from typing import List
from unittest import mock

import pytest

from stanford_parser_ros.checked_folder import MANIFEST, write_manifest
from stanford_parser_ros.inference import ModelError, shipped_model_dir
from stanford_parser_ros.words.word_folder import CUTS, ENDS, FILES, LEMMA, WORDS, read_word_folder
from stanford_parser_ros.words.words import FOLDER, Words

SHIPPED = shipped_model_dir() / FOLDER


@pytest.fixture(scope="module")
def words() -> Words:
    return Words(SHIPPED)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return Path(shutil.copytree(SHIPPED, tmp_path / "words"))


@pytest.mark.parametrize(
    ("text", "forms"),
    [
        ("Turn left 120 degrees.", "Turn|left|120|degrees|."),
        ("Don't can't gimme the dunno, I'd've gone.", "Do|n't|ca|n't|gimme|the|dunno|,|I|'d|'ve|gone|."),
        ("the wugs' blickets and Alice's", "the|wugs|'|blickets|and|Alice|'s"),
        ("\n\n go home\n\nturn left", "go|home"),
        ("mail it to bob@example.org now", "mail|it|to|bob@example.org|now"),
        ("Turn\u00a0left   two  metres", "Turn|left|two|metres"),
        ("x" * 1001, "<UNK>"),
    ],
)
def test_a_text_is_split_as_stanza_does(words: Words, text: str, forms: str) -> None:
    assert "|".join(words.split(text).forms) == forms


def test_each_word_has_its_place(words: Words) -> None:
    text = "She's  gone, don't  go"
    split = words.split(text)
    assert [text[start:end] for start, end in split.spans] == split.forms


@pytest.mark.parametrize(
    ("form", "upos", "lemma"),
    [
        ("went", "VERB", "go"),
        ("left", "VERB", "leave"),
        ("left", "ADJ", "left"),
        ("blickets", "NOUN", "blicket"),
        ("frobnicated", "VERB", "frobnicate"),
        ("XYZZYS", "NOUN", "xyzzys"),
        ("žluťoučkés", "NOUN", "bluťoučk"),
        ("漢字s", "NOUN", "漢字s"),
        ("señores", "NOUN", "señore"),
        ("☕", "SYM", "☕"),
        ("3.75", "NUM", "3.75"),
    ],
)
def test_a_word_has_the_lemma_that_stanza_gives(words: Words, form: str, upos: str, lemma: str) -> None:
    assert words.lemmas([form], [upos]) == [lemma]


def test_lemmas_that_were_spelled_are_kept_up_to_a_bound(words: Words) -> None:
    forms = [f"blick{number}s" for number in range(20)]
    once = words.lemmas(forms, ["NOUN"] * len(forms))
    with mock.patch("stanford_parser_ros.words.lemmas.Lemmatizer.MOST_KEPT", 3):
        assert words.lemmas(forms, ["NOUN"] * len(forms)) == once


@pytest.mark.parametrize("text", ["漢字 かな", "\u0000", "🤖" * 300, "اذهب إلى المطبخ", "go " * 500, "\u0301go"])
def test_texts_of_any_script_and_length_are_split(words: Words, text: str) -> None:
    split = words.split(text)
    assert split.forms
    assert all(words.lemmas(split.forms, ["NOUN"] * len(split.forms)))


@pytest.mark.parametrize("name", FILES)
def test_a_file_that_was_cut_is_one_clear_error(folder: Path, name: str) -> None:
    path = folder / name
    path.write_bytes(path.read_bytes()[:-10])
    with pytest.raises(ModelError, match=rf"{name}: SHA-256 is [0-9a-f]{{64}}, and manifest.json says .*git checkout"):
        read_word_folder(folder)


@pytest.mark.parametrize("name", [*FILES, MANIFEST])
def test_a_missing_file_is_one_clear_error(folder: Path, name: str) -> None:
    (folder / name).unlink()
    with pytest.raises(ModelError, match=rf"{name}.*git checkout"):
        Words(folder)


@pytest.mark.parametrize("content", ["", "[]", '{"files": 3}', '{"files": [{"path": "x"}]}'])
def test_a_broken_manifest_is_one_clear_error(folder: Path, content: str) -> None:
    (folder / MANIFEST).write_text(content, encoding="utf-8")
    with pytest.raises(ModelError, match=MANIFEST):
        read_word_folder(folder)


@pytest.mark.parametrize("name", [ENDS, CUTS, LEMMA])
def test_another_file_than_a_network_is_one_clear_error(folder: Path, name: str) -> None:
    (folder / name).write_bytes(b"no network")
    write_manifest(folder, FILES)
    with pytest.raises(ModelError, match=f"ONNX Runtime cannot load .*{name}"):
        Words(folder)


def test_words_of_another_package_are_refused(folder: Path) -> None:
    Words(folder, package="command")
    with pytest.raises(ModelError, match=r"package 'command', not of 'gum'.*export-words.*runtime to stanza"):
        Words(folder, package="gum")


def test_without_onnx_runtime_the_command_that_installs_it_is_named() -> None:
    with mock.patch.dict("sys.modules", {"onnxruntime": None}), pytest.raises(ModelError, match="make setup"):
        Words(SHIPPED)


def test_the_dictionary_is_data(words: Words) -> None:
    """Every entry of the shipped dictionary is what the lemmatizer says."""
    lemmas = json.loads((SHIPPED / WORDS).read_text(encoding="utf-8"))["lemmas"]
    nouns: List[str] = sorted(lemmas["NOUN"])
    assert words.lemmas(nouns, ["NOUN"] * len(nouns)) == [lemmas["NOUN"][form] for form in nouns]
