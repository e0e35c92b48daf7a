"""Sets aside why something is to be done: "bring me a coat *because I am cold*"."""

from typing import Sequence

from utterance_passes.engine.utterance_pass import Example, Kind, tree_pass
from utterance_passes.trees.tree import ASIDE, NOUNS, DependencyTree, Word
from utterance_passes.trees.tree_edits import TreeEdit, set_aside
from utterance_passes.trees.vocabulary import Vocabulary, is_verb
from word_classes import word_class

_REASONS = word_class("reason_conjunctions")
_OWN_CLAUSES = ("conj", "parataxis")
#: A reason behind one of these may be the reason for it.
_CLAUSES_OF_VERBS = ("ccomp", "xcomp", "advcl", "acl", "acl:relcl", "parataxis", "conj")
#: They need not stand for the thing: "because *this* is heavy".
_POINTING = word_class("pronouns") - word_class("plural_pronouns") - {"it"}
_PRONOUNS = (
    word_class("pronouns")
    | word_class("male_pronouns")
    | word_class("female_pronouns")
    | word_class("pronouns_of_persons_or_things")
) - _POINTING
_MODALS = word_class("modals")
_PERSONS = word_class("pronouns_of_persons")
_SUBJECTS = ("nsubj", "nsubj:pass", "expl")


@tree_pass(
    Kind.MEANING,
    Example(
        "come|VERB|0|root because|SCONJ|5|mark I|PRON|5|nsubj am|AUX|5|cop cold|ADJ|1|advcl",
        (
            "because: mark(cold) -> discourse:aside(come)",
            "I: nsubj(cold) -> discourse:aside(come)",
            "am: cop(cold) -> discourse:aside(come)",
            "cold: advcl(come) -> discourse:aside(come)",
        ),
    ),
    requires=["advcl"],
    assigns=[ASIDE, "root", "parataxis"],
)
def reasons(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Set aside the clauses that give the reason for a command, or what speaks against it: they do not change it.

    A clause stays that may hold a command itself: "take the cup because it is broken and bring it to me". One that
    names what the command speaks of becomes a remark: "because the cup is dirty, wash *it*".
    """
    found = [
        word
        for word in tree.words
        if word.deprel == "advcl" and _is_reason(tree, word) and _is_of_deed(tree, word, vocabulary)
    ]
    if not found:
        return tree
    told = [word for word in found if _is_spoken_of(tree, word)]
    edit = TreeEdit(tree)
    for clause in told:
        edit.relabel(clause.index, "parataxis")
        edit.relabel(_first(tree, clause), ASIDE)
    positions = frozenset().union(*(tree.subtree(word.index) for word in found if word not in told))
    tree = edit.tree()
    return set_aside(tree, positions, ASIDE, lambda word: is_verb(vocabulary, word)) if positions else tree


def _first(tree: DependencyTree, clause: Word) -> int:
    return min(index for index in tree.subtree(clause.index) if tree.word(index).upos != "PUNCT")


def _is_spoken_of(tree: DependencyTree, clause: Word) -> bool:
    """Whether words behind a clause may stand for what it names."""
    inside = tree.subtree(clause.index)
    is_named = any(tree.word(index).upos in NOUNS for index in inside)
    behind = tree.words[max(inside) :]
    return is_named and any(word.said in _PRONOUNS for word in behind)


def _is_reason(tree: DependencyTree, clause: Word) -> bool:
    children = tree.children(clause.index)
    first = tree.word(_first(tree, clause))
    is_marked = first.head == clause.index and (first.said in _REASONS or _is_for_somebody(first, children))
    return is_marked and _has_subject(children) and not _holds_command(tree, clause)


def _is_for_somebody(first: Word, children: Sequence[Word]) -> bool:
    """Whether a clause says what a person can do then: "so that I can see", but not "so that it faces the wall"."""
    is_persons = any(child.deprel in _SUBJECTS and child.said in _PERSONS for child in children)
    return first.said == "so" and is_persons and any(child.said in _MODALS for child in children)


def _has_subject(children: Sequence[Word]) -> bool:
    return any(child.deprel in _SUBJECTS for child in children)


def _holds_command(tree: DependencyTree, clause: Word) -> bool:
    """Whether a clause goes on with one that has no subject of its own, which the parser may have put here."""
    return any(
        word.deprel in ("conj", "parataxis") and word.upos == "VERB" and not _has_subject(tree.children(word.index))
        for word in map(tree.word, tree.subtree(clause.index) - {clause.index})
    )


def _is_of_deed(tree: DependencyTree, clause: Word, vocabulary: Vocabulary) -> bool:
    """Whether a reason can only belong to its verb: it is in front of it, or no other clause and no words that are
    said are between both."""
    verb = top = tree.governor(clause)
    if vocabulary.takes_clause(verb.lemma.lower(), tree.word(_first(tree, clause)).said):
        return False
    while top.deprel in _OWN_CLAUSES:
        top = tree.governor(top)
    if top.head:
        return False  # "tell Anna to come because dinner is ready"
    if clause.index < verb.index:
        return True
    others = [child for child in tree.children(verb.index) if verb.index < child.index < clause.index]
    is_said = vocabulary.speech_of(verb.lemma.lower()) is not None
    return not is_said and not any(
        word.deprel in _CLAUSES_OF_VERBS for other in others for word in map(tree.word, tree.subtree(other.index))
    )
