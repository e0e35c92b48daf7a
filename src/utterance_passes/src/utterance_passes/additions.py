"""Joins what is added to the thing that it is added to: "the cup *as well as the plate*"."""

from typing import Optional, Sequence, Tuple

from utterance_passes.clauses import has_case
from utterance_passes.pass_needs import only_with, only_with_forms
from utterance_passes.persons import is_likely, is_person, is_person_or_name
from utterance_passes.tree import ASIDE, DependencyTree, Word
from utterance_passes.tree_edits import TreeEdit
from utterance_passes.vocabulary import Vocabulary
from word_classes import word_class

#: "Too", "also" and the first word of "as well".
_ADDITIVES = word_class("additive_adverbs") | frozenset(["as"])
_AS_WELL_AS = ["as", "well", "as"]
#: What is not brought to anybody.
_FIXED = ("Location", "Furniture", "Portal")
_NOT_ONLY = ["not", "only"]
_NOUNS = frozenset(["NOUN", "PROPN", "PRON"])
_OBJECT_PRONOUNS = word_class("object_pronouns") - {"it"}
_THINGS = ("Physical_object", "Substance", "Fluid")


@only_with_forms(["well"])
def with_as_well_as(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make "and" of "as well as": "bring me the cup *as well as the plate*" is about two things."""
    edit = TreeEdit(tree)
    for first in tree.words[:-3]:
        said = tree.words[first.index - 1 : first.index + 2]
        thing = _added(tree, said) or first
        is_said = [word.form.lower() for word in said] == _AS_WELL_AS and thing.index > said[-1].index
        before = tree.word(first.index - 1) if first.index > 1 else first
        while before.head and before.upos in _NOUNS and tree.word(before.head).upos in _NOUNS:
            before = tree.word(before.head)
        if is_said and thing.upos in _NOUNS and before.upos in _NOUNS and before.index < first.index:
            edit.rehang(thing.index, before.index, "conj")
            for word in said:
                edit.rehang(word.index, thing.index, "cc")
    return edit.tree()


def _added(tree: DependencyTree, said: Sequence[Word]) -> Optional[Word]:
    """Return the noun behind "as well as": above its last word, or right behind it where its words are one."""
    last = said[-1]
    if last.head and last.head not in [word.index for word in said]:
        return tree.word(last.head)
    behind = (word for word in tree.words[last.index :] if min(tree.subtree(word.index)) == last.index + 1)
    return next((word for word in behind if word.upos in _NOUNS), None)


@only_with("cc")
def without_not_only(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Set "not only" aside before "but": "bring *not only* the cup but also the plate" forbids nothing."""
    edit = TreeEdit(tree)
    for first, second in zip(tree.words, tree.words[1:]):
        joints = [word for word in tree.words[second.index :] if word.form.lower() == "but" and word.deprel == "cc"]
        if [first.form.lower(), second.form.lower()] == _NOT_ONLY and joints and first.head:
            for word in (first, second):
                edit.rehang(word.index, first.head, ASIDE)
    return edit.tree()


@only_with("conj")
def with_things_added(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Join a thing behind "and" to the object, not to the person or the place before it.

    "Bring the cup to Anna *and the fork*" names no second goal, nor does "put the cup in the sink *and the fork too*".
    """
    edit = TreeEdit(tree)
    for thing in tree.words:
        goal = tree.word(thing.head) if thing.head else thing
        above = tree.word(goal.head) if goal.head else goal
        joints = [child.form.lower() for child in tree.children(thing.index) if child.deprel == "cc"]
        if thing.deprel != "conj" or thing.upos != "NOUN" or joints != ["and"] or has_case(tree, thing):
            continue
        if goal.upos == "VERB":
            verb = goal
        else:
            verb = tree.word(above.head) if goal.deprel == "nmod" and above.deprel == "obj" else above
        objects = [child for child in tree.children(verb.index) if child.deprel == "obj" and child.index < thing.index]
        is_behind_phrase = goal is verb or goal.deprel in ("obl", "nmod")
        if verb.upos != "VERB" or not is_behind_phrase or len(objects) != 1 or is_person(objects[0]):
            continue
        is_added = bool(_ADDITIVES.intersection(word.form.lower() for word in _around(tree, thing)))
        is_no_goal = goal is not verb and _is_person_or_place(goal) and not is_likely(thing, _FIXED)
        if is_likely(thing, _THINGS) and (is_added or is_no_goal):
            edit.rehang(thing.index, objects[0].index)
    return edit.tree()


def _around(tree: DependencyTree, phrase: Word) -> Tuple[Word, ...]:
    """Return the words of a phrase, and the word behind it."""
    behind = max(tree.subtree(phrase.index)) + 1
    return tuple(word for word in tree.words if word.index in tree.subtree(phrase.index) or word.index == behind)


def _is_person_or_place(word: Word) -> bool:
    is_anybody = is_person_or_name(word) or word.form.lower() in _OBJECT_PRONOUNS
    return is_anybody or is_likely(word, ["Location"])
