"""Replaces relations that the guidelines of Universal Dependencies (v2) rule out.

A parser labels each arc by itself; these passes correct labels that contradict the arcs around them.
"""

from typing import FrozenSet, Optional

from utterance_passes.clauses import has_case, prepositions_of, verb_above
from utterance_passes.pass_needs import only_with
from utterance_passes.persons import is_person_or_name
from utterance_passes.tree import DependencyTree, Word
from utterance_passes.tree_edits import TreeEdit
from utterance_passes.vocabulary import Speech, Vocabulary, is_verb
from word_classes import word_class

_INFORMING = word_class("verbs_of_informing")
_ASKING = word_class("asking_verbs")
_HANDLING = word_class("verbs_of_handling")
#: Tags of a verb that may be a command.
_BARE_TAGS = frozenset(["VB", "VBP"])
_GOING = word_class("verbs_of_going")
_HEARERS = word_class("hearers")
#: Relations of words that no command has.
_OF_FINITE = frozenset(["nsubj", "csubj", "aux", "cc", "mark", "expl"])
_OF_REMARKS = word_class("speaker_subjects") | frozenset(["it"])
_QUESTION_WORDS = word_class("question_words")
_WHETHER = word_class("whether_words")
_WHO = word_class("relative_persons")
_OF_MESSAGES = frozenset(["ccomp", "xcomp"])
_OPINION = word_class("verbs_of_opinion") - word_class("wanting_verbs") - word_class("wishing_verbs")
_PLACE_PREPOSITIONS = word_class("place_prepositions")
_TO_PREPOSITIONS = word_class("to_prepositions")
_RECEIVERS = (word_class("object_pronouns") | word_class("female_pronouns") | word_class("hearers")) - {"it"}
_WITH_TO = word_class("verbs_with_to")
#: Words with which begins what is told.
_OPENINGS = _QUESTION_WORDS | _WHETHER | frozenset(["that"])


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


@only_with("iobj", "obj")
def with_hearers_joined(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Join a person behind "and" to the hearer, not to what the hearer is told: "tell her *and Bob* that dinner is
    ready" tells nothing of Bob, nor does "tell her *and then Bob* that ..."."""
    edit = TreeEdit(tree)
    orders = [then for joint, then in zip(tree.words, tree.words[1:]) if _is_and_then(joint, then)]
    words = [word for word in tree.words if word not in orders]
    for hearer, joint, person, opening in zip(words, words[1:], words[2:], words[3:]):
        verb = tree.word(hearer.head) if hearer.head else hearer
        is_telling = vocabulary.speech_of(verb.lemma.lower()) is Speech.TOLD or verb.lemma.lower() in _ASKING
        is_right = person.head == hearer.index and joint.head == person.index
        is_joined = hearer.deprel in ("iobj", "obj") and joint.form.lower() == "and" and not is_right
        if not (is_telling and is_joined and is_person_or_name(person)) or opening.form.lower() not in _OPENINGS:
            continue
        edit.rehang(person.index, hearer.index, "conj")
        edit.rehang(joint.index, person.index, "cc")
        for then in orders:
            if joint.index < then.index < person.index:
                edit.rehang(then.index, person.index)
        clauses = [child for child in tree.children(verb.index) if child.deprel == "ccomp"]
        if opening.deprel == "det" and clauses and opening.form.lower() == "that":
            edit.retag(opening.index, "SCONJ", "IN")
            edit.rehang(opening.index, clauses[0].index, "mark")
    return edit.tree()


@only_with("conj")
def with_deeds_of_hearers(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Join a deed to what a hearer is to do, if it cannot be the robot's: "tell him to sit down *and to relax*", and
    without "to" where the robot does not know how to do that."""
    edit = TreeEdit(tree)
    for deed in tree.words:
        verb = tree.word(deed.head) if deed.deprel == "conj" and deed.upos == "VERB" else deed
        lemma = verb.lemma.lower()
        if verb is deed or (vocabulary.speech_of(lemma) is not Speech.TOLD and lemma not in _ASKING):
            continue
        children = tree.children(verb.index)
        own = [child for child in children if child.index < deed.index and tree.is_infinitive(child.index)]
        is_known = bool(vocabulary.verbs_beginning_with(deed.lemma.lower()))
        if own and deed.xpos == "VB" and (tree.is_infinitive(deed.index) or not is_known):
            edit.rehang(deed.index, own[-1].index)
    return edit.tree()


@only_with("acl", "ccomp")
def with_messages_behind_clauses(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Make what follows the description of a hearer what the hearer is told: "tell the man who sits there *that dinner
    is ready*"."""
    edit = TreeEdit(tree)
    for clause in tree.words:
        hearer = _described_by(tree, clause)
        verb = tree.word(hearer.head) if hearer is not clause and hearer.head else hearer
        lemma = verb.lemma.lower()
        is_telling = vocabulary.speech_of(lemma) is Speech.TOLD or lemma in _ASKING
        says_itself = vocabulary.speech_of(clause.lemma.lower()) is not None or clause.lemma.lower() in _OPINION
        if clause.deprel.startswith("acl") and hearer is not clause:
            _tell_behind_place(edit, tree, clause, vocabulary)
        if hearer is verb or hearer.deprel not in ("obj", "iobj") or not is_telling or says_itself:
            continue
        message = _message_inside(tree, clause)
        others = [child for child in tree.children(verb.index) if child is not clause]
        if clause.deprel == "ccomp" and any(child.deprel == "ccomp" and child.index > clause.index for child in others):
            # "Tell Bob, who is in the garden, *that I am waiting*" has one message.
            edit.rehang(clause.index, hearer.index, "acl:relcl")
            continue
        if message is None or any(child.deprel in _OF_MESSAGES for child in others):
            continue
        edit.rehang(clause.index, hearer.index, "acl:relcl")
        edit.rehang(message.index, verb.index, "ccomp")
        edit.relabel(hearer.index, "iobj")
        opening = tree.word(_first_word(tree, message))
        if opening.deprel == "det":
            edit.retag(opening.index, "SCONJ", "IN")
            edit.rehang(opening.index, message.index, "mark")
    return edit.tree()


def _tell_behind_place(edit: TreeEdit, tree: DependencyTree, clause: Word, vocabulary: Vocabulary) -> None:
    """Make a message of a whole sentence behind the place of a hearer, or what the hearer has: "tell Anna in the garden
    *that dinner is ready*". Without it, nothing is told."""
    place = tree.word(clause.head)
    verb = verb_above(tree, place)
    children = tree.children(verb.index)
    hearers = [child for child in children if child.deprel in ("obj", "iobj")]
    if vocabulary.speech_of(verb.lemma.lower()) is not Speech.TOLD or len(hearers) != 1 or hearers[0] is place:
        return
    that = tree.word(_first_word(tree, clause))
    subjects = [child for child in tree.children(clause.index) if child.deprel.startswith("nsubj")]
    has_subject = any(subject.index != that.index for subject in subjects)
    is_told = any(child.deprel in _OF_MESSAGES for child in children)
    # "Tell Bob about the things that we did" describes the things.
    cases = prepositions_of(tree, place.index)
    is_place = any(case in _PLACE_PREPOSITIONS for case in cases) or cases == ["with"]
    is_beside = is_place and place.head in (verb.index, hearers[0].index)
    if is_told or not is_beside or that.form.lower() != "that" or not has_subject or not is_person_or_name(hearers[0]):
        return
    edit.relabel(hearers[0].index, "iobj")
    edit.rehang(clause.index, verb.index, "ccomp")
    edit.retag(that.index, "SCONJ", "IN")
    edit.rehang(that.index, clause.index, "mark")


def _described_by(tree: DependencyTree, clause: Word) -> Word:
    """Return the noun that a clause describes, the clause itself for none: "tell *Bob*, who is in the garden, that ..."
    may be read as "tell Bob who is in the garden"."""
    if clause.head and clause.deprel.startswith("acl"):
        return tree.word(clause.head)
    if clause.deprel != "ccomp":
        return clause
    first = _first_word(tree, clause)
    if first < 3 or tree.word(first - 1).form != "," or tree.word(first).form.lower() not in _WHO:
        return clause
    heads = [child for child in tree.children(clause.head) if child.deprel in ("obj", "iobj")]
    return next((child for child in heads if max(tree.subtree(child.index)) == first - 2), clause)


def _first_word(tree: DependencyTree, head: Word) -> int:
    """Return the position of the first word below another one that is no mark."""
    return min(index for index in tree.subtree(head.index) if index == head.index or tree.word(index).upos != "PUNCT")


def _message_inside(tree: DependencyTree, clause: Word) -> Optional[Word]:
    """Return the last clause below another one if it begins like a message: "that dinner is ready", "what he wants"."""
    end = max(tree.subtree(clause.index))
    for index in sorted(tree.subtree(clause.index) - {clause.index}):
        word = tree.word(index)
        inside = tree.subtree(index)
        first = _first_word(tree, word)
        opening = tree.word(first).form.lower()
        is_clause = word.deprel.split(":")[0] in ("advcl", "acl", "ccomp", "parataxis") and any(
            child.deprel.startswith("nsubj") for child in tree.children(index)
        )
        if is_clause and max(inside) == end and opening in _OPENINGS and first > clause.index:
            return word
    return None


@only_with("acl")
def with_requests_behind_clauses(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach what somebody is asked for to the verb, not to the description of the person: "ask the woman sitting there
    *for her name*"."""
    edit = TreeEdit(tree)
    for clause in tree.words:
        hearer = tree.word(clause.head) if clause.head and clause.deprel.startswith("acl") else clause
        verb = tree.word(hearer.head) if hearer is not clause and hearer.head else hearer
        if verb.lemma.lower() not in _ASKING or hearer.deprel not in ("obj", "iobj"):
            continue
        asked = [child for child in tree.children(clause.index) if prepositions_of(tree, child.index) == ["for"]]
        is_said = any(prepositions_of(tree, child.index) == ["for"] for child in tree.children(verb.index))
        if asked and not is_said and max(tree.subtree(asked[-1].index)) == max(tree.subtree(clause.index)):
            edit.rehang(asked[-1].index, verb.index, "obl")
    return edit.tree()


@only_with("ccomp")
def with_things_named_by_clauses(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make "what" the thing that a clause describes: "bring me *what* I left there" asks nothing."""
    edit = TreeEdit(tree)
    for clause in tree.words:
        verb = tree.word(clause.head) if clause.head and clause.deprel == "ccomp" else clause
        if verb is clause or verb.lemma.lower() not in _HANDLING:
            continue
        what = tree.word(_first_word(tree, clause))
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
        goals = [tree.word(index) for index in inside if _has_preposition(tree, index, _TO_PREPOSITIONS)]
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


def _is_and_then(joint: Word, then: Word) -> bool:
    return joint.form.lower() == "and" and then.form.lower() == "then"


@only_with("cop")
def with_predicates_as_clauses(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make a clause of an object that has a subject and a copula: "find out *what time it is*"."""
    edit = TreeEdit(tree)
    for word in tree.words:
        children = tree.children(word.index)
        copulas = [child for child in children if child.deprel == "cop"]
        below = [*children, *(inner for copula in copulas for inner in tree.children(copula.index))]
        if word.deprel == "obj" and copulas and any(child.deprel.startswith("nsubj") for child in below):
            edit.relabel(word.index, "ccomp")
    return edit.tree()


@only_with("obj", "iobj")
def with_persons_told(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Make a person the hearer who is the only object of a verb of telling: "tell *the man raising his hand*". What a
    person is told about belongs to the verb: "warn the guests *about the dog*"."""
    edit = TreeEdit(tree)
    for topic in tree.words:
        hearer = tree.word(topic.head) if topic.head else topic
        is_about = topic.deprel == "nmod" and "about" in prepositions_of(tree, topic.index)
        is_told = hearer.deprel in ("obj", "iobj") and tree.word(hearer.head).lemma.lower() in _INFORMING
        if is_about and is_told and is_person_or_name(hearer):
            edit.rehang(topic.index, hearer.head, "obl")
    for verb in tree.words:
        if vocabulary.speech_of(verb.lemma.lower()) is not Speech.TOLD or verb.upos != "VERB":
            continue
        children = tree.children(verb.index)
        objects = [child for child in children if child.deprel in ("obj", "iobj", "ccomp", "xcomp")]
        is_alone = len(objects) == 1 and min(tree.subtree(objects[0].index)) == verb.index + 1
        if is_alone and objects[0].deprel == "obj" and is_person_or_name(objects[0]):
            edit.relabel(objects[0].index, "iobj")
    return edit.tree()
