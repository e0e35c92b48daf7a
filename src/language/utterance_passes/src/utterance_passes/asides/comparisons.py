"""Sets aside phrases such as "as quickly as you can" and "as close as possible"."""

from typing import FrozenSet, Optional, Tuple

from utterance_passes.engine.utterance_pass import Example, Kind, tree_pass
from utterance_passes.trees.formula_file import pattern_of
from utterance_passes.trees.tree import ASIDE, VERBS, DependencyTree
from utterance_passes.trees.tree_edits import TreeEdit
from utterance_passes.trees.vocabulary import Vocabulary, is_verb

_COMPARISONS = pattern_of("comparisons")
#: The group of a pattern that stays in the sentence: "as *slowly* as you can".
_LEFT = "how"
#: The most words of a comparison.
_LONGEST = 7


@tree_pass(
    Kind.MEANING,
    Example(
        "go|VERB|0|root as|ADV|3|advmod fast|ADV|1|advmod as|ADV|5|advmod possible|ADJ|1|xcomp to|ADP|7|case "
        "Bob|PROPN|5|obl",
        (
            "as: advmod(fast) -> discourse:aside(go)",
            "fast: advmod(go) -> discourse:aside(go)",
            "as: advmod(possible) -> discourse:aside(go)",
            "possible: xcomp(go) -> discourse:aside(go)",
            "Bob: obl(possible) -> obl(go)",
        ),
    ),
    assigns=["advmod", "obl", ASIDE],
)
def comparisons(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Set comparisons aside, wherever they stand, but keep their adverb: "as *slowly* as you can".

    The parser makes the next words a part of the comparison: "as quickly as *you can to the gate*".
    """
    while True:
        found = _find(tree)
        verb = _verb_of(tree, found[0] | ({found[1]} - {0}), vocabulary) if found else 0
        if found is None or not verb:
            return tree
        tree = _set_aside(tree, *found, verb)


def _set_aside(tree: DependencyTree, said: FrozenSet[int], adverb: int, verb: int) -> DependencyTree:
    inside = said | ({adverb} - {0})
    edit = TreeEdit(tree)
    for word in tree.words:
        if word.index in said:
            edit.rehang(word.index, verb, ASIDE)
        elif word.index == adverb:
            edit.retag(word.index, "ADV")
            edit.rehang(word.index, verb, "advmod")
        elif word.index == verb:
            edit.rehang(word.index, *_outside(tree, word.index, inside))
        else:
            below = tree.children(word.index)
            is_phrase = word.deprel == "advcl" and word.upos not in VERBS
            is_of_it = word.head in inside or any(child.index in said for child in below)
            if is_of_it:
                is_phrase = is_phrase and any(child.deprel == "case" and child.index not in said for child in below)
                edit.rehang(word.index, verb if word.head in inside else word.head, "obl" if is_phrase else "")
    return edit.tree()


def _find(tree: DependencyTree) -> Optional[Tuple[FrozenSet[int], int]]:
    """Find the first comparison: its words, and the adverb that stays; 0 if there is none."""
    words = tree.open_words
    forms = [word.said for word in words]
    if not _COMPARISONS.search(" ".join(forms)):
        return None
    for first in range(len(words)):
        for behind in range(min(len(words), first + _LONGEST), first, -1):
            match = _COMPARISONS.fullmatch(" ".join(forms[first:behind]))
            if match and behind - first < len(words):
                said = words[first:behind]
                positions = frozenset(word.index for word in said)
                left = match.groupdict()[_LEFT]
                adverb = next((word.index for word in said if left and word.said == left), 0)
                return positions - {adverb}, adverb
    return None


def _verb_of(tree: DependencyTree, inside: FrozenSet[int], vocabulary: Vocabulary) -> int:
    """Return the verb that the comparison modifies: the one above it, else the first known verb; 0 if there is none."""
    above = {_outside(tree, index, inside)[0] for index in inside} - {0}
    verbs = [word for word in tree.open_words if word.index not in inside and word.upos in VERBS]
    known = [word for word in verbs if is_verb(vocabulary, word)]
    return next((word.index for word in verbs if word.index in above), known[0].index if known else 0)


def _outside(tree: DependencyTree, index: int, inside: FrozenSet[int]) -> Tuple[int, str]:
    """Return the nearest head of a word that is not among some words, and the relation to it."""
    word = tree.word(index)
    while word.head in inside:
        word = tree.governor(word)
    return word.head, word.deprel
