"""Joins what is added to the thing that it is added to: "the cup *as well as the plate*"."""

from utterance_passes.pass_needs import only_with
from utterance_passes.tree import ASIDE, DependencyTree
from utterance_passes.tree_edits import TreeEdit
from utterance_passes.vocabulary import Vocabulary

_NOT_ONLY = ["not", "only"]


@only_with("cc")
def without_not_only(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Set "not only" aside before "but": "bring *not only* the cup but also the plate" forbids nothing."""
    edit = TreeEdit(tree)
    for first, second in zip(tree.words, tree.words[1:]):
        joints = [word for word in tree.words[second.index :] if word.form.lower() == "but" and word.deprel == "cc"]
        if [first.form.lower(), second.form.lower()] == _NOT_ONLY and joints and first.head:
            for word in (first, second):
                edit.rehang(word.index, first.head, ASIDE)
    return edit.tree()
