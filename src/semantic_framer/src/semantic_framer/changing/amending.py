"""Applies a fragment to the last command: the words of the fragment fill elements, and all others stay as they were.

Which element a phrase fills is found by ``fragment_phrases``.
"""

import re
import sys
from dataclasses import replace
from typing import Dict, List, Optional, Sequence, Tuple

from phrase_meanings.arguments import amount_argument, on_other_side, unit_argument
from phrase_meanings.head_words import ONES
from semantic_framer.changing.fragment_phrases import FragmentPhrases, measured
from semantic_framer.changing.paces import PACES, at_pace, pace_element
from semantic_framer.clauses.fragments import Fragment
from semantic_framer.filling.unheeded import without_unheeded
from semantic_framer.units.frame_roles import MESSAGE
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.dialogue import LastCommand
from semantic_framer.values.fragment_kind import FragmentKind
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from semantic_framer.values.slight_amounts import slight_amount, stated
from semantic_frames.frame import SemanticFrame
from typed_arguments import Source, TypedArgument
from typed_arguments.positions import without_any_position
from word_classes import word_class, word_list

_DETERMINERS = word_class("determiners_and_possessives")
_HEARERS = word_class("hearers")
_PAIRS = word_list("opposite_sides")
#: The other side of each side.
_OPPOSITES: Dict[str, str] = {
    **dict(zip(_PAIRS[::2], _PAIRS[1::2])),
    **dict(zip(_PAIRS[1::2], _PAIRS[::2])),
}


Clauses = Tuple[Tuple[Reading, ...], ...]


def amended(fragment: Fragment, sentence: Sentence, last: LastCommand, known: FramedLexicon) -> Tuple[Clauses, ...]:
    """Return what a fragment may mean after a command.

    Args:
        fragment: the fragment
        sentence: its utterance
        last: the command
        known: lexical units and frames
    Returns:
        the readings of the changed command, for each of its clauses that the fragment may change; empty if the
        fragment fits none
    """
    if any(one.unit.frame_name not in known.frames for readings in last.clauses for one in readings):
        return ()
    if fragment.kind is FragmentKind.REPEAT:
        if (fragment.times and len(last.clauses) > 1) or not _may_repeat(fragment, sentence, last, known):
            return ()
        return (tuple(tuple(_repeated(one, fragment.times) for one in readings) for readings in last.clauses),)
    found: List[Tuple[int, Clauses]] = []
    for readings in reversed(last.clauses):
        changes = [_Amending(fragment, sentence, reading, known).changed() for reading in readings]
        fitting = tuple(reading for reading in changes if reading is not None)
        # The best reading was what the person meant: if it does not fit, the fragment is about something else.
        if fitting and changes[0] is not None:
            names = {one.name for one in readings[0].arguments}
            added = sum(1 for one in fitting[0].arguments if one.positions and one.name not in names)
            found.append((added, (fitting,)))
    least = min((added for added, _ in found), default=0)
    return tuple(clauses for added, clauses in found if added == least)


def _may_repeat(fragment: Fragment, sentence: Sentence, last: LastCommand, known: FramedLexicon) -> bool:
    """Whether a fragment may mean the last command: "tell him again" does only if something was said."""
    says = any(known.speech_of(sentence.word(index).said) is not None for index in fragment.positions)
    return not says or any(MESSAGE in known.frames[readings[0].unit.frame_name].roles for readings in last.clauses)


def _repeated(reading: Reading, times: int) -> Reading:
    again = _unsaid(reading)
    if not times:
        return again
    return replace(again, control=replace(again.control, count=times * max(1, again.control.count)))


def _unsaid(reading: Reading) -> Reading:
    """Return a reading of an earlier utterance as one of which nothing was said in this one."""
    return replace(
        reading,
        verb_positions=(),
        arguments=tuple(_inferred(argument) for argument in reading.arguments),
        left_over=(),
        extra=None,
        listed=frozenset(),
        unread=(),
    )


def _inferred(argument: TypedArgument) -> TypedArgument:
    is_default = argument.source is Source.DEFAULT
    return replace(without_any_position(argument), source=Source.DEFAULT if is_default else Source.INFERRED)


def _as_phrase(argument: TypedArgument) -> str:
    """Return the words of an argument with its preposition, as inside a sentence."""
    words = argument.words or argument.text
    first, _, rest = words.partition(" ")
    if rest and first.lower() in _DETERMINERS:
        words = f"{first.lower()} {rest}"
    is_said = not argument.relation or first.lower() == argument.relation.split("_")[0]
    return words if is_said else f"{argument.relation.replace('_', ' ')} {words}"


class _Amending:
    """Applies a fragment to one reading of a clause."""

    def __init__(self, fragment: Fragment, sentence: Sentence, reading: Reading, known: FramedLexicon) -> None:
        self._fragment = fragment
        self._sentence = sentence
        self._tree = sentence.tree
        self._reading = reading
        self._known = known
        self._frame: SemanticFrame = known.frames[reading.unit.frame_name]
        self._phrases = FragmentPhrases(fragment, sentence, reading, known)

    def changed(self) -> Optional[Reading]:
        """Return the changed reading; None if the fragment does not fit it."""
        kind = self._fragment.kind
        if kind is FragmentKind.MORE:
            return _unsaid(self._reading) if measured(self._reading, self._frame) else None
        if kind is FragmentKind.BIT:
            return self._with_a_bit()
        if kind in PACES:
            return self._at_pace(PACES[kind])
        *before, last = (self._tree.word(index).said for index in self._fragment.positions)
        if kind is FragmentKind.ONE_MORE:
            found = self._phrases.counted()
        elif kind is FragmentKind.OPPOSITE or last in ONES or (before == ["the"] and last in _OPPOSITES):
            found = self._of_a_side() or self._phrases.replaced()
        else:
            found = (
                self._phrases.replaced()
                or self._phrases.counted()
                or self._phrases.behind_same_preposition()
                or self._phrases.behind_verb()
            )
        if not found:
            return None
        changed = self._with(found)
        _, lost = without_unheeded(self._sentence, changed, self._frame, self._known.heeded.get(self._frame.name))
        return None if lost else changed

    def _with(self, found: Sequence[TypedArgument]) -> Reading:
        new = {argument.name: argument for argument in found}
        before = _unsaid(self._reading)
        kept = [one for one in before.arguments if one.name not in new]
        order = {element.name: place for place, element in enumerate(self._frame.frame_elements)}
        arguments = tuple(sorted([*kept, *found], key=lambda one: order.get(one.name, len(order))))
        units = {element.unit_element for element in self._frame.frame_elements if element.quantity}
        spoken = [one for one in arguments if one.source is not Source.DEFAULT and one.name not in units]
        said = [_as_phrase(one) for one in sorted(spoken, key=self._place)]
        return replace(
            before,
            arguments=arguments,
            missing=tuple(element for element in before.missing if element.name not in new),
            clause_text=" ".join([before.verb, *(words for words in said if words.lower() not in _HEARERS)])
            + stated(arguments),
        )

    def _place(self, argument: TypedArgument) -> int:
        """Return where an element was said in the command before; behind all others if it was not said there."""
        before = self._reading.argument(argument.name)
        return before.head_position if before is not None and before.head_position else sys.maxsize

    def _with_a_bit(self) -> Optional[Reading]:
        """Return the reading with the amount that is assumed for "a bit"; without one, the person must say it."""
        found = measured(self._reading, self._frame)
        if len(found) != 1 or found[0].quantity is None:
            return None
        names = {found[0].name, found[0].unit_element}
        amount = slight_amount(self._fragment.positions, found[0].quantity.value)
        if amount is not None and found[0].unit_element:
            value = amount_argument(self._tree, found[0].name, amount, is_whole=False)
            return self._with([value, unit_argument(self._tree, found[0].unit_element, amount)])
        before = _unsaid(self._reading)
        return replace(
            before,
            arguments=tuple(one for one in before.arguments if one.name not in names),
            missing=tuple(element for element in self._frame.frame_elements if element.name in names),
        )

    def _at_pace(self, pace: str) -> Optional[Reading]:
        """Return the reading at another pace; None if no server heeds one, or there is none beyond."""
        name = pace_element(self._frame, self._known.heeded.get(self._frame.name), pace)
        words = self._tree.text_of(self._fragment.positions)
        found = at_pace(self._reading, name, pace, words, self._fragment.positions) if name else None
        if found is None:
            return None
        if found.text:
            return self._with([found])
        usual = self._with(())
        return replace(usual, arguments=tuple(one for one in usual.arguments if one.name != name))

    def _of_a_side(self) -> Tuple[TypedArgument, ...]:
        """Return the only argument with a side, on the other side, or on the side that the fragment names ("the right
        one"); nothing if there is none.
        """
        named = [self._tree.word(index).said for index in self._fragment.positions]
        sides = [form for form in named if form in _OPPOSITES]
        found = []
        for argument in self._reading.arguments:
            words = re.findall(r"\w+", argument.text.lower()) + [one.word.lower() for one in argument.modifiers]
            spoken = [word for word in dict.fromkeys(words) if word in _OPPOSITES]
            # "The other one" is a thing at a side, such as a door or an arm: a direction has no other one.
            is_meant = argument.head.lower() not in _OPPOSITES or not any(form in ONES for form in named)
            if len(spoken) == 1 and argument.measure is None and is_meant:
                found.append((argument, spoken[0]))
        is_about_sides = self._fragment.kind is FragmentKind.OPPOSITE or len(sides) == 1
        if len(found) != 1 or not is_about_sides or (sides and sides[0] not in (found[0][1], _OPPOSITES[found[0][1]])):
            return ()
        argument, side = found[0]
        other = sides[0] if sides else _OPPOSITES[side]
        return (on_other_side(self._tree, argument, side, other, self._fragment.positions),)
