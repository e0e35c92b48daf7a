"""Finds implausible values, such as a side, a degree or a deed that is taken for a thing."""

from dataclasses import dataclass
from typing import FrozenSet, Tuple

from phrase_meanings.head_words import is_side_of_something
from semantic_framer.units.frame_roles import MESSAGE, NO_THINGS, PLACES, THEME, THINGS
from semantic_framer.values.reading import Reading
from semantic_framer.values.things import is_direction, is_indefinite, is_no_thing
from semantic_frames.extra_thematic import is_of_every_action
from semantic_frames.frame import SemanticFrame
from semantic_frames.relation_names import MEASURE
from spoken_quantities import find_whole_number
from typed_arguments import TypedArgument
from utterance_passes.trees.persons import is_name_of_person
from utterance_passes.trees.tree import NOUNS, VERBS, DependencyTree, Word
from word_classes import word_class

_ADVERBS_BEFORE_PREPOSITIONS = word_class("adverbs_before_prepositions")
_BEFORE_DETERMINERS = word_class("determiners_of_all")
_DEGREES = word_class("degrees")
_EXACTLY = word_class("exact_adverbs")
_VAGUE_PERIODS = word_class("short_periods")
_FORWARD_AND_BACKWARD = word_class("forward_and_backward")
_HEARERS = word_class("hearers")
_ITSELF = frozenset(["yourself"])
_LEFT_AND_RIGHT = word_class("left_and_right")
_PLACE_PREPOSITIONS = word_class("place_prepositions")
# What is put between two places is put in one.
_PLACING = word_class("placing_prepositions") - {"between"}
_QUESTION_WORDS = word_class("question_words")
_SHARES = frozenset(["percent", "%"])
_SINGULAR = frozenset(["NN", "NNP"])
_SIDES = word_class("sides")
_SOUGHT_OR_SAID = frozenset(["Sought_entity", MESSAGE])
_SPEAKERS = word_class("speaker_objects")


@dataclass(frozen=True)
class Filled:
    """A value to be judged.

    Attributes:
        value: the value, which has a head word
        reading: the reading with the value
        beside: all readings of the clause
        frame: the frame of the reading
        tree: the sentence
    """

    value: TypedArgument
    reading: Reading
    beside: Tuple[Reading, ...]
    frame: SemanticFrame
    tree: DependencyTree

    @property
    def head(self) -> Word:
        """The head word of the value."""
        return self.tree.word(self.value.head_position)

    @property
    def roles(self) -> FrozenSet[str]:
        """FrameNet's name of the element that the value fills; empty for an amount."""
        element = None if self.value.measure else self.frame.element(self.value.name)
        return frozenset() if element is None or element.quantity is not None else frozenset([element.framenet])


def is_noun_of_a_verb(filled: Filled) -> bool:
    """Whether a noun is part of the verb of another unit: "take a look"."""
    return filled.head.upos in ("NOUN", "PROPN", "NUM") and any(
        filled.head.index in other.verb_positions and filled.head.index not in filled.reading.verb_positions
        for other in filled.beside
    )


def is_measure_elsewhere(filled: Filled) -> bool:
    """Whether another unit uses the number as a measure: "turn one eighty"."""
    is_phrase = bool(filled.tree.prepositions(filled.head.index))
    return (
        not is_phrase
        and filled.head.index not in _measured(filled.reading)
        and any(filled.head.index in _measured(other) for other in filled.beside)
    )


def is_miscounted(reading: Reading, beside: Tuple[Reading, ...], tree: DependencyTree) -> bool:
    """Whether a number above one counts a singular noun, and another unit, which does not take the noun, asks for an
    amount: "turn right *90 image*"."""
    counted = [
        value.name
        for value in reading.arguments
        if value.head_position and value.measure is None and not value.relation
        if tree.word(value.head_position).xpos in _SINGULAR
        for child in tree.children(value.head_position)
        if child.deprel == "nummod" and (find_whole_number(child.form) or 0) > 1
    ]
    return any(
        path.steps[-1] == MEASURE
        for name in counted
        for other in beside
        if other.argument(name) is None
        for relation in other.unit.relations
        for path in relation.relations
    )


def joins_unlisted_word(reading: Reading, tree: DependencyTree) -> bool:
    """Whether only a comma joins a word that the unit lists to one that it does not list: "to your *right, photos* at
    the door"."""
    listed = {relation.name: relation.words for relation in reading.unit.relations if relation.words}
    return any(
        child.deprel == "conj"
        and child.index in value.positions
        and child.said not in listed[value.name]
        and not any(below.deprel == "cc" for below in tree.children(child.index))
        for value in reading.arguments
        if value.name in listed and value.head_position in reading.listed
        for child in tree.children(value.head_position)
    )


def is_unread_elsewhere(filled: Filled) -> bool:
    """Whether the words contain an amount that another unit asks for and that must not be acted on. One that is an
    amount here, too, has only the wrong unit there: "go left 90 degrees" is no distance."""
    unread = {position for other in filled.beside for amount in other.unread for position in amount.positions}
    is_amount = filled.value.measure or filled.reading.unread
    return not is_amount and bool(unread & frozenset(filled.value.positions))


def _measured(reading: Reading) -> FrozenSet[int]:
    return frozenset(position for value in reading.arguments if value.measure for position in value.positions)


def is_asked_about_elsewhere(filled: Filled) -> bool:
    """Whether a word has the wrong type here, and the right one in a reading that only lacks an element: "take Anna"
    asks where to, not whether Anna is a thing. So does "take Rose", whose name is a thing, too."""
    reading = filled.reading
    is_odd = any(wrong.name == filled.value.name for wrong in reading.wrong_types) or (
        bool(reading.doubtful_types) and is_name_of_person(filled.head)
    )
    return is_odd and any(
        other.missing and not other.wrong_types and not other.doubtful_types
        for other in filled.beside
        if filled.head.index in other.listed and not other.left_over
    )


def is_numbered_place(filled: Filled) -> bool:
    """Whether a number is taken for the place of something: "set the vase to 20", or for a part of the place behind it:
    "go on three hundred to the door"."""
    if not filled.roles & PLACES:
        return False
    children = filled.tree.children(filled.head.index)
    counts = [child.index for child in children if child.deprel == "nummod"]
    first = min((child.index for child in children if child.deprel == "case"), default=0)
    if any(index < first for index in counts):
        return True
    # "Wait *at ten sharp*."
    is_counted = filled.head.lemma.lower() in _SHARES or filled.head.said in _EXACTLY
    if filled.head.upos != "NUM" and not (is_counted and counts):
        return False
    if "Place" in filled.roles:
        return True  # "Turn left *at ten*" says when.
    elements = filled.frame.frame_elements
    themes = {element.name for element in elements if element.framenet == THEME and element.quantity is None}
    return any(other.name in themes and other.positions for other in filled.reading.arguments)


def is_one_of_two_places(filled: Filled) -> bool:
    """Whether one thing is put in two places: "put the cup on the table and the bowl" does not say whether the bowl is
    a place. But "to Anna and Ben" is plausible: a thing can be brought to one after the other.
    """
    if filled.value.conjunction != "and" or "Goal" not in filled.roles:
        return False
    prepositions = filled.tree.prepositions(filled.head.index)
    elements = filled.frame.frame_elements
    themes = {element.name for element in elements if element.framenet == THEME and element.quantity is None}
    is_put = any(other.name in themes and other.positions for other in filled.reading.arguments)
    return is_put and bool(prepositions) and prepositions[0].said in _PLACING


def is_two_phrases(filled: Filled) -> bool:
    """Whether a noun phrase directly follows another: in "room 3 polish the table" the parser took the verb of a new
    command for a noun.
    """
    if MESSAGE in filled.roles:
        return False
    words = [filled.tree.word(index) for index in filled.value.positions]
    if any(word.upos in VERBS for word in words) or filled.tree.quoted & frozenset(filled.value.positions):
        return False
    return any(
        word.upos in ("NOUN", "PROPN", "NUM", "ADJ")
        and word.said not in _BEFORE_DETERMINERS
        and following.index == word.index + 1
        and following.head != word.index
        and (following.deprel == "det" or _counts_an_apposition(filled.tree, following))
        for word, following in zip(words, words[1:])
    )


def _counts_an_apposition(tree: DependencyTree, word: Word) -> bool:
    """Whether a number modifies an apposition to the noun before it: "3" in "room 3 knock"."""
    return word.deprel == "nummod" and tree.governor(word).deprel == "appos"


def is_side_of_the_place_before(filled: Filled) -> bool:
    """Whether a phrase that says where something is for the hearer is taken for a place to go to, directly behind
    another place: "through the door on the left", "to the wall in front of you".
    """
    if not filled.roles & PLACES or filled.value.members:
        return False
    positions = filled.value.positions
    words = [filled.tree.word(index) for index in positions]
    prepositions = [word for word in words if word.deprel == "case" and word.head == filled.head.index]
    if not prepositions or prepositions[0].said not in _PLACE_PREPOSITIONS:
        return False
    nouns = [word for word in words if word.upos in NOUNS and word.said not in _SIDES]
    is_of_hearer = all(word.said in _HEARERS for word in words if word.upos == "PRON" and word.xpos == "PRP")
    is_side = filled.head.said in _SIDES or filled.head.said in _HEARERS
    start = positions[0]
    while start > 1 and filled.tree.word(start - 1).said in _ADVERBS_BEFORE_PREPOSITIONS:
        start -= 1
    is_behind_place = any(
        value.relation and value.measure is None and value.positions and value.positions[-1] == start - 1
        for value in filled.reading.arguments
        if value is not filled.value
    )
    return is_side and is_of_hearer and is_behind_place and not nouns


def is_subject_of_a_question(filled: Filled) -> bool:
    """Whether the subject of an indirect question is taken for what is looked at: "find out where *my keys* are" does
    not look at the keys. "Whether the oven is hot" does.
    """
    head, form = filled.head, filled.head.said
    if "Ground" not in filled.roles or not head.deprel.startswith("nsubj") or form in _QUESTION_WORDS:
        return False
    asked = [filled.tree.word(index) for index in filled.tree.subtree(head.head)]
    is_asked = any(word.said in _QUESTION_WORDS for word in asked if word.index < head.index)
    return is_asked or filled.tree.governor(head).said in _QUESTION_WORDS


def is_way(filled: Filled) -> bool:
    """Whether words that say how something is done are taken for a place: "drive in a square", but not "stand in the
    square", which is a place.
    """
    head, tree = filled.head, filled.tree
    prepositions = tree.prepositions(head.index)
    is_certain = any(child.deprel in ("det", "nmod:poss") for child in tree.children(head.index))
    is_open = is_indefinite(tree, head.index) or not is_certain
    is_shape = bool(prepositions) and is_of_every_action(prepositions[0].said, head.form)
    return bool(filled.roles & PLACES) and is_open and is_shape and len(prepositions) == 1


def is_wisher(filled: Filled) -> bool:
    """Whether the person for whom something is done is taken for what is sought or said: "check the door *for me*", but
    not "look for me in the kitchen", where the phrase is the first behind the verb.
    """
    is_for_speaker = filled.value.relation == "for" and filled.value.text.lower() in _SPEAKERS
    is_first = filled.value.positions[:1] == (max(filled.reading.verb_positions, default=0) + 1,)
    return bool(filled.roles & _SOUGHT_OR_SAID) and is_for_speaker and not is_first


def is_degree(filled: Filled) -> bool:
    """Whether a degree or a time is taken for a thing: "move a bit", "wait a moment", but not "a bit of bread" or "the
    dog's hair".
    """
    children = filled.tree.children(filled.head.index)
    is_of_something = any(child.deprel in ("nmod", "nmod:poss", "compound") for child in children)
    # "Ask him not to touch it" has a verb.
    is_measure = filled.head.upos != "VERB" and filled.head.said in _DEGREES | _VAGUE_PERIODS
    return bool(filled.roles) and is_measure and not is_of_something


def is_side(filled: Filled) -> bool:
    """Whether a side or a direction is taken for a thing: "take a right", or "northwards" parsed as a noun."""
    form = filled.head.said
    # "Drive 19 in backwards" goes to no place.
    if filled.roles & PLACES and form in _FORWARD_AND_BACKWARD and filled.head.upos == "ADV":
        return True
    # "Turn to the left and then to the right" names two directions, and no place.
    if filled.roles & PLACES and filled.value.direction and _is_direction_said_beside(filled):
        return True
    if filled.roles & THINGS and is_direction(filled.tree, filled.head.index) and form not in _SIDES:
        return True
    is_one = form in _LEFT_AND_RIGHT and not is_side_of_something(filled.tree, filled.head.index)
    return is_one and filled.head.deprel == "obj" and bool(filled.roles) and not filled.roles & (PLACES | NO_THINGS)


def _is_direction_said_beside(filled: Filled) -> bool:
    others = (other for other in filled.reading.arguments if other is not filled.value and other.direction)
    return any(other.head_position in filled.reading.listed for other in others)


def is_deed(filled: Filled) -> bool:
    """Whether a deed, an event, a way or the robot itself is taken for a thing that is moved, given or held: "take a
    nap", "put yourself next to the door".
    """
    is_subject = filled.head.deprel.startswith("nsubj")
    is_moved = bool(filled.roles & THINGS) and not is_subject
    is_robot = filled.head.said in _ITSELF
    return is_moved and (is_robot or is_no_thing(filled.tree, filled.head.index, filled.reading.verb))


def is_listed_elsewhere(filled: Filled) -> bool:
    """Whether another unit lists an indefinite noun: "the photo" may be a known thing, but "a photo" fits the other
    unit.
    """
    head = filled.head
    is_bare = not any(child.deprel in ("det", "nmod:poss") for child in filled.tree.children(head.index))
    is_new = is_bare or is_indefinite(filled.tree, head.index)
    return (head.upos == "NOUN" and head.deprel == "obj" and is_new) and any(
        head.index in other.listed and other.unit.frame_name != filled.reading.unit.frame_name and not other.missing
        for other in filled.beside
    )
