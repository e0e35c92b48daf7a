"""Makes one list of items whose order is said: "visit the kitchen, *then* the office and *finally* the hall"."""

from typing import Optional

from utterance_passes.engine.pass_needs import only_with_forms
from utterance_passes.engine.utterance_pass import Example, Kind, tree_pass
from utterance_passes.trees.tree import ASIDE, NOUNS, DependencyTree, Word
from utterance_passes.trees.tree_edits import TreeEdit
from utterance_passes.trees.vocabulary import Vocabulary
from word_classes import word_class

_ORDER = word_class("adverbs_of_order")
_ONLY = word_class("restricting_adverbs")
_BORDERS = frozenset([",", "and", "then"])
#: Relations of an item that the parser attaches to the verb or to another item.
_OF_ITEMS = frozenset(["conj", "parataxis", "appos", "dep", "vocative"])


@tree_pass(
    Kind.MEANING,
    Example(
        "visit|VERB|0|root halls|NOUN|1|obj ,|PUNCT|5|punct then|ADV|5|advmod offices|NOUN|1|parataxis",
        ("then: advmod(offices) -> discourse:aside(offices)", "offices: parataxis(visit) -> conj(halls)"),
    ),
    assigns=["dep", "conj", ASIDE],
)
@only_with_forms(_ORDER)
def items_in_order(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Set aside words of order before an item of a list, and attach the item to the item before it.

    Lists are carried out in the order in which they were said. An item with a preposition is a phrase of its own:
    "then to the office".
    """
    edit = TreeEdit(tree)
    for adverb in tree.words:
        item = _item(tree, adverb)
        first = _item_before(tree, item, adverb) if item is not None else None
        if item is not None and first is None and item.deprel == "vocative":
            edit.relabel(item.index, "dep")  # Nobody is called "then Bob".
        if item is None or first is None:
            continue
        edit.rehang(adverb.index, item.index, ASIDE)
        before = tree.word(adverb.index - 1)
        if before.said in _ONLY and before.head == item.index:
            edit.relabel(before.index, ASIDE)  # "And *only* then the hall."
        if item.head != first.index:
            edit.rehang(item.index, first.index, "conj")
    return edit.tree()


def _item(tree: DependencyTree, adverb: Word) -> Optional[Word]:
    """Return the item of a list that begins with a word of order; None if there is none."""
    if adverb.said not in _ORDER or not adverb.head or adverb.index < 3:
        return None
    item = tree.governor(adverb)
    children = tree.children(item.index)
    if item.upos not in NOUNS or item.index < adverb.index or item.deprel not in _OF_ITEMS:
        return None
    if any(child.deprel in ("case", "cop") or child.deprel.startswith("nsubj") for child in children):
        return None
    is_set_off = tree.word(adverb.index - 1).said in _BORDERS | _ONLY
    return item if is_set_off else None


def _item_before(tree: DependencyTree, item: Word, adverb: Word) -> Optional[Word]:
    """Return the item to which another item is attached: the object or the goal of its verb; None for another head."""
    head = tree.governor(item)
    if head.upos in NOUNS:
        return head
    said = [child for child in tree.children(head.index) if head.index < child.index < adverb.index]
    # "Bring Anna a cup, then Bob": a person is no second thing.
    items = [child for child in said if child.deprel in ("obj", "iobj", "obl") and child.upos == item.upos]
    return items[0] if head.upos == "VERB" and len(items) == 1 else None
