"""Tells apart who is told or asked something, and what: a parser attaches a message to the description of a person."""

from typing import Optional

from utterance_passes.clauses import prepositions_of, verb_above
from utterance_passes.pass_needs import only_with
from utterance_passes.persons import is_person_or_name
from utterance_passes.tree import DependencyTree, Word
from utterance_passes.tree_edits import TreeEdit
from utterance_passes.vocabulary import Speech, Vocabulary
from word_classes import word_class

_INFORMING = word_class("verbs_of_informing")
_ASKING = word_class("asking_verbs")
_QUESTION_WORDS = word_class("question_words")
_WHETHER = word_class("whether_words")
_WHO = word_class("relative_persons")
_OF_MESSAGES = frozenset(["ccomp", "xcomp"])
_OPINION = word_class("verbs_of_opinion") - word_class("wanting_verbs") - word_class("wishing_verbs")
_PLACE_PREPOSITIONS = word_class("place_prepositions")
_WITH_DEEDS = word_class("wanting_verbs") | word_class("wishing_verbs") | word_class("verbs_of_duty")
#: Words with which begins what is told.
_OPENINGS = _QUESTION_WORDS | _WHETHER | frozenset(["that"])


@only_with("iobj", "obj")
def with_hearers_joined(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Join a person behind "and" to the hearer, not to what the hearer is told: "tell her *and Bob* that dinner is
    ready" tells nothing of Bob, nor does "tell her *and then Bob* that ..."."""
    edit = TreeEdit(tree)
    orders = [then for joint, then in zip(tree.words, tree.words[1:]) if _is_and_then(joint, then)]
    words = [word for word in tree.words if word not in orders]
    for hearer, joint, person, opening in zip(words, words[1:], words[2:], words[3:]):
        verb = tree.word(hearer.head) if hearer.head else hearer
        is_telling = _tells(vocabulary, verb)
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
        if verb is deed or not _tells(vocabulary, verb):
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
        is_telling = _tells(vocabulary, verb)
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
        opening = tree.word(tree.first_spoken(message.index))
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
    that = tree.word(tree.first_spoken(clause.index))
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
    first = tree.first_spoken(clause.index)
    if first < 3 or tree.word(first - 1).form != "," or tree.word(first).form.lower() not in _WHO:
        return clause
    heads = [child for child in tree.children(clause.head) if child.deprel in ("obj", "iobj")]
    return next((child for child in heads if max(tree.subtree(child.index)) == first - 2), clause)


def _message_inside(tree: DependencyTree, clause: Word) -> Optional[Word]:
    """Return the last clause below another one if it begins like a message: "that dinner is ready", "what he wants"."""
    end = max(tree.subtree(clause.index))
    for index in sorted(tree.subtree(clause.index) - {clause.index}):
        word = tree.word(index)
        inside = tree.subtree(index)
        first = tree.first_spoken(word.index)
        opening = tree.word(first).form.lower()
        is_clause = word.deprel.split(":")[0] in ("advcl", "acl", "ccomp", "parataxis") and any(
            child.deprel.startswith("nsubj") for child in tree.children(index)
        )
        is_clause = is_clause or tree.has_copula_and_subject(index)
        if is_clause and max(inside) == end and opening in _OPENINGS and first > clause.index:
            return word
    return None


@only_with("acl")
def with_requests_behind_clauses(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Attach what somebody is asked for, or to do, to the verb, not to the description of the person: "ask the woman
    sitting there *for her name*", "tell the man who is waiting *to come in*"."""
    edit = TreeEdit(tree)
    for clause in tree.words:
        hearer = tree.word(clause.head) if clause.head and clause.deprel.startswith("acl") else clause
        verb = tree.word(hearer.head) if hearer is not clause and hearer.head else hearer
        if hearer.deprel not in ("obj", "iobj"):
            continue
        deed = _request_inside(tree, clause) if clause.deprel == "acl:relcl" else None
        if deed is not None and _is_without_message(tree, hearer) and _tells(vocabulary, verb):
            edit.rehang(deed.index, verb.index, "xcomp")
            edit.relabel(hearer.index, "iobj")
            continue
        if verb.lemma.lower() not in _ASKING:
            continue
        asked = [child for child in tree.children(clause.index) if prepositions_of(tree, child.index) == ["for"]]
        is_said = any(prepositions_of(tree, child.index) == ["for"] for child in tree.children(verb.index))
        if asked and not is_said and max(tree.subtree(asked[-1].index)) == max(tree.subtree(clause.index)):
            edit.rehang(asked[-1].index, verb.index, "obl")
    return edit.tree()


def _tells(vocabulary: Vocabulary, verb: Word) -> bool:
    """Whether a verb has a hearer, who is told or asked something."""
    return vocabulary.speech_of(verb.lemma.lower()) is Speech.TOLD or verb.lemma.lower() in _ASKING


def _is_without_message(tree: DependencyTree, hearer: Word) -> bool:
    others = [child for child in tree.children(hearer.head) if child.index != hearer.index]
    return not any(other.deprel in ("obj", "ccomp", "xcomp", "advcl") for other in others)


def _request_inside(tree: DependencyTree, clause: Word) -> Optional[Word]:
    """Return the infinitive at the end of the description of a person that the description does not need: not in "who
    wants *to leave*"."""
    end = max(tree.subtree(clause.index))
    inside = [tree.word(index) for index in sorted(tree.subtree(clause.index) - {clause.index})]
    deeds = [word for word in inside if tree.is_infinitive(word.index) and word.deprel in ("xcomp", "advcl")]
    is_needed = bool(deeds) and tree.word(deeds[-1].head).lemma.lower() in _WITH_DEEDS
    return None if not deeds or is_needed or max(tree.subtree(deeds[-1].index)) != end else deeds[-1]


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


def _is_and_then(joint: Word, then: Word) -> bool:
    return joint.form.lower() == "and" and then.form.lower() == "then"
