"""Finds the deed in a wish for its result: whoever says "I want *the table cleaned*" wants no table."""

from typing import List, NamedTuple, Optional

from utterance_passes.tree import DependencyTree, Word
from utterance_passes.tree_edits import TreeEdit
from utterance_passes.vocabulary import Vocabulary
from word_classes import word_class

_INDEFINITE = word_class("indefinite_articles")
_PRONOUNS = word_class("object_pronouns")
_SPEAKERS = word_class("speaker_subjects")
_WISHES = word_class("wanting_verbs") | word_class("wishing_verbs")
_PARTICIPLES = ("VBN", "VBD")
_CLAUSES = ("acl", "xcomp", "ccomp", "advcl")
_THINGS = ("obj", "nsubj", "nsubj:pass")
#: Behind a participle alone, other phrases may tell which thing is meant: "the book placed on the shelf".
_OF_DEEDS = word_class("to_prepositions")


class _Result(NamedTuple):
    thing: Word
    deed: Word


def with_wished_results(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Make a request for a deed of the wish for its result; "I want a bottle filled with water" asks for a bottle."""
    edit = TreeEdit(tree)
    for wish in tree.words:
        if not _is_speaker(tree, wish):
            continue
        result = _result(tree, wish, vocabulary)
        joined = _joined_results(tree, wish)
        things = [child for child in tree.children(wish.index) if child.deprel == "obj"]
        if result is not None:
            _make_deed(edit, result, wish.index, "xcomp")
            for other in joined:
                # "I want the table cleaned and *the floor swept*".
                _make_deed(edit, other, result.deed.index, "conj")
        elif len(things) == 1 and len(joined) == 1 and _is_definite(tree, things[0]):
            # "I want *the table and the chairs* cleaned".
            _make_deed(edit, _Result(things[0], joined[0].deed), wish.index, "xcomp")
            edit.rehang(joined[0].thing.index, things[0].index, "conj")
            for child in tree.children(joined[0].deed.index):
                if child.deprel == "cc":
                    edit.rehang(child.index, joined[0].thing.index)
    return edit.tree()


def _make_deed(edit: TreeEdit, result: _Result, head: int, relation: str) -> None:
    edit.rehang(result.deed.index, head, relation)
    edit.retag(result.deed.index, "VERB", "VBN")
    edit.rehang(result.thing.index, result.deed.index, "obj")


def _joined_results(tree: DependencyTree, wish: Word) -> List[_Result]:
    found = []
    for deed in tree.children(wish.index):
        things = [child for child in tree.children(deed.index) if child.deprel in _THINGS and child.index < deed.index]
        if deed.deprel == "conj" and deed.xpos in _PARTICIPLES and len(things) == 1:
            found.append(_Result(things[0], deed))
    return found


def _result(tree: DependencyTree, wish: Word, vocabulary: Vocabulary) -> Optional[_Result]:
    children = tree.children(wish.index)
    for deed in tree.words[wish.index :]:
        above = [tree.word(deed.head)] if deed.head else []
        things = [*above, *children, *tree.children(deed.index)]
        thing = next((one for one in things if one.deprel in _THINGS and wish.index < one.index < deed.index), None)
        if thing is None or deed.deprel not in _CLAUSES or wish.index not in (deed.head, thing.head):
            continue
        if _is_definite(tree, thing) and _is_deed(tree, thing, deed, vocabulary):
            return _Result(thing, deed)
    return None


def _is_speaker(tree: DependencyTree, wish: Word) -> bool:
    """Whether the speaker wishes something now."""
    subjects = [child.form.lower() for child in tree.children(wish.index) if child.deprel == "nsubj"]
    return wish.form.lower() in _WISHES and any(subject in _SPEAKERS for subject in subjects)


def _is_definite(tree: DependencyTree, thing: Word) -> bool:
    determiners = {
        child.form.lower() for child in tree.children(thing.index) if child.deprel.split(":")[0] in ("det", "nmod")
    }
    is_named = thing.upos == "PROPN" or thing.form.lower() in _PRONOUNS
    return is_named or (bool(determiners) and not determiners & _INDEFINITE)


def _is_deed(tree: DependencyTree, thing: Word, deed: Word, vocabulary: Vocabulary) -> bool:
    """Whether the participle right behind a thing is a deed of the lexicon, and what is behind it belongs to that."""
    own = [child for child in tree.children(deed.index) if child.index != thing.index]
    first = min([deed.index, *(child.index for child in own)])
    # The deed may be below its thing, or above it.
    below = tree.subtree(deed.index) if deed.head == thing.index else frozenset()
    last = max(tree.subtree(thing.index) - below)
    if deed.xpos not in _PARTICIPLES or first != last + 1 or not vocabulary.verbs_beginning_with(deed.lemma.lower()):
        return False
    if any(child.deprel == "aux:pass" for child in own):
        return all(child.deprel in ("mark", "aux:pass") for child in own if child.index < deed.index)
    cases = [case.form.lower() for child in own for case in tree.children(child.index) if case.deprel == "case"]
    return first == deed.index and all(case in _OF_DEEDS for case in cases)
