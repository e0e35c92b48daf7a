"""Finds names of one letter: "room C", "shelf a", "gate B12"."""

import re
from typing import FrozenSet, List

from spoken_quantities import find_unit
from utterance_passes.tree import DependencyTree, Word
from utterance_passes.tree_edits import NotATree, TreeEdit
from utterance_passes.vocabulary import Vocabulary
from word_classes import word_class

_LETTERED = word_class("lettered_nouns")
_LETTER = re.compile("[A-Z][0-9]*|[0-9]+[A-Za-z]")
_SMALL_LETTER = re.compile("[a-z]")
#: A letter before one of these is not a name: "a mug", "I want".
_NO_END = frozenset(["NOUN", "PROPN", "ADJ", "NUM", "VERB", "AUX"])


def with_letters_as_names(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach a letter or a number after a noun to the noun, as its name.

    A small letter, as speech recognisers write it, is a name only after a noun that takes letters as names.
    """
    for noun, name in zip(tree.words, tree.words[1:]):
        if not _is_name(tree, noun, name) or name.head == noun.index or noun.head == name.index:
            continue
        edit = TreeEdit(tree)
        edit.rehang_children(name.index, noun.index)
        if name.index in _above(tree, noun):
            edit.rehang(noun.index, name.head, name.deprel)
        edit.retag(name.index, "NUM" if name.upos == "NUM" else "PROPN")
        edit.rehang(name.index, noun.index, "flat")
        try:
            tree = edit.tree()
        except NotATree:
            continue
    return tree


def _is_name(tree: DependencyTree, noun: Word, name: Word) -> bool:
    following = tree.words[name.index] if name.index < len(tree.words) else None
    if noun.upos not in ("NOUN", "PROPN") or find_unit(noun.form) or (following and following.upos in _NO_END):
        return False
    if _SMALL_LETTER.fullmatch(name.form) or name.upos == "NUM" or name.form.isdigit():
        return noun.lemma.lower() in _LETTERED
    return _LETTER.fullmatch(name.form) is not None


def _above(tree: DependencyTree, word: Word) -> FrozenSet[int]:
    above: List[int] = []
    while word.head:
        word = tree.word(word.head)
        above.append(word.index)
    return frozenset(above)
