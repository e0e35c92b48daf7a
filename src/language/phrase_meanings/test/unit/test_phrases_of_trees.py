"""Phrases of trees that no sentence of a test leads to; real sentences are in the tests of the framer."""

from phrase_meanings.phrases import Phrases
from utterance_passes.trees.tree import DependencyTree, Word


def list_of(count: int) -> DependencyTree:
    """Return "bring cup, cup, ..."."""
    words = [Word(1, "bring", "bring", "VERB", "VB", "", 0, "root"), Word(2, "cup", "cup", "NOUN", "NN", "", 1, "obj")]
    words += [Word(index, "cup", "cup", "NOUN", "NN", "", 2, "conj") for index in range(3, count + 2)]
    return DependencyTree(" ".join(word.form for word in words), tuple(words))


def test_phrase_with_too_many_parts_keeps_its_words() -> None:
    assert len(Phrases(list_of(60)).argument("theme", 2).members) == 60
    found = Phrases(list_of(70)).argument("theme", 2)
    assert found.members == ()
    assert (len(found.positions), found.head, found.text.split()) == (70, "cup", ["cup"] * 70)


def test_word_of_order_is_of_no_member() -> None:
    words = (
        Word(1, "kitchen", "kitchen", "NOUN", "NN", "", 0, "root"),
        Word(2, "then", "then", "ADV", "RB", "", 3, "advmod"),
        Word(3, "bedroom", "bedroom", "NOUN", "NN", "", 1, "conj"),
    )
    found = Phrases(DependencyTree("kitchen then bedroom", words)).argument("goal", 1)
    assert [member.text for member in found.members] == ["kitchen", "bedroom"]
