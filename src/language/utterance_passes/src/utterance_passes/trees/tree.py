"""Values for a parsed sentence: words and their Universal Dependencies (v2)."""

from dataclasses import dataclass, field
from functools import cached_property
from typing import Dict, FrozenSet, Iterable, List, NamedTuple, Optional, Set, Tuple

from utterance_passes.trees.formula_file import is_filler

#: The universal relations, without subtypes.
RELATIONS = frozenset(
    "acl advcl advmod amod appos aux case cc ccomp clf compound conj cop csubj dep det discourse dislocated expl "
    "fixed flat goeswith iobj list mark nmod nsubj nummod obj obl orphan parataxis punct reparandum root vocative "
    "xcomp".split()
)
#: Relation to the verb for formulas around a command ("if you don't mind").
ASIDE = "discourse:aside"
#: Relation for the words of a quotation ("say *don't worry*") to the word that fills the element.
QUOTED = "flat:quoted"
#: Relation to the correction for the words that the speaker took back, and for the editing term.
ABANDONED = "reparandum"
#: Parts of speech of words that name things and persons, and of words that stand for them.
NOUNS = frozenset(["NOUN", "PROPN"])
NOMINALS = NOUNS | {"PRON"}
#: Parts of speech of what may head a noun phrase.
PHRASE_HEADS = NOMINALS | {"NUM"}
VERBS = frozenset(["VERB", "AUX"])
QUOTATION_MARKS = frozenset(['"', "“", "”", "«", "»", "``", "''"])
#: No blank stands before these.
CLOSE_MARKS = ("'", "’", "n't", ",", ";", ":", ".", "!", "?")


@dataclass(frozen=True)
class Word:
    """One word of a dependency tree, the fields in the order of CoNLL-U.

    Attributes:
        index: 1 for the first word of the sentence
        form: the word as it was written
        lemma: dictionary form
        upos: universal part of speech
        xpos: Penn Treebank tag
        feats: features, ``Mood=Imp|VerbForm=Fin``; empty if there are none
        head: index of the governing word; 0 if the word is the root
        deprel: universal relation to the head
        start_character: position of its first character in the text, from 0
        end_character: position after its last character
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

    @cached_property
    def said(self) -> str:
        """The word in lower case."""
        return self.form.lower()


class Alternative(NamedTuple):
    """Another governor that a word may have.

    Attributes:
        word: position of the word
        head: position of the governor; 0 for the root
        deprel: universal relation to it
        probability: of both, as the parser says
    """

    word: int
    head: int
    deprel: str
    probability: float


@dataclass(frozen=True)
class DependencyTree:
    """A sentence and its Universal Dependencies. Only ``tree_edits`` derives one tree from another.

    Attributes:
        text: the sentence as it was said
        words: its words, in order; ``words[i].index == i + 1``
        brackets: the phrase tree as "(ROOT (S ...))"; empty if the models have no constituency parser
        times: positions of each phrase that says when; the pass ``times`` marks them
        sharing_a_verb: heads of phrases that share the verb of the phrase before; the pass ``shared_verbs`` marks them
        clusters: verb and heads of each group of phrases that forms a separate clause; the pass ``argument_clusters``
            marks them
        alternatives: what else each word may hang on, as the parser says, for the words of its tree; trees are equal
            whatever else they might have been
    """

    text: str
    words: Tuple[Word, ...]
    brackets: str = ""
    times: Tuple[FrozenSet[int], ...] = ()
    sharing_a_verb: FrozenSet[int] = frozenset()
    clusters: Tuple[Tuple[int, FrozenSet[int]], ...] = ()
    alternatives: Tuple[Alternative, ...] = field(default=(), compare=False)

    def word(self, index: int) -> Word:
        """Return the word at a position, from 1.

        Raises:
            IndexError: there is no such word; 0 means the root, which is not a word
        """
        if index < 1:
            raise IndexError(f"words are counted from 1, got {index}")
        return self.words[index - 1]

    def children(self, index: int) -> Tuple[Word, ...]:
        """Return the words that the word at an index governs, in order; 0 gives the root."""
        return self._children.get(index, ())

    @cached_property
    def _children(self) -> Dict[int, Tuple[Word, ...]]:
        found: Dict[int, List[Word]] = {}
        for word in self.words:
            found.setdefault(word.head, []).append(word)
        return {head: tuple(words) for head, words in found.items()}

    def subtree(self, index: int) -> FrozenSet[int]:
        """Return the positions of the word at an index and of all words below it."""
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

    def governor(self, word: Word) -> Word:
        """Return the word on which a word hangs; the root is its own governor."""
        return self.word(word.head) if word.head else word

    def verb_above(self, word: Word) -> Word:
        """Return the nearest verb above a word, or the word itself if it is one; the top word if there is none."""
        while word.upos != "VERB" and word.head:
            word = self.governor(word)
        return word

    def phrase_start(self, index: int) -> int:
        """Return the position of the first word at or below the word at an index."""
        return min(self.subtree(index))

    def phrase_end(self, index: int) -> int:
        """Return the position of the last word at or below the word at an index."""
        return max(self.subtree(index))

    def prepositions(self, index: int) -> Tuple[Word, ...]:
        """Return the words with the relation ``case`` to the word at an index: "*from* *under* the table"."""
        return tuple(child for child in self.children(index) if child.deprel == "case")

    def said_prepositions(self, index: int) -> List[str]:
        """Return the prepositions of the phrase of the word at an index, in lower case."""
        return [child.said for child in self.prepositions(index)]

    def preposition(self, index: int) -> str:
        """Return the first preposition of the phrase of the word at an index; empty if it has none."""
        return next(iter(self.said_prepositions(index)), "")

    def subject(self, index: int) -> Optional[Word]:
        """Return the first subject of the word at an index, of an active or a passive clause; None if it has none."""
        return next((child for child in self.children(index) if child.deprel.startswith("nsubj")), None)

    def is_next(self, index: int, before: int) -> bool:
        """Whether the phrase of the word at an index begins right behind the phrase of another word."""
        return self.phrase_start(index) == self.phrase_end(before) + 1

    def is_infinitive(self, index: int) -> bool:
        """Whether "to" marks the verb at an index: "tell Bob *to come*"."""
        return any(child.deprel == "mark" and child.said == "to" for child in self.children(index))

    @cached_property
    def relations(self) -> FrozenSet[str]:
        """The relations of all words, with and without subtype."""
        found = {word.deprel for word in self.words}
        return frozenset(found | {relation.split(":")[0] for relation in found})

    @cached_property
    def forms(self) -> FrozenSet[str]:
        """The words as they were written, in lower case."""
        return frozenset(word.said for word in self.words)

    @cached_property
    def lemmas(self) -> FrozenSet[str]:
        """The dictionary forms of all words, in lower case."""
        return frozenset(word.lemma.lower() for word in self.words)

    @cached_property
    def abandoned(self) -> FrozenSet[int]:
        """Positions of corrected words, editing terms and asides."""
        return frozenset().union(
            *(self.subtree(word.index) for word in self.words if word.deprel in (ABANDONED, ASIDE))
        )

    @cached_property
    def quoted(self) -> FrozenSet[int]:
        """Positions of quoted words: "say *don't worry*"."""
        return frozenset(index for word in self.words if word.deprel == QUOTED for index in (word.index, word.head))

    @cached_property
    def between_marks(self) -> Tuple[FrozenSet[int], ...]:
        """Positions of the words between each pair of quotation marks, with or without a relation to what is said."""
        marks = [word.index for word in self.words if word.form in QUOTATION_MARKS]
        pairs = zip(marks[::2], marks[1::2])
        return tuple(frozenset(range(first + 1, last)) for first, last in pairs if last > first + 1)

    @cached_property
    def fillers(self) -> FrozenSet[int]:
        """Positions of words that people say only while they think: "um"."""
        return frozenset(word.index for word in self.words if is_filler(word.form))

    @property
    def open_words(self) -> Tuple[Word, ...]:
        """Words that are not asides, not taken back and not quoted."""
        return tuple(word for word in self.words if word.deprel not in (ASIDE, QUOTED, ABANDONED))

    def text_of(self, positions: Iterable[int]) -> str:
        """Return the text of words in sentence order; a clitic ("'s") or a comma joins the word before it."""
        return self.text_in_order(sorted(positions))

    def text_in_order(self, positions: Iterable[int]) -> str:
        """Return the text of words in the order of the given positions; "check-in" is written as it was."""
        text = ""
        before = 0
        for index in positions:
            form = self.word(index).form
            is_close = form.startswith(CLOSE_MARKS) or (before > 0 and self._is_joined_by_a_mark(before, index))
            text += form if not text or is_close else " " + form
            before = index
        return text

    def is_glued(self, first: int, second: int) -> bool:
        """Whether no blank separates two words, such as "forty" and "-" in "forty-five"."""
        before, after = self.word(first), self.word(second)
        # The text passes split "2½" in two: two numbers in digits are never one word.
        are_digits = before.form[-1:].isdigit() and after.form[:1].isdigit()
        return 0 < before.end_character == after.start_character and not are_digits

    def _is_joined_by_a_mark(self, first: int, second: int) -> bool:
        """Whether two words are glued, and one is a mark, as the hyphen of "check-in" is."""
        is_mark = not all(any(map(str.isalnum, self.word(index).form)) for index in (first, second))
        return is_mark and self.is_glued(first, second)

    @property
    def is_connected(self) -> bool:
        """Whether there is one root that governs every word, directly or not: whether it is a tree."""
        if len(self.children(0)) != 1:
            return False
        return len(self.subtree(0)) == len(self.words) + 1
