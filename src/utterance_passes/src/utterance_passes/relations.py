"""Replaces relations that the guidelines of Universal Dependencies (v2) rule out.

A parser labels each arc by itself; these passes correct labels that contradict the arcs around them.
"""

from utterance_passes.tree import DependencyTree, Word
from utterance_passes.tree_edits import TreeEdit
from utterance_passes.vocabulary import Vocabulary
from word_classes import word_class

_ASKING = word_class("asking_verbs")
_QUESTION_WORDS = word_class("question_words")
_WHETHER = word_class("whether_words")


def with_one_object(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Turn a particle between two objects of a verb into a preposition: "pick up the cup off the foot of the bed"."""
    edit = TreeEdit(tree)
    for particle in tree.words:
        if particle.deprel != "compound:prt":
            continue
        objects = [child for child in tree.children(particle.head) if child.deprel == "obj"]
        first = [child for child in objects if child.index < particle.index]
        second = [child for child in objects if min(tree.subtree(child.index)) == particle.index + 1]
        if first and second:
            edit.make_preposition(particle.index, second[0].index)
            edit.relabel(second[0].index, "obl")
    return edit.tree()


def without_particle_predicates(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Turn a particle with a copula into a clause: "check if the lights are off" asks whether they are off."""
    edit = TreeEdit(tree)
    for word in tree.words:
        if word.deprel == "compound:prt" and any(child.deprel == "cop" for child in tree.children(word.index)):
            edit.relabel(word.index, "ccomp")
    return edit.tree()


def without_verb_compounds(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Turn a verb that is a compound with the verb before it into a clause: "go get the mug" means to go and get it."""
    edit = TreeEdit(tree)
    for word in tree.words:
        head = tree.word(word.head) if word.head else word
        if word.deprel == "compound" and head.upos == word.upos == "VERB" and head.index < word.index:
            edit.relabel(word.index, "xcomp")
    return edit.tree()


def without_infinitive_conjuncts(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Turn a conjunct with "to" into a purpose clause: "turn left to face the door" says why to turn."""
    edit = TreeEdit(tree)
    for word in tree.words:
        if word.deprel == "conj" and word.upos == "VERB" and word.head and _is_infinitive(tree, word):
            is_joined = any(child.deprel == "cc" for child in tree.children(word.index))
            if not is_joined and not _is_infinitive(tree, tree.word(word.head)):
                edit.relabel(word.index, "advcl")
    return edit.tree()


def _is_infinitive(tree: DependencyTree, word: Word) -> bool:
    return any(child.deprel == "mark" and child.form.lower() == "to" for child in tree.children(word.index))


def with_told_predicates(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Make a clause of a predicate behind the question that is to be told: "tell what day *is tomorrow*"."""
    edit = TreeEdit(tree)
    for verb in tree.words:
        following = tree.word(verb.index + 1).form.lower() if verb.index < len(tree.words) else ""
        is_saying = any(vocabulary.speech_of(one) for one in vocabulary.verbs_beginning_with(verb.lemma.lower()))
        if not is_saying or following not in _QUESTION_WORDS:
            continue
        below = (tree.word(index) for index in sorted(tree.subtree(verb.index)) if index > verb.index)
        copula = next((word for word in below if word.deprel == "cop"), None)
        predicate = tree.word(copula.index + 1) if copula is not None and copula.index < len(tree.words) else None
        if copula is None or predicate is None or predicate.head != verb.index or predicate.deprel.startswith("ccomp"):
            continue
        edit.relabel(predicate.index, "ccomp")
        edit.rehang(copula.index, predicate.index)
        between = tree.words[verb.index : copula.index - 1]
        for word in between:
            if not verb.index < word.head < copula.index:
                edit.rehang(word.index, predicate.index, "nsubj")
    return edit.tree()


def with_asked_clauses(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make a clause behind the person who is asked the question: "ask Bob *if he has seen Anna*" has no condition."""
    edit = TreeEdit(tree)
    for verb in tree.words:
        if verb.lemma.lower() not in _ASKING:
            continue
        children = tree.children(verb.index)
        asked = [child for child in children if child.deprel in ("obj", "iobj") and child.index > verb.index]
        for clause in children:
            marks = [child.index for child in tree.children(clause.index) if child.form.lower() in _WHETHER]
            is_behind = bool(asked and marks) and marks[0] == max(tree.subtree(asked[0].index)) + 1
            if clause.deprel == "advcl" and is_behind:
                edit.relabel(clause.index, "ccomp")
                edit.relabel(asked[0].index, "iobj")
    return edit.tree()
