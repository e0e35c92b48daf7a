"""A sentence: its tree, and the relations of each governor."""

from functools import cached_property
from typing import Dict, FrozenSet, Optional, Sequence, Set, Tuple

from phrase_meanings.phrase_types import PhraseTypes
from phrase_meanings.phrases import Phrases
from semantic_types import WordTypes, shipped_types
from stanford_parser_ros.stanford_dependencies import Arc, arcs
from utterance_passes.phrases.amounts import is_number
from utterance_passes.trees.tree import ABANDONED, ASIDE, VERBS, DependencyTree, Word
from word_classes import word_class

#: Relations that only a noun governs, by their names in both schemes.
_OF_NOUNS = frozenset(
    "num number nummod poss nmod:poss possessive nn compound amod det predet preconj appos abbrev rcmod vmod partmod "
    "infmod acl".split()
)
#: "By six" is an amount or a time: nobody goes by a number, and no cup stands by one.
_BY = frozenset(["prep_by", "obl:by", "nmod:by"])
_HARMLESS = word_class("harmless")
_NOT = word_class("not")
_SPEAKER_OBJECTS = word_class("speaker_objects")
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
    ABANDONED,
    ASIDE,
    "goeswith",
}


class Sentence:
    """A tree after all passes, with its relations by governor; each parse of an utterance has one.

    Attributes:
        tree: the tree
        types: semantic types of its phrases
        phrases: makes the arguments of its phrases
        goals: heads of phrases that say where a thing shall be, as the world has it
        described: heads of phrases that tell which thing is meant, as the world has it
        arcs: every relation, with all of its names
        relations: the names of all relations
        forms: its words, in lower case
    """

    def __init__(
        self,
        tree: DependencyTree,
        words: Optional[WordTypes] = None,
        *,
        goals: FrozenSet[int] = frozenset(),
        described: FrozenSet[int] = frozenset(),
        unquoted_tree: Optional[DependencyTree] = None,
    ) -> None:
        """
        Args:
            tree: the tree
            words: semantic types of words; None for those of the language alone
            goals: heads of phrases that say where a thing shall be, as the world has it
            described: heads of phrases that tell which thing is meant, as the world has it
            unquoted_tree: the tree before the words of a message became one object; None if nothing is quoted
        """
        self.tree = tree
        self.unquoted_tree = unquoted_tree
        self._types_of_words = words or shipped_types()
        self.types = PhraseTypes(tree, self._types_of_words)
        self.goals = goals
        self.described = described
        self.phrases = Phrases(tree, self.types.likeliest)
        self.arcs: Tuple[Arc, ...] = arcs(tree)
        found: Dict[Tuple[int, str], Set[int]] = {}
        for arc in self.arcs:
            for relation in arc.relations:
                if relation not in _BY or not is_number(tree, arc.dependent):
                    found.setdefault((arc.governor, relation), set()).add(arc.dependent)
        #: By governor and relation, in the order of the sentence: each unit asks again.
        self._dependents = {key: tuple(sorted(dependents)) for key, dependents in found.items()}
        self.relations = frozenset(relation for _, relation in found)
        self.forms = frozenset(word.said for word in tree.words)

    def attached(
        self, tree: DependencyTree, *, goals: FrozenSet[int] = frozenset(), described: FrozenSet[int] = frozenset()
    ) -> "Sentence":
        """Return the sentence with another tree, and what the world says of its phrases of place."""
        return Sentence(tree, self._types_of_words, goals=goals, described=described, unquoted_tree=self.unquoted_tree)

    @cached_property
    def unquoted(self) -> Optional["Sentence"]:
        """The sentence before the words of a message became one object; None if nothing is quoted."""
        return None if self.unquoted_tree is None else Sentence(self.unquoted_tree, self._types_of_words)

    def word(self, index: int) -> Word:
        """Return a word by its index from 1."""
        return self.tree.word(index)

    def children(self, index: int) -> Tuple[Word, ...]:
        """Return the words that a word governs."""
        return self.tree.children(index)

    def subtree(self, index: int) -> FrozenSet[int]:
        """Return the positions of a word and of all words below it."""
        return self.tree.subtree(index)

    def text(self, positions: Sequence[int]) -> str:
        """Return words in spoken order, with clitics ("'s") and commas joined to their words."""
        return self.tree.text_of(positions)

    @property
    def abandoned(self) -> FrozenSet[int]:
        """Positions of words that the speaker corrected, of words that announce the correction, and of asides."""
        return self.tree.abandoned

    def dependents(self, governor: int, relation: str) -> Tuple[int, ...]:
        """Return the words that have a relation, of either scheme, to a governor, in the order of the sentence.

        If a verb has no such word and only a noun governs the relation ("num", "poss"), the arguments of the verb are
        searched: units of 2012 name these relations alone.
        """
        found = self._dependents.get((governor, relation), ())
        if not found and relation in _OF_NOUNS and governor and self.word(governor).upos in VERBS:
            nouns = [child.index for child in self.children(governor) if child.deprel.split(":")[0] in _ARGUMENTS]
            found = tuple(sorted({position for noun in nouns for position in self.dependents(noun, relation)}))
        return found

    def is_content(self, index: int) -> bool:
        """Whether a word has content: to ignore it would change the request."""
        word = self.word(index)
        if word.deprel in _FUNCTION_RELATIONS or word.upos in ("PUNCT", "INTJ", "SYM", "CCONJ", "PART"):
            return False
        # "Open the door for me": "for me" only repeats that the speaker wants it.
        is_wisher = word.said in _SPEAKER_OBJECTS and "for" in self.tree.said_prepositions(index)
        # "Robot" calls the hearer, but "a story about a robot" does not.
        is_phrase = word.upos == "NOUN" and bool(self.tree.prepositions(index))
        # "Clean the table, *not now*."
        is_denied = any(child.said in _NOT for child in self.children(index))
        is_harmless = word.said in _HARMLESS and not is_phrase and not is_denied
        return not is_harmless and index not in self.tree.fillers and not is_wisher
