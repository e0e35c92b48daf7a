"""Reads what specifies the things that were counted before it: "two cups, *a red one and a blue one*" are two cups."""

from typing import List

from spoken_quantities import find_whole_number
from utterance_passes.engine.utterance_pass import Example, Kind, tree_pass
from utterance_passes.trees.tree import ASIDE, DependencyTree, Word
from utterance_passes.trees.tree_edits import TreeEdit
from utterance_passes.trees.vocabulary import Vocabulary
from word_classes import word_class

_MARKS = frozenset([",", ":"])
_NOT = word_class("not")
#: "Clean *ones*" are all of them.
_ONE = "one"
#: Relations that the parser gives to what specifies a noun.
_OF_ITEMS = frozenset(["conj", "appos", "amod"])


@tree_pass(
    Kind.MEANING,
    Example(
        "take|VERB|0|root two|NUM|3|nummod cups|NOUN|1|obj|cup ,|PUNCT|6|punct big|ADJ|6|amod one|NOUN|3|conj "
        "and|CCONJ|9|cc small|ADJ|9|amod one|NOUN|3|conj",
        (
            "two: nummod(cups) -> discourse:aside(cup-6)",
            "cups: obj(take) -> discourse:aside(cup-6)",
            "one: conj(cups) NOUN/one one -> obj(take) NOUN/cup cup",
            "one: conj(cups) NOUN/one one -> conj(cup-6) NOUN/cup cup",
        ),
    ),
    requires=["nummod"],
    assigns=["dep", "conj", "punct", ASIDE],
)
def specified_items(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Take what specifies counted things for these things, and not for further ones.

    Where the items are not as many, or have no "one" ("two cups, *one red and one blue*"), nobody knows what is meant:
    they get the relation ``dep``, which no unit knows.
    """
    edit = TreeEdit(tree)
    for things in tree.words:
        items = _items(tree, things)
        if not items:
            continue
        are_whole = all(item.said == _ONE for item in items)
        if not are_whole or len(items) != _count(tree, things):
            for item in items:
                edit.rehang(item.index, things.head, "dep")
            continue
        first = items[0]
        edit.rehang(first.index, things.head, things.deprel)
        for item in items:
            edit.respell(item.index, things.lemma, things.lemma)
        for item in items[1:]:
            edit.rehang(item.index, first.index, "conj")
        for word in tree.children(things.index):
            if word not in items:
                edit.rehang(word.index, first.index, "punct" if word.upos == "PUNCT" else ASIDE)
        edit.rehang(things.index, first.index, ASIDE)
    return edit.tree()


def _items(tree: DependencyTree, things: Word) -> List[Word]:
    """Return what specifies things behind a mark; nothing where it may add to them: "two cups, *and a red one*"."""
    mark = tree.words[things.index] if things.index < len(tree.words) else things
    if things.upos != "NOUN" or not things.head or mark.form not in _MARKS or _count(tree, things) < 2:
        return []
    behind = [child for child in tree.children(things.index) if child.index > mark.index and child.upos != "PUNCT"]
    items = [child for child in behind if child.deprel in _OF_ITEMS and _is_described_alone(tree, child)]
    starts = min((tree.phrase_start(item.index) for item in items), default=0)
    is_next = starts in (mark.index, mark.index + 1) and tree.word(mark.index + 1).deprel != "cc"
    return items if is_next and behind == items else []


def _is_described_alone(tree: DependencyTree, word: Word) -> bool:
    """Whether a word stands for a thing that its description alone tells: "a red *one*", "one *red*"."""
    children = tree.children(word.index)
    if any(child.said in _NOT for child in children):
        return False  # "Three cups, *not the red one*."
    return any(child.deprel == "amod" for child in children) if word.said == _ONE else word.upos == "ADJ"


def _count(tree: DependencyTree, things: Word) -> int:
    """Return how many things there are; 0 if no number says so."""
    numbers = [
        child for child in tree.children(things.index) if child.deprel == "nummod" and child.index < things.index
    ]
    return (find_whole_number(numbers[0].form) or 0) if len(numbers) == 1 else 0
