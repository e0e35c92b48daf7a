"""Joins adverbs of place to what they say the place of: "ahead of", "the chair closest to the door"."""

from utterance_passes.pass_needs import only_with
from utterance_passes.tree import DependencyTree
from utterance_passes.tree_edits import TreeEdit
from utterance_passes.vocabulary import Vocabulary
from word_classes import word_class

_ADVERB, _PREPOSITION = "ahead", "of"
_SUPERLATIVES = word_class("near_superlatives") | word_class("far_superlatives")
_NOUNS = frozenset(["NOUN", "PROPN"])


@only_with("case")
def with_ahead_as_preposition(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach "ahead of" to the noun behind it, and the noun to what "ahead" hangs on."""
    edit = TreeEdit(tree)
    for word, following in zip(tree.words, tree.words[1:]):
        is_pair = word.form.lower() == _ADVERB and following.form.lower() == _PREPOSITION
        noun = tree.word(following.head) if is_pair and following.head else None
        if noun is None or following.deprel != "case" or noun.index < following.index or word.deprel == "case":
            continue
        if noun.head == word.index:
            edit.rehang(noun.index, word.head, "obl" if word.deprel == "advmod" else word.deprel)
        for child in tree.children(word.index):
            if child.index != noun.index:
                edit.rehang(child.index, noun.index)
        edit.make_preposition(word.index, noun.index)
        edit.rehang(following.index, word.index, "fixed")
    return edit.tree()


@only_with("case")
def with_superlatives_at_nouns(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach a superlative of place, and the phrase behind it, to the noun before it: "the chair *closest to the
    door*" is one thing, and "to the door" is no way to go.
    """
    edit = TreeEdit(tree)
    for noun, word in zip(tree.words, tree.words[1:]):
        is_behind = noun.upos in _NOUNS and word.form.lower() in _SUPERLATIVES and word.deprel != "case"
        following = tree.word(word.index + 1) if word.index < len(tree.words) else word
        place = tree.word(following.head) if is_behind and following.deprel == "case" and following.head else None
        if place is None or place.index < following.index:
            continue
        if noun.head == word.index:
            # The parser took the superlative for the noun.
            edit.rehang(noun.index, word.head, word.deprel)
            for child in tree.children(word.index):
                if child.index != noun.index:
                    edit.rehang(child.index, noun.index)
        edit.retag(word.index, "ADJ", "JJS")
        edit.rehang(word.index, noun.index, "amod")
        edit.rehang(place.index, word.index, "obl")
    return edit.tree()
