"""Separates words behind a comma from the phrase before it: "go to the wall, *photo*", "turn left, *honey*"."""

from semantic_types import Fit, shipped_types
from utterance_passes.clauses import verb_above
from utterance_passes.pass_needs import only_with
from utterance_passes.tree import DependencyTree, Word
from utterance_passes.tree_edits import TreeEdit
from utterance_passes.vocabulary import Vocabulary
from word_classes import word_class

_ADDRESSED = word_class("those_addressed") | word_class("robots")
_OF_NOUNS = frozenset(["conj", "appos"])
_SET_OFF = frozenset(["vocative", "obj"]) | _OF_NOUNS
#: Types of whoever is spoken to.
_LIVING = ("Sentient", "Animal")


@only_with(*_SET_OFF)
def with_words_set_off(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Make a separate part of the sentence of a bare noun at the end, behind a comma.

    Nothing joins it to what stands before, and an object of one thing would have an article. Names for whoever is
    spoken to are addresses; all others are words whose meaning a person must tell.
    """
    edit = TreeEdit(tree)
    for noun in tree.words[2:]:
        if not _is_set_off(tree, noun) or not noun.head or _is_said(tree, noun, vocabulary):
            continue
        head = tree.word(noun.head)
        if _is_addressed(noun):
            if noun.deprel in _OF_NOUNS and _has_article(tree, head):
                edit.rehang(noun.index, verb_above(tree, noun).index, "vocative")
        elif noun.deprel == "vocative" or (noun.deprel == "obj" and noun.index > head.index + 2):
            edit.relabel(noun.index, "parataxis")
        elif noun.deprel in _OF_NOUNS and _has_article(tree, head):
            edit.rehang(noun.index, verb_above(tree, noun).index, "parataxis")
    return edit.tree()


def _is_set_off(tree: DependencyTree, noun: Word) -> bool:
    """Whether a noun without an article or a conjunction stands at the end behind a comma; adjectives may be there."""
    if noun.upos != "NOUN" or noun.deprel not in _SET_OFF or noun.xpos == "NNS":
        return False
    inside = map(tree.word, sorted(tree.subtree(noun.index)))
    spoken = [word for word in inside if word.upos != "PUNCT"]
    first = spoken[0].index
    is_bare = all(word is noun or word.upos == "ADJ" for word in spoken)
    comma = tree.word(max(1, first - 1))
    is_last = all(word.upos == "PUNCT" for word in tree.words[noun.index :])
    if not (is_bare and is_last and comma.form == "," and comma.index > 1):
        return False
    # "Bring me, please, tea" has an object.
    return tree.word(comma.index - 1).upos not in ("INTJ", "PUNCT")


def _is_addressed(noun: Word) -> bool:
    """Whether a noun may be a name for whoever is spoken to; the parser takes a word of which nothing is known for
    one, or not."""
    if noun.form.lower() in _ADDRESSED:
        return True
    fit = shipped_types().of_noun([noun.form.lower(), noun.lemma.lower()]).fit(_LIVING)
    return fit is Fit.LIKELY or (noun.deprel == "vocative" and fit is not Fit.WRONG)


def _has_article(tree: DependencyTree, noun: Word) -> bool:
    """Whether a noun is described and heads no list with a conjunction."""
    children = tree.children(noun.index)
    items = [child for child in children if child.deprel == "conj"]
    is_list = any(inner.deprel == "cc" for item in items for inner in tree.children(item.index))
    return not is_list and any(child.deprel in ("det", "amod", "nmod:poss") for child in children)


def _is_said(tree: DependencyTree, noun: Word, vocabulary: Vocabulary) -> bool:
    """Whether a noun belongs to a message."""
    return any(vocabulary.speech_of(word.lemma.lower()) is not None for word in tree.words[: noun.index])
