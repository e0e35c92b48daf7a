"""Sets aside the words that open a correction of a running command: "no, turn right", "no I meant turn right"."""

from utterance_passes.formula_file import pattern_of
from utterance_passes.tree import ASIDE, DependencyTree, Word
from utterance_passes.tree_edits import set_aside
from utterance_passes.vocabulary import Vocabulary, is_verb
from word_classes import word_class

_LEAD_IN = word_class("lead_in")
_OPENING = pattern_of("objections")


def without_objection(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Set aside the opening of a correction if a whole command follows: "no, turn right", "I meant turn right"."""
    text = ""
    for position, word in enumerate(tree.words):
        if position and _OPENING.fullmatch(text) and _begins_command(tree, position, vocabulary):
            opening = frozenset(range(1, position + 1))
            return set_aside(tree, opening, ASIDE, lambda word: is_verb(vocabulary, word))
        text = f"{text} {plain(word)}".strip()
    return tree


def plain(word: Word) -> str:
    """Return a word in the form that the patterns of objections expect: lower case, straight apostrophes, any mark as
    a comma.
    """
    form = word.form.lower().replace("\u2019", "'")
    return "," if word.upos == "PUNCT" else "n't" if form == "nt" else form


def _begins_command(tree: DependencyTree, position: int, vocabulary: Vocabulary) -> bool:
    words = [word for word in tree.words[position:] if word.upos != "PUNCT" and word.form.lower() not in _LEAD_IN]
    return bool(words) and is_verb(vocabulary, words[0])
