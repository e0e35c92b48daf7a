"""Mends the lemmas of verbs: the models say "hugg" for "hugging", and "bake" only where they have seen it."""

from dataclasses import replace
from typing import Tuple

from semantic_types.parts_of_speech import VERB, base_forms, parts_of_speech
from utterance_passes.trees.tree import DependencyTree, Word

#: Penn tags of inflected verbs; a base form is its own lemma.
_INFLECTED = frozenset(["VBD", "VBG", "VBN", "VBZ"])


def with_verb_lemmas(tree: DependencyTree) -> DependencyTree:
    """Return a tree in which the lemma of each inflected verb is a verb, by WordNet's rules and exceptions."""
    words: Tuple[Word, ...] = tuple(map(_mended, tree.words))
    return tree if words == tree.words else replace(tree, words=words)


def _mended(word: Word) -> Word:
    form = word.form.lower()
    if word.upos != "VERB" or word.xpos not in _INFLECTED or not form.isalpha():
        return word
    if word.lemma.lower() != form and VERB in parts_of_speech(word.lemma.lower()):
        return word
    found = next((base for base in base_forms(form, VERB)[1:] if VERB in parts_of_speech(base)), None)
    return word if found is None else replace(word, lemma=found)
