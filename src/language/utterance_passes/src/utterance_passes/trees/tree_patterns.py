"""Finds words of a tree by what they are and how they stand to each other, so that a rule can be data.

The operators are those of spaCy's DependencyMatcher, with the same signs, and two more for phrases.
"""

from dataclasses import dataclass
from typing import AbstractSet, Callable, Dict, FrozenSet, Iterable, Iterator, Mapping, Tuple

from utterance_passes.trees.tree import DependencyTree, Word
from utterance_passes.trees.tree_edits import TreeEdit

_ANY: FrozenSet[str] = frozenset()


def _parent(tree: DependencyTree, word: Word) -> Tuple[Word, ...]:
    return (tree.governor(word),) if word.head else ()


def _children(tree: DependencyTree, word: Word) -> Tuple[Word, ...]:
    return tree.children(word.index)


def _siblings(tree: DependencyTree, word: Word) -> Iterable[Word]:
    return (one for one in tree.children(word.head) if one.index != word.index) if word.head else ()


#: What stands in each relation to a word. "The first one ``>`` the other one": the first one governs the other one.
OPERATORS: Mapping[str, Callable[[DependencyTree, Word], Iterable[Word]]] = {
    "<": _parent,
    "<--": lambda tree, word: (one for one in _parent(tree, word) if one.index < word.index),
    "<++": lambda tree, word: (one for one in _parent(tree, word) if one.index > word.index),
    ">": _children,
    ">--": lambda tree, word: (one for one in _children(tree, word) if one.index < word.index),
    ">++": lambda tree, word: (one for one in _children(tree, word) if one.index > word.index),
    ">>": lambda tree, word: (tree.word(index) for index in sorted(tree.subtree(word.index) - {word.index})),
    ".": lambda tree, word: tree.words[word.index : word.index + 1],
    ".*": lambda tree, word: tree.words[word.index :],
    ";": lambda tree, word: tree.words[max(0, word.index - 2) : word.index - 1],
    ";*": lambda tree, word: tree.words[: word.index - 1],
    "$--": lambda tree, word: (one for one in _siblings(tree, word) if one.index < word.index),
    "$++": lambda tree, word: (one for one in _siblings(tree, word) if one.index > word.index),
    # The nearest verb above.
    "<<v": lambda tree, word: (tree.verb_above(one) for one in _parent(tree, word)),
    # What it governs, if both phrases end at one place.
    ">|": lambda tree, word: (
        one for one in _children(tree, word) if tree.phrase_end(one.index) == tree.phrase_end(word.index)
    ),
}


@dataclass(frozen=True)
class Sought:
    """A word of a pattern. An empty set allows anything.

    Attributes:
        name: its name in the pattern
        beside: name of an earlier word of the pattern; empty for the first word
        operator: how the earlier word stands to it, a key of ``OPERATORS``
        deprel: its relations; "nsubj:*" is that relation with and without subtype
        upos: its parts of speech
        lemma: its dictionary forms, in lower case
        said: its forms, in lower case
        preposition: the first prepositions of its phrase
        is_only: whether no other word with one of these relations stands in the same place
        is_absent: whether there must be no such word
    """

    name: str
    beside: str = ""
    operator: str = ""
    deprel: AbstractSet[str] = _ANY
    upos: AbstractSet[str] = _ANY
    lemma: AbstractSet[str] = _ANY
    said: AbstractSet[str] = _ANY
    preposition: AbstractSet[str] = _ANY
    is_only: bool = False
    is_absent: bool = False

    def has_relation(self, word: Word) -> bool:
        """Whether a word has one of the relations."""
        relation = word.deprel
        return not self.deprel or relation in self.deprel or relation.split(":")[0] + ":*" in self.deprel

    def fits(self, tree: DependencyTree, word: Word) -> bool:
        """Whether a word is as it must be, wherever it stands."""
        return (
            self.has_relation(word)
            and (not self.upos or word.upos in self.upos)
            and (not self.lemma or word.lemma.lower() in self.lemma)
            and (not self.said or word.said in self.said)
            and (not self.preposition or tree.preposition(word.index) in self.preposition)
        )


class TreePattern:
    """Words that stand to each other as a rule says."""

    def __init__(self, first: Sought, *others: Sought) -> None:
        """
        Args:
            first: a word that may stand anywhere
            others: each stands beside an earlier one
        Raises:
            ValueError: an operator does not exist, a name is used twice, or a word stands beside no earlier one
        """
        self._words = (first, *others)
        known: Dict[str, Sought] = {}
        for one in self._words:
            is_first = one is first
            if one.name in known:
                raise ValueError(f'two words of the pattern are called "{one.name}"')
            if is_first != (not one.beside) or (one.beside and one.beside not in known):
                raise ValueError(f'"{one.name}" stands beside no earlier word: "{one.beside}"')
            if not is_first and one.operator not in OPERATORS:
                raise ValueError(f'"{one.name}" has an operator that does not exist: "{one.operator}"')
            if is_first and (one.is_only or one.is_absent):
                raise ValueError(f'"{one.name}" is the first word, which stands anywhere')
            if not one.is_absent:
                known[one.name] = one

    def matches(self, tree: DependencyTree) -> Iterator[Mapping[str, Word]]:
        """Yield the words of each place where the pattern fits, by their names."""
        for word in tree.words:
            if self._words[0].fits(tree, word):
                yield from self._matches(tree, {self._words[0].name: word}, 1)

    def _matches(self, tree: DependencyTree, found: Dict[str, Word], place: int) -> Iterator[Mapping[str, Word]]:
        if place == len(self._words):
            yield dict(found)
            return
        sought = self._words[place]
        there = [one for one in OPERATORS[sought.operator](tree, found[sought.beside]) if sought.has_relation(one)]
        fitting = [one for one in there if sought.fits(tree, one)]
        if sought.is_absent:
            if not fitting:
                yield from self._matches(tree, found, place + 1)
            return
        for word in fitting if not sought.is_only or len(there) == 1 else ():
            yield from self._matches(tree, {**found, sought.name: word}, place + 1)


@dataclass(frozen=True)
class Rehang:
    """A change to a word of a pattern.

    Attributes:
        name: of the word
        deprel: its new relation
        head: name of its new governor; empty if it keeps the old one
    """

    name: str
    deprel: str
    head: str = ""


def rehung(tree: DependencyTree, pattern: TreePattern, *changes: Rehang) -> DependencyTree:
    """Return a tree with changes in each place where a pattern fits.

    Args:
        tree: the tree
        pattern: the pattern
        changes: what becomes of its words
    """
    edit = TreeEdit(tree)
    for found in pattern.matches(tree):
        for change in changes:
            if change.head:
                edit.rehang(found[change.name].index, found[change.head].index, change.deprel)
            else:
                edit.relabel(found[change.name].index, change.deprel)
    return edit.tree()
