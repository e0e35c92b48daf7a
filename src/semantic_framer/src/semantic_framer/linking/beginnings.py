"""Words that say when a command begins, while another one runs: "then go home", "meanwhile say hello".

The framer does not know what runs. It passes on what was said, and the executor decides.
"""

from dataclasses import dataclass
from typing import FrozenSet, Optional

from semantic_framer.linking.link_file import LinkKind, shipped_links
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.sentence import Sentence
from utterance_passes.asides.objections import plain
from utterance_passes.trees.formula_file import is_filler
from utterance_passes.trees.tree import ASIDE, DependencyTree, Word
from utterance_passes.trees.tree_edits import NotATree, mark_times, set_aside
from word_classes import word_class

_PREPOSITIONS = word_class("place_prepositions_alike")
_KINDS = {LinkKind.THEN: "FOLLOW", LinkKind.MEANWHILE: "BESIDE"}
#: The most words that say when a command begins.
_LONGEST = 8


@dataclass(frozen=True)
class Beginning:
    """When a command begins.

    Attributes:
        kind: FOLLOW or BESIDE, as in the Plan message
        positions: of the words that say so
    """

    kind: str
    positions: FrozenSet[int]


def beginning_of(tree: DependencyTree) -> Optional[Beginning]:
    """Return when a command begins; None if nothing is said about it, or nothing else is said."""
    words = [word for word in tree.words if word.upos != "PUNCT" and word.index not in tree.quoted]
    while words and is_filler(words[0].form) and plain(words[0]) != "then":
        words.pop(0)
    while words and is_filler(words[-1].form):
        words.pop()
    forms = [plain(word) for word in words]
    kind, length = shipped_links().beginning_at(forms, is_front=True)
    if kind is not None and length < len(words) and " ".join(forms[:2]) not in _PREPOSITIONS:
        return Beginning(_KINDS[kind], frozenset(word.index for word in words[:length]))
    for length in range(min(_LONGEST, len(words) - 1), 0, -1):
        kind, said = shipped_links().beginning_at(forms[-length:], is_front=False)
        if kind is not None and said == length:
            return Beginning(_KINDS[kind], frozenset(word.index for word in words[-length:]))
    return None


def without_beginning(sentence: Sentence, beginning: Beginning, known: FramedLexicon) -> Optional[Sentence]:
    """Return a sentence with the words that say when it begins set aside; None if the other words make no tree."""
    tree = sentence.tree

    def is_verb(word: Word) -> bool:
        return word.upos == "VERB" or bool(known.verbs_beginning_with(word.lemma.lower()))

    # A time among these words is accounted for.
    times = tuple(time for time in tree.times if not time <= beginning.positions)
    try:
        made = set_aside(tree, beginning.positions, ASIDE, is_verb)
    except NotATree:
        return None
    return Sentence(mark_times(made, times), known.types)
