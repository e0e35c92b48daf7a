"""Attaches directions of the compass to the verb: the parser makes a name or a property of the distance of them."""

from typing import Optional

from spoken_quantities import find_unit
from utterance_passes.pass_needs import only_with_forms
from utterance_passes.tree import DependencyTree, Word
from utterance_passes.tree_edits import TreeEdit
from utterance_passes.vocabulary import Vocabulary
from word_classes import word_class

_COMPASS = word_class("compass_directions")


@only_with_forms(_COMPASS)
def with_compass_directions_apart(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach a bare direction behind a verb to the verb: "move north three feet", "turn ten degrees south west"."""
    edit = TreeEdit(tree)
    for word in tree.words:
        behind = tree.words[word.index] if word.index < len(tree.words) else None
        if not _is_direction(word) or (behind is not None and _is_direction(behind)) or not _is_bare(tree, word):
            continue
        verb = _verb_above(tree, word)
        if verb is None:
            continue
        before = tree.word(word.index - 1)
        if _is_direction(before):
            edit.retag(before.index, "ADV", "RB")
            edit.rehang(before.index, verb.index, "advmod")
        for child in tree.children(word.index):
            if child.index > word.index:
                edit.rehang(child.index, verb.index, "obl:unmarked" if _is_measure(child) else "")
        edit.retag(word.index, "ADV", "RB")
        edit.rehang(word.index, verb.index, "advmod")
    return edit.tree()


def _is_direction(word: Word) -> bool:
    return word.form.lower() in _COMPASS


def _is_measure(word: Word) -> bool:
    return find_unit(word.form) is not None or word.upos == "NUM"


def _is_bare(tree: DependencyTree, word: Word) -> bool:
    """Whether a direction has no preposition or article, is no part of a list, and does not belong to a noun behind it:
    "the north door"."""
    own = [child for child in tree.children(word.index) if child.upos != "PUNCT" and not _is_direction(child)]
    governor = tree.word(word.head) if word.head else word
    is_of_noun = governor.index > word.index and governor.upos in ("NOUN", "PROPN") and not _is_measure(governor)
    is_listed = word.deprel == "conj" or any(child.deprel == "conj" for child in own)
    return not is_of_noun and not is_listed and all(_is_measure(child) for child in own)


def _verb_above(tree: DependencyTree, word: Word) -> Optional[Word]:
    """Return the verb of a direction: its governor, or that of the measure or the direction on which it hangs."""
    governor = word
    while governor.head:
        governor = tree.word(governor.head)
        if governor.upos == "VERB":
            return governor if governor.index < word.index else None
        if not (_is_measure(governor) or _is_direction(governor)):
            return None
    return None
