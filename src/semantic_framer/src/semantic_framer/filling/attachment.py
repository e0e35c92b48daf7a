"""Finds the phrase that a prepositional phrase belongs to if the parser attached it to the verb but no element asks
for it.
"""

from typing import AbstractSet, Collection, Container, FrozenSet, Iterable, List, Sequence, Set, Tuple

from semantic_framer.units.frame_roles import DIRECTION
from semantic_framer.values.things import is_direction
from semantic_frames.extra_thematic import is_of_every_action
from semantic_frames.frame import SemanticFrame
from semantic_frames.lexical_unit import LexicalUnit
from typed_arguments import TypedArgument
from utterance_passes.phrases.amounts import is_beside, is_number
from utterance_passes.phrases.clauses import has_case
from utterance_passes.phrases.shared_objects import shared_object
from utterance_passes.trees.persons import is_likely, is_person, is_person_or_name
from utterance_passes.trees.tree import NOUNS, DependencyTree
from word_classes import word_class

#: These prepositions identify a thing or person only directly after its name: "the guy with the blue jacket".
_OF_A_THING = frozenset(["with", "without"])
_ADVERBS_BEFORE_PREPOSITIONS = word_class("adverbs_before_prepositions")
_AMOUNT_MODIFIERS = word_class("amount_modifiers")
_INDEFINITES = word_class("words_for_all") | word_class("indefinite_persons") | word_class("things_asked")
_INDEFINITE_PERSONS = word_class("indefinite_persons")
_ORDINALS = word_class("ordinals") | word_class("last_ordinals")
_SIDES_OF_A_ROW = word_class("sides")
_LEFT_AND_RIGHT = word_class("left_and_right")
_ONWARD = word_class("forward_and_backward") | {"on"}
#: "Home" says where things go, but not where they are.
_PLACE_ADVERBS = word_class("place_adverbs") - {"home"}
_MARKINGS = word_class("markings")
_PLACE_PREPOSITIONS = word_class("place_prepositions")
_PLACING_PREPOSITIONS = word_class("placing_prepositions")
_PRONOUNS = word_class("pronouns")
_SPEAKERS = word_class("speaker_objects")
_STRAIGHT = word_class("adverbs_before_prepositions")


def is_postmodifier_of(tree: DependencyTree, index: int, head: int, is_described: bool) -> bool:
    """Whether a phrase that is attached to a verb identifies the noun in front of it.

    Args:
        tree: the sentence
        index: head of the phrase
        head: the noun
        is_described: whether the verb is only about the noun, so that "with" belongs to the noun: "follow the guy with
            the hat". In "grab the cup with the tongs", "with" does not belong to the cup: the robot needs the tongs.
    """
    word = tree.word(index)
    if word.deprel == "advmod":
        return word.said in _PLACE_ADVERBS
    prepositions = tree.said_prepositions(index)
    if not prepositions or not _is_prepositional(tree, index) or is_of_every_action(prepositions[0], word.form):
        return False
    if prepositions[0] == "by" and is_number(tree, index):
        return False  # "the cup *by six*" is a time
    # "The door on the left", with the tag of the adverb.
    if word.upos == "ADV" and word.said not in _LEFT_AND_RIGHT:
        return False
    if prepositions[0] == "to" and word.said in _LEFT_AND_RIGHT:
        return True  # "the door to your left"
    if prepositions[0] in _OF_A_THING and (word.lemma.lower() in _MARKINGS or contents_behind(tree, index)):
        return True  # "the shirt *with blue stripes*"
    # "Hand the cup to the man *with the beard*".
    is_somebody = tree.word(head).upos == "NOUN" and is_person(tree.word(head))
    is_thing = word.upos != "PRON" and (is_somebody or not has_case(tree, tree.word(head)))
    return prepositions[0] in _PLACE_PREPOSITIONS or (is_described and is_thing and prepositions[0] in _OF_A_THING)


def contents_behind(tree: DependencyTree, index: int) -> int:
    """Return the pronoun behind a phrase with "with" that says where in the thing something is: "a bowl with a pen *in
    it*"; 0 for none. The phrase belongs to the thing, and is nothing that is done with.

    Args:
        tree: the sentence
        index: head of the phrase
    """
    if tree.preposition(index) != "with":
        return 0
    own = {index, *(one.index for one in tree.children(index) if one.index < index)}
    for word in tree.words[index:]:
        if word.said in _PRONOUNS and tree.preposition(word.index) in _PLACE_PREPOSITIONS:
            first = tree.prepositions(word.index)[0].index
            between = range(max(own) + 1, first)
            return word.index if all(tree.word(one).head in own for one in between) else 0
        if word.deprel == "case" and tree.governor(word).said not in _PRONOUNS:
            return 0
    return 0


def are_contents(tree: DependencyTree, index: int) -> bool:
    """Whether a phrase tells which thing is meant by what is in it: "with a pen" and "in it" in "put the bowl *with a
    pen in it* on the desk". Without another place, "in it" may be where to.
    """
    if contents_behind(tree, index):
        return True
    is_behind = any(contents_behind(tree, word.index) == index for word in tree.words[: index - 1])
    return is_behind and any(
        word.deprel == "case" and word.said in _PLACING_PREPOSITIONS and word.head > index
        for word in tree.words[index:]
    )


def tells_which(tree: DependencyTree, index: int) -> bool:
    """Whether a phrase of a noun says from which side a thing is counted, or what a person wears: "the second bottle
    *from the left*", "the man *in the red shirt*". No verb takes it."""
    word = tree.word(index)
    prepositions = tree.said_prepositions(index)
    if word.deprel != "nmod":
        return False
    if prepositions == ["from"]:
        is_counted = any(child.said in _ORDINALS for child in tree.children(word.head))
        return word.said in (_SIDES_OF_A_ROW if is_counted else _LEFT_AND_RIGHT)
    if prepositions == ["to"]:
        # "Bring me the cup *to the left of the plate*"; "put the cup to the left of the plate" says where to.
        has_receiver = any(child.deprel == "iobj" for child in tree.children(tree.governor(word).head))
        return has_receiver and word.said in _LEFT_AND_RIGHT
    return prepositions == ["in"] and is_person_or_name(tree.governor(word)) and is_likely(word, ["Clothing"])


def is_right_behind(tree: DependencyTree, phrase: FrozenSet[int], noun: FrozenSet[int]) -> bool:
    """Whether nothing that counts stands between a noun and a phrase: what was taken back does not."""
    last, first = max(noun), min(phrase)
    return last < first and is_beside(tree, last, first)


def places_said(tree: DependencyTree, heads: Iterable[int]) -> List[int]:
    """Return places as they are said, those that tell which of all things are meant behind the others: "put everything
    *on the table* in the sink"."""

    def key(index: int) -> Tuple[bool, int]:
        word = tree.word(index)
        before = tree.phrase_start(index) - 1
        tells = [one for one in (word.head, before) if one and tree.word(one).said in _INDEFINITES]
        return bool(tells), index

    return sorted(heads, key=key)


def _is_prepositional(tree: DependencyTree, index: int) -> bool:
    """Whether a phrase begins with its preposition, or with adverbs that make it more precise: "directly in front"."""
    first = tree.prepositions(index)[0].index
    before = [tree.word(position) for position in tree.subtree(index) if position < first]
    return all(word.said in _ADVERBS_BEFORE_PREPOSITIONS for word in before)


def has_postmodifiers(tree: DependencyTree, index: int) -> bool:
    """Whether a place behind a word can tell which is meant: "the mug on the table", "Bob at the door"."""
    word = tree.word(index)
    return word.upos in NOUNS or word.said in _INDEFINITE_PERSONS


def is_of_something(tree: DependencyTree, index: int) -> bool:
    """Whether a noun has a complement with "of": "the name of the man"."""
    return any(
        child.deprel == "nmod" and any(case.said == "of" for case in tree.children(child.index))
        for child in tree.children(index)
    )


def behind_description(tree: DependencyTree, verb: int, phrases: Sequence[int]) -> Tuple[int, ...]:
    """Return the phrase behind a whole description: "guide the man sitting on the sofa *to the door*".

    Args:
        tree: the sentence
        verb: of the description
        phrases: phrases of the verb with the wanted preposition; the first phrase of "the man pointing to the door"
            belongs to the description, and so does a phrase with more words of the description behind it
    """
    described = [child.index for child in tree.children(verb) if child.index > verb]
    is_purpose = any(child.deprel == "mark" for child in tree.children(verb))
    end = tree.phrase_end(verb)
    return tuple(
        index for index in phrases if (is_purpose or index != min(described)) and tree.phrase_end(index) == end
    )


def persons_behind(tree: DependencyTree, verb: int, preposition: str, *, is_needed: bool = False) -> Tuple[int, ...]:
    """Return a person at the end of a description that the parser attached to a noun in it: "describe the man sitting
    at the table *to me*", "... lying at the exit *to the person at the bar*"; no place is to anybody.

    A place may be meant only if the verb needs one: "lead the man dressed in a coat in the hall *to the exit*".

    Args:
        tree: the sentence
        verb: of the description
        preposition: of the person
        is_needed: whether the verb of the sentence lacks something without such a phrase
    """
    last = tree.phrase_end(verb)
    found = []
    for index in sorted(tree.subtree(verb)):
        word = tree.word(index)
        governor = tree.governor(word)
        has_preposition = any(c.said == preposition for c in tree.prepositions(index))
        is_end = has_preposition and tree.phrase_end(index) == last and governor.upos == "NOUN"
        is_speaker = word.said in _SPEAKERS
        # "The man reading the letter to the nurse": the letter may be to her.
        is_of_place = governor.index != verb and governor.deprel in ("obl", "nmod") and not is_person(governor)
        if is_end and (is_speaker or (is_of_place and preposition == "to" and (is_needed or is_person(word)))):
            found.append(index)
    return tuple(found[-1:])


def is_later_item(tree: DependencyTree, index: int, phrases: Collection[int]) -> bool:
    """Whether a word is a later item of a list whose first item is the head of a phrase: "to Anna and Ben" is one."""
    return tree.word(index).deprel == "conj" and tree.word(index).head in phrases


def places_before(tree: DependencyTree, head: int) -> Tuple[str, ...]:
    """Return the prepositions of the place phrases before a phrase, nearest first: in "the box on the table on the
    couch", "on" precedes "on the couch".
    """
    own = [child.index for child in tree.prepositions(head)]
    before = tree.words[: own[0] - 1] if own else ()
    return tuple(
        word.said
        for word in reversed(before)
        if word.deprel == "case" and word.said in _PLACE_PREPOSITIONS and word.head < own[0]
    )


def words_before(tree: DependencyTree, verb: int, first: int, free: FrozenSet[int]) -> FrozenSet[int]:
    """Return the adverb that modifies the preposition directly after it: "close" in "close to the door"."""
    before = first - 1
    if before <= verb or before not in free or tree.word(first).deprel != "case":
        return frozenset()
    word = tree.word(before)
    is_precise = word.deprel == "advmod" and word.said in _ADVERBS_BEFORE_PREPOSITIONS
    return frozenset([before]) if is_precise else frozenset()


def words_before_amount(tree: DependencyTree, first: int) -> FrozenSet[int]:
    """Return the words before a number that belong to it: "by almost" in "by almost 90 degrees"."""
    found = []
    position = first - 1
    while position > 0 and tree.word(position).said in _AMOUNT_MODIFIERS:
        found.append(position)
        position -= 1
    return frozenset(found)


def lost_directions(tree: DependencyTree, frame: SemanticFrame, arguments: Iterable[TypedArgument]) -> FrozenSet[int]:
    """Return the directions below the head of a direction that are not in its text: "right" in "left again and then
    right", whose text is "left".
    """
    lost: Set[int] = set()
    for argument in arguments:
        element = frame.element(argument.name)
        if argument.head_position and element is not None and element.framenet == DIRECTION:
            told = argument.text.lower().split()
            below = [tree.word(index) for index in tree.subtree(argument.head_position) if is_direction(tree, index)]
            lost.update(word.index for word in below if word.said not in told)
    return frozenset(lost)


def is_of_one_direction(tree: DependencyTree, index: int, used: AbstractSet[int]) -> bool:
    """Whether a word and a used word next to it name one direction: "straight ahead"."""
    beside = {index - 1: (_STRAIGHT, _ONWARD), index + 1: (_ONWARD, _STRAIGHT)}
    return any(
        other in used and tree.word(other).said in its and tree.word(index).said in own
        for other, (its, own) in beside.items()
    )


def objects_elsewhere(tree: DependencyTree, verb: Sequence[int]) -> List[int]:
    """Return nouns that the parser takes for something else than the object of a verb: for a place behind a particle of
    the verb ("plug in *the charger*"), for somebody who is spoken to ("spot *Ali*, ...") though no pause is before the
    name, or for the object of the next verb alone ("open and close *the door*").

    Args:
        tree: the sentence
        verb: positions of the verb and its particles
    """
    particles = [tree.word(index) for index in verb[1:]]
    found = [
        one.head
        for one in particles
        if one.deprel == "case"
        and tree.governor(one).deprel == "obl"
        and all(child.index in verb for child in tree.prepositions(one.head))
    ]
    behind = max(verb) + 1
    children = tree.children(verb[0])
    if not any(child.deprel in ("obj", "iobj") for child in children):
        found += [one.index for one in children if one.deprel == "vocative" and tree.phrase_start(one.index) == behind]
        found += [index for index in [shared_object(tree, verb[0])] if index]
    return found


def is_all_at_first_of_two_places(tree: DependencyTree, noun: int) -> bool:
    """Whether the first of two places says which things are meant: "put *everything on the table* in the box"."""
    if tree.word(noun).said not in _INDEFINITES:
        return False
    places = [child.index for child in tree.children(noun) if child.deprel == "nmod"]
    return any(
        inner.deprel == "nmod" and bool(tree.prepositions(inner.index))
        for place in places
        for inner in tree.children(place)
    )


def is_part_of_used_name(tree: DependencyTree, index: int, used: Container[int]) -> bool:
    """Whether a word is part of a used name: "living" in "living room"."""
    word = tree.word(index)
    # A number is not part of a name: "five foot thirteen" must not become five feet.
    return word.deprel in ("compound", "flat", "goeswith", "fixed") and word.head in used and word.upos != "NUM"


def listed_particle(tree: DependencyTree, unit: LexicalUnit, name: str, verb: Sequence[int]) -> int:
    """Return the particle of a verb that a unit lists for an element, too, whatever the parser takes it for: "on" in
    "turn on the light"; 0 for none.

    Args:
        tree: the sentence
        unit: the lexical unit
        name: of the element
        verb: positions of the words of the verb
    """
    words = {word for one in unit.relations if one.name == name for word in one.words}
    return next((index for index in verb[1:] if tree.word(index).said in words), 0)
