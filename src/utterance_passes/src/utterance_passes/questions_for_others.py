"""Separates the deeds behind a question for somebody else from it: "ask Bob what he wants *and bring it to him*"."""

from typing import FrozenSet

from utterance_passes.pass_relations import only_with
from utterance_passes.tree import DependencyTree, Word
from utterance_passes.tree_edits import TreeEdit
from utterance_passes.vocabulary import Vocabulary, is_verb
from word_classes import word_class

_QUESTION_WORDS = word_class("question_words")
_THERE = frozenset(["there"])
_THINGS = word_class("pronouns_of_things") | word_class("pronouns_of_persons_or_things") | {"one"}


@only_with("ccomp")
def with_deeds_behind_questions(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Join a deed that names what a question asks for to the verb of the command: nobody asks "what he wants to bring
    *it* to him"."""
    edit = TreeEdit(tree)
    for question in tree.words:
        asking = tree.word(question.head) if question.head else question
        if question.deprel != "ccomp" or asking.upos != "VERB" or asking.index > question.index:
            continue
        inside = [tree.word(index) for index in sorted(tree.subtree(question.index))]
        asked = inside[0].form.lower()
        if asked not in _QUESTION_WORDS:
            continue
        again = _THERE if asked == "where" else _THINGS
        for deed in inside:
            if deed.deprel == "conj" and _is_deed(tree, deed, vocabulary) and _names(tree, deed, again):
                edit.rehang(deed.index, asking.index, "conj")
                break
    return edit.tree()


def _is_deed(tree: DependencyTree, word: Word, vocabulary: Vocabulary) -> bool:
    """Whether a word begins a command: a verb of the lexicon in its base form, without a subject or an auxiliary."""
    relations = [child.deprel.split(":")[0] for child in tree.children(word.index)]
    is_bare = word.form.lower() == word.lemma.lower() and not {"nsubj", "aux", "cop", "mark"} & set(relations)
    return word.upos == "VERB" and is_bare and is_verb(vocabulary, word)


def _names(tree: DependencyTree, deed: Word, pronouns: FrozenSet[str]) -> bool:
    return any(
        child.form.lower() in pronouns and child.deprel in ("obj", "iobj", "advmod", "obl")
        for child in tree.children(deed.index)
    )
