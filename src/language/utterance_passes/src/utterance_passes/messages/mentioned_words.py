"""Makes noun phrases of words that are spoken of and not said to the hearer: "the password is *'open the door'*"."""

from typing import FrozenSet

from utterance_passes.engine.utterance_pass import Example, Kind, tree_pass
from utterance_passes.trees.tree import NOUNS, QUOTED, DependencyTree, Word
from utterance_passes.trees.tree_edits import TreeEdit
from utterance_passes.trees.vocabulary import Vocabulary
from word_classes import word_class

#: Who only says these around a quotation says the quotation.
_AROUND = (
    word_class("padding")
    | word_class("lead_in")
    | word_class("robot_names")
    | word_class("greetings")
    | word_class("thanks")
)
_CLAUSES = frozenset(["acl", "acl:relcl", "advcl", "ccomp", "conj", "csubj", "parataxis", "xcomp"])
_ADDRESSES = frozenset(["discourse", "vocative"])
_SAYING = word_class("saying_verbs")


@tree_pass(
    Kind.MEANING,
    Example(
        'forget|VERB|0|root "|PUNCT|3|punct open|VERB|1|ccomp it|PRON|3|obj "|PUNCT|3|punct',
        ("open: ccomp(forget) VERB/open -> obj(forget) NOUN/open", "it: obj(open) -> flat:quoted(open)"),
    ),
    assigns=[QUOTED, "obj", "obl", "case", "cop", "punct", "appos"],
)
def mentioned_words(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Make a noun phrase of a clause between quotation marks that is spoken of.

    Its verb asks for nothing: neither "forget 'open the door'" nor "the password is 'open the door'" opens it. The
    marks belong to what is between them.
    """
    quotations = tree.between_marks
    if not quotations or not _says_more(tree, frozenset().union(*quotations)):
        return tree
    edit = TreeEdit(tree)
    for inside in quotations:
        head = _top(tree, inside)
        if any(tree.word(index).upos == "VERB" for index in inside):
            _make_phrase(edit, tree, head, inside)
            _join_to_word_before(edit, tree, head, inside, vocabulary)
        for mark in (min(inside) - 1, max(inside) + 1):
            if head.index not in tree.subtree(mark):
                edit.rehang(mark, head.index, "punct")
    return edit.tree()


def _top(tree: DependencyTree, inside: FrozenSet[int]) -> Word:
    """Return the first word that is below no other one: the parser may have joined two of them by a word outside."""
    below = frozenset().union(*(tree.subtree(index) - {index} for index in inside))
    return tree.word(min(inside - below))


def _says_more(tree: DependencyTree, quoted: FrozenSet[int]) -> bool:
    unsaid = quoted | tree.fillers
    return any(
        word.index not in unsaid and word.upos != "PUNCT" and word.said not in _AROUND and word.deprel not in _ADDRESSES
        for word in tree.words
    )


def _make_phrase(edit: TreeEdit, tree: DependencyTree, head: Word, inside: FrozenSet[int]) -> None:
    for word in tree.words:
        if word.index != head.index and word.index in inside:
            edit.rehang(word.index, head.index, QUOTED)
        elif word.head in inside and word.index not in inside:
            is_copula = word.deprel.startswith("aux") and word.lemma.lower() == "be"
            edit.rehang(word.index, head.index, "cop" if is_copula else "")
    edit.retag(head.index, "NOUN", "NN")
    if head.deprel in _CLAUSES and not _joins_nouns(tree, head):
        edit.relabel(head.index, "obj")


def _join_to_word_before(
    edit: TreeEdit, tree: DependencyTree, head: Word, inside: FrozenSet[int], vocabulary: Vocabulary
) -> None:
    """Make the phrase a part of what stands before it: "the file 'go home'", "the room called 'come in'"."""
    before = next((word for word in reversed(tree.words[: min(inside) - 2]) if word.upos != "PUNCT"), None)
    if before is None:
        return
    if before.index in tree.subtree(head.index):
        if before.deprel in ("mark", "case") and before.head == head.index and head.deprel in _CLAUSES:
            edit.relabel(before.index, "case")
            edit.relabel(head.index, "obl")
    elif before.upos == "NOUN" and not _is_told(tree, before, vocabulary):
        edit.rehang(head.index, before.index, "appos")
    elif before.deprel == "acl":
        edit.rehang(head.index, before.index, "obj")


def _is_told(tree: DependencyTree, word: Word, vocabulary: Vocabulary) -> bool:
    """Whether a noun belongs to a verb of saying or of naming, which takes the quotation, too."""
    verb = tree.governor(word).lemma.lower() if word.head else ""
    return verb in _SAYING or vocabulary.speech_of(verb) is not None


def _joins_nouns(tree: DependencyTree, word: Word) -> bool:
    return word.deprel == "conj" and tree.governor(word).upos in NOUNS
