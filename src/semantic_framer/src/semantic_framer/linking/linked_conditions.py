"""Finds the conditions of a sentence: behind links, asked first, and those of many persons."""

from dataclasses import replace
from typing import FrozenSet, Optional, Tuple

from semantic_framer.clauses.conditions import is_auxiliary, read_asked, read_condition
from semantic_framer.clauses.event_conditions import CONDITION_OF_DEED
from semantic_framer.linking.joints import SENTENCE_ENDS, Joint
from semantic_framer.linking.link_file import Link, LinkKind, shipped_links
from semantic_framer.linking.link_words import MANY_PERSONS, LinkWords
from word_classes import word_class

_DO, _NEGATIONS = word_class("forms_of_do"), word_class("negations")
_WHO = word_class("relative_pronouns")
#: Links behind which the log says what the robot has done: it is decided now.
_OF_THE_PAST = frozenset([LinkKind.IF, LinkKind.UNLESS])


class LinkedConditions:
    """Finds the conditions among the words of a sentence; each method returns None and 0 where there is none."""

    def __init__(self, said: LinkWords) -> None:
        self._said = said

    def linked(self, place: int) -> Tuple[Optional[Joint], int]:
        """Return the condition behind a link, and the place behind it: the most words that make a condition."""
        link, length = shipped_links().link_at(self._said.forms[place:])
        return (None, 0) if link is None else self._condition(link, place, length)

    def checked(self, place: int) -> Tuple[Optional[Joint], int]:
        """Return a condition that is checked first: "*check if the door is open, and if so,* close it", "*is the door
        open?* Close it *if it is*".
        """
        length = shipped_links().check_at(self._said.forms[place:])
        is_question = is_auxiliary(self._said.words[place]) and (
            not place or self._said.forms[place - 1] in SENTENCE_ENDS
        )
        for behind in range(place + length + 1, len(self._said.words)) if length or is_question else ():
            kind, words_behind = shipped_links().answer_at(self._said.forms[behind:])
            end = behind + words_behind
            if kind is None or self._said.is_end(end):
                continue
            said = [word.index for word in self._said.words[place + length : behind] if word.upos != "PUNCT"]
            condition = read_asked(self._said.sentence, self._said.known, said)
            joint = self._said.joint(Link(kind), place, end, length, condition)
            return (joint, end) if condition is not None else (None, 0)
        return self._checked_before_deed(place, length) if length or is_question else (None, 0)

    def _checked_before_deed(self, place: int, length: int) -> Tuple[Optional[Joint], int]:
        """Return both parts of "*check if the door is open and* close it *if it is*"."""
        words = self._said.words
        start, kind = self._case_at_end(place)
        for border in range(place + length + 1, start):
            if kind is None or words[border].upos not in ("PUNCT", "CCONJ"):
                continue
            said = [word.index for word in words[place + length : border]]
            condition = read_asked(self._said.sentence, self._said.known, said)
            if condition is None:
                continue
            end = next(at for at in range(border, len(words)) if words[at].upos not in ("PUNCT", "CCONJ"))
            joint = self._said.joint(Link(kind), place, end, length, condition)
            behind = frozenset(word.index for word in words[start:] if word.upos != "PUNCT")
            return replace(joint, positions=joint.positions | behind), end
        return None, 0

    def _case_at_end(self, place: int) -> Tuple[int, Optional[LinkKind]]:
        """Return where the words behind a place begin that end the sentence with a case, "if it is", and the case."""
        for start in range(place + 2, len(self._said.words)):
            kind, length = shipped_links().answer_at(self._said.forms[start:])
            if kind is not None and self._said.is_end(start + length):
                return start, kind
        return 0, None

    def of_persons(self, place: int) -> Tuple[Optional[Joint], int]:
        """Return what each of many persons does: "greet everybody *who comes in*", "greet whoever *comes in*"."""
        if not place or self._said.forms[place - 1] not in MANY_PERSONS:
            return None, 0
        person = self._said.words[place - 1].index
        start = place + (self._said.forms[place] in _WHO)
        for end in range(len(self._said.words), start, -1):
            words = [word.index for word in self._said.words[start:end] if word.upos != "PUNCT"]
            if not words or not self._said.may_end(end):
                continue
            condition = read_condition(self._said.sentence, self._said.known, [person, *words], somebody=person)
            if condition is not None:
                link = Link(LinkKind.WHENEVER)
                return replace(self._said.joint(link, place, end, end - place, condition), is_of_persons=True), end
        return None, 0

    def beforehand(self, place: int) -> Tuple[Optional[Joint], int]:
        """Return what may happen in the meantime: "close the door *before Anna comes in*"."""
        link, length = shipped_links().deed_link_at(self._said.forms[place:])
        if link is None or link.kind is not LinkKind.BEFORE:
            return None, 0
        return self._condition(Link(LinkKind.BEFOREHAND), place, length)

    def _condition(self, link: Link, place: int, length: int) -> Tuple[Optional[Joint], int]:
        start = place + length
        is_order = link.kind is LinkKind.UNTIL and bool(self._denial())
        for end in range(len(self._said.words), start, -1):
            if not self._said.may_end(end):
                continue
            words = self._said.words[start:end]
            while words and words[-1].upos == "PUNCT":
                words = words[:-1]
            condition = read_condition(
                self._said.sentence,
                self._said.known,
                [word.index for word in words],
                is_until=link.kind is LinkKind.UNTIL,
                must_last=link.kind is LinkKind.WHILE,
                is_of_the_past=is_order or link.kind in _OF_THE_PAST,
            )
            if condition is not None:
                return self._put_off(self._said.joint(link, place, end, length, condition)), end
        return None, 0

    def _put_off(self, joint: Joint) -> Joint:
        """Return "do not say hello *until you have closed the door*" as an order of two deeds: the greeting waits.

        What is forbidden until somebody else does something is only forbidden.
        """
        said = joint.condition.reading if joint.condition is not None else None
        if joint.kind is not LinkKind.UNTIL or said is None or said.unit.frame_name != CONDITION_OF_DEED:
            return joint
        denial = self._denial()
        return replace(joint, kind=LinkKind.WHEN, positions=joint.positions | denial) if denial else joint

    def _denial(self) -> FrozenSet[int]:
        """Return the words that make a prohibition of the sentence: "*do not* say hello"; none if it is none."""
        tree = self._said.sentence.tree
        (top,) = tree.children(0)[:1]
        children = tree.children(top.index)
        denying = [child for child in children if child.deprel in ("aux", "advmod") and child.index < top.index]
        forms = [child.said for child in denying]
        is_denied = len(forms) == 2 and forms[0] in _DO and forms[1] in _NEGATIONS
        if not is_denied or any(child.deprel.startswith("nsubj") for child in children):
            return frozenset()
        return frozenset(child.index for child in denying)
