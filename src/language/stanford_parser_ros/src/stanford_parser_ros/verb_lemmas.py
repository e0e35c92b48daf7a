"""Mends the lemmas of verbs: the models say "hugg" for "hugging", and "bake" only where they have seen it."""

from semantic_types.parts_of_speech import VERB, base_forms, parts_of_speech
from utterance_passes.trees.tree import DependencyTree, Word
from utterance_passes.trees.tree_edits import TreeEdit

#: Penn tags of inflected verbs; a base form is its own lemma.
_INFLECTED = frozenset(["VBD", "VBG", "VBN", "VBZ"])


def with_verb_lemmas(tree: DependencyTree) -> DependencyTree:
    """Return a tree in which the lemma of each inflected verb is a verb, by WordNet's rules and exceptions."""
    edit = TreeEdit(tree)
    for word in tree.words:
        edit.respell(word.index, word.form, _lemma(word))
    return edit.tree()


def _lemma(word: Word) -> str:
    form = word.said
    if word.upos != "VERB" or word.xpos not in _INFLECTED or not form.isalpha():
        return word.lemma
    if word.lemma.lower() != form and VERB in parts_of_speech(word.lemma.lower()):
        return word.lemma
    found = (base for base in base_forms(form, VERB)[1:] if VERB in parts_of_speech(base))
    return next(found, word.lemma)
