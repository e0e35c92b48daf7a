"""A parsed sentence as a value: words and their Universal Dependencies (v2)."""

from dataclasses import dataclass
from functools import cached_property
from typing import Dict, FrozenSet, Iterable, List, Set, Tuple

from utterance_passes.formula_file import is_filler

#: Relation of what is only said around a command ("if you don't mind") to its verb.
ASIDE = "discourse:aside"
#: Relation of the words of a quotation ("say *don't worry*") to the one that fills the element.
QUOTED = "flat:quoted"
#: Relation of what the speaker took back, and of the words that said so, to what counts instead.
ABANDONED = "reparandum"


@dataclass(frozen=True)
class Word:
    """One word of a dependency tree, the fields in the order of CoNLL-U.

    Attributes:
        index: 1 for the first word of the sentence
        form: as written
        lemma: dictionary form
        upos: universal part of speech
        xpos: Penn Treebank tag
        feats: ``Mood=Imp|VerbForm=Fin``, empty for none
        head: index of the governing word, 0 for the root
        deprel: universal relation to the head
        start_character: where the word begins in the text, from 0
        end_character: one past its last character
    """

    index: int
    form: str
    lemma: str
    upos: str
    xpos: str
    feats: str
    head: int
    deprel: str
    start_character: int = 0
    end_character: int = 0


@dataclass(frozen=True)
class DependencyTree:
    """A sentence and its Universal Dependencies. Only ``tree_edits`` makes one tree of another.

    Attributes:
        text: as it was said
        words: in order; ``words[i].index == i + 1``
        brackets: the phrase tree as "(ROOT (S ...))", where the models have a constituency parser; empty otherwise
        times: positions of each phrase that says when, as the pass ``times`` marks them
        sharing_a_verb: heads of phrases that share the verb of the phrase before them, as ``shared_verbs`` marks them
        clusters: verb and heads of each group of phrases that makes a clause of its own, as ``argument_clusters``
            marks them
    """

    text: str
    words: Tuple[Word, ...]
    brackets: str = ""
    times: Tuple[FrozenSet[int], ...] = ()
    sharing_a_verb: FrozenSet[int] = frozenset()
    clusters: Tuple[Tuple[int, FrozenSet[int]], ...] = ()

    def word(self, index: int) -> Word:
        """Return the word at a position, from 1.

        Raises:
            IndexError: no such word; 0 is the root and not a word
        """
        if index < 1:
            raise IndexError(f"words are counted from 1, got {index}")
        return self.words[index - 1]

    def children(self, index: int) -> Tuple[Word, ...]:
        """Return the words governed by the word at that index (0: the root's), in order."""
        return self._children.get(index, ())

    @cached_property
    def _children(self) -> Dict[int, Tuple[Word, ...]]:
        found: Dict[int, List[Word]] = {}
        for word in self.words:
            found.setdefault(word.head, []).append(word)
        return {head: tuple(words) for head, words in found.items()}

    def subtree(self, index: int) -> FrozenSet[int]:
        """Return the positions of the word at that index and of everything below it."""
        found = self._subtrees.get(index)
        if found is None:
            inside: Set[int] = {index}
            pending: List[int] = [index]
            while pending:
                for child in self.children(pending.pop()):
                    if child.index not in inside:
                        inside.add(child.index)
                        pending.append(child.index)
            found = self._subtrees[index] = frozenset(inside)
        return found

    @cached_property
    def _subtrees(self) -> Dict[int, FrozenSet[int]]:
        return {}

    @cached_property
    def abandoned(self) -> FrozenSet[int]:
        """Positions of what the speaker corrected, of the words that said so, and of asides."""
        return frozenset().union(
            *(self.subtree(word.index) for word in self.words if word.deprel in (ABANDONED, ASIDE))
        )

    @cached_property
    def quoted(self) -> FrozenSet[int]:
        """Positions of quoted words: "say *don't worry*"."""
        return frozenset(index for word in self.words if word.deprel == QUOTED for index in (word.index, word.head))

    @cached_property
    def fillers(self) -> FrozenSet[int]:
        """Positions of words that are said only while thinking: "um"."""
        return frozenset(word.index for word in self.words if is_filler(word.form))

    @property
    def open_words(self) -> Tuple[Word, ...]:
        """Words that are neither asides nor taken back nor quoted."""
        return tuple(word for word in self.words if word.deprel not in (ASIDE, QUOTED, ABANDONED))

    def text_of(self, positions: Iterable[int]) -> str:
        """Return words in the order in which they were said, a clitic ("'s") or a comma joined to its word."""
        return self.text_in_order(sorted(positions))

    def text_in_order(self, positions: Iterable[int]) -> str:
        """Return words in the order in which their positions are given."""
        text = ""
        for index in positions:
            form = self.word(index).form
            text += form if not text or form.startswith(("'", "’", "n't", ",", ";", ":", ".", "!", "?")) else " " + form
        return text

    @property
    def is_connected(self) -> bool:
        """Whether every word hangs, at some distance, on one root: whether it is a tree."""
        if len(self.children(0)) != 1:
            return False
        return len(self.subtree(0)) == len(self.words) + 1
