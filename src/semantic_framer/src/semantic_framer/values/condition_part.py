"""A condition as it was understood, and whether it happens in a moment."""

from dataclasses import dataclass
from typing import FrozenSet, Mapping, Optional, Tuple

from semantic_framer.values.reading import Reading
from semantic_frames.frame import SemanticFrame
from utterance_passes.trees.tree import DependencyTree
from word_classes import word_class

_HAVE, _BE = word_class("forms_of_have"), word_class("forms_of_be") | {"be"}
#: FrameNet's names of what happens in a moment.
_MOMENTARY = frozenset(["Arriving", "Departing", "Impact", "Process_end", "Process_start", "Statement"])
#: FrameNet's names of what begins when a verb says so, and may last: "the door opens", "the bell rings".
_CHANGING = frozenset(["Make_noise", "State_of_entity"])
_EVENT, _BEGINNING = "Event", word_class("aspectual_verbs") - word_class("continuing_verbs")
_LASTING = word_class("lasting_verbs") | _BE


@dataclass(frozen=True)
class ConditionPart:
    """A condition, or several ones that are joined.

    Attributes:
        kind: CONDITION, ALL or ANY
        positions: of all its words
        reading: of a CONDITION; None for the others
        children: the joined conditions
        is_negated: whether the opposite is meant
        is_anew: whether it must begin to hold: "rings again"
        words: a question as a statement: "the door is open"; empty for a condition that was said as one
    """

    kind: str
    positions: FrozenSet[int]
    reading: Optional[Reading] = None
    children: Tuple["ConditionPart", ...] = ()
    is_negated: bool = False
    is_anew: bool = False
    words: str = ""


def happens(part: ConditionPart, tree: DependencyTree, frames: Mapping[str, SemanticFrame]) -> bool:
    """Whether a condition happens in a moment: "if Anna comes", "if the door opens", but not "if Anna has come", "if
    the door is opening" or "if nobody comes".
    """
    if part.is_negated:
        return False
    forms = {tree.word(index).lemma.lower() for index in part.positions if tree.word(index).upos == "AUX"}
    if is_momentary(part, frames):
        return not forms & _HAVE
    if part.reading is None or forms & (_HAVE | _BE):
        return False
    own = {tree.word(index).lemma.lower() for index in part.reading.verb_positions}
    framenet = frames[part.reading.unit.frame_name].framenet
    if framenet == _EVENT:
        return bool(own & _BEGINNING)  # "If it starts raining"; "if it rains" asks how it is now.
    return framenet in _CHANGING and bool(own) and not own & _LASTING


def is_momentary(part: ConditionPart, frames: Mapping[str, SemanticFrame]) -> bool:
    """Whether a condition, or one of those in it, is over in a moment: "Anna comes", but not "the bell rings"."""
    if part.reading is None:
        return any(is_momentary(child, frames) for child in part.children)
    return frames[part.reading.unit.frame_name].framenet in _MOMENTARY
