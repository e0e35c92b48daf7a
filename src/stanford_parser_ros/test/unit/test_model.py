"""The shipped models, loaded once for all tests of this module."""

import socket
from pathlib import Path

import pytest

from stanford_parser_ros.model import ModelError, Parser, UnparsableText, shipped_model_dir


@pytest.fixture(scope="module")
def parser() -> Parser:
    def refuse(*_arguments: object, **_keywords: object) -> None:
        raise AssertionError("the parser opened a connection")

    connect = socket.socket.connect
    socket.socket.connect = refuse
    try:
        return Parser(model_dir=shipped_model_dir(), cache_size=2)
    finally:
        socket.socket.connect = connect


@pytest.mark.parametrize(
    "text, verb",
    [
        ("Turn left 120 degrees.", "turn"),
        ("move backwards one metre", "move"),
        ("Give me 5.", "give"),
        ("follow me", "follow"),
        ("Go to the office.", "go"),
    ],
)
def test_verb_of_a_command_is_the_root(parser: Parser, text: str, verb: str) -> None:
    (root,) = parser.parse(text).children(0)
    assert (root.lemma, root.upos) == (verb, "VERB")


def test_known_verb_at_the_front_is_the_root_whatever_it_looks_like(parser: Parser) -> None:
    tree = parser.parse("Bulldoze it.", frozenset(["bulldoze"]))
    assert (tree.word(1).deprel, tree.word(1).upos) == ("root", "VERB")


def test_characters_are_those_of_the_text_as_it_was_said(parser: Parser) -> None:
    said = "  turn   90°  to Roger’s office"
    for word in parser.parse(said).words:
        if word.form in ("turn", "90", "to", "Roger", "office"):
            assert said[word.start_character : word.end_character] == word.form


def test_several_sentences_are_one_tree(parser: Parser) -> None:
    assert len(parser.parse("Go to the kitchen. Turn left.").children(0)) == 1


@pytest.mark.parametrize("text", ["", "   ", "?!", "..."])
def test_text_without_words_is_refused(parser: Parser, text: str) -> None:
    with pytest.raises(UnparsableText):
        parser.parse(text)


def test_cache_is_bounded_and_gives_the_same_tree(parser: Parser) -> None:
    first = parser.parse("go home")
    assert parser.parse("go home") is first
    parser.parse("go left")
    parser.parse("go right")
    assert parser.parse("go home") is not first


@pytest.mark.parametrize("name", ["nowhere", "empty"])
def test_missing_models_are_one_clear_error(name: str, tmp_path: Path) -> None:
    (tmp_path / "empty").mkdir()
    with pytest.raises(ModelError, match=name):
        Parser(model_dir=tmp_path / name)


def test_broken_model_is_one_clear_error(tmp_path: Path) -> None:
    for processor in ("tokenize", "mwt", "pos", "lemma", "depparse"):
        (tmp_path / "en" / processor).mkdir(parents=True)
        (tmp_path / "en" / processor / "x.pt").write_bytes(b"no model")
    (tmp_path / "resources.json").write_text("{}")
    with pytest.raises(ModelError, match="cannot be loaded"):
        Parser(model_dir=tmp_path)
