"""Brings what is told of a place into one form: "she is at the desk"."""

from typing import Tuple

from utterance_passes.engine.utterance_pass import Example, Kind, tree_pass
from utterance_passes.trees.tree import ASIDE, DependencyTree, Word
from utterance_passes.trees.tree_edits import TreeEdit
from utterance_passes.trees.vocabulary import Vocabulary
from word_classes import word_class

#: Where something was, nobody knows.
_PRESENT_TENSE = ("VBZ", "VBP")
_FINDING = word_class("finding_verbs")
_GOING = word_class("verbs_of_going")
_HEARERS = word_class("hearers")
_MODALS = word_class("modals") | word_class("future_auxiliaries")
_SHOW = "show"
_PLACE_PREPOSITIONS = word_class("place_prepositions")
#: Relations of "where" at the verb on which it depends.
_OF_STATEMENTS = frozenset(["ccomp", "xcomp", "advcl", "obj"])
#: Subjects by objects.
_SUBJECTS = {"him": "he", "her": "she", "them": "they", "it": "it"}
_OBJECTS = {"i": "me", "we": "us", **{subject: its for its, subject in _SUBJECTS.items()}}


@tree_pass(
    Kind.MEANING,
    Example(
        "go|VERB|0|root ,|PUNCT|5|punct you|PRON|5|nsubj will|AUX|5|aux find|VERB|1|parataxis her|PRON|5|obj "
        "at|ADP|8|case desks|NOUN|5|obl",
        (
            ",: punct(find) -> punct(desks)",
            "you: nsubj(find) PRON/you you -> nsubj(desks) PRON/she she",
            "will: aux(find) -> discourse:aside(desks)",
            "find: parataxis(go) VERB/find find -> cop(desks) AUX/be is",
            "her: obj(find) -> discourse:aside(desks)",
            "desks: obl(find) -> parataxis(go)",
        ),
    ),
    requires=["parataxis", "conj", "ccomp", "list"],
    assigns=["cop", ASIDE],
)
def places_told(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Replace "you will find her at the desk" beside a command by "she is at the desk".

    Alone, such a sentence may be a command.
    """
    for word in tree.words:
        if word.lemma.lower() in _FINDING and word.deprel in ("parataxis", "conj", "ccomp", "list"):
            told = _told(tree, word)
            if told:
                return _replaced(tree, word, *told)
    return tree


def _told(tree: DependencyTree, verb: Word) -> Tuple[Word, ...]:
    """Return the hearer, and who or what is where: an object and a place; nothing if it is no promise."""
    children = tree.children(verb.index)
    subjects = [child for child in children if child.deprel == "nsubj" and child.said in _HEARERS]
    modals = [child for child in children if child.deprel == "aux" and child.said in _MODALS]
    objects = [child for child in children if child.deprel == "obj" and child.said in _SUBJECTS]
    places = [child for child in children if child.deprel == "obl" and _is_place(tree, child)]
    is_promise = subjects and modals and subjects[0].index < modals[0].index and len(objects) == len(places) == 1
    return (subjects[0], objects[0], places[0]) if is_promise else ()


def _is_place(tree: DependencyTree, word: Word) -> bool:
    return any(child.said in _PLACE_PREPOSITIONS for child in tree.prepositions(word.index))


def _replaced(tree: DependencyTree, verb: Word, hearer: Word, thing: Word, place: Word) -> DependencyTree:
    edit = TreeEdit(tree)
    edit.rehang(place.index, verb.head, verb.deprel)
    for child in tree.children(verb.index):
        if child.index != place.index:
            is_aside = child.deprel == "aux" or child.index == thing.index
            edit.rehang(child.index, place.index, ASIDE if is_aside else "")
    # The subject stands where the hearer was named, before its verb.
    edit.respell(hearer.index, _SUBJECTS[thing.said])
    edit.rehang(verb.index, place.index, "cop")
    edit.tag(verb.index, "AUX", "VBZ", "Mood=Ind|Tense=Pres|VerbForm=Fin")
    edit.respell(verb.index, "is", lemma="be")
    return edit.tree()


@tree_pass(
    Kind.MEANING,
    Example(
        "show|VERB|0|root Bob|PROPN|1|iobj where|ADV|1|ccomp it|PRON|3|nsubj is|AUX|3|cop|be|VBZ",
        (
            "where: ccomp(show) ADV/where -> case(it) ADP/where",
            "it: nsubj(where) -> obl(show)",
            "is: cop(where) -> discourse:aside(show)",
        ),
    ),
    requires=["cop"],
    assigns=["obl", "case", ASIDE],
)
def places_shown(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make a goal of the place where something is: "show Bob *where it is*", "go *where Anna is*"."""
    edit = TreeEdit(tree)
    for where in tree.words:
        verb = tree.governor(where)
        children = tree.children(where.index)
        cases = [child for child in children if child.deprel == "case"]
        subjects = [child for child in children if child.deprel == "nsubj" and child.index > where.index]
        copulas = [child for child in children if child.deprel == "cop" and child.xpos in _PRESENT_TENSE]
        is_where = where.said == "where" and (
            (_is_clause_at(verb, where) and verb.lemma.lower() in _GOING | {_SHOW})
            or (where.deprel == "obl" and [case.said for case in cases] == ["to"])
        )
        if not is_where or len(subjects) != 1 or len(copulas) != 1:
            continue
        edit.rehang(subjects[0].index, verb.index, "obl")
        if subjects[0].said in _OBJECTS:
            edit.respell(subjects[0].index, _OBJECTS[subjects[0].said])
        for child in (*children, where):
            if child in cases or (child is where and not cases):
                edit.make_preposition(child.index, subjects[0].index)
            elif child is not subjects[0]:
                edit.rehang(child.index, verb.index, ASIDE if child is where or child in copulas else "")
        if not cases and verb.lemma.lower() in _GOING:
            edit.respell(where.index, "to")
    return edit.tree()


def _is_clause_at(verb: Word, where: Word) -> bool:
    """Whether "where" belongs to a verb: right behind it, it cannot be a remark."""
    return where.deprel in _OF_STATEMENTS or (where.deprel == "parataxis" and where.index == verb.index + 1)
