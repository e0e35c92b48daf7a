"""Tells whether a noun is a person, a thing of some type, or no thing at all."""

from typing import Sequence

from semantic_types import Fit, Likelihoods, shipped_types
from utterance_passes.trees.tree import NOUNS, DependencyTree, Word
from word_classes import word_class

_STANDINS = word_class("noun_standins")
_THINGS = ("Physical_entity",)
_INDEFINITE_PERSONS = word_class("indefinite_persons")


def is_person(word: Word) -> bool:
    """Whether a word names a person, or any person: "the nurse", "Bob", "somebody"."""
    if word.said in _INDEFINITE_PERSONS:
        return True
    if word.upos not in NOUNS:
        return False
    types = _types_of(word, is_name=word.upos == "PROPN")
    return types.fit(["Human"]) is Fit.LIKELY


def is_person_or_name(word: Word) -> bool:
    """Whether a word names a person, or is a name of which nothing is known."""
    return word.upos == "PROPN" or is_person(word)


def is_name_of_person(word: Word) -> bool:
    """Whether a word is a person's name, or one of which nothing is known: "Mary" and "Anna", but not "Monday"."""
    if word.upos != "PROPN":
        return False
    types = _types_of(word, is_name=True)
    return types.fit(["Human"]) in (Fit.LIKELY, Fit.UNKNOWN)


def is_likely(word: Word, types: Sequence[str]) -> bool:
    """Whether a noun usually has one of some types."""
    return _types_of(word).fit(types) is Fit.LIKELY


def is_abstract(tree: DependencyTree, index: int, *, is_mostly: bool = False) -> bool:
    """Whether a noun names nothing that can be seen and touched: "in a *hurry*", "take *care* of the cat". What is
    measured or stands for another noun may be anything: "a *litre* of milk", "the red *one*".

    Args:
        tree: the sentence
        index: of the noun
        is_mostly: whether a noun counts that seldom names a thing: "your *opinion*"
    """
    word = tree.word(index)
    if word.upos != "NOUN" or word.lemma.lower() in _STANDINS:
        return False
    children = tree.children(index)
    types = _types_of(word)
    has_part = any(tree.preposition(child.index) == "of" for child in children)
    if has_part and (is_mostly or types.likeliest() == "Quantity"):
        return False
    parts = [child.said for child in children if child.deprel in ("compound", "amod") and child.index < index]
    whole = shipped_types().of_noun([" ".join([*parts, word.said])]).fit(_THINGS) if parts else Fit.UNKNOWN
    fit = types.fit(_THINGS)
    return (fit is Fit.WRONG or (is_mostly and fit is Fit.POSSIBLE)) and whole is not Fit.LIKELY


def _types_of(word: Word, *, is_name: bool = False) -> Likelihoods:
    return shipped_types().of_noun([word.said, word.lemma.lower()], is_name=is_name)
