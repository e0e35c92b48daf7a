"""Attaches an object that stands behind other phrases to its verb: "bring to Bob at the table *the dish*"."""

from typing import Tuple

from utterance_passes.pass_needs import only_with
from utterance_passes.persons import is_likely, is_name_of_person, is_person, is_person_or_name
from utterance_passes.tree import ASIDE, DependencyTree, Word
from utterance_passes.tree_edits import TreeEdit
from utterance_passes.vocabulary import Speech, Vocabulary
from word_classes import word_class

_NOUNS = frozenset(["NOUN", "PROPN"])
_GREETINGS = word_class("greetings") | word_class("greetings_alone") | word_class("courtesies")
_GOING = word_class("verbs_of_going")
_OBJECT_PRONOUNS = word_class("object_pronouns") - {"it"}
_PLACES = word_class("destination_adverbs")
_SAYING = word_class("saying_verbs")
_THING_PRONOUNS = frozenset(["it", "them"])
#: Relations of a noun phrase without a preposition behind the words of a description.
_UNMARKED = frozenset(["obl:unmarked", "obl", "obj", "nmod:unmarked"])
#: Relations that the parser gives to such a phrase if it takes it for a part of the phrase before it.
_OF_NOUNS = frozenset(["conj", "nmod", "nmod:unmarked", "appos"])


@only_with("obj", "iobj", "obl")
def with_objects_behind(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Attach a noun phrase with an article to the verb as its object.

    It is not an item of a list if nothing joins it ("bring to Bob at the table the dish"), and not a part of the
    description of a person if that is complete without it ("give the man holding a cup a spoon").
    """
    edit = TreeEdit(tree)
    for verb in tree.words:
        if verb.upos != "VERB":
            continue
        for person, thing in _listed_with_person(tree, verb):
            edit.relabel(person.index, "iobj")
            edit.rehang(thing.index, verb.index, "obj")
        objects = [child for child in tree.children(verb.index) if child.deprel in ("obj", "iobj")]
        for thing in objects:
            for number in _number_behind_name(tree, thing):
                edit.rehang(number.index, thing.index, "nummod")
        if not objects:
            taker = _verb_without_thing(tree, verb)
            for word in (_unmarked(tree, verb) or _unjoined(tree, verb))[:1]:
                edit.rehang(word.index, taker.index, "obj")
                if taker is not verb:
                    edit.relabel(verb.head, "iobj")
            for word, preposition in _slips(tree, verb):
                edit.relabel(word.index, "obj")
                edit.rehang(preposition.index, verb.index, ASIDE)
        elif len(objects) == 1:
            _correct_only_object(edit, tree, objects[0], vocabulary)
        elif len(objects) == 2:
            if _are_person_and_thing(tree, *objects):
                edit.relabel(objects[0].index, "iobj")
            _take_owner_from_name(edit, tree, *objects)
    return edit.tree()


def _verb_without_thing(tree: DependencyTree, verb: Word) -> Word:
    """Return the verb that has only a person, whom another verb describes: "*tell* the man pointing to the left at the
    door *your name*". If there is none, return the other verb."""
    person = tree.word(verb.head) if verb.head and verb.deprel == "acl" else verb
    above = tree.word(person.head) if person is not verb and person.head else verb
    objects = [child for child in tree.children(above.index) if child.deprel in ("obj", "iobj")]
    return above if objects == [person] and above.upos == "VERB" and is_person_or_name(person) else verb


def _correct_only_object(edit: TreeEdit, tree: DependencyTree, only: Word, vocabulary: Vocabulary) -> None:
    """Find the person or the thing beside the only object of a verb."""
    verb = tree.word(only.head)
    number, owner = _number_in_name(tree, only), _unmarked_owner(tree, only)
    greeting = _greeting_behind(tree, verb, only) if is_person(only) else ()
    if _is_object_alone(tree, only, vocabulary):
        edit.relabel(only.index, "obj")
    elif owner:
        edit.rehang(owner[0].index, verb.index, "iobj")
    elif number:
        edit.relabel(only.index, "iobj")
        edit.rehang(number[0].index, verb.index, "obj")
    elif greeting:
        edit.relabel(only.index, "iobj")
        edit.retag(greeting[0].index, "NOUN", "NN")
        edit.relabel(greeting[0].index, "obj")
    elif is_person_or_name(only):
        is_told = vocabulary.speech_of(verb.lemma.lower()) is Speech.TOLD
        behind = _behind_description(tree, only) or _behind_place(tree, verb)
        for word in behind or _behind_whole_description(tree, only, is_told=is_told):
            edit.rehang(word.index, verb.index, "obj")
            edit.relabel(only.index, "iobj")


def _listed_with_person(tree: DependencyTree, verb: Word) -> Tuple[Tuple[Word, Word], ...]:
    """Return a person and the thing right behind, of which the parser makes a list: "give *the children* some *paper*
    and pencils"."""
    objects = [child for child in tree.children(verb.index) if child.deprel in ("obj", "iobj")]
    if len(objects) != 1 or not is_person(objects[0]):
        return ()
    return tuple(
        (objects[0], item)
        for item in tree.children(objects[0].index)
        if item.deprel == "conj" and item.upos == "NOUN" and _begins_with_article(tree, item) and _is_thing(item)
        if tree.word(min(tree.subtree(item.index)) - 1).index == objects[0].index
        # "Bring the guests some wine and me some tea" has two groups.
        if not any(word.upos == "PRON" or is_person(word) for word in map(tree.word, tree.subtree(item.index)))
    )[:1]


def _is_object_alone(tree: DependencyTree, person: Word, vocabulary: Vocabulary) -> bool:
    """Whether a person gets nothing: the parser takes a time or a place for the thing, "greet *Anna* every morning",
    "find Bob and bring *him* here", or nothing follows a name, "find *Anna Maria Smith*"."""
    behind = [child for child in tree.children(person.head) if child.index > person.index]
    is_told = vocabulary.speech_of(tree.word(person.head).lemma.lower()) is Speech.TOLD
    is_before_time = bool(behind) and behind[0].deprel == "obl:unmarked" and person.upos != "PRON"
    is_before_place = bool(behind) and behind[0].deprel == "advmod" and behind[0].form.lower() in _PLACES
    is_clause_behind = any(child.deprel in ("ccomp", "xcomp") for child in behind)
    is_all = person.upos == "PROPN" and all(child.upos == "PUNCT" for child in behind)
    is_object = is_before_time or is_before_place or is_all
    return person.deprel == "iobj" and is_object and not is_clause_behind and not is_told


def _number_in_name(tree: DependencyTree, person: Word) -> Tuple[Word, ...]:
    """Return how many things a person gets, which the parser takes for a part of the name: "bring Anna *one*, too"."""
    return tuple(
        number
        for number in tree.children(person.index)
        if _is_number_in_name(number)
        if person.index == person.head + 1 and number.index == person.index + 1 and is_name_of_person(person)
    )


def _number_behind_name(tree: DependencyTree, thing: Word) -> Tuple[Word, ...]:
    """Return the number of the things right behind it, which the parser takes for a part of a name: "and Paul *two*
    bananas"."""
    before = tree.word(max(1, thing.index - 1))
    is_behind = _is_number_in_name(before) and before.head == before.index - 1
    is_name = is_behind and is_name_of_person(tree.word(before.head))
    return (before,) if is_name and thing.upos == "NOUN" else ()


def _is_number_in_name(word: Word) -> bool:
    """Whether a number in small letters is a part of a name to the parser."""
    return word.deprel == "flat" and word.upos == "NUM" and word.form.islower() and word.form.isalpha()


def _unmarked_owner(tree: DependencyTree, thing: Word) -> Tuple[Word, ...]:
    """Return the person right behind the verb whom the parser takes for the owner: "bring *Anna* orange juice"."""
    return tuple(
        owner
        for owner in tree.children(thing.index)
        if owner.deprel == "nmod:poss" and owner.index == thing.head + 1 and is_name_of_person(owner)
        # "Bring Annas cup" lacks an apostrophe.
        if not owner.form.endswith("s") and not tree.children(owner.index)
    )


def _take_owner_from_name(edit: TreeEdit, tree: DependencyTree, person: Word, thing: Word) -> None:
    """Give a thing its owner, whom the parser takes for a part of a person's name: "bring Anna *Bob's* cup", "give
    Uncle Bob *Anna's* cup"."""
    for owner in tree.words[person.index : max(0, thing.index - 1)]:
        is_owner = any(case.form in ("'s", "'") for case in tree.children(owner.index) if case.deprel == "case")
        if owner.deprel != "flat" or not is_owner:
            continue
        named = tree.word(owner.head)
        if named.deprel == "nmod:poss" and named.head == thing.index and named.index == person.index + 1:
            edit.rehang(named.index, person.index, "flat")
        elif person.index not in (named.index, named.head):
            continue
        edit.rehang(owner.index, thing.index, "nmod:poss")


def _slips(tree: DependencyTree, verb: Word) -> Tuple[Tuple[Word, Word], ...]:
    """Return a pronoun for a thing, and its preposition, if the same preposition follows at once: nobody delivers "*to
    it* to Anna"."""
    phrases = [child for child in tree.children(verb.index) if child.deprel == "obl" and child.index > verb.index]
    for pronoun, behind in zip(phrases, phrases[1:]):
        cases = [case for case in tree.children(pronoun.index) if case.deprel == "case"]
        others = [case for case in tree.children(behind.index) if case.deprel == "case"]
        is_twice = cases and others and cases[0].form.lower() == others[0].form.lower() == "to"
        is_thing = pronoun.form.lower() in _THING_PRONOUNS and verb.lemma.lower() not in _GOING
        if is_twice and is_thing and cases[0].index == verb.index + 1 and others[0].index == pronoun.index + 1:
            return ((pronoun, cases[0]),)
    return ()


def _greeting_behind(tree: DependencyTree, verb: Word, person: Word) -> Tuple[Word, ...]:
    """Return the greeting right behind the person to whom it shall be said: "tell the visitors *goodbye*"."""
    behind = max(tree.subtree(person.index)) + 1
    return tuple(
        word
        for word in tree.children(verb.index)
        if word.index == behind and word.deprel == "discourse" and word.form.lower() in _GREETINGS
        if verb.lemma.lower() in _SAYING and person.deprel in ("obj", "iobj")
    )


def _are_person_and_thing(tree: DependencyTree, first: Word, second: Word) -> bool:
    """Whether the second object stands behind the first, which is a person, or behind the place where the person is:
    "offer *the guests* some tea", "bring *me* please a spoon", "give *the man* at the door a cup"."""
    between = tree.words[max(tree.subtree(first.index)) : min(tree.subtree(second.index)) - 1]
    places = [child for child in tree.children(first.head) if first.index < child.index < second.index]
    below = frozenset().union(*(tree.subtree(place.index) for place in places if place.deprel == "obl"))
    is_around = all(word.upos in ("INTJ", "PUNCT") or word.index in below for word in between)
    is_behind = is_around and first.index < second.index
    is_anybody = is_person(first) or is_name_of_person(first) or first.form.lower() in _OBJECT_PRONOUNS
    return is_behind and first.deprel == second.deprel == "obj" and is_anybody


def _unmarked(tree: DependencyTree, verb: Word) -> Tuple[Word, ...]:
    """Return the nouns of phrases with an article and without a preposition behind another phrase of a verb: "bring to
    Bob at the table *the dish*"."""
    children = tree.children(verb.index)
    behind = min((child.index for child in children if child.deprel == "obl" and child.index > verb.index), default=0)
    return tuple(
        child
        for child in children
        if behind and child.index > behind and child.deprel in ("obl", "obl:unmarked", "dep") and child.upos in _NOUNS
        if _begins_with_article(tree, child) and _is_thing(child)
    )


def _behind_place(tree: DependencyTree, verb: Word) -> Tuple[Word, ...]:
    """Return the thing behind the place where a person is: "bring Anna in the kitchen *a glass of water*"."""
    return tuple(word for word in (_unmarked(tree, verb) or _unjoined(tree, verb))[:1] if _is_thing(word))


def _is_thing(word: Word) -> bool:
    return is_likely(word, ["Physical_object", "Fluid"])


def _unjoined(tree: DependencyTree, verb: Word) -> Tuple[Word, ...]:
    """Return the nouns of phrases of a verb that the parser took for parts of another phrase."""
    below = [
        index for child in tree.children(verb.index) if child.deprel == "obl" for index in tree.subtree(child.index)
    ]
    lemmas = [tree.word(index).lemma.lower() for index in below]
    # "Go to the cone on the right a red cone" names one thing again.
    return tuple(
        word
        for word in map(tree.word, sorted(below))
        if word.deprel in _OF_NOUNS and word.upos in _NOUNS and _begins_with_article(tree, word)
        if lemmas.count(word.lemma.lower()) == 1
    )


def _begins_with_article(tree: DependencyTree, word: Word) -> bool:
    first = tree.word(min(tree.subtree(word.index)))
    before = tree.word(first.index - 1) if first.index > 1 else first
    # "Bring the lady at the bar *her* drink".
    is_owner = first.deprel == "nmod:poss" and first.upos == "PRON"
    return (is_owner or first.deprel == "det") and first.head == word.index and before.upos not in ("PUNCT", "CCONJ")


def _behind_description(tree: DependencyTree, person: Word) -> Tuple[Word, ...]:
    """Return the last phrase of a participle behind a person if it is one too many."""
    participles = [child for child in tree.children(person.index) if child.deprel == "acl"]
    for participle in participles[-1:]:
        phrases = [child for child in tree.children(participle.index) if child.index > participle.index]
        last = phrases[-1] if len(phrases) > 1 else None
        is_noun = last is not None and last.upos == "NOUN" and last.deprel in _UNMARKED
        if last is not None and is_noun and _begins_with_article(tree, last):
            return (last,)
    return ()


def _behind_whole_description(tree: DependencyTree, person: Word, *, is_told: bool) -> Tuple[Word, ...]:
    """Return the last phrase of a verb if it follows the description of a person without a preposition: "tell the man
    waving in the hall *a joke*"."""
    end = max(tree.subtree(person.index))
    return tuple(
        child
        for child in tree.children(person.head)
        if child.deprel == "obl" and child.upos == "NOUN" and min(tree.subtree(child.index)) == end + 1
        if _begins_with_article(tree, child) and (is_told or _is_thing(child))
    )
