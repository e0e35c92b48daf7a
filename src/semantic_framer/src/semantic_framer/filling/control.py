"""How often, or for how long, a clause is to be carried out: "twice", "three times", "for two minutes"."""

from dataclasses import replace
from typing import FrozenSet, Optional, Tuple

from semantic_framer.filling.extra_phrases import left_over_groups
from semantic_framer.units.frame_roles import DIRECTION, GOAL, PATROLLING
from semantic_framer.values.iterations import times_said
from semantic_framer.values.reading import Reading, with_argument
from semantic_framer.values.sentence import Sentence
from semantic_frames.frame import Quantity, SemanticFrame
from typed_arguments import Measure, Source, TypedArgument
from utterance_passes.phrases.clauses import Clause
from utterance_passes.phrases.measures import amounts_of
from utterance_passes.trees.tree import ASIDE
from word_classes import word_class

#: A clause goes on for a day at most, seconds.
LONGEST_S = 86_400.0
#: FrameNet's names of what goes on until somebody ends it. Other things are over when they are done: nobody opens a
#: door for two minutes.
GOING_ON = frozenset(
    ["Change_direction", "Cotheme", "Gesture", "Make_noise", "Motion_directional", "Patrolling", "Self_motion"]
)
#: Units of what is filled in without being said.
_UNITS = {Quantity.LENGTH: "metres", Quantity.ANGLE: "radians"}
_EXACT = word_class("exact_adverbs")
_LEFT_AND_RIGHT = word_class("left_and_right")
_KEEPING = word_class("continuing_verbs")
#: FrameNet's name of going somewhere, and its semantic type of places.
_GOING, _PLACE = "Self_motion", "Location"
#: Extra-thematic elements; a server that heeds one of them gets it as an argument.
_DURATION, ITERATION = "Duration", "Iteration"


def with_times(
    sentence: Sentence, clause: Clause, reading: Reading, frame: SemanticFrame
) -> Tuple[Reading, FrozenSet[int]]:
    """Take a number of times out of the left-over words of a reading.

    Args:
        sentence: the sentence
        clause: the clause of the reading
        reading: the reading
        frame: its frame
    Returns:
        the reading, and the positions of the words that say how often; the same reading for "once" behind a turn
        of which nobody said how far it goes: "spin around once"
    """
    found = []
    if frame.framenet == PATROLLING:
        return reading, frozenset()  # It ends when something ends it, and never a second time.
    for root in left_over_groups(sentence, clause, reading.left_over):
        words = sentence.subtree(root) & clause.positions
        times = _times(sentence, root, words)
        if times:
            found.append((times, words))
    if found and _may_be_of_all(sentence, clause, found[0][1]):
        return reading, frozenset()
    if len(found) != 1 or reading.control.count or (found[0][0] == 1 and is_turn_assumed(reading, frame)):
        return reading, frozenset()
    times, words = found[0]
    left_over = tuple(index for index in reading.left_over if index not in words)
    return replace(reading, left_over=left_over, control=replace(reading.control, count=times)), words


def _may_be_of_all(sentence: Sentence, clause: Clause, words: FrozenSet[int]) -> bool:
    """Whether a mark before a number of times leaves open how much is done so often: "go to the hall and then to the
    office, *three times*".

    Args:
        sentence: the sentence
        clause: the last clause before the number
        words: positions of the words of the number
    """
    tree = sentence.tree
    first = min(index for index in words if tree.word(index).upos != "PUNCT")
    if first == 1 or tree.word(first - 1).form != ",":
        return False
    before = [word for word in tree.words[: first - 1] if word.upos == "VERB" and word.index not in clause.positions]
    return bool(before) or any(index < first for index in tree.sharing_a_verb)


def is_turn_assumed(reading: Reading, frame: SemanticFrame) -> bool:
    """Whether nobody said how far to turn, nor to which side: "spin around *once*" says that it is no half turn."""
    elements = {element.name for element in frame.frame_elements if element.quantity is Quantity.ANGLE}
    direction = reading.argument_in_role(DIRECTION, frame)
    is_said = direction is not None and direction.text.lower() in _LEFT_AND_RIGHT
    return not is_said and any(one.source is Source.DEFAULT and one.name in elements for one in reading.arguments)


def _times(sentence: Sentence, root: int, words: FrozenSet[int]) -> int:
    """Return how often some words say; 0 if they say something else."""
    forms = [sentence.word(index).said for index in sorted(words) if sentence.word(index).upos != "PUNCT"]
    forms = [form for form in forms if form not in _EXACT]
    said = times_said(forms)
    if said is None or said[1] != len(forms) or sentence.word(root).said != forms[-1]:
        return 0
    return said[0]


def with_duration(
    sentence: Sentence, clause: Clause, reading: Reading, frame: SemanticFrame
) -> Tuple[Reading, FrozenSet[int]]:
    """Take a duration out of the extra-thematic phrases of a reading that no server heeds.

    Args:
        sentence: the sentence
        clause: the clause of the reading
        reading: the reading, with its extra-thematic phrases
        frame: its frame
    Returns:
        the reading, and the positions of the words that say how long; the same reading if its frame is over when it is
        done, or if something else says how far it goes
    """
    said = [extra for extra in reading.extra or () if extra.name == _DURATION]
    open_ended = going_on(reading, frame) if len(said) == 1 else None
    if open_ended is None:
        return reading, frozenset()
    words = frozenset(said[0].positions) | sentence.subtree(said[0].head_position)
    seconds = [
        amount.si_amount
        for amount in amounts_of(sentence.tree, clause.positions, clause.verb)
        if amount.quantity == "duration" and not amount.is_doubtful and words.issuperset(amount.positions)
    ]
    if len(seconds) != 1 or not 0.0 < seconds[0] <= LONGEST_S:
        return reading, frozenset()
    return (
        replace(
            open_ended,
            left_over=tuple(index for index in reading.left_over if index not in words),
            extra=tuple(extra for extra in reading.extra or () if extra is not said[0]),
            control=replace(reading.control, duration_s=seconds[0]),
        ),
        words,
    )


def kept_up(sentence: Sentence, clause: Clause, reading: Reading, frame: SemanticFrame) -> Reading:
    """Return a reading that says that the deed goes on: "*keep* saying hello".

    "Keep going to the office" means to go on to the office, "to the hall and the office" to go there again and again,
    and "keep moving two metres" ends after two metres.
    """
    goal = reading.argument_in_role(GOAL, frame)
    if goal is not None and goal.separate_members and sentence.word(clause.verb).said in _KEEPING:
        return replace(reading, control=replace(reading.control, is_kept_up=not reading.control.is_said))
    before = sentence.word(clause.verb - 1) if clause.verb > 1 else None
    if before is None or before.said not in _KEEPING or before.deprel != ASIDE:
        return reading
    if has_end(reading, frame) or reading.control.is_said or reading.missing:
        return reading
    positions = reading.control.positions | {before.index}
    return replace(reading, control=replace(reading.control, is_kept_up=True, positions=positions))


def has_end(reading: Reading, frame: SemanticFrame) -> bool:
    """Whether something says how far a deed goes: an amount, or a place to go to."""
    said = [argument for argument in reading.arguments if argument.positions]
    return any(argument.measure is not None for argument in said) or (
        frame.framenet == _GOING and any(argument.semantic_type == _PLACE for argument in said)
    )


def going_on(reading: Reading, frame: SemanticFrame) -> Optional[Reading]:
    """Return a reading of something that goes on until it is ended: how far is as far as the frame allows.

    Returns:
        None if it is over when it is done, if something says how far it goes, or if nothing limits that
    """
    if frame.framenet not in GOING_ON:
        return None
    for element in frame.frame_elements:
        if element.quantity not in _UNITS:
            continue
        argument = reading.argument(element.name)
        if argument is not None and argument.positions:
            return None
        if element in reading.missing:
            if element.maximum is None or not element.unit_element:
                return None
            unit = _UNITS[element.quantity]
            text = f"{element.maximum:g}"
            measure = Measure(element.quantity.value, f"{text} {unit}", element.maximum, unit, element.maximum)
            farthest = TypedArgument(element.name, text, Source.INFERRED, measure=measure)
            reading = with_argument(reading, farthest)
            reading = with_argument(reading, TypedArgument(element.unit_element, unit, Source.INFERRED))
    return reading
