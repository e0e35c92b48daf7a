"""Finds names behind nouns and names: "room C", "gate B12", "Anna Smith", "my friend Bob"."""

import re
from typing import FrozenSet, List

from spoken_quantities import find_unit
from utterance_passes.persons import is_likely, is_name_of_person, is_person
from utterance_passes.tree import DependencyTree, Word
from utterance_passes.tree_edits import NotATree, TreeEdit
from utterance_passes.vocabulary import Vocabulary
from word_classes import word_class

_LETTERED = word_class("lettered_nouns")
_TITLES = word_class("titles")
_LETTER = re.compile("[A-Z][0-9]*|[0-9]+[A-Za-z]")
_SMALL_LETTER = re.compile("[a-z]")
_ROLES = ("obj", "iobj", "obl", "nmod", "nsubj")
#: A letter before one of these is not a name: "a mug", "I want".
_NO_END = frozenset(["NOUN", "PROPN", "ADJ", "NUM", "VERB", "AUX"])


def with_names_behind_nouns(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach a name, a letter or a number to the noun or the name in front of it.

    A small letter, as speech recognisers write it, is a name only after a noun that takes letters as names. A number
    before things counts them.
    """
    tree = _with_counts_behind_names(tree)
    for index in range(1, len(tree.words)):
        noun, name = _whole(tree, tree.word(index)), tree.word(index + 1)
        if name.head == noun.index or noun.head == name.index:
            continue
        if not (_is_letter(tree, tree.word(index), name) or _is_next_name(tree, noun, name)):
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


def _with_counts_behind_names(tree: DependencyTree) -> DependencyTree:
    """Attach a number to the things behind it, not to the person before it: "bring Anna *two* bananas"."""
    edit = TreeEdit(tree)
    for number, things in zip(tree.words, tree.words[1:]):
        person = tree.word(number.head) if number.head else number
        is_of_name = number.deprel == "flat" and number.upos == "NUM" and is_name_of_person(person)
        if is_of_name and things.upos == "NOUN" and things.xpos == "NNS":
            edit.rehang(number.index, things.index, "nummod")
    return edit.tree()


def _whole(tree: DependencyTree, word: Word) -> Word:
    """Return the word that a word is a part of the name of."""
    return tree.word(word.head) if word.deprel == "flat" else word


def _is_next_name(tree: DependencyTree, noun: Word, name: Word) -> bool:
    """Whether a name goes on with a word, for which the parser has no other use: it is the same to the verb, or
    somebody who is spoken to, though no mark is before it."""
    if name.head != noun.head:
        return False
    if name.upos == "NOUN" and name.deprel == noun.deprel == "iobj":
        return noun.form.lower().rstrip(".") in _TITLES
    if name.upos != "PROPN":
        return False
    if name.deprel == "vocative":
        return noun.deprel in _ROLES and (is_name_of_person(noun) or is_person(noun))
    # "Bring Bob Coke" names a person and a thing.
    if noun.deprel not in _ROLES or not is_name_of_person(name):
        return False
    is_same = name.deprel == noun.deprel and noun.upos == "PROPN"
    return is_same or (name.deprel in _ROLES and _is_title(tree, noun))


def _is_title(tree: DependencyTree, noun: Word) -> bool:
    """Whether a word stands before names: "Dr", "Aunt". Whoever shows the nurse Anna may show Anna to her."""
    is_bare = not any(child.deprel in ("det", "nmod:poss") for child in tree.children(noun.index))
    # "Bring guests Fanta" names a thing of which nothing is known.
    if not is_bare or noun.xpos.endswith("S"):
        return False
    return noun.form.lower().rstrip(".") in _TITLES or is_likely(noun, ["Human"])


def _is_letter(tree: DependencyTree, noun: Word, name: Word) -> bool:
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
