"""Sets aside formulas around a command: "if you don't mind", "right away".

Such formulas are not real wishes, conditions or negations. Their words become *asides* of the sentence; later steps
ignore them.
"""

from typing import FrozenSet, Sequence

from utterance_passes.engine.utterance_pass import Example, Kind, tree_pass
from utterance_passes.trees.formula_file import pattern_of
from utterance_passes.trees.tree import ASIDE, DependencyTree, Word
from utterance_passes.trees.tree_edits import set_aside
from utterance_passes.trees.vocabulary import Verbs, Vocabulary, is_verb

_ANYWHERE = pattern_of("anywhere")
_APART = pattern_of("apart")
_ENDINGS = pattern_of("endings")
#: The most words of a formula.
_LONGEST = 12


@tree_pass(
    Kind.MEANING,
    Example(
        "turn|VERB|0|root right|ADV|3|advmod away|ADV|1|advmod",
        ("right: advmod(away) -> discourse:aside(turn)", "away: advmod(turn) -> discourse:aside(turn)"),
        Verbs(frozenset(["turn"])),
    ),
    assigns=[ASIDE, "root", "parataxis"],
)
def formulas(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Set aside the formulas around a command: "... right away, if you don't mind". Formulas in a quotation stay."""
    while True:
        positions = _around(tree, vocabulary)
        if not positions:
            return tree
        tree = set_aside(tree, positions, ASIDE, lambda word: is_verb(vocabulary, word))


def _around(tree: DependencyTree, vocabulary: Vocabulary) -> FrozenSet[int]:
    words = tree.open_words
    forms = [word.said.replace("’", "'") for word in words]
    spoken = [word for word in words if word.upos != "PUNCT"]
    for first, word in enumerate(words):
        for behind in range(min(len(words), first + _LONGEST), first, -1):
            if word.upos == "PUNCT" or words[behind - 1].upos == "PUNCT" or behind - first == len(spoken):
                continue
            is_apart = behind == len(words) or words[behind].upos == "PUNCT"
            is_front = word.index == spoken[0].index
            if not is_apart and not is_front:
                continue
            text = " ".join(forms[first:behind])
            if (
                (is_apart and _APART.fullmatch(text))
                or (is_apart and not is_front and _ENDINGS.fullmatch(text))
                or ((is_apart or (is_front and is_verb(vocabulary, words[behind]))) and _ANYWHERE.fullmatch(text))
            ) and not (first and _belongs_to(words[first - 1], words[first:behind], vocabulary)):
                return frozenset(word.index for word in words[first:behind])
    return frozenset()


def _belongs_to(before: Word, words: Sequence[Word], vocabulary: Vocabulary) -> bool:
    """Whether words belong to the word before them: "to the right now", "turn right now", "what do you know"."""
    if before.upos == "AUX" and before.head in [word.index for word in words]:
        return True
    verbs = vocabulary.verbs_beginning_with(before.lemma.lower()) if before.upos == "VERB" else ()
    return before.upos in ("ADP", "DET", "SCONJ") or any(
        words[0].said in listed for verb in verbs for listed in vocabulary.lists_of(verb)
    )
