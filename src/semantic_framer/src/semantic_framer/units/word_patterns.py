"""Words that fill elements: those that a pattern of a lexical unit leaves open, and those that a unit lists."""

from typing import FrozenSet, List, Mapping, Sequence

from phrase_meanings.head_words import is_side_of_something
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from semantic_frames.frame import SemanticFrame
from semantic_frames.lexical_unit import LexicalUnit
from typed_arguments import Source, TypedArgument
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


def whole_reading(
    sentence: Sentence, frame: SemanticFrame, unit: LexicalUnit, verb: str, elements: Mapping[str, Sequence[int]]
) -> Reading:
    """Return the reading of a sentence of which all words are understood, with the values of its unit.

    Args:
        sentence: the sentence
        frame: that the unit evokes
        unit: the unit
        verb: what evokes it, for the trace
        elements: positions of the words of each element that is said
    """
    filled = {name: argument_of(sentence, name, positions) for name, positions in elements.items()}
    filled.update((name, TypedArgument(name, text, Source.INFERRED)) for name, text in unit.values.items())
    inside = frozenset().union(*elements.values())
    own = tuple(word.index for word in sentence.tree.words if word.index not in inside and word.upos != "PUNCT")
    return Reading(
        unit=unit,
        verb=verb,
        verb_positions=own,
        arguments=tuple(filled[element.name] for element in frame.frame_elements if element.name in filled),
        missing=(),
        left_over=(),
        coverage=1.0,
        clause_text=sentence.tree.text.strip(),
    )


def listed_words(tree: DependencyTree, head: int, words: Sequence[str]) -> FrozenSet[int]:
    """Return the longest sequence of listed words that ends at a head ("low five"); nothing if none is listed."""
    if is_side_of_something(tree, head):
        return frozenset()
    for length in range(max((len(listed.split()) for listed in words), default=0), 0, -1):
        positions = range(max(1, head - length + 1), head + 1)
        if " ".join(tree.word(index).said for index in positions) in words:
            return frozenset(positions)
    return frozenset([head]) if tree.word(head).lemma.lower() in words else frozenset()
