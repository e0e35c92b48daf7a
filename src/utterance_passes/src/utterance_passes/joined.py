"""Corrects how a parser joins verbs and phrases that stand side by side: conditions, words to be said, lists."""

from typing import Optional

from utterance_passes.clauses import has_case, prepositions_of, verb_above
from utterance_passes.pass_needs import only_with
from utterance_passes.persons import is_likely, is_person_or_name
from utterance_passes.tree import ASIDE, QUOTED, DependencyTree, Word
from utterance_passes.tree_edits import TreeEdit
from utterance_passes.vocabulary import Speech, Vocabulary
from word_classes import word_class

_BACK = word_class("way_adverbs")
_CONDITIONS = word_class("conditions")
_CONTENTS = frozenset(["ccomp", "xcomp"])
_DEEDS = word_class("opinion_subjects")
_HEARERS = word_class("hearers")
_HERE = word_class("here_and_there")
_MANNERS = word_class("manner_adverbs")
_NOT = word_class("not")
#: Relations of verbs that are no part of a noun phrase.
_OF_DEEDS = frozenset(["root", "conj", "parataxis", "advcl", "xcomp", "ccomp"])
_ONES = word_class("noun_standins")
_OWNED = word_class("pronouns_of_owned_things")
_ON_AND_IN = frozenset(["on", "in"])
_PLACE_PREPOSITIONS = word_class("place_prepositions")
_PUTTING = word_class("verbs_of_putting")
_SIDES = word_class("opposite_sides")
_SPEAKERS = word_class("speaker_subjects")
_UNTIL = frozenset(["until", "till"])


@only_with("nummod")
def with_numbers_at_verbs(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach a number to the verb before it, not to a noun of another deed: "go to the middle, turn *45* right, take a
    photo" has no middle 45, and "turn left *60*, take a photo" takes no 60 photos."""
    edit = TreeEdit(tree)
    for number in tree.words:
        if number.deprel != "nummod" or number.upos != "NUM":
            continue
        first, last = sorted((number.index, number.head))
        between = [word for word in tree.words[first : last - 1] if word.upos == "VERB" and word.deprel in _OF_DEEDS]
        before = [word for word in tree.words[: number.index - 1] if word.upos == "VERB"]
        if between and before:
            edit.rehang(number.index, before[-1].index, "obl:unmarked")
    return edit.tree()


@only_with("conj", "parataxis")
def with_conditions_joined(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make a condition of a clause that is joined to the command: "bring me the cup, *but only if it is clean*"."""
    edit = TreeEdit(tree)
    for clause in tree.words:
        governor = tree.word(clause.head) if clause.head else clause
        # "If it is clean and if it is empty" are two conditions.
        if clause.deprel in ("conj", "parataxis") and _mark(tree, clause) and not _mark(tree, governor):
            is_command = governor.upos == "VERB" and governor.index < clause.index
            if is_command and any(child.deprel.startswith("nsubj") for child in tree.children(clause.index)):
                edit.relabel(clause.index, "advcl")
    return edit.tree()


@only_with("advcl")
def with_deeds_joined(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Join a bare verb behind a comma to the deed before it, which the parser takes for what goes on meanwhile: "find
    Anna, *find Bob*, and wave"."""
    edit = TreeEdit(tree)
    for deed in tree.words:
        before = tree.word(deed.index - 1) if deed.index > 1 else deed
        is_bare = deed.deprel == "advcl" and before.form == "," and deed.form.lower() == deed.lemma.lower()
        children = tree.children(deed.index)
        is_clause = any(child.deprel in ("mark", "aux", "cop") or "subj" in child.deprel for child in children)
        is_behind = 0 < deed.head < deed.index and tree.word(deed.head).upos == "VERB"
        if is_bare and is_behind and not is_clause and vocabulary.verbs_beginning_with(deed.form.lower()):
            edit.relabel(deed.index, "conj")
            edit.retag(deed.index, "VERB", "VB")
    return edit.tree()


@only_with("acl:relcl")
def with_deadlines_joined(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make a clause of the command of what describes "the time": "be there *by the time Bob comes*" names no place."""
    edit = TreeEdit(tree)
    for time in tree.words:
        clauses = [child for child in tree.children(time.index) if child.deprel == "acl:relcl"]
        cases = [child for child in tree.children(time.index) if child.deprel == "case"]
        is_deadline = time.form.lower() == "time" and [case.form.lower() for case in cases] == ["by"]
        if is_deadline and len(clauses) == 1 and time.deprel in ("obl", "nmod"):
            verb = verb_above(tree, tree.word(time.head))
            edit.rehang(clauses[0].index, verb.index, "advcl")
            edit.rehang(time.index, clauses[0].index, "mark")
            edit.rehang(cases[0].index, time.index, "fixed")
    return edit.tree()


def _mark(tree: DependencyTree, clause: Word) -> Optional[Word]:
    marks = [child for child in tree.children(clause.index) if child.deprel in ("mark", "advmod")]
    return next((mark for mark in marks if mark.form.lower() in _CONDITIONS and mark.index < clause.index), None)


@only_with("cc")
def with_manners_joined(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach a manner that is joined like a deed: "follow me, *but slowly*", "go to the door and *slowly* open it"."""
    edit = TreeEdit(tree)
    for manner in tree.words:
        verb = tree.word(manner.head) if manner.head else manner
        if (
            manner.deprel not in ("conj", "advmod")
            or manner.upos != "ADV"
            or verb.upos != "VERB"
            or not _is_manner(manner)
        ):
            continue
        children = tree.children(manner.index)
        joining = [child for child in children if child.deprel == "cc"]
        if not joining or any(child.deprel not in ("cc", "punct") for child in children):
            continue
        behind = tree.word(manner.index + 1) if manner.index < len(tree.words) else manner
        if behind.upos == "VERB" and behind.head == verb.index and behind.deprel in ("parataxis", "conj"):
            edit.relabel(behind.index, "conj")
            edit.rehang(manner.index, behind.index, "advmod")
            for child in children:
                edit.rehang(child.index, behind.index)
        else:
            edit.relabel(manner.index, "advmod")
            for child in joining:
                edit.rehang(child.index, verb.index, ASIDE)
    return edit.tree()


def _is_manner(word: Word) -> bool:
    form = word.form.lower()
    return form in _MANNERS or form.endswith("ly")


@only_with("mark")
def with_particles_at_verbs(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach a particle before a conjunction to its verb: "stand *by* until somebody comes"."""
    edit = TreeEdit(tree)
    for verb, particle, mark in zip(tree.words, tree.words[1:], tree.words[2:]):
        are_marks = particle.deprel == mark.deprel == "mark" and particle.head == mark.head
        is_particle = particle.upos == "ADP" and particle.form.lower() not in _CONDITIONS
        if are_marks and is_particle and verb.upos == "VERB":
            edit.rehang(particle.index, verb.index, "compound:prt")
    return edit.tree()


@only_with("advcl")
def with_words_said(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Make what somebody says the object of saying: "wave until I say *stop*" has no command "stop"."""
    edit = TreeEdit(tree)
    for saying, word in zip(tree.words, tree.words[1:]):
        is_joined = word.deprel in ("conj", "parataxis", "xcomp")
        is_said = is_joined and saying.deprel == "advcl" and saying.head == word.index
        if not is_said or vocabulary.speech_of(saying.lemma.lower()) is not Speech.SAID:
            continue
        if any(child.deprel.startswith("nsubj") for child in tree.children(saying.index)):
            edit.rehang(saying.index, word.head, "advcl")
            edit.rehang(word.index, saying.index, "ccomp")
    return edit.tree()


@only_with("conj")
def with_phrases_in_a_row(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach the last of three phrases with one preposition to the verb: "go to Bob, to Anna and *to Ben*"."""
    edit = TreeEdit(tree)
    for last in tree.words:
        second = tree.word(last.head) if last.head else last
        phrase = _phrase_of(tree, last)
        if last.deprel != "conj" or second.deprel != "obl" or phrase is None:
            continue
        said = _preposition(tree, second)
        before = [child for child in tree.children(second.head) if child.deprel == "obl" and child.index < second.index]
        if said and _preposition(tree, phrase) == said and any(_preposition(tree, one) == said for one in before):
            edit.rehang(last.index, second.head)
    return edit.tree()


def _phrase_of(tree: DependencyTree, word: Word) -> Optional[Word]:
    """Return a word with a preposition, or such a word below "last" or "finally"."""
    if has_case(tree, word):
        return word
    below = [child for child in tree.children(word.index) if child.deprel in ("obl", "nmod") and has_case(tree, child)]
    return below[0] if len(below) == 1 else None


def _preposition(tree: DependencyTree, word: Word) -> str:
    return " ".join(child.form.lower() for child in tree.children(word.index) if child.deprel == "case")


_PHRASES = frozenset(["obl", "obl:unmarked", "advmod"])


@only_with("xcomp")
def with_emphatic_do(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make "do" before a bare verb its auxiliary: "please *do* shut the door"."""
    for do, verb in zip(tree.words, tree.words[1:]):
        is_bare = verb.xpos in ("VB", "VBP") and (verb.head, verb.deprel) == (do.index, "xcomp")
        if do.lemma.lower() == "do" and do.head == 0 and is_bare:
            edit = TreeEdit(tree)
            edit.rehang_children(do.index, verb.index)
            edit.rehang(verb.index, 0, "root")
            edit.rehang(do.index, verb.index, "aux")
            edit.retag(do.index, "AUX")
            return edit.tree()
    return tree


@only_with("advcl")
def with_remarks_joined(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Set a remark apart that no conjunction joins to the command: "guide Bob to the bath, *he is at the sink*", "*the
    lamp is on*, switch it off"."""
    edit = TreeEdit(tree)
    for predicate in tree.words:
        children = tree.children(predicate.index)
        first = min((child.index for child in children if child.upos != "PUNCT"), default=predicate.index)
        is_finite = any(child.deprel == "cop" for child in children) and tree.word(first).deprel == "nsubj"
        if predicate.deprel != "advcl" or not is_finite or any(child.deprel == "mark" for child in children):
            continue
        if predicate.head < first:
            beside = first - 1
        else:
            beside = 1 + max(index for index in tree.subtree(predicate.index) if tree.word(index).upos != "PUNCT")
        is_apart = beside <= len(tree.words) and not first < predicate.head < beside
        if is_apart and tree.word(beside).form == ",":
            edit.relabel(predicate.index, "parataxis")
    return edit.tree()


@only_with("cop")
def with_copulas_at_question_words(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach "is" behind a question word to it, not to the subject: "who *is* the person at the sink"."""
    edit = TreeEdit(tree)
    for asked, copula in zip(tree.words, tree.words[1:]):
        subject = tree.word(copula.head) if copula.head else copula
        is_of_subject = copula.deprel == "cop" and (subject.head, subject.deprel) == (asked.index, "nsubj")
        if is_of_subject and asked.xpos in ("WP", "WRB"):
            edit.rehang(copula.index, asked.index)
    return edit.tree()


@only_with("mark")
def with_prepositions_of_nouns(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make "to" before a noun a preposition: "say hello *to Bob* in ten minutes"."""
    edit = TreeEdit(tree)
    for to in tree.words:
        noun = tree.word(to.head) if to.head else to
        is_mark = to.deprel == "mark" and to.form.lower() == "to" and noun.deprel in ("obl", "nmod")
        if is_mark and noun.index > to.index and noun.upos in ("NOUN", "PROPN", "PRON"):
            edit.make_preposition(to.index, noun.index)
    return edit.tree()


@only_with("obl")
def with_places_of_what_fails(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach a place to the object of what the speaker cannot do: "I can't reach the biscuits *on the top shelf*"."""
    edit = TreeEdit(tree)
    for verb in tree.words:
        children = tree.children(verb.index)
        is_speaker = any(child.deprel == "nsubj" and child.form.lower() in _SPEAKERS for child in children)
        is_denied = any(child.xpos == "MD" for child in children) and any(
            child.form.lower() in _NOT for child in children
        )
        objects = [child for child in children if child.deprel == "obj"] if is_speaker and is_denied else []
        for place in children if len(objects) == 1 else ():
            is_behind = tree.is_next(place.index, objects[0].index)
            if place.deprel == "obl" and is_behind and _preposition(tree, place) in _PLACE_PREPOSITIONS:
                edit.rehang(place.index, objects[0].index, "nmod")
    return edit.tree()


@only_with("compound:prt")
def with_things_put_down(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make a place of the object of a deed that puts down what the deed before took: "take the bowl and place *on the
    table*". Nobody puts a table on."""
    edit = TreeEdit(tree)
    for particle in tree.words:
        verb = tree.word(particle.head) if particle.head else particle
        before = tree.word(verb.head) if verb.head else verb
        objects = [child for child in tree.children(verb.index) if child.deprel in ("obj", "iobj", "obl")]
        is_put_on = particle.deprel == "compound:prt" and particle.form.lower() in _ON_AND_IN
        is_bare = is_put_on and len(objects) == 1 and particle.index == verb.index + 1
        if not is_bare or verb.deprel != "conj" or verb.lemma.lower() not in _PUTTING:
            continue
        is_place = objects[0].deprel == "obj" and is_likely(objects[0], ["Furniture", "Container"])
        is_next = min(tree.subtree(objects[0].index)) == particle.index + 1
        if is_place and is_next and any(child.deprel == "obj" for child in tree.children(before.index)):
            edit.make_preposition(particle.index, objects[0].index)
            edit.relabel(objects[0].index, "obl")
    return edit.tree()


@only_with("compound")
def with_owned_things_apart(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Part what somebody owns from who gets it: "give Bob his cup and *Anna hers*" gives Bob no second thing. No unit
    knows the relation ``dep``."""
    edit = TreeEdit(tree)
    for owned in tree.words:
        names = [child for child in tree.children(owned.index) if child.deprel == "compound"]
        if owned.form.lower() in _OWNED and owned.deprel == "conj" and names:
            edit.rehang(owned.index, verb_above(tree, owned).index, "dep")
    return edit.tree()


@only_with("expl")
def with_places_of_what_there_is(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach a place behind what there is to the verb: "there is a radio *next to the bed*" says where it is."""
    edit = TreeEdit(tree)
    for verb in tree.words:
        children = tree.children(verb.index)
        things = [child for child in children if child.deprel == "nsubj" and child.index > verb.index]
        is_existence = verb.lemma == "be" and any(child.deprel == "expl" for child in children)
        for place in tree.children(things[0].index) if is_existence and len(things) == 1 else ():
            first = _preposition(tree, place).split(" ")[0]
            is_last = max(tree.subtree(place.index)) == max(tree.subtree(things[0].index))
            if place.deprel == "nmod" and is_last and first in _PLACE_PREPOSITIONS and first != "of":
                edit.rehang(place.index, verb.index, "obl")
    return edit.tree()


@only_with("advmod")
def with_places_over_here(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Attach an adverb of way to "here" or "there" behind it: "pull the cart *over* here" has one place. So has "stay
    *right* here", but "turn right here" has a side."""
    edit = TreeEdit(tree)
    for way, place in zip(tree.words[1:], tree.words[2:]):
        are_adverbs = way.head == place.head and way.deprel == place.deprel == "advmod"
        if are_adverbs and way.form.lower() in _BACK and place.form.lower() in _HERE and way.head < way.index - 1:
            edit.rehang(way.index, place.index)
        elif are_adverbs and place.form.lower() in _HERE and way.form.lower() == "right":
            lists = vocabulary.lists_of(tree.word(way.head).lemma.lower())
            if not any("right" in words for words in lists):
                edit.rehang(way.index, place.index)
    return edit.tree()


@only_with("conj")
def with_shared_nouns(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make the noun of two described things the head of both: "bring me the red and the blue *cup*"."""
    edit = TreeEdit(tree)
    for described in tree.words:
        joined = [child for child in tree.children(described.index) if child.deprel == "conj"]
        is_side = described.form.lower() in _SIDES
        if (described.upos != "ADJ" and not is_side) or len(joined) != 1 or not _is_described(tree, joined[0]):
            continue
        before = [child for child in tree.children(described.index) if child.index < described.index]
        if not any(child.deprel == "det" for child in before):
            continue
        noun = joined[0]
        edit.rehang(noun.index, described.head, described.deprel)
        edit.rehang(described.index, noun.index, "conj")
        edit.retag(described.index, "ADJ", "JJ")
        for child in before:
            if child.deprel == "case":
                edit.rehang(child.index, noun.index)
        for child in tree.children(noun.index):
            if child.deprel == "cc":
                edit.rehang(child.index, described.index)
    return edit.tree()


def _is_described(tree: DependencyTree, noun: Word) -> bool:
    relations = {child.deprel for child in tree.children(noun.index) if child.index < noun.index}
    return noun.upos == "NOUN" and {"cc", "det", "amod"} <= relations and noun.form.lower() not in _ONES


@only_with("obl")
def with_clothes_at_persons(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach what a person wears to the person: "find the man *in the red shirt*" does not look into a shirt."""
    edit = TreeEdit(tree)
    for clothes in tree.words:
        first = min(tree.subtree(clothes.index))
        person = tree.word(first - 1) if first > 1 else clothes
        if clothes.deprel != "obl" or clothes.head != person.head or not is_person_or_name(person):
            continue
        if prepositions_of(tree, clothes.index) == ["in"] and is_likely(clothes, ["Clothing"]):
            edit.rehang(clothes.index, person.index, "nmod")
    return edit.tree()


@only_with("conj")
def with_phrases_behind_joints(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach a phrase between a conjunction and a verb to that verb, not to the one before: "go home and *after that*,
    clean the table"; also what stands between two commas and only points back."""
    edit = TreeEdit(tree)
    for verb in tree.words:
        if verb.deprel != "conj" or verb.upos != "VERB":
            continue
        joints = [child.index for child in tree.children(verb.index) if child.deprel == "cc"]
        for phrase in tree.children(verb.head):
            is_between = phrase.deprel in _PHRASES and phrase.index < verb.index
            cases = [child.index for child in tree.children(phrase.index) if child.deprel == "case"]
            is_set_off = any(tree.word(index - 1).upos == "PUNCT" for index in cases[:1] if index > 1)
            points_back = is_set_off and phrase.form.lower() in _DEEDS
            own = [child.index for child in tree.children(phrase.index) if child.deprel == "cc"]
            if is_between and (points_back or own or (joints and joints[0] < phrase.index)):
                edit.rehang(phrase.index, verb.index)
                for joint in own:
                    edit.rehang(joint, verb.index)
    return edit.tree()


@only_with("advcl")
def with_conditions_of_hearers(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Attach when the hearer does something to the command, not to what is found out: "make sure that
    the door is closed *before you go*"."""
    edit = TreeEdit(tree)
    for clause in tree.words:
        subjects = [child.form.lower() for child in tree.children(clause.index) if child.deprel == "nsubj"]
        if clause.deprel != "advcl" or not _mark(tree, clause) or not subjects or subjects[0] not in _HEARERS:
            continue
        inner = tree.word(clause.head)
        top = inner
        while top.head and top.deprel in _CONTENTS:
            top = tree.word(top.head)
        is_command = not any(child.deprel.startswith("nsubj") for child in tree.children(top.index))
        is_behind = clause.index > inner.index > top.index
        if is_behind and is_command and top.upos == "VERB" and vocabulary.speech_of(top.lemma.lower()) is None:
            edit.rehang(clause.index, top.index)
    return edit.tree()


@only_with("xcomp")
def with_bounds_of_messages(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Leave how long somebody else is to do something in what that person is told: "tell Bob to wait *until I come
    back*". To tell him takes no time."""
    edit = TreeEdit(tree)
    for clause in tree.words:
        inner = tree.word(clause.head) if clause.head and clause.deprel == "advcl" else clause
        mark = _mark(tree, clause)
        is_bound = mark is not None and mark.form.lower() in _UNTIL and inner.deprel == "xcomp"
        if is_bound and vocabulary.speech_of(tree.word(inner.head).lemma.lower()) is not None:
            for index in tree.subtree(clause.index):
                edit.rehang(index, inner.index, QUOTED)
    return edit.tree()
