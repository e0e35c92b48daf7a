"""Joins adverbs of place to what they say the place of: "ahead of", "the chair closest to the door"."""

from utterance_passes.pass_needs import only_with
from utterance_passes.tree import DependencyTree
from utterance_passes.tree_edits import TreeEdit
from utterance_passes.vocabulary import Vocabulary

_ADVERB, _PREPOSITION = "ahead", "of"


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
