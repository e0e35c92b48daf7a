"""Replaces verbs that only say that a deed begins or goes on by the deed: "start moving" means "move"."""

from typing import Optional

from semantic_types.parts_of_speech import VERB, base_forms
from utterance_passes.engine.pass_needs import only_with_lemmas
from utterance_passes.engine.utterance_pass import Example, Kind, tree_pass
from utterance_passes.trees.tree import ASIDE, DependencyTree, Word
from utterance_passes.trees.tree_edits import TreeEdit
from utterance_passes.trees.vocabulary import Verbs, Vocabulary
from word_classes import word_class

_ASPECTUAL_VERBS = word_class("aspectual_verbs")
_HEARERS = word_class("hearers")
#: Words before the deed: "continue *to* go", "start *by* turning".
_MARKS = frozenset(["to", "by"])
_CLAUSES = frozenset(["xcomp", "advcl"])


@tree_pass(
    Kind.MEANING,
    Example(
        "start|VERB|0|root turning|VERB|1|xcomp|turn|VBG",
        ("start: root -> discourse:aside(turning)", "turning: xcomp(start) -> root"),
        Verbs(frozenset(["turn"])),
    ),
    assigns=[ASIDE],
)
@only_with_lemmas(_ASPECTUAL_VERBS)
def aspectual_verbs(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Replace "start moving", "continue to move" and the like by "move".

    The aspectual verb is set aside.

    "I started moving" and "the robot keeps moving" are no commands. A verb that the lexicon has with its deed ("keep
    moving") stays.
    """
    edit = TreeEdit(tree)
    for word in tree.words:
        deed = _deed(tree, word, vocabulary)
        if deed is None:
            continue
        edit.respell(deed.index, deed.form, _base(deed, vocabulary))
        edit.retag(deed.index, "VERB", "VB")
        edit.rehang(deed.index, word.head, word.deprel)
        for child in tree.children(word.index):
            if child.index != deed.index:
                # "Keep following *me*" may be read as "keep me".
                edit.rehang(child.index, deed.index)
        edit.rehang(word.index, deed.index, ASIDE)
        for child in tree.children(deed.index):
            if child.deprel == "mark":
                edit.relabel(child.index, ASIDE)
    return edit.tree()


def _deed(tree: DependencyTree, word: Word, vocabulary: Vocabulary) -> Optional[Word]:
    if word.lemma.lower() not in _ASPECTUAL_VERBS or word.upos != "VERB" or word.said != word.lemma.lower():
        return None
    children = tree.children(word.index)
    subjects = [child for child in children if child.deprel.startswith("nsubj")]
    if any(subject.said not in _HEARERS for subject in subjects):
        return None
    deed = next((child for child in children if child.index > word.index and _is_deed(tree, child)), None)
    if deed is None or any(child.deprel in ("obj", "iobj") and child.index < deed.index for child in children):
        return None
    marks = {child.said for child in tree.children(deed.index) if child.deprel == "mark"}
    is_bare = not marks and (deed.upos == "NOUN" or (deed.xpos == "VBG" and deed.deprel == "xcomp"))
    is_known = f"{word.lemma.lower()} {deed.said}" in vocabulary.verbs_beginning_with(word.lemma.lower())
    is_deed = bool(_base(deed, vocabulary)) and not is_known
    return deed if is_deed and (is_bare or (bool(marks) and marks <= _MARKS)) else None


def _is_deed(tree: DependencyTree, word: Word) -> bool:
    """Whether a word may be the deed: a clause, or a gerund that the parser takes for a thing, "start cleaning"."""
    is_alone = all(child.deprel == "punct" for child in tree.children(word.index))
    return (word.deprel in _CLAUSES and word.upos == "VERB") or (
        word.deprel == "obj" and word.upos == "NOUN" and is_alone
    )


def _base(deed: Word, vocabulary: Vocabulary) -> str:
    """Return the base form that the lexicon has of a deed; empty if it has none."""
    form = deed.said
    forms = [deed.lemma.lower()] if deed.upos == "VERB" else []
    forms += base_forms(form, VERB) if form.endswith("ing") else ()
    return next((form for form in forms if vocabulary.verbs_beginning_with(form)), "")
