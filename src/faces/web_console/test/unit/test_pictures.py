"""Arcs of dependencies, and the pictures that they become."""

from xml.etree import ElementTree

import pytest

from web_console.arcs import MOST_WORDS, ParsedWord, draw_arcs, levels, relation_kind, tell_arcs
from web_console.picture import Picture, Shape, as_svg

TURN = (
    ParsedWord(1, "Turn", "VERB", 0, "root"),
    ParsedWord(2, "left", "ADV", 1, "advmod"),
    ParsedWord(3, "120", "NUM", 4, "nummod"),
    ParsedWord(4, "degrees", "NOUN", 1, "obl:unmarked"),
    ParsedWord(5, ".", "PUNCT", 1, "punct"),
)


def texts(picture: Picture, kind: str):
    return [shape.text for shape in picture.shapes if ("class", kind) in shape.attributes]


def test_short_arcs_lie_below_long_ones():
    assert {word.form: level for word, level in levels(TURN)} == {"left": 1, "120": 1, "degrees": 2, ".": 3}


def test_arcs_carry_relations_and_words_their_tags():
    picture = draw_arcs(TURN)
    assert texts(picture, "label core") == ["obl:unmarked"]
    assert sorted(texts(picture, "label modifier")) == ["advmod", "nummod"]
    assert texts(picture, "word root") == ["Turn"]
    assert texts(picture, "word") == ["left", "120", "degrees", "."]
    assert texts(picture, "tag") == ["VERB", "ADV", "NUM", "NOUN", "PUNCT"]


def test_words_do_not_overlap():
    picture = draw_arcs(TURN)
    xs = [float(dict(shape.attributes)["x"]) for shape in picture.shapes if ("class", "tag") in shape.attributes]
    assert all(right - left > 30 for left, right in zip(xs, xs[1:]))
    assert xs[0] > 0 and xs[-1] < picture.width


def test_label_between_neighbours_has_room():
    near = draw_arcs((ParsedWord(1, "a", "X", 0, "root"), ParsedWord(2, "b", "X", 1, "a_very_long_relation")))
    far = draw_arcs((ParsedWord(1, "a", "X", 0, "root"), ParsedWord(2, "b", "X", 1, "obj")))
    assert near.width > far.width + 60


def test_picture_is_svg_and_markup_is_text():
    picture = draw_arcs((ParsedWord(1, '<script>"&', "X", 0, "root"),))
    root = ElementTree.fromstring(as_svg(picture))
    assert "script" not in {element.tag.rpartition("}")[2] for element in root.iter()}
    assert '<script>"&' in [element.text for element in root.iter()]


def test_pictures_have_no_other_shapes_and_attributes():
    with pytest.raises(ValueError, match="foreignObject"):
        Shape("foreignObject", ())
    with pytest.raises(ValueError, match="onload"):
        Shape("path", (("onload", "alert(1)"),))


def test_long_sentences_and_words_are_bounded():
    words = [ParsedWord(index, "w" * 500, "X", 0 if index == 1 else 1, "dep") for index in range(1, 400)]
    picture = draw_arcs(words)
    assert len(texts(picture, "tag")) == MOST_WORDS
    assert max(map(len, texts(picture, "word"))) < 30


def test_empty_and_broken_trees_are_drawn():
    assert draw_arcs(()).shapes == ()
    assert texts(draw_arcs((ParsedWord(1, "a", "X", 7, "dep"),)), "word") == ["a"]


def test_tree_is_told_in_words():
    assert tell_arcs(TURN[:2]) == "Turn is the root; left: advmod of Turn"


@pytest.mark.parametrize(
    ("relation", "kind"), [("obj", "core"), ("obl:to", "core"), ("amod", "modifier"), ("case", "grammar")]
)
def test_relations_have_kinds(relation, kind):
    assert relation_kind(relation) == kind
