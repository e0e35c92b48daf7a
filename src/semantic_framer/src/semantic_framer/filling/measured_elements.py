"""Assigns the amounts of a clause to the elements of a frame."""

from dataclasses import dataclass
from typing import AbstractSet, Dict, Optional, Sequence, Tuple

from semantic_framer.units.frame_roles import OPERATIONAL_STATE
from semantic_framer.values.sentence import Sentence
from semantic_framer.values.slight_amounts import slight_amount, slight_words
from semantic_frames.frame import Quantity, SemanticFrame
from semantic_frames.lexical_unit import ElementRelation, LexicalUnit, RelationPath
from semantic_frames.relation_names import MEASURE
from spoken_quantities import find_unit
from utterance_passes.phrases.measures import Amount, stands_free

_OF_SPACE = frozenset([Quantity.LENGTH.value, Quantity.ANGLE.value])
_NUMBERS_OF_2012 = frozenset(["num", "number", "nummod"])
_MEASURES_OF_2012 = _NUMBERS_OF_2012 | {"tmod", "npadvmod"}


@dataclass(frozen=True)
class MeasuredElements:
    """The amounts for the elements that ask for a measure.

    Attributes:
        amount_of: the amount of each element; the unit element has the same amount
        unread: the amounts that were said for an element but must not fill it: "two or three metres"
    """

    amount_of: Dict[str, Amount]
    unread: Dict[str, Tuple[Amount, ...]]


def measured_elements(
    sentence: Sentence,
    unit: LexicalUnit,
    frame: SemanticFrame,
    verb_positions: Sequence[int],
    amounts: Sequence[Amount],
    positions: AbstractSet[int] = frozenset(),
) -> MeasuredElements:
    """Give each amount to the first element that asks for a measure of its quantity.

    An element stays open if its amount must not be acted on, or if two amounts are said for it. Nothing else may fill
    it then, not even its default, because the person said something different.

    Args:
        sentence: the sentence
        unit: the lexical unit whose relations ask for measures
        frame: the frame of the unit
        verb_positions: words of the verb
        amounts: the amounts of the clause
        positions: the words of the clause; "a bit" among them stands for an amount
    """
    asking = [
        (relation, element, element.quantity)
        for relation in unit.relations
        for element in [frame.element(relation.name)]
        if element is not None and element.quantity is not None
    ]
    if not asking:
        return MeasuredElements({}, {})
    free = [amount for amount in amounts if not _is_of_the_verb(sentence, amount, verb_positions)]
    amount_of: Dict[str, Amount] = {}
    unread: Dict[str, Tuple[Amount, ...]] = {}
    for relation, _, quantity in asking:
        if not any(path.steps[-1] == MEASURE for path in relation.relations):
            continue
        fitting = [amount for amount in free if amount.quantity == quantity.value] or [
            amount for amount in free if not amount.unit and not amount.is_of_noun
        ]
        if not fitting:
            continue
        is_number_of_step = _names_a_step(sentence, fitting[0], verb_positions)
        if is_number_of_step or fitting[0].is_doubtful or (fitting[0].is_share and quantity is not Quantity.NUMBER):
            unread[relation.name] = tuple(fitting)
            continue
        free.remove(fitting[0])
        amount_of[relation.name] = fitting[0]
    for name, amount in list(amount_of.items()):
        others = [other for other in free if other.quantity == amount.quantity and other.unit]
        unit_element = next(element.unit_element for _, element, _ in asking if element.name == name)
        if others:
            unread[name] = (amount_of.pop(name), *others)
        elif unit_element and amount.unit:
            amount_of[unit_element] = amount
    # "Turn right five inches" gives a distance, but turning needs an angle.
    misplaced = tuple(amount for amount in free if amount.unit and amount.quantity in _OF_SPACE)
    # "A bit" stands for an amount, except where the amount itself says what is done: "go left *90 degrees*".
    slight = slight_words(sentence.tree, positions - frozenset(verb_positions)) if not free else ()
    for relation, element, quantity in asking:
        is_open = relation.name not in amount_of and relation.name not in unread
        if misplaced and is_open and quantity.value in _OF_SPACE:
            unread[relation.name] = misplaced
        is_assumable = is_open and element.unit_element and not relation.is_required
        assumed = slight_amount(slight, quantity.value) if is_assumable else None
        if assumed is not None:
            amount_of[relation.name] = amount_of[element.unit_element] = assumed
    return MeasuredElements(amount_of, unread)


def _names_a_step(sentence: Sentence, amount: Amount, verb_positions: Sequence[int]) -> bool:
    """Whether a bare number right behind the verb numbers it: "*step 1:* go to the kitchen" has no step forward."""
    unit = find_unit(sentence.word(verb_positions[-1]).form)
    is_behind = amount.positions[0] == verb_positions[-1] + 1
    return unit is not None and unit.is_assumed and is_behind and not amount.unit


def _is_of_the_verb(sentence: Sentence, amount: Amount, verb_positions: Sequence[int]) -> bool:
    """Whether the verb includes a whole amount except articles: "make a turn", "pull a 180"; not "make half a turn"."""
    verb = frozenset(verb_positions)
    own = [
        position
        for position in amount.positions
        if position != amount.unit_position and sentence.word(position).said not in ("a", "an")
    ]
    unit = find_unit(amount.unit)
    if unit is not None and unit.is_assumed:
        # "Take a step" says how far.
        return False
    return not amount.is_doubtful and bool(verb & frozenset(amount.positions)) and verb >= frozenset(own)


def asks_for_a_measure(unit: LexicalUnit) -> bool:
    """Whether a unit asks for an amount: how far, by how much, or for how long."""
    return any(path.steps[-1] == MEASURE for relation in unit.relations for path in relation.relations)


def is_in_a_measure(sentence: Sentence, head: int, amounts: Sequence[Amount], *, is_measuring: bool) -> bool:
    """Whether a word is part of a measure ("two degrees"), and no thing.

    Args:
        sentence: the sentence
        head: the word
        amounts: the amounts of the clause
        is_measuring: whether a unit of the verb asks for an amount; a number without a unit is one then ("wait for 5"),
            and also one that is written on a word that is no unit ("3mnis"). Otherwise it is a thing ("give me 5")
    """
    word = sentence.word(head)
    is_glued = any(
        child.deprel == "nummod" and sentence.tree.is_glued(child.index, head) for child in sentence.children(head)
    )
    if is_measuring and word.upos == "NOUN" and is_glued:
        return True
    return any(
        amount.unit
        or _is_end(sentence, amount, head)
        or (is_measuring and not amount.is_of_noun and stands_free(sentence.tree, head))
        for amount in amounts
        if head in amount.positions
    )


def _is_end(sentence: Sentence, amount: Amount, head: int) -> bool:
    """Whether a word ends a range that includes its preposition: "fifteen" in "ten to fifteen"."""
    cases = [child.index for child in sentence.tree.prepositions(head)]
    return amount.is_doubtful and bool(cases) and cases[0] in amount.positions


def measures_as_in_2012(unit: LexicalUnit) -> bool:
    """Whether a unit asks for the number and the counted noun by their relations, as in 2012."""
    return any(
        path.steps[-1] in _MEASURES_OF_2012 and not relation.words
        for relation in unit.relations
        for path in relation.relations
    )


def numeral_at(head: int, path: RelationPath, amounts: Sequence[Amount]) -> Optional[Amount]:
    """Return the amount that a unit of 2012 asks for by the relation of one word of the amount.

    Args:
        head: the word
        path: relations that lead to the word
        amounts: the amounts of the clause
    Returns:
        the amount; None if the word is the whole number, or not a number
    """
    amount = next((amount for amount in amounts if head in amount.positions), None)
    if amount is None or path.steps[-1] not in _NUMBERS_OF_2012:
        return None
    numeral = [position for position in amount.positions if position != amount.unit_position]
    return amount if amount.is_doubtful or numeral != [head] else None


def is_setting(frame: SemanticFrame, relation: ElementRelation, head: int, amounts: Sequence[Amount]) -> bool:
    """Whether degrees are the state that a device shall have, and no angle: "set the oven *to 200 degrees*"."""
    element = frame.element(relation.name)
    is_state = relation.is_required and element is not None and element.framenet == OPERATIONAL_STATE
    return is_state and any(head in amount.positions and amount.quantity == "angle" for amount in amounts)
