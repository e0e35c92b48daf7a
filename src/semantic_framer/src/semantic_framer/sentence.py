"""A parsed sentence with its relations by governor, and the words that carry no content of their own."""

import re
from functools import lru_cache
from typing import Dict, FrozenSet, List, Sequence, Set, Tuple

from stanford_parser_ros.stanford_dependencies import Arc, arcs
from stanford_parser_ros.tree import DependencyTree, Word

from semantic_framer.mending import mended

#: Said while thinking, as long as it takes ("uhhh"); never a part of what is said.
_FILLER = re.compile(r"(u+h+m*|u+m+|e+r+m*|e+h+|e+h*m+|h+m+|m{2,}|f{2,}|n{2,})$")
#: Relation of what is only said around a command ("if you don't mind") to its verb.
ASIDE = "discourse:aside"
#: Relation of the words of a quotation ("say *don't worry*") to the one that fills the element.
QUOTED = "flat:quoted"
HEDGES = frozenset(["maybe", "perhaps", "possibly"])
#: Said around a command without changing it.
HARMLESS = (
    frozenset(
        "please now just kindly then also okay ok so well hey hi hello robot again next first finally simply actually "
        "thanks thank could can would will you i us lets alright".split()
    )
    | HEDGES
)
#: Relations that only a noun governs, under their names in both schemes.
_OF_NOUNS = frozenset(
    "num number nummod poss nmod:poss possessive nn compound amod det predet preconj appos abbrev rcmod vmod partmod "
    "infmod acl".split()
)
_ARGUMENTS = frozenset(["nsubj", "obj", "iobj", "obl", "xcomp"])
_FUNCTION_RELATIONS = {
    "punct",
    "det",
    "case",
    "mark",
    "aux",
    "aux:pass",
    "cop",
    "cc",
    "cc:preconj",
    "discourse",
    "vocative",
    "fixed",
    "expl",
    "reparandum",
    ASIDE,
    "goeswith",
}


class Sentence:
    """A dependency tree, looked at from its governors.

    Attributes:
        tree: the tree, mended where the parser hung words as no command has them
        arcs: every relation under all of its names
    """

    def __init__(self, tree: DependencyTree) -> None:
        self.tree = tree = mended(tree)
        self.arcs: Tuple[Arc, ...] = arcs(tree)
        self._by_governor: Dict[int, List[Arc]] = {}
        for arc in self.arcs:
            self._by_governor.setdefault(arc.governor, []).append(arc)
        self._children: Dict[int, Tuple[Word, ...]] = {
            index: tree.children(index) for index in range(len(tree.words) + 1)
        }
        self.subtree = lru_cache(maxsize=None)(self._subtree)
        #: Positions of what the speaker corrected, of the words that said so, and of asides.
        self.abandoned: FrozenSet[int] = frozenset().union(
            *(self._subtree(word.index) for word in tree.words if word.deprel in ("reparandum", ASIDE))
        )
        #: Positions of words that are said of nothing here: "say *don't worry*".
        self.quoted: FrozenSet[int] = frozenset(
            index for word in tree.words if word.deprel == QUOTED for index in (word.index, word.head)
        )
        self.fillers: FrozenSet[int] = frozenset(word.index for word in tree.words if is_filler(word.form))

    def word(self, index: int) -> Word:
        """Return a word by its index from 1."""
        return self.tree.word(index)

    def children(self, index: int) -> Tuple[Word, ...]:
        """Return the words that a word governs in the tree."""
        return self._children.get(index, ())

    def dependents(self, governor: int, relation: str) -> List[int]:
        """Return the words that are in a relation, of either scheme, to a governor, in order of the sentence.

        Relations that only a noun governs ("num", "poss") are looked for below what a verb governs: units of 2012 name
        them alone.
        """
        found = {arc.dependent for arc in self._by_governor.get(governor, ()) if relation in arc.relations}
        if not found and relation in _OF_NOUNS and governor and self.word(governor).upos in ("VERB", "AUX"):
            nouns = [child.index for child in self.children(governor) if child.deprel.split(":")[0] in _ARGUMENTS]
            found.update(position for noun in nouns for position in self.dependents(noun, relation))
        return sorted(found)

    def _subtree(self, index: int) -> FrozenSet[int]:
        found: Set[int] = {index}
        pending = [index]
        while pending:
            for child in self._children.get(pending.pop(), ()):
                if child.index not in found:
                    found.add(child.index)
                    pending.append(child.index)
        return frozenset(found)

    def text(self, positions: Sequence[int]) -> str:
        """Return words in the order in which they were said, a clitic ("'s") or a comma joined to its word."""
        return self.text_in_order(sorted(positions))

    def text_in_order(self, positions: Sequence[int]) -> str:
        """Return words in the order in which they are given."""
        text = ""
        for index in positions:
            form = self.word(index).form
            text += form if not text or form.startswith(("'", "’", "n't", ",", ";", ":", ".", "!", "?")) else " " + form
        return text

    def is_content(self, index: int) -> bool:
        """Whether a word says something of its own: ignoring it would change what was asked."""
        word = self.word(index)
        if word.deprel in _FUNCTION_RELATIONS or word.upos in ("PUNCT", "INTJ", "SYM", "CCONJ", "PART"):
            return False
        # "Open the door for me": who wants something done wants it for himself.
        is_wisher = word.form.lower() in ("me", "us") and any(
            child.deprel == "case" and child.form.lower() == "for" for child in self.children(index)
        )
        return word.form.lower() not in HARMLESS and index not in self.fillers and not is_wisher


def is_filler(form: str) -> bool:
    """Whether a word is said only while thinking: "um", "uhhh"."""
    return _FILLER.match(form.lower()) is not None
