"""Says whether a default is meant: it is not where the sentence may say something else for the element."""

from dataclasses import replace
from typing import Collection, FrozenSet, Mapping

from phrase_meanings.arguments import default_argument
from semantic_framer.units.frame_roles import DIRECTION
from semantic_framer.values.iterations import times_said
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from semantic_framer.values.things import is_direction
from semantic_frames.frame import FrameElement, Quantity, SemanticFrame
from semantic_types import Fit
from typed_arguments import Source, TypedArgument
from utterance_passes.phrases.clauses import Clause, is_then
from utterance_passes.phrases.measures import find_amounts
from word_classes import word_class

_LEFT_AND_RIGHT = word_class("left_and_right")
_IN = "in"
_PLACING_PREPOSITIONS = word_class("placing_prepositions")
#: FrameNet's name of going somewhere, and its semantic type of places.
_GOING, _PLACES = "Motion", ("Location",)


def is_said_otherwise(
    sentence: Sentence,
    clause: Clause,
    frame: SemanticFrame,
    element: FrameElement,
    *,
    unread: Collection[str],
    understood: FrozenSet[int],
) -> bool:
    """Whether something is said that may be meant for an element that has nothing but its default.

    Args:
        sentence: the sentence
        clause: the clause that is read
        frame: its frame
        element: the element with the default
        unread: the elements for which amounts are said that cannot fill them
        understood: the words that fill other elements, and those of the verb
    """
    if element.framenet == DIRECTION:
        return any(is_direction(sentence.tree, index) for index in clause.positions - understood)
    if element.name in unread:
        return True
    measured = next((one for one in frame.frame_elements if element.name in (one.name, one.unit_element)), element)
    if measured.quantity is None:
        return False
    is_of_another = _has_amount_of_another(sentence, clause, measured.quantity)
    return is_of_another or (measured.quantity is Quantity.ANGLE and _is_all_the_way(sentence, clause))


def _has_amount_of_another(sentence: Sentence, clause: Clause, quantity: Quantity) -> bool:
    """Whether a clause with the same verb has an amount that may be of both: "turn left and right *20 degrees*"."""
    tree = sentence.tree
    sharing = [word for word in tree.children(clause.verb) if word.index in tree.sharing_a_verb]
    # "Turn left, *then* right 20 degrees" are two turns, each with its own amount.
    if not sharing or any(is_then(child) for word in sharing for child in tree.children(word.index)):
        return False
    others = tree.subtree(clause.verb) - clause.positions
    return any(
        others & frozenset(amount.positions) and (not amount.unit or amount.quantity == quantity.value)
        for amount in find_amounts(tree, [word.index for word in tree.words if word.index not in tree.quoted])
    )


def _is_all_the_way(sentence: Sentence, clause: Clause) -> bool:
    """Whether a turn to neither side is to be made once: "spin around once" goes all the way round, and not by the
    default; who turns twice turns by the default each time."""
    forms = [sentence.word(index).said for index in sorted(clause.positions)]
    counts = [times[0] for place in range(len(forms)) for times in [times_said(forms[place:])] if times is not None]
    return counts == [1] and _LEFT_AND_RIGHT.isdisjoint(forms)


def may_say_direction(sentence: Sentence, reading: Reading, frames: Mapping[str, SemanticFrame]) -> bool:
    """Whether a phrase that nothing heeds may say where to, while the direction is only a default: "move *in reverse*".

    A yes to go on without it would move the robot the other way.
    """
    directions = [
        reading.argument(element.name)
        for element in frames[reading.unit.frame_name].frame_elements
        if element.framenet == DIRECTION
    ]
    is_default = any(one is not None and one.source is Source.DEFAULT for one in directions)
    is_going_nowhere = frames[reading.unit.frame_name].framenet == _GOING and bool(reading.missing)
    return (is_default or is_going_nowhere) and any(
        _is_bare_in(sentence, extra.head_position)
        for extra in reading.extra or ()
        if 0 < extra.head_position <= len(sentence.tree.words)
    )


def value_of_verb(name: str, text: str) -> TypedArgument:
    """Make the argument that a verb says by itself: to "refrigerate" something is to put it *in the fridge*."""
    preposition, _, rest = text.partition(" ")
    if not rest or preposition not in _PLACING_PREPOSITIONS:
        return default_argument(name, text)
    return replace(default_argument(name, rest), relation=preposition)


def is_no_place(sentence: Sentence, head: int, frame: SemanticFrame) -> bool:
    """Whether a bare noun says how somebody goes, and not where to: "go in *reverse*", "go in *style*"."""
    is_bare_in = frame.framenet == _GOING and _is_bare_in(sentence, head)
    return is_bare_in and sentence.types.fit(head, _PLACES) is Fit.WRONG


def _is_bare_in(sentence: Sentence, head: int) -> bool:
    """Whether a noun has "in" before it, and nothing else: "in reverse"."""
    children = [child for child in sentence.children(head) if child.deprel != "punct"]
    is_alone = all(child.deprel == "case" and child.said == _IN for child in children)
    return sentence.word(head).upos == "NOUN" and bool(children) and is_alone
