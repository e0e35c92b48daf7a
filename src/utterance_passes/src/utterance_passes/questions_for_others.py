"""Finds the question for somebody else, and the deeds behind it: "ask Bob *what he wants* and bring it to him"."""

from typing import FrozenSet

from utterance_passes.pass_needs import only_with
from utterance_passes.tree import DependencyTree, Word
from utterance_passes.tree_edits import TreeEdit
from utterance_passes.vocabulary import Vocabulary, is_verb
from word_classes import word_class

_ASKING = word_class("asking_verbs")
_QUESTION_WORDS = word_class("question_words")
_THERE = frozenset(["there"])
_THINGS = word_class("pronouns_of_things") | word_class("pronouns_of_persons_or_things") | {"one"}
_WHETHER = word_class("whether_words")


@only_with("advcl")
def with_asked_clauses(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Make a clause behind the person who is asked the question: "ask Bob *if he has seen Anna*" has no condition. What
    somebody is told how to do is such a clause, too: "tell Bob *how to get there*"."""
    edit = TreeEdit(tree)
    for verb in tree.words:
        children = tree.children(verb.index)
        for clause in children if vocabulary.speech_of(verb.lemma.lower()) is not None else ():
            first = tree.word(min(tree.subtree(clause.index)))
            if clause.deprel == "advcl" and tree.is_infinitive(clause.index) and first.form.lower() in _QUESTION_WORDS:
                edit.relabel(clause.index, "ccomp")
        if verb.lemma.lower() not in _ASKING:
            continue
        asked = [child for child in children if child.deprel in ("obj", "iobj") and child.index > verb.index]
        for clause in children:
            marks = [child.index for child in tree.children(clause.index) if child.form.lower() in _WHETHER]
            is_behind = bool(asked and marks) and marks[0] == _end_of_phrases(tree, verb, asked[0]) + 1
            if clause.deprel == "advcl" and is_behind:
                edit.relabel(clause.index, "ccomp")
                edit.relabel(asked[0].index, "iobj")
    return edit.tree()


def _end_of_phrases(tree: DependencyTree, verb: Word, first: Word) -> int:
    """Return the last word of a phrase and of those right behind it: "ask *Anna in the kitchen* if she wants tea"."""
    end = max(tree.subtree(first.index))
    for child in tree.children(verb.index):
        inside = tree.subtree(child.index)
        if child.deprel == "obl" and min(inside) == end + 1:
            end = max(inside)
    return end


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
