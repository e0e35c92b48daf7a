"""A parsed sentence as a value: words and their Universal Dependencies (v2)."""
from dataclasses import dataclass
from typing import List, Tuple


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
    """A sentence and its Universal Dependencies.

    Attributes:
        text: as it was said
        words: in order; ``words[i].index == i + 1``
        brackets: the phrase tree as "(ROOT (S ...))", where the models have a constituency parser; empty otherwise
    """

    text: str
    words: Tuple[Word, ...]
    brackets: str = ""

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
        return tuple(word for word in self.words if word.head == index)

    def subtree(self, index: int) -> Tuple[Word, ...]:
        """Return the word at that index and everything below it, in order of the sentence."""
        inside = {index}
        pending: List[int] = [index]
        while pending:
            governor = pending.pop()
            for word in self.children(governor):
                if word.index not in inside:
                    inside.add(word.index)
                    pending.append(word.index)
        return tuple(word for word in self.words if word.index in inside)
