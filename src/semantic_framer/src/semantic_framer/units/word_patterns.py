"""Words that fill elements: those that a pattern of a lexical unit leaves open, and those that a unit lists."""

from typing import FrozenSet, List, Sequence

from phrase_meanings.head_words import is_side_of_something
from semantic_framer.values.sentence import Sentence
from typed_arguments import TypedArgument
from utterance_passes.trees.tree import PHRASE_HEADS, DependencyTree


def heads(tree: DependencyTree, positions: Sequence[int]) -> List[int]:
    """Return the words of some that depend on none of the others."""
    return [index for index in positions if tree.word(index).head not in positions]


def argument_of(sentence: Sentence, name: str, positions: Sequence[int]) -> TypedArgument:
    """Return the argument of the words of an element, whatever the parser attached them to."""
    inside = frozenset(positions)
    tops = heads(sentence.tree, positions)
    nouns = [index for index in tops if sentence.word(index).upos in PHRASE_HEADS]
    head = nouns[0] if nouns else tops[-1]
    below = sentence.subtree(head)
    return sentence.phrases.argument(name, head, left_out=below - inside, attached=inside - below)


def listed_words(tree: DependencyTree, head: int, words: Sequence[str]) -> FrozenSet[int]:
    """Return the longest sequence of listed words that ends at a head ("low five"); nothing if none is listed."""
    if is_side_of_something(tree, head):
        return frozenset()
    for length in range(max((len(listed.split()) for listed in words), default=0), 0, -1):
        positions = range(max(1, head - length + 1), head + 1)
        if " ".join(tree.word(index).said for index in positions) in words:
            return frozenset(positions)
    return frozenset([head]) if tree.word(head).lemma.lower() in words else frozenset()
