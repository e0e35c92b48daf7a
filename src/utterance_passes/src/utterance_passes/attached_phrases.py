"""Attaches phrases that the parser takes for another part of a command: "with your left hand", "from the left"."""

from typing import FrozenSet, Optional

from spoken_quantities import find_unit
from utterance_passes.clauses import has_case, verb_above
from utterance_passes.pass_needs import only_with, only_with_forms
from utterance_passes.persons import is_person_or_name
from utterance_passes.tree import DependencyTree, Word
from utterance_passes.tree_edits import TreeEdit
from utterance_passes.vocabulary import Vocabulary
from word_classes import word_class

_ASKING = word_class("words_that_ask_which")
_CONDITIONS = word_class("conditions")
_FOR = frozenset(["for"])
_GOING = word_class("verbs_of_going")
_HANDS = word_class("hands")
_HERE_AND_THERE = word_class("here_and_there")
_INDEFINITE = word_class("indefinite_articles")
_NOUNS = frozenset(["NOUN", "PROPN", "PRON"])
_NOT = word_class("not")
_LEFT_AND_RIGHT = word_class("left_and_right")
_ONES = word_class("noun_standins")
#: Relations of "one" to the thing, or to its verb.
_OF_ITEMS = frozenset(["conj", "parataxis"])
_OF_ONE_HAND = word_class("words_for_one_hand")
_ORDINALS = word_class("ordinals_in_order") | word_class("last_ordinals")
_OF = frozenset(["of"])
_PLACE_PREPOSITIONS = word_class("place_prepositions")
_OF_WAYS = frozenset(["down", "up"])
_PERSONS = word_class("pronouns_of_persons")
_POINTING = word_class("demonstrative_determiners")
_SIDES = word_class("sides_of_a_row")
_FROM = frozenset(["from"])
_TO = frozenset(["to"])
_TO_PREPOSITIONS = word_class("to_prepositions")
#: Nobody is brought all of "me".
_ONE_PERSON = word_class("male_pronouns") | word_class("female_pronouns") | word_class("words_of_the_speaker")
_OBJECT_PRONOUNS = (word_class("object_pronouns") | word_class("plural_pronouns")) - _ONE_PERSON
_WHOLE = word_class("determiners_of_all")
_WITH_TO = word_class("verbs_with_to")
_YOUR = frozenset(["your"])
_USING = frozenset(["with", "using"])


@only_with("nmod")
def with_hands_at_verbs(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach the robot's own hand to the verb, not to the object: "pick up the block *with your left hand*"."""
    edit = TreeEdit(tree)
    for hand in tree.words:
        noun = tree.word(hand.head) if hand.head else hand
        verb = tree.word(noun.head) if noun.head else noun
        is_of_object = hand.deprel == "nmod" and noun.deprel in ("obj", "obl") and verb.upos == "VERB"
        if is_of_object and hand.lemma.lower() in _HANDS and _is_own(tree, hand):
            edit.rehang(hand.index, verb.index, "obl")
    return edit.tree()


def _is_own(tree: DependencyTree, hand: Word) -> bool:
    children = tree.children(hand.index)
    is_used = any(child.deprel == "case" and child.form.lower() in _USING for child in children)
    is_yours = any(child.deprel == "nmod:poss" and child.form.lower() in _YOUR for child in children)
    return is_used and (is_yours or any(child.form.lower() in _OF_ONE_HAND for child in children))


@only_with("advmod")
def with_there_at_things(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach "there" to the thing that somebody points at and another person gets: "bring me that thing *over there*"
    names no goal, "put that thing over there" does."""
    edit = TreeEdit(tree)
    for there in tree.words:
        verb = tree.word(there.head) if there.head else there
        is_there = there.form.lower() in _HERE_AND_THERE and there.deprel == "advmod"
        if not is_there or verb.upos != "VERB" or there.index < 3:
            continue
        over = tree.word(there.index - 1)
        first = over if over.upos in ("ADV", "ADP") and over.head in (there.index, verb.index) else there
        children = tree.children(verb.index)
        things = [one for one in children if one.deprel == "obj" and max(tree.subtree(one.index)) == first.index - 1]
        is_given = any(
            one.deprel == "iobj" or (one.deprel == "obl" and _has_case(tree, one, _TO) and _is_somebody(one))
            for one in children
        )
        for thing in things:
            before = (thing, *(child for child in tree.children(thing.index) if child.deprel == "det"))
            if is_given and any(word.form.lower() in _POINTING for word in before):
                edit.rehang(there.index, thing.index)
                edit.rehang(first.index, there.index if first is not there else thing.index)
    return edit.tree()


def _is_somebody(word: Word) -> bool:
    return is_person_or_name(word) or word.form.lower() in _PERSONS


@only_with("nsubj")
def with_phrases_of_what_is_asked(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach a phrase to the noun that it follows, not to the word that asks: "what is the colour of the cup *on the
    table*"."""
    edit = TreeEdit(tree)
    for asking in [word for word in tree.words if word.form.lower() in _ASKING]:
        children = tree.children(asking.index)
        subject = next((child for child in children if child.deprel == "nsubj" and child.upos in _NOUNS), None)
        if subject is None or subject.index < asking.index:
            continue
        noun = tree.word(max(tree.subtree(subject.index)))
        for phrase in children:
            is_next = min(tree.subtree(phrase.index)) == noun.index + 1 and phrase.deprel in ("obl", "nmod")
            if is_next and has_case(tree, phrase) and noun.upos in ("NOUN", "PROPN"):
                edit.rehang(phrase.index, noun.index, "nmod")
    return edit.tree()


@only_with_forms(["upside"])
def with_upside_down(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make an adverb of "upside down", of which the parser makes a noun or another deed."""
    edit = TreeEdit(tree)
    for upside, down in zip(tree.words, tree.words[1:]):
        if (upside.form.lower(), down.form.lower()) != ("upside", "down") or not upside.head:
            continue
        things = [child for child in tree.children(upside.index) if child.deprel == "compound"]
        above = things[-1].index if things else upside.head
        for child in tree.children(upside.index):
            edit.rehang(child.index, above)
        if things:
            edit.rehang(above, upside.head, upside.deprel)
        edit.retag(upside.index, "ADV", "RB")
        edit.rehang(upside.index, down.index, "advmod")
        edit.rehang(down.index, upside.head, "advmod")
    return edit.tree()


@only_with("case")
def with_places_in_a_row(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach the side from which things are counted to the thing, "the second bottle *from the left*", and the side of
    another thing to what somebody gets, "bring me the cup *to the left of the plate*"."""
    edit = TreeEdit(tree)
    for side in tree.words:
        if side.form.lower() not in _SIDES:
            continue
        cases = [child for child in tree.children(side.index) if child.deprel == "case"]
        prepositions = [case.form.lower() for case in cases]
        if prepositions == ["to"]:
            _attach_to_what_is_given(edit, tree, side, cases[0])
        if prepositions != ["from"]:
            continue
        noun = tree.word(cases[0].index - 1) if cases[0].index > 1 else side
        is_counted = any(child.form.lower() in _ORDINALS for child in tree.children(noun.index))
        if is_counted and noun.upos in ("NOUN", "PROPN") and side.head == noun.head:
            edit.rehang(side.index, noun.index, "nmod")
    return edit.tree()


def _attach_to_what_is_given(edit: TreeEdit, tree: DependencyTree, side: Word, case: Word) -> None:
    noun = tree.word(case.index - 1) if case.index > 1 else side
    has_receiver = any(child.deprel == "iobj" for child in tree.children(noun.head)) if noun.head else False
    is_of_thing = any(_has_case(tree, child, frozenset(["of"])) for child in tree.children(side.index))
    if noun.deprel == "obj" and side.head == noun.head and has_receiver and is_of_thing:
        edit.rehang(side.index, noun.index, "nmod")


@only_with("obl")
def with_ways_at_verbs(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach a source and the goal behind it to the verb that moves: "from the table *to the hall*" is no table to a
    hall, and nobody raises an arm "*from the bed to the sofa*"."""
    edit = TreeEdit(tree)
    for source in tree.words:
        if source.deprel != "obl" or not _has_case(tree, source, _FROM):
            continue
        beside = [*tree.children(source.index), *tree.children(source.head)]
        goal = next((word for word in beside if _is_goal_behind(tree, word, source)), None)
        if goal is None:
            continue
        verb = _moving_verb(tree, source)
        for place in (source, goal):
            if place.head != verb:
                edit.rehang(place.index, verb, "obl")
    return edit.tree()


def _is_goal_behind(tree: DependencyTree, goal: Word, source: Word) -> bool:
    # "From the left to the right" is no way.
    is_place = goal.upos in _NOUNS and goal.form.lower() not in _SIDES
    is_behind = goal.index > source.index and goal.deprel in ("nmod", "obl")
    return is_behind and is_place and _has_case(tree, goal, _TO_PREPOSITIONS)


def _moving_verb(tree: DependencyTree, source: Word) -> int:
    """Return the verb that a way belongs to; not a participle that has an object or a goal of its own: "the man
    *pointing to the right*"."""
    participle = tree.word(source.head)
    noun = tree.word(participle.head) if participle.deprel == "acl" else participle
    before = [child for child in tree.children(participle.index) if child.index < source.index]
    is_full = any(child.upos in _NOUNS and child.deprel in ("obj", "obl") for child in before)
    is_of_verb = participle.deprel == "acl" and noun.head and tree.word(noun.head).upos == "VERB"
    return noun.head if is_full and is_of_verb else participle.index


@only_with("obj", "iobj")
def with_wholes_at_pronouns(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach "all" or "both" to the pronoun before it, "put them *both* on the table", or to the object behind it,
    "take *both* the cup and the plate": there is one object."""
    edit = TreeEdit(tree)
    for whole in tree.words:
        if whole.form.lower() not in _WHOLE or whole.deprel != "obj" or tree.children(whole.index):
            continue
        objects = [child for child in tree.children(whole.head) if child.deprel == "obj" and child.upos == "NOUN"]
        behind = [one for one in objects if min(tree.subtree(one.index)) == whole.index + 1]
        if behind:
            is_of_two = any(child.deprel == "conj" for child in tree.children(behind[0].index))
            edit.rehang(whole.index, behind[0].index, "cc:preconj" if is_of_two else "det")
    for pronoun, whole in zip(tree.words, tree.words[1:]):
        is_object = pronoun.deprel in ("obj", "iobj") and pronoun.form.lower() in _OBJECT_PRONOUNS
        noun = tree.word(whole.head) if whole.head else whole
        # "Bring them both *a* drink", but "bring them *both the* cups".
        articles = [child for child in tree.children(noun.index) if child.deprel == "det" and child.index > whole.index]
        is_apart = any(article.form.lower() in _INDEFINITE for article in articles)
        is_beside = whole.head == pronoun.head or (is_apart and noun.head == pronoun.head)
        # "Bring me *both* the cup and the glass".
        is_of_two = whole.deprel == "cc:preconj" and any(child.deprel == "conj" for child in tree.children(noun.index))
        if whole.form.lower() not in _WHOLE or is_of_two:
            continue
        if is_object and is_beside and not tree.children(whole.index):
            edit.rehang(whole.index, pronoun.index, "det")
            if whole.deprel == "obj":
                edit.relabel(pronoun.index, "obj")
    return edit.tree()


def _has_case(tree: DependencyTree, word: Word, prepositions: FrozenSet[str]) -> bool:
    return any(child.deprel == "case" and child.form.lower() in prepositions for child in tree.children(word.index))


@only_with("det", "nmod:poss")
def with_words_before_nouns(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach an article or an owner to the object right behind it, not to a noun further on: "tell *the* kids dinner is
    ready", "tell *my* wife dinner is ready". Where the noun behind a thing is an object as well, both are one: "find
    the *stop* sign"."""
    edit = TreeEdit(tree)
    for before, noun in zip(tree.words, tree.words[1:]):
        whole = tree.word(before.head) if before.head else noun
        is_part = noun.upos == "NOUN" and not is_person_or_name(noun) and whole.index == noun.index + 1
        are_objects = whole.deprel == noun.deprel == "obj" and whole.head == noun.head
        # "Give the dog water" has two.
        is_of_one = are_objects and tree.word(noun.head).lemma.lower() not in _WITH_TO
        if is_part and is_of_one and before.deprel == "det":
            edit.rehang(noun.index, whole.index, "compound")
            continue
        is_object = noun.deprel in ("obj", "iobj") and noun.upos == "NOUN"
        is_before = before.deprel in ("det", "nmod:poss") and before.upos in ("DET", "PRON")
        if is_object and is_before and before.head > noun.index:
            edit.rehang(before.index, noun.index)
    return edit.tree()


@only_with("conj", "parataxis")
def with_things_named_again(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make one thing of a thing and the words that tell it apart or describe it: "that mug, *the small one*" and "a
    mug, *but a clean one*" are no lists.
    """
    edit = TreeEdit(tree)
    for one in tree.words:
        thing = _named_before(tree, one) if one.form.lower() in _ONES and one.deprel in _OF_ITEMS else None
        if thing is None:
            continue
        edit.rehang(one.index, thing.index, "appos")
        for child in tree.children(one.index):
            if child.deprel.split(":")[0] in ("nmod", "acl"):
                edit.rehang(child.index, thing.index)
    return edit.tree()


def _named_before(tree: DependencyTree, one: Word) -> Optional[Word]:
    """Return the thing before "one" that it is; None if it is another thing, one of a list, or not meant."""
    children = tree.children(one.index)
    forms = [child.form.lower() for child in children if child.index < one.index]
    joining = [child.form.lower() for child in children if child.deprel == "cc"]
    is_described = "the" in forms or any(child.deprel == "amod" for child in children)
    if not is_described or joining not in ([], ["but"]) or not (joining or "," in forms) or _NOT & frozenset(forms):
        return None
    head = tree.word(one.head)
    objects = [child for child in tree.children(head.index) if child.deprel == "obj" and child.index < one.index]
    thing = objects[-1] if head.upos == "VERB" and objects else head
    alike = (other for other in tree.words[one.index :] if other.form.lower() in _ONES and other.deprel == "conj")
    if thing.upos != "NOUN" or any(other.head in (head.index, one.index) for other in alike):
        return None
    # "A red mug, a blue one" are two.
    is_another = not joining and "the" not in forms and any(c.deprel == "amod" for c in tree.children(thing.index))
    return None if is_another else thing


@only_with("compound:prt")
def with_ways_behind_particles(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Make a way of what stands behind "down" and before the goal: "drive *down the hall* to the door"."""
    edit = TreeEdit(tree)
    for particle in tree.words:
        verb = tree.word(particle.head) if particle.head else particle
        children = tree.children(verb.index)
        ways = [child for child in children if child.deprel == "obj" and child.index > particle.index]
        is_going = verb.lemma.lower() in _GOING and particle.deprel == "compound:prt"
        if not is_going or particle.form.lower() not in _OF_WAYS or len(ways) != 1:
            continue
        behind = [child for child in children if child.deprel == "obl" and child.index > ways[0].index]
        goals = [
            case for child in behind for case in tree.children(child.index) if case.form.lower() in _TO_PREPOSITIONS
        ]
        if goals and particle.index + 1 == min(tree.subtree(ways[0].index)):
            edit.make_preposition(particle.index, ways[0].index)
            edit.relabel(ways[0].index, "obl")
    return edit.tree()


@only_with("nmod")
def with_durations_at_verbs(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach how long to the verb, not to a place: "go to the hall and then to the office *for five minutes*"."""
    edit = TreeEdit(tree)
    for time in tree.words:
        place = tree.word(time.head) if time.head else time
        unit = find_unit(time.form)
        is_how_long = unit is not None and unit.quantity == "duration" and _has_case(tree, time, _FOR)
        if not is_how_long or time.deprel != "nmod" or place.deprel not in ("obl", "conj"):
            continue
        edit.rehang(time.index, verb_above(tree, place).index, "obl")
    return edit.tree()


@only_with("obl")
def with_places_of_whom_is_told(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Attach a place to the person of whom something is told to somebody: "tell the name of the man *at the bar* to
    Anna"."""
    edit = TreeEdit(tree)
    for verb in tree.words:
        phrases = [child for child in tree.children(verb.index) if child.index > verb.index and child.upos != "PUNCT"]
        if vocabulary.speech_of(verb.lemma.lower()) is None or len(phrases) < 3:
            continue
        told, place, hearer = phrases[:3]
        last = max(tree.subtree(told.index))
        persons = [
            word
            for word in map(tree.word, tree.subtree(told.index) - {told.index})
            if _has_case(tree, word, _OF) and is_person_or_name(word) and max(tree.subtree(word.index)) == last
        ]
        is_behind = place.deprel == "obl" and tree.is_next(place.index, told.index)
        is_heard = is_person_or_name(hearer) and _has_case(tree, hearer, _TO)
        if told.deprel == "obj" and persons and is_behind and is_heard and _has_case(tree, place, _PLACE_PREPOSITIONS):
            edit.rehang(place.index, persons[0].index, "nmod")
    return edit.tree()


@only_with("acl")
def with_subjects_of_descriptions(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Give a deed that describes a thing its subject, which the parser takes for somebody spoken to, or for another
    thing: "close the window *Anna* opened"."""
    edit = TreeEdit(tree)
    for deed in tree.words[2:]:
        subject = tree.word(deed.index - 1)
        first = min((index for index in tree.subtree(subject.index) if index < deed.index), default=0)
        thing = tree.word(first - 1) if first > 1 else subject
        is_participle = deed.deprel == "acl" and deed.xpos in ("VBN", "VBD")
        is_taken_for_another = subject.deprel in ("vocative", "obj") and subject.head == thing.head != 0
        if not is_participle or thing.deprel != "obj" or not is_taken_for_another:
            continue
        if deed.head in (thing.index, subject.index) and is_person_or_name(subject):
            edit.retag(deed.index, "VERB", "VBD")
            edit.rehang(deed.index, thing.index, "acl:relcl")
            edit.rehang(subject.index, deed.index, "nsubj")
    return edit.tree()


@only_with("advcl")
def with_sides_of_goals(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach a side to what is reached or seen in a condition: "until you reach the door *on the right*"."""
    edit = TreeEdit(tree)
    for verb in tree.words:
        children = tree.children(verb.index)
        is_condition = verb.deprel == "advcl" and any(child.form.lower() in _CONDITIONS for child in children)
        things = [child for child in children if child.deprel == "obj" and child.upos in _NOUNS]
        for side in children if is_condition and len(things) == 1 else ():
            is_side = side.deprel == "obl" and side.form.lower() in _LEFT_AND_RIGHT
            if is_side and tree.is_next(side.index, things[0].index):
                edit.rehang(side.index, things[0].index, "nmod")
    return edit.tree()


@only_with("obl")
def with_topics_at_nouns(tree: DependencyTree, _: Vocabulary) -> DependencyTree:
    """Attach what something is about to it: "tell me a story *about a robot*"; who is told about something is none."""
    edit = TreeEdit(tree)
    for topic in tree.words:
        first = min(tree.subtree(topic.index))
        is_topic = topic.deprel == "obl" and tree.word(first).form.lower() == "about" and first < topic.index
        for thing in tree.children(topic.head) if is_topic and topic.head else ():
            is_thing = thing.deprel == "obj" and thing.upos == "NOUN" and not is_person_or_name(thing)
            if is_thing and max(tree.subtree(thing.index)) == first - 1:
                edit.rehang(topic.index, thing.index, "nmod")
    return edit.tree()
