"""Replaces relations that the guidelines of Universal Dependencies (v2) rule out.

A parser labels each arc by itself; these passes correct labels that contradict the arcs around them.
"""

from typing import FrozenSet

from utterance_passes.clauses import has_case, prepositions_of, verb_above
from utterance_passes.pass_needs import only_with
from utterance_passes.tree import DependencyTree, Word
from utterance_passes.tree_edits import TreeEdit
from utterance_passes.vocabulary import Vocabulary, is_verb
from word_classes import word_class

_HANDLING = word_class("verbs_of_handling")
#: Tags of a verb that may be a command.
_BARE_TAGS = frozenset(["VB", "VBP"])
#: "Next *to*" and "close *to*" lead nowhere.
_BESIDE = frozenset(["next", "close"])
_GOING = word_class("verbs_of_going")
_HEARERS = word_class("hearers")
#: Relations of words that no command has.
_OF_FINITE = frozenset(["nsubj", "csubj", "aux", "cc", "mark", "expl"])
_OF_REMARKS = word_class("speaker_subjects") | frozenset(["it"])
_QUESTION_WORDS = word_class("question_words")
_PLACE_PREPOSITIONS = word_class("place_prepositions")
_TO_PREPOSITIONS = word_class("to_prepositions")
_RECEIVERS = (word_class("object_pronouns") | word_class("female_pronouns") | word_class("hearers")) - {"it"}
_WITH_TO = word_class("verbs_with_to")


def with_one_object(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Turn a particle between two objects of a verb into a preposition: "pick up the cup off the foot of the bed"."""
    edit = TreeEdit(tree)
    for particle in tree.words:
        if particle.deprel != "compound:prt":
            continue
        objects = [child for child in tree.children(particle.head) if child.deprel == "obj"]
        first = [child for child in objects if child.index < particle.index]
        # The parser may see that it is no object, but not its preposition: "pick the cup up *off* the floor".
        bare = [child for child in tree.children(particle.head) if child.deprel == "obl" and not has_case(tree, child)]
        second = [child for child in (*objects, *bare) if min(tree.subtree(child.index)) == particle.index + 1]
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


def with_relative_subjects(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make "who" the subject of the verb right behind it, which has no other: "greet everybody *who leaves*"."""
    edit = TreeEdit(tree)
    for word in tree.words[:-1]:
        verb = tree.word(word.index + 1)
        is_beside = word.xpos == "WP" and (word.head, word.deprel, verb.upos) == (verb.index, "compound", "VERB")
        if is_beside and not any(child.deprel.startswith("nsubj") for child in tree.children(verb.index)):
            edit.relabel(word.index, "nsubj")
    return edit.tree()


def without_infinitive_conjuncts(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Turn a conjunct with "to" into a purpose clause: "turn left to face the door" says why to turn."""
    edit = TreeEdit(tree)
    for word in tree.words:
        if word.deprel == "conj" and word.upos == "VERB" and word.head and tree.is_infinitive(word.index):
            is_joined = any(child.deprel == "cc" for child in tree.children(word.index))
            if not is_joined and not tree.is_infinitive(word.head):
                edit.rehang(word.index, _last_deed_before(tree, word).index, "advcl")
    return edit.tree()


def _last_deed_before(tree: DependencyTree, purpose: Word) -> Word:
    """Return the last of the joined deeds before a purpose: "turn left, then *turn right* to face the door"."""
    deeds = [tree.word(purpose.head)]
    for word in tree.words[deeds[0].index : purpose.index - 1]:
        is_deed = word.deprel in ("conj", "parataxis") and word.upos == "VERB" and not tree.is_infinitive(word.index)
        deeds += [word] if is_deed and word.head in [deed.index for deed in deeds] else []
    return deeds[-1]


@only_with("conj", "xcomp", "advcl")
def with_commands_behind_statements(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Make a clause of its own of a command behind a statement: in "the dog needs to go out, *open the door*" the dog
    opens nothing."""
    edit = TreeEdit(tree)
    for verb in tree.words:
        governor = tree.word(verb.head) if verb.head else verb
        children = tree.children(verb.index)
        relations = {child.deprel.split(":")[0] for child in children}
        first = min(tree.subtree(verb.index))
        is_bare = verb.upos == "VERB" and verb.xpos in _BARE_TAGS and verb.form.lower() == verb.lemma.lower()
        is_apart = tree.word(first).form == "," and tree.word(first).head == verb.index
        if verb.deprel not in ("conj", "xcomp", "advcl") or not (is_bare and is_apart and first + 1 == verb.index):
            continue
        if relations & _OF_FINITE or not is_verb(vocabulary, verb):
            continue
        above = governor
        while above.deprel in ("conj", "xcomp") and above.head:
            above = tree.word(above.head)
        subjects = [child for child in tree.children(above.index) if child.deprel.startswith("nsubj")]
        if subjects and subjects[0].index < above.index and subjects[0].form.lower() not in _HEARERS:
            edit.rehang(verb.index, above.index, "parataxis")
    return edit.tree()


@only_with("acl:relcl")
def with_remarks_apart(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make a clause of its own of a whole sentence behind a noun: in "bring me water *I'm thirsty*" the water is not
    described."""
    edit = TreeEdit(tree)
    for predicate in tree.words:
        children = tree.children(predicate.index)
        subjects = [child.form.lower() for child in children if child.deprel == "nsubj"]
        has_copula = any(child.deprel == "cop" for child in children)
        is_whole = predicate.upos == "ADJ" and has_copula and len(subjects) == 1 and subjects[0] in _OF_REMARKS
        first = min(tree.subtree(predicate.index))
        if predicate.deprel != "acl:relcl" or not is_whole or tree.word(first).form.lower() not in _OF_REMARKS:
            continue
        verb = verb_above(tree, tree.word(predicate.head))
        if verb.upos == "VERB":
            edit.rehang(predicate.index, verb.index, "parataxis")
    return edit.tree()


@only_with("case")
def with_prepositions_at_names(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach a preposition to the noun right behind it: in "look *for Adam* at the chair" it does not belong to the
    chair."""
    edit = TreeEdit(tree)
    for preposition in tree.words[:-1]:
        noun = tree.word(preposition.index + 1)
        governor = tree.word(preposition.head) if preposition.head else preposition
        is_skipped = preposition.deprel == "case" and governor.index > noun.index and noun.head == governor.head
        has_another = any(
            child.deprel == "case" and child.index > noun.index for child in tree.children(preposition.head)
        )
        if is_skipped and has_another and noun.upos in ("NOUN", "PROPN", "PRON"):
            edit.rehang(preposition.index, noun.index)
            edit.relabel(noun.index, "obl")
    return edit.tree()


@only_with("cop")
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


@only_with("ccomp")
def with_things_named_by_clauses(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make "what" the thing that a clause describes: "bring me *what* I left there" asks nothing."""
    edit = TreeEdit(tree)
    for clause in tree.words:
        verb = tree.word(clause.head) if clause.head and clause.deprel == "ccomp" else clause
        if verb is clause or verb.lemma.lower() not in _HANDLING:
            continue
        what = tree.word(tree.first_spoken(clause.index))
        is_what = what.form.lower() == "what" and what.xpos == "WP"
        has_object = any(child.deprel == "obj" for child in tree.children(verb.index))
        if is_what and what.head == clause.index and what.index > verb.index and not has_object:
            edit.rehang(what.index, verb.index, "obj")
            edit.rehang(clause.index, what.index, "acl:relcl")
    return edit.tree()


@only_with("acl:relcl")
def with_goals_behind_clauses(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach the goal behind the description of a thing to the verb: "bring the book I put on the shelf *to Anna*"."""
    edit = TreeEdit(tree)
    for clause in tree.words:
        thing = tree.word(clause.head) if clause.head and clause.deprel == "acl:relcl" else clause
        verb = tree.word(thing.head) if thing is not clause and thing.head else thing
        if thing.deprel != "obj" or verb.upos != "VERB" or clause.lemma.lower() in _GOING:
            continue
        inside = sorted(tree.subtree(clause.index))
        goals = [
            tree.word(index)
            for index in inside
            if _has_preposition(tree, index, _TO_PREPOSITIONS) and not _is_beside_something(tree, index)
        ]
        if len(goals) != 1 or goals[0] is clause or max(tree.subtree(goals[0].index)) != inside[-1]:
            continue
        # "What you *found* to the kitchen": nothing is found to a place.
        is_without = verb.lemma.lower() in _HANDLING and clause.lemma.lower() not in _WITH_TO and clause.upos == "VERB"
        if is_without or _is_complete_before(tree, clause, goals[0]):
            edit.rehang(goals[0].index, verb.index, "obl")
    return edit.tree()


def _is_complete_before(tree: DependencyTree, clause: Word, goal: Word) -> bool:
    """Whether what describes a thing ends before a goal.

    Nothing is left in two places: "that he left *on the table* to the kitchen"; nor given to two: "that I gave *you* to
    the kitchen". Where a verb goes stands before when it went: "that he used *yesterday* to the kitchen".
    """
    children = tree.children(clause.index)
    ends = [index for index in tree.subtree(clause.index) if _has_preposition(tree, index, _PLACE_PREPOSITIONS)]
    ends += [child.index for child in children if child.deprel == "obl:unmarked" or child.form.lower() in _RECEIVERS]
    is_place = clause.index in ends and any(child.deprel == "cop" for child in children)
    return is_place or any(clause.index < index < goal.index for index in ends)


def _has_preposition(tree: DependencyTree, index: int, prepositions: FrozenSet[str]) -> bool:
    return any(preposition in prepositions for preposition in prepositions_of(tree, index))


def _is_beside_something(tree: DependencyTree, index: int) -> bool:
    """Whether a phrase says what something is next to, or close to."""
    before = tree.words[: min(tree.subtree(index)) - 1][-1:]
    return _has_preposition(tree, index, _BESIDE) or any(word.form.lower() in _BESIDE for word in before)


@only_with("cop")
def with_predicates_as_clauses(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make a clause of an object that has a subject and a copula: "find out *what time it is*"."""
    edit = TreeEdit(tree)
    for word in tree.words:
        if word.deprel == "obj" and tree.has_copula_and_subject(word.index):
            edit.relabel(word.index, "ccomp")
    return edit.tree()
