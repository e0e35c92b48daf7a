"""The joint model: pieces of words, windows, the folder, and what the network's scores say."""

import hashlib
import json
import shutil
from pathlib import Path
from typing import List
from unittest import mock

import pytest

from stanford_parser_ros.checked_folder import MANIFEST
from stanford_parser_ros.inference import ModelError, shipped_model_dir
from stanford_parser_ros.joint.inference import described
from stanford_parser_ros.joint.model_folder import NETWORK, PIECES, read_joint_folder
from stanford_parser_ros.joint.network import MOST_PIECES, Governor, JointNetwork, pool
from stanford_parser_ros.joint.pieces import SHAPES, PieceVocabulary, shape
from stanford_parser_ros.joint.windows import windows
from utterance_passes.trees.tree import Alternative, DependencyTree, Word

#: A network of few weights that knows nothing; ``training/joint_parser/tiny.py`` makes it.
TINY = Path(__file__).parent / "joint_tiny"
VOCABULARY = PieceVocabulary("[UNK] [CLS] [SEP] un ##able able ##a ##b a b go ' s café cafe".split())


@pytest.fixture(scope="module")
def network() -> JointNetwork:
    return JointNetwork(TINY)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return Path(shutil.copytree(TINY, tmp_path / "joint"))


@pytest.mark.parametrize(
    ("word", "numbers"),
    [
        ("Unable", [3, 4]),
        ("ab", [8, 7]),
        ("café", [14]),
        ("go's", [10, 11, 12]),
        ("xyz", [0]),
        ("", [0]),
        ("\u200b", [0]),
        ("go go", [10, 10]),
        ("漢字", [0]),
    ],
)
def test_pieces_are_the_longest_that_are_known(word: str, numbers: List[int]) -> None:
    assert list(VOCABULARY.of_word(word)) == numbers


def test_pieces_of_a_sentence() -> None:
    found = VOCABULARY.of_sentence(["Unable", "go", "5"])
    assert found.numbers == [1, 3, 4, 10, 0, 2]
    assert found.first == [1, 3, 4]
    assert [SHAPES[n] for n in found.shapes] == ["other", "Title", "Title", "lower", "number", "other"]


@pytest.mark.parametrize(
    ("word", "name"),
    [
        ("go", "lower"),
        ("Go", "Title"),
        ("A", "Title"),
        ("TV", "UPPER"),
        ("iPad", "mixed"),
        ("5pm", "number"),
        (".", "other"),
    ],
)
def test_shapes(word: str, name: str) -> None:
    assert SHAPES[shape(word)] == name


def test_the_share_of_pieces_in_words_is_their_mean() -> None:
    shares = pool(VOCABULARY.of_sentence(["unable", "go"]))
    assert shares.tolist() == [[1, 0, 0, 0, 0], [0, 0.5, 0.5, 0, 0], [0, 0, 0, 1, 0]]


@pytest.mark.parametrize("count", [1, 5, 6, 7, 12, 40])
@pytest.mark.parametrize("size", [1, 2, 5])
def test_each_word_is_read_in_one_window_that_holds_it(count: int, size: int) -> None:
    found = windows([size] * count, 6)
    read = [word for part in found for word in range(part.first, part.last)]
    assert read == list(range(count))
    for part in found:
        assert part.start <= part.first < part.last <= part.end
        assert (part.end - part.start) * size <= 6
    for part, following in zip(found, found[1:]):
        assert following.start > part.start


@pytest.mark.parametrize("words", [1, 2, 9, 100, MOST_PIECES, MOST_PIECES + 1, 900])
def test_a_sentence_of_any_length_is_one_tree(network: JointNetwork, words: int) -> None:
    forms = ("bring the mugs to the kitchen and put it on the table .".split() * words)[:words]
    found = network.analyse(forms)
    assert len(found.heads) == words
    assert found.heads.count(0) == 1 == found.relations.count("root")
    assert found.heads.index(0) == found.relations.index("root")
    for word in range(1, words + 1):
        seen = set()
        while word:
            assert word not in seen
            seen.add(word)
            word = found.heads[word - 1]


def test_words_of_any_script_and_length_are_read(network: JointNetwork) -> None:
    found = network.analyse(["漢字", "\u0000", "x" * 5000, "🤖", "go"])
    assert len(found.upos) == 5


def test_a_sentence_without_words_is_an_error(network: JointNetwork) -> None:
    with pytest.raises(ValueError, match="without words"):
        network.analyse([])


def test_other_governors_have_their_probability(network: JointNetwork) -> None:
    found = network.analyse("bring the mug to the table .".split())
    for head, relation, governors in zip(found.heads, found.relations, found.governors):
        assert (head, relation) == (governors[0].head, governors[0].relation)
        shares = [one.probability for one in governors]
        assert shares[1:] == sorted(shares[1:], reverse=True)
        assert 0.0 < sum(shares) <= 1.0 + 1e-6
        assert len({one.head for one in governors}) == len(governors)
    assert any(len(governors) > 1 for governors in found.governors)


def test_the_same_sentence_has_the_same_analysis(network: JointNetwork) -> None:
    words = "put it on the table".split()
    assert network.analyse(words) == network.analyse(words)


def word(index: int, form: str, head: int, deprel: str) -> Word:
    return Word(index, form, form, "X", "", "", head, deprel)


def test_described_names_the_words_that_may_hang_elsewhere() -> None:
    words = (word(1, "put", 0, "root"), word(2, "it", 1, "obj"))
    others = (Alternative(2, 0, "root", 0.26), Alternative(2, 2, "dep", 0.04))
    tree = DependencyTree("put it", words, alternatives=others)
    assert described(tree) == ("it: obj of put; or root, 26%",)


def test_a_file_that_was_cut_is_one_clear_error(folder: Path) -> None:
    path = folder / NETWORK
    path.write_bytes(path.read_bytes()[:-10])
    with pytest.raises(
        ModelError, match=r"parser.onnx: SHA-256 is [0-9a-f]{64}, and manifest.json says .*git checkout"
    ):
        read_joint_folder(folder)


def test_a_missing_file_is_one_clear_error(folder: Path) -> None:
    (folder / PIECES).unlink()
    with pytest.raises(ModelError, match=r"pieces.txt.*git checkout"):
        read_joint_folder(folder)


@pytest.mark.parametrize("content", ["", "[]", '{"files": 3}', '{"files": [{"path": "x"}]}'])
def test_a_broken_manifest_is_one_clear_error(folder: Path, content: str) -> None:
    (folder / MANIFEST).write_text(content, encoding="utf-8")
    with pytest.raises(ModelError, match=MANIFEST):
        read_joint_folder(folder)


def test_another_file_than_a_network_is_one_clear_error(folder: Path) -> None:
    (folder / NETWORK).write_bytes(b"no network")
    manifest = json.loads((folder / MANIFEST).read_text(encoding="utf-8"))
    for entry in manifest["files"]:
        if entry["path"] == NETWORK:
            entry["sha256"] = hashlib.sha256(b"no network").hexdigest()
    (folder / MANIFEST).write_text(json.dumps(manifest), encoding="utf-8")
    with pytest.raises(ModelError, match="ONNX Runtime cannot load"):
        JointNetwork(folder)


def test_without_onnx_runtime_the_command_that_installs_it_is_named() -> None:
    with mock.patch.dict("sys.modules", {"onnxruntime": None}), pytest.raises(ModelError, match="make setup"):
        JointNetwork(TINY)


def test_the_variant_of_stanza_gives_the_same_trees(network: JointNetwork) -> None:
    stanza = pytest.importorskip("stanza")
    from stanford_parser_ros.joint.stanza_variants import register

    processors = register(TINY)
    pipeline = stanza.Pipeline(
        "en",
        dir=str(shipped_model_dir()),
        processors=processors,
        download_method=None,
        use_gpu=False,
        tokenize_no_ssplit=True,
        logging_level="ERROR",
    )
    (sentence,) = pipeline("Put the mug on the table.").sentences
    found = network.analyse([one.text for one in sentence.words])
    assert [one.head for one in sentence.words] == list(found.heads)
    assert [one.deprel for one in sentence.words] == list(found.relations)
    assert [one.upos for one in sentence.words] == list(found.upos)
    assert len(sentence.dependencies) == len(sentence.words)


def test_a_word_alone_is_the_root_for_certain(network: JointNetwork) -> None:
    assert network.analyse(["go"]).governors == ((Governor(0, "root", 1.0),),)
