"""Finds the deed in a wish for its result: whoever says "I want *the table cleaned*" wants no table.

"Get the table cleaned" and "the table needs to be cleaned" wish the same.
"""

from typing import List, NamedTuple, Optional

from semantic_types.parts_of_speech import VERB, base_forms
from utterance_passes.engine.utterance_pass import Example, Kind, tree_pass
from utterance_passes.trees.tree import ASIDE, DependencyTree, Word
from utterance_passes.trees.tree_edits import TreeEdit
from utterance_passes.trees.vocabulary import Verbs, Vocabulary
from word_classes import word_class

_CAUSATIVE = word_class("causative_verbs")
_HEARERS = word_class("hearers")
_INDEFINITE = word_class("indefinite_articles")
_NEEDS = word_class("verbs_of_duty")
_PRONOUNS = word_class("object_pronouns")
_SPEAKERS = word_class("speaker_subjects")
_WISHES = word_class("wanting_verbs") | word_class("wishing_verbs")
_PARTICIPLES = ("VBN", "VBD")
_CLAUSES = ("acl", "xcomp", "ccomp", "advcl")
_THINGS = ("obj", "nsubj", "nsubj:pass")
#: What a participle behind a thing calls it.
_NAMES = ("obj", "xcomp", "appos", "nmod")
#: Forms of "be" before a result: "to *be* cleaned", "to *be* open".
_TO_BE = ("aux:pass", "cop")
#: Behind a participle alone, other phrases may tell which thing is meant: "the book placed on the shelf".
_OF_DEEDS = word_class("to_prepositions")


class _Result(NamedTuple):
    thing: Word
    deed: Word
    base: str


@tree_pass(
    Kind.MEANING,
    Example(
        "I|PRON|2|nsubj want|VERB|0|root the|DET|4|det door|NOUN|2|obj closed|VERB|4|acl|close|VBN",
        ("door: obj(want) -> obj(closed)", "closed: acl(door) -> xcomp(want)"),
        Verbs(frozenset(["close"])),
    ),
    requires=["obj", "nsubj"],
    assigns=["xcomp", "conj", "aux", "aux:pass", "obj", ASIDE],
)
def wished_results(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Make a request for a deed of the wish for its result; "I want a bottle filled with water" asks for a bottle."""
    edit = TreeEdit(tree)
    for wish in tree.words:
        if _is_speaker(tree, wish):
            _make_wished(edit, tree, wish, vocabulary)
        elif wish.head and wish.deprel not in ("conj", "parataxis"):
            # What Anna is told to get done is a message.
            continue
        elif _is_causative(tree, wish):
            _put_in_place(edit, tree, wish, vocabulary)
        else:
            _make_needed(edit, tree, wish, vocabulary)
    return edit.tree()


def _make_wished(edit: TreeEdit, tree: DependencyTree, wish: Word, vocabulary: Vocabulary) -> None:
    """Make deeds of the results that are wished."""
    result = _result(tree, wish, vocabulary)
    joined = _joined_results(tree, wish, vocabulary)
    things = [child for child in tree.children(wish.index) if child.deprel == "obj"]
    if result is not None:
        _make_deed(edit, tree, result, wish.index, "xcomp")
        for other in joined:
            # "I want the table cleaned and *the floor swept*".
            _make_deed(edit, tree, other, result.deed.index, "conj")
        return
    for child in tree.children(things[0].index) if things else ():
        if child.deprel == "acl" and any(word.deprel in _TO_BE for word in tree.children(child.index)):
            # Whoever wants "the cup *to be on the table*" does not want the cup.
            edit.rehang(child.index, wish.index, "xcomp")
    if len(things) == 1 and len(joined) == 1 and _is_definite(tree, things[0]):
        # "I want *the table and the chairs* cleaned".
        _make_deed(edit, tree, joined[0]._replace(thing=things[0]), wish.index, "xcomp")
        edit.rehang(joined[0].thing.index, things[0].index, "conj")
        for child in tree.children(joined[0].deed.index):
            if child.deprel == "cc":
                edit.rehang(child.index, joined[0].thing.index)


def _make_needed(edit: TreeEdit, tree: DependencyTree, verb: Word, vocabulary: Vocabulary) -> None:
    """Make a deed of what a thing needs; "needs" and "has to" help it, as "must" does."""
    needed = _needed(tree, verb, vocabulary)
    if needed is None:
        return
    if needed.deed.index != verb.index:
        edit.rehang_children(verb.index, needed.deed.index)
        edit.rehang(verb.index, needed.deed.index, "aux")
    _make_deed(edit, tree, needed, verb.head, verb.deprel)


def _make_deed(edit: TreeEdit, tree: DependencyTree, result: _Result, head: int, relation: str) -> None:
    for child in tree.children(result.deed.index):
        if child.deprel == "cop":
            edit.relabel(child.index, "aux:pass")
    edit.respell(result.deed.index, result.deed.form, result.base)
    edit.retag(result.deed.index, "VERB", "VBN")
    edit.rehang(result.deed.index, head, relation)
    edit.rehang(result.thing.index, result.deed.index, "obj")


def _put_in_place(edit: TreeEdit, tree: DependencyTree, verb: Word, vocabulary: Vocabulary) -> None:
    """Let the deed of "*get* the table cleaned" take the place of the verb, which is set aside."""
    result = _result(tree, verb, vocabulary)
    if result is None:
        return
    edit.rehang_children(verb.index, result.deed.index)
    for one in (result, *_joined_results(tree, verb, vocabulary)):
        edit.respell(one.deed.index, one.base)
        edit.retag(one.deed.index, "VERB", "VB")
        edit.rehang(one.thing.index, one.deed.index, "obj")
    edit.rehang(result.deed.index, verb.head, verb.deprel)
    edit.rehang(verb.index, result.deed.index, ASIDE)


def _needed(tree: DependencyTree, verb: Word, vocabulary: Vocabulary) -> Optional[_Result]:
    """Return what a thing needs: "the table *must be cleaned*", "the table *needs cleaning*"."""
    things = [child for child in tree.children(verb.index) if child.deprel in ("nsubj", "nsubj:pass")]
    if len(things) != 1 or things[0].index > verb.index or not _is_definite(tree, things[0]):
        return None
    is_verb_of_duty = verb.lemma.lower() in _NEEDS
    deeds = [child for child in tree.children(verb.index) if child.deprel == "xcomp"] if is_verb_of_duty else [verb]
    for deed in deeds:
        helping = [child for child in tree.children(deed.index) if child.deprel.startswith("aux")]
        is_helped = any(child.deprel == "aux:pass" for child in helping)
        is_passive = deed.xpos in _PARTICIPLES and (is_helped or is_verb_of_duty)
        is_due = is_verb_of_duty or any(child.xpos == "MD" and child.said in _NEEDS for child in helping)
        is_wanted = is_due and (is_passive or (is_verb_of_duty and deed.xpos == "VBG"))
        base = _base(deed, vocabulary) if is_wanted else ""
        if base:
            return _Result(things[0], deed, base)
    return None


def _base(deed: Word, vocabulary: Vocabulary) -> str:
    """Return the base form that the lexicon has of a deed; empty if it has none."""
    bases = [deed.lemma.lower(), *base_forms(deed.form, VERB)]
    return next((base for base in bases if vocabulary.verbs_beginning_with(base)), "")


def _is_causative(tree: DependencyTree, verb: Word) -> bool:
    """Whether the hearer is told to have something done: "get", "can you have"."""
    subjects = [child.said for child in tree.children(verb.index) if child.deprel.startswith("nsubj")]
    is_base = verb.said in _CAUSATIVE and verb.upos == "VERB"
    return is_base and all(subject in _HEARERS for subject in subjects)


def _joined_results(tree: DependencyTree, wish: Word, vocabulary: Vocabulary) -> List[_Result]:
    found = []
    for deed in tree.children(wish.index):
        things = [child for child in tree.children(deed.index) if child.deprel in _THINGS and child.index < deed.index]
        if deed.deprel == "conj" and deed.xpos in _PARTICIPLES and len(things) == 1:
            found.append(_Result(things[0], deed, _base(deed, vocabulary) or deed.lemma))
    return found


def _result(tree: DependencyTree, wish: Word, vocabulary: Vocabulary) -> Optional[_Result]:
    children = tree.children(wish.index)
    for deed in tree.words[wish.index :]:
        above = [tree.governor(deed)] if deed.head else []
        things = [*above, *children, *tree.children(deed.index)]
        thing = next((one for one in things if one.deprel in _THINGS and wish.index < one.index < deed.index), None)
        if thing is None or deed.deprel not in _CLAUSES or wish.index not in (deed.head, thing.head):
            continue
        base = _base(deed, vocabulary) if _is_definite(tree, thing) and _is_deed(tree, thing, deed) else ""
        if base:
            return _Result(thing, deed, base)
    return None


def _is_speaker(tree: DependencyTree, wish: Word) -> bool:
    """Whether the speaker wishes something now."""
    subjects = [child.said for child in tree.children(wish.index) if child.deprel == "nsubj"]
    return wish.said in _WISHES and any(subject in _SPEAKERS for subject in subjects)


def _is_definite(tree: DependencyTree, thing: Word) -> bool:
    determiners = {child.said for child in tree.children(thing.index) if child.deprel.split(":")[0] in ("det", "nmod")}
    is_named = thing.upos == "PROPN" or thing.said in _PRONOUNS
    return is_named or (bool(determiners) and not determiners & _INDEFINITE)


def _is_deed(tree: DependencyTree, thing: Word, deed: Word) -> bool:
    """Whether a participle is right behind a thing, and what is behind it belongs to the deed."""
    own = [child for child in tree.children(deed.index) if child.index != thing.index]
    first = min([deed.index, *(child.index for child in own)])
    # The deed may be below its thing, or above it.
    below = tree.subtree(deed.index) if deed.head == thing.index else frozenset()
    last = max(tree.subtree(thing.index) - below)
    is_to_be = any(child.deprel in _TO_BE for child in own)
    # "I want the door *closed*", "get the room *clean*".
    is_state = deed.upos == "ADJ" and (is_to_be or deed.deprel == "xcomp")
    if not (is_state or deed.xpos in _PARTICIPLES) or first != last + 1:
        return False
    if is_to_be:
        return all(child.deprel in ("mark", *_TO_BE) for child in own if child.index < deed.index)
    if any(child.deprel in _NAMES for child in own):
        # "The book *called Emma*".
        return False
    cases = [case.said for child in own for case in tree.prepositions(child.index)]
    return first == deed.index and all(case in _OF_DEEDS for case in cases)
