"""Brings what is told of a place into one form: "she is at the desk"."""

from typing import Tuple

from utterance_passes.pass_needs import only_with
from utterance_passes.tree import ASIDE, DependencyTree, Word
from utterance_passes.tree_edits import TreeEdit
from utterance_passes.vocabulary import Vocabulary
from word_classes import word_class

_ASKING = word_class("asking_verbs")
#: Where something was, nobody knows.
_BEING_NOW = word_class("present_forms_of_be")
_FINDING = word_class("finding_verbs")
_GOING = word_class("verbs_of_going")
_HEARERS = word_class("hearers")
_MODALS = word_class("modals_of_promises")
_SHOWING = word_class("showing_verbs")
_NOBODY = word_class("no_pronouns")
_NOT = word_class("not")
_ON_AND_OFF = frozenset(["on", "off"])
_ON_OR_OFF = word_class("states_of_devices")
_PLACE_PREPOSITIONS = word_class("place_prepositions")
_NOUNS = frozenset(["NOUN", "PROPN"])
#: Relations of a place that a clause may describe.
_OF_PLACES = frozenset(["obl", "nmod", "obj"])
#: Relations of "where" at the verb on which it depends.
_OF_STATEMENTS = frozenset(["ccomp", "xcomp", "advcl", "obj"])
#: Relations of words that belong to a clause, not to the noun that is its predicate.
_OF_CLAUSES = frozenset(["cop", "cc", "punct", "advmod", "discourse", "conj", "parataxis", "aux", "mark"])
#: Subjects by objects.
_SUBJECTS = {"him": "he", "her": "she", "them": "they", "it": "it"}
_OBJECTS = {"i": "me", "we": "us", **{subject: its for its, subject in _SUBJECTS.items()}}


@only_with("parataxis", "conj", "ccomp", "list")
def with_places_told(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
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
    subjects = [child for child in children if child.deprel == "nsubj" and child.form.lower() in _HEARERS]
    modals = [child for child in children if child.deprel == "aux" and child.form.lower() in _MODALS]
    objects = [child for child in children if child.deprel == "obj" and child.form.lower() in _SUBJECTS]
    places = [child for child in children if child.deprel == "obl" and _is_place(tree, child)]
    is_promise = subjects and modals and subjects[0].index < modals[0].index and len(objects) == len(places) == 1
    return (subjects[0], objects[0], places[0]) if is_promise else ()


def _is_place(tree: DependencyTree, word: Word) -> bool:
    return any(
        child.deprel == "case" and child.form.lower() in _PLACE_PREPOSITIONS for child in tree.children(word.index)
    )


def _replaced(tree: DependencyTree, verb: Word, hearer: Word, thing: Word, place: Word) -> DependencyTree:
    edit = TreeEdit(tree)
    edit.rehang(place.index, verb.head, verb.deprel)
    for child in tree.children(verb.index):
        if child.index != place.index:
            is_aside = child.deprel == "aux" or child.index == thing.index
            edit.rehang(child.index, place.index, ASIDE if is_aside else "")
    # The subject stands where the hearer was named, before its verb.
    edit.respell(hearer.index, _SUBJECTS[thing.form.lower()])
    edit.rehang(verb.index, place.index, "cop")
    edit.tag(verb.index, "AUX", "VBZ", "Mood=Ind|Tense=Pres|VerbForm=Fin")
    edit.respell(verb.index, "is", lemma="be")
    return edit.tree()


@only_with("cop")
def with_places_shown(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make a goal of the place where something is: "show Bob *where it is*", "go *where Anna is*"."""
    edit = TreeEdit(tree)
    for where in tree.words:
        verb = tree.word(where.head) if where.head else where
        children = tree.children(where.index)
        cases = [child for child in children if child.deprel == "case"]
        subjects = [child for child in children if child.deprel == "nsubj" and child.index > where.index]
        copulas = [child for child in children if child.deprel == "cop" and child.form.lower() in _BEING_NOW]
        is_where = where.form.lower() == "where" and (
            (_is_clause_at(verb, where) and verb.lemma.lower() in _SHOWING | _GOING)
            or (where.deprel == "obl" and [case.form.lower() for case in cases] == ["to"])
        )
        if not is_where or len(subjects) != 1 or len(copulas) != 1:
            continue
        edit.rehang(subjects[0].index, verb.index, "obl")
        if subjects[0].form.lower() in _OBJECTS:
            edit.respell(subjects[0].index, _OBJECTS[subjects[0].form.lower()])
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


@only_with("parataxis", "advcl", "ccomp", "advmod")
def with_places_described(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Attach a clause to the place that it describes: "the room *where Anna is*", "the room *Anna is in*"."""
    edit = TreeEdit(tree)
    for place in tree.words:
        if place.upos != "NOUN" or place.index == len(tree.words) or place.deprel not in _OF_PLACES:
            continue
        first = tree.word(place.index + 1)
        # In "where Bob sleeps" and "Anna is in", the first word is below the top of the clause.
        is_below = first.head and not any(child.deprel == "nsubj" for child in tree.children(first.index))
        top = tree.word(first.head) if is_below and first.deprel in ("advmod", "nsubj") else first
        is_told = top.deprel == "ccomp" and _is_asked(tree, top, vocabulary)
        is_apart = top.deprel in ("parataxis", "advcl", "ccomp", "advmod") and not is_told
        is_described = first.form.lower() == "where" or _is_stranded(tree, top)
        # Where nobody is, nobody knows.
        is_known = not any(child.form.lower() in _NOBODY for child in tree.children(top.index))
        if is_apart and is_described and is_known and place.index not in tree.subtree(top.index):
            edit.rehang(top.index, place.index, "acl:relcl")
    return edit.tree()


def _is_asked(tree: DependencyTree, clause: Word, vocabulary: Vocabulary) -> bool:
    """Whether a clause is what somebody asks, tells, shows or finds: "ask the man in the hall *where Anna is*"."""
    verb = tree.word(clause.head)
    lemma = verb.lemma.lower()
    return verb.index < clause.index and (
        vocabulary.speech_of(lemma) is not None or lemma in _ASKING | _SHOWING | _FINDING
    )


def _is_stranded(tree: DependencyTree, preposition: Word) -> bool:
    """Whether a preposition has no noun but a subject and "is": "Anna is *in*"."""
    relations = {child.deprel for child in tree.children(preposition.index)}
    is_one = preposition.form.lower() in _PLACE_PREPOSITIONS
    return preposition.upos in ("ADP", "ADV") and is_one and {"nsubj", "cop"} <= relations


@only_with("cop")
def with_inverted_places(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make a place before "is" the predicate of the thing behind it: "behind the robot is a door".

    The parser takes the place for the subject of the thing.
    """
    edit = TreeEdit(tree)
    for thing in tree.words:
        children = tree.children(thing.index)
        copula = next((child for child in children if child.deprel == "cop" and child.index < thing.index), None)
        places = [child for child in children if child.deprel in ("obl", "nsubj", "nmod") and _is_place(tree, child)]
        places = [child for child in places if copula is not None and child.index < copula.index]
        has_subject = any(child.deprel.startswith(("nsubj", "expl")) and child not in places for child in children)
        if copula is None or thing.upos not in _NOUNS or len(places) != 1 or has_subject:
            continue
        edit.rehang(places[0].index, thing.head, thing.deprel)
        edit.rehang(thing.index, places[0].index, "nsubj")
        for child in children:
            if child.deprel in _OF_CLAUSES and child.index != places[0].index:
                edit.rehang(child.index, places[0].index)
    return edit.tree()


@only_with("cop")
def with_states_before_places(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make the predicate of a state of a device in front of a place, in a clause: "check if the lights are *on* in the
    hall"."""
    edit = TreeEdit(tree)
    for state, case in zip(tree.words, tree.words[1:]):
        if state.form.lower() not in _ON_AND_OFF or case.deprel != "case" or case.head < case.index:
            continue
        place = tree.word(case.head)
        below = (*tree.children(place.index), *tree.children(state.index))
        copulas = [child for child in below if child.deprel == "cop"]
        between = tree.words[copulas[0].index : state.index - 1] if copulas else ()
        is_state = state.head in (place.index, place.head)
        if not copulas or not place.head or not is_state or any(word.form.lower() not in _NOT for word in between):
            continue
        edit.retag(state.index, "ADJ", "JJ")
        edit.rehang(state.index, place.head, place.deprel)
        for child in tree.children(place.index):
            if child.index < state.index:
                edit.rehang(child.index, state.index)
        edit.rehang(place.index, state.index, "obl")
    return edit.tree()


@only_with("cop")
def with_places_of_subjects(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach a place to the thing before it in a question about its state: "is the cup *on the table* red", "is the
    radio *in the kitchen* on"."""
    edit = TreeEdit(tree)
    for predicate in tree.words:
        children = tree.children(predicate.index)
        copula = next((child for child in children if child.deprel == "cop"), predicate)
        subject = next((child for child in children if child.deprel == "nsubj"), predicate)
        if not copula.index < subject.index < predicate.index:
            continue
        places = [child for child in children if child.deprel == "obl" and _is_place(tree, child)]
        for place in places if predicate.upos == "ADJ" else ():
            if subject.index < place.index < predicate.index:
                edit.rehang(place.index, subject.index, "nmod")
        state = [child for child in children if child.index > predicate.index and child.form.lower() in _ON_OR_OFF]
        if predicate.upos in _NOUNS and len(state) == 1 and state[0].deprel == "case" and _is_place(tree, predicate):
            edit.rehang(state[0].index, predicate.head, predicate.deprel)
            edit.retag(state[0].index, "ADV")
            for child in children:
                if child.deprel in _OF_CLAUSES or child.index == subject.index:
                    edit.rehang(child.index, state[0].index)
            edit.rehang(predicate.index, subject.index, "nmod")
    return edit.tree()
