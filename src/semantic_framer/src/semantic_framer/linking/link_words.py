"""Finds times, delays and bounds between the deeds of a sentence, and where a condition may end."""

from dataclasses import replace
from typing import List, Optional, Tuple

from semantic_framer.linking.joints import Joint
from semantic_framer.linking.link_file import Link, LinkKind, shipped_links
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.condition_part import ConditionPart
from semantic_framer.values.sentence import Sentence
from spoken_quantities import QuantityError, parse_measure
from utterance_passes.phrases.clock_times import ClockTime, clock_time_at
from utterance_passes.trees.tree import Word
from word_classes import word_class

#: A plan waits for a day at most, seconds.
LONGEST_WAIT_S = 86_400.0
_DELAYS = word_class("delay_prepositions")
_PERIODS = word_class("determiners_of_all")
_BORDERS = word_class("clause_borders")
_BEFORE_MESSAGES = word_class("whether_words") | frozenset(["that"])
_LIMITS = word_class("limits_before_times")
#: Relations of a verb that belongs to what is before it.
INNER = frozenset(["amod", "compound", "xcomp", "aux", "aux:pass", "cop"])
#: Words behind a delay that do not change it.
_FROM_NOW = ["from", "now"]
#: Pronouns for persons without a name.
ANYBODY = word_class("indefinite_persons") | word_class("indefinite_persons_asked")
#: Pronouns for each of many persons; "whoever comes in" is "everybody who comes in".
MANY_PERSONS = ANYBODY & word_class("words_for_all") | {"whoever"}


def spoken_words(sentence: Sentence) -> List[Word]:
    """Return the words of a sentence without asides, corrected words and fillers."""
    hidden = sentence.tree.abandoned | sentence.tree.fillers
    return [word for word in sentence.tree.words if word.index not in hidden]


class LinkWords:
    """The words of a sentence among which links are looked for.

    Attributes:
        sentence: the sentence
        known: lexical units and frames
        words: its words without asides, corrected words and fillers
        forms: these words, in lower case
    """

    def __init__(self, sentence: Sentence, known: FramedLexicon) -> None:
        self.sentence = sentence
        self.known = known
        self.words = spoken_words(sentence)
        self.forms = [word.said for word in self.words]

    def joint(self, link: Link, place: int, end: int, length: int, condition: Optional[ConditionPart]) -> Joint:
        """Return the joint of a link whose words, of a length, begin at a place, and that reaches to an end."""
        words = self.words[place:end]
        while words and words[-1].upos == "PUNCT":
            words = words[:-1]
        said = self.sentence.text([word.index for word in self.words[place : place + length]])
        return Joint(link.kind, self.words[place].index, frozenset(word.index for word in words), condition, words=said)

    def may_end(self, end: int, *, is_clock: bool = True) -> bool:
        """Whether a condition may end before a place: at a mark, before a conjunction, a link, a time or a verb.

        Args:
            end: the place
            is_clock: whether a time of the clock may follow
        """
        if self.words[end - 1].upos == "PUNCT" or end == len(self.words):
            return True
        word, form = self.words[end], self.forms[end]
        if word.upos in ("PUNCT", "CCONJ") or form in _BORDERS:
            return True
        if form == "to" and [after.xpos for after in self.words[end + 1 : end + 2]] == ["VB"]:
            return True  # "Remind me at six *to call Bob*".
        if word.deprel == "mark" and form in _BEFORE_MESSAGES:
            return True  # "Tell Bob at six *that dinner is ready*".
        links = shipped_links()
        if any(at(self.forms[end:])[1] for at in (links.link_at, links.joiner_at, links.deed_link_at, links.order_at)):
            return True
        if self.bound(end)[0] is not None or self.timed(end)[0] is not None:
            return True
        if is_clock and self.clock(end) is not None:
            return True
        is_verb = bool(self.known.verbs_beginning_with(word.lemma.lower()) or self.known.verbs_beginning_with(form))
        # "If you see a mug *bring* it to me": without a comma the parser takes the deed for a part of the condition.
        is_deed = word.xpos == "VB" and word.deprel == "xcomp" and self.forms[end - 1] != "to"
        return (
            is_verb
            and (is_deed or word.deprel not in INNER)
            and word.upos in ("VERB", "NOUN", "ADJ", "PROPN", "INTJ", "X")
        )

    def clock(self, place: int) -> Optional[ClockTime]:
        """Return the time of the clock that begins at a place: "at eight", not "at eight tables" or "until noon"."""
        if place and self.forms[place - 1] in _LIMITS:
            return None
        found = clock_time_at(self.forms[place:])
        if found is None:
            return None
        words = {word.index for word in self.words[place : place + found.length]}
        is_time = found.is_certain and any(words <= time for time in self.sentence.tree.times)
        return found if is_time or self.may_end(place + found.length, is_clock=False) else None

    def at(self, place: int, clock: ClockTime) -> Tuple[Optional[Joint], int]:
        """Return the joint of a time of the clock that begins at a place."""
        end = place + clock.length
        joint = self.joint(Link(LinkKind.CLOCK), place, end, clock.length, None)
        return replace(joint, when=clock.when), end

    def timed(self, place: int) -> Tuple[Optional[Joint], int]:
        """Return a delay ("in five minutes") or a period ("every ten seconds") that begins at a place."""
        form = self.forms[place]
        kind = LinkKind.DELAY if form in _DELAYS else LinkKind.PERIOD if form in _PERIODS else None
        if kind is None or place + 1 == len(self.forms):
            return None, 0
        for end in range(min(len(self.forms), place + 7), place + 1, -1):
            seconds = self._seconds(place + 1, end, is_unit_enough=kind is LinkKind.PERIOD)
            if seconds is None:
                continue
            if self.forms[end : end + len(_FROM_NOW)] == _FROM_NOW:
                end += len(_FROM_NOW)
            link = Link(kind)
            return replace(self.joint(link, place, end, end - place, None), seconds=seconds), end
        return None, 0

    def _seconds(self, start: int, end: int, *, is_unit_enough: bool = False) -> Optional[float]:
        words = self.words[start:end]
        if any(word.upos == "PUNCT" for word in words):
            return None
        text = self.sentence.text([word.index for word in words])
        for said in (text, f"one {text}") if is_unit_enough else (text,):
            try:
                seconds = parse_measure(said, quantity="duration").si_amount
            except QuantityError:
                continue
            return seconds if 0.0 < seconds <= LONGEST_WAIT_S else None
        return None

    def bound(self, place: int) -> Tuple[Optional[Joint], int]:
        """Return a longest time that begins at a place: "for at most an hour", "for an hour at most"."""
        link = Link(LinkKind.THEN)
        length = shipped_links().bound_at(self.forms[place:])
        for end in range(min(len(self.forms), place + length + 5), place + length, -1) if length else ():
            seconds = self._seconds(place + length, end)
            if seconds is not None:
                return replace(self.joint(link, place, end, length, None), limit_s=seconds), end
        if self.forms[place] == "for":
            for end in range(min(len(self.forms), place + 6), place + 1, -1):
                behind = shipped_links().behind_bound_at(self.forms[end:])
                seconds = self._seconds(place + 1, end) if behind else None
                if seconds is not None:
                    end += behind
                    return replace(self.joint(link, place, end, 1, None), limit_s=seconds), end
        return None, 0

    def is_end(self, place: int) -> bool:
        """Whether only marks stand behind a place."""
        return all(word.upos == "PUNCT" for word in self.words[place:])
