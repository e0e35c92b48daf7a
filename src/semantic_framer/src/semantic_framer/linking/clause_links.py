"""Finds what joins the deeds of a sentence: conditions, delays, periods, bounds and joiners, each with its words."""

from dataclasses import dataclass, field, replace
from typing import FrozenSet, List, Optional, Sequence, Tuple

from semantic_framer.clauses.conditions import is_auxiliary, read_asked, read_condition
from semantic_framer.clauses.event_conditions import CONDITION_OF_DEED
from semantic_framer.linking.deed_orders import deed_behind, end_order, item_order, times_at
from semantic_framer.linking.joints import SENTENCE_ENDS, Joint, Joints, with_limits
from semantic_framer.linking.link_file import Link, LinkKind, shipped_links
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.condition_part import ConditionPart
from semantic_framer.values.sentence import Sentence
from spoken_quantities import QuantityError, parse_measure
from utterance_passes.phrases.clock_times import ClockTime, clock_time_at
from utterance_passes.phrases.measures import find_amounts
from utterance_passes.trees.tree import Word
from word_classes import word_class

#: A plan waits for a day at most, seconds.
LONGEST_WAIT_S = 86_400.0
_DO, _NEGATIONS = word_class("forms_of_do"), word_class("negations")
_DELAYS = word_class("delay_prepositions")
_PERIODS = word_class("period_determiners")
_BORDERS = word_class("clause_borders")
_BEFORE_MESSAGES = word_class("whether_words") | frozenset(["that"])
_LIMITS = word_class("limits_before_times")
_TIMES = word_class("iteration_adverbs")
_MANY, _WHO = word_class("persons_among_many"), word_class("relative_persons")
#: Links behind which the log says what the robot has done: it is decided now.
_OF_THE_PAST = frozenset([LinkKind.IF, LinkKind.UNLESS])
#: Relations of a verb that belongs to what is before it.
_INNER = frozenset(["amod", "compound", "xcomp", "aux", "aux:pass", "cop"])
#: Words behind a delay that do not change it.
_FROM_NOW = ["from", "now"]


def find_joints(sentence: Sentence, known: FramedLexicon) -> Joints:
    """Find what joins the deeds of a sentence. A link whose condition is not understood is left where it is."""
    return _Finder(sentence, known).find()


def condition_places(sentence: Sentence) -> FrozenSet[int]:
    """Return the positions at which a joint with a condition may begin; at most of them none does."""
    links = shipped_links()
    words = _spoken(sentence)
    forms = [word.form.lower() for word in words]
    return frozenset(
        word.index
        for place, word in enumerate(words)
        if any(at(forms[place:])[1] for at in (links.link_at, links.deed_link_at))
        or (place and forms[place - 1] in _MANY)
    )


def asks_whether(sentence: Sentence) -> bool:
    """Whether a sentence begins as one that asks for a condition: "*is* it open?", "*check whether* it is open"."""
    words = _spoken(sentence)
    return bool(words) and (
        is_auxiliary(words[0]) or bool(shipped_links().check_at([word.form.lower() for word in words]))
    )


def answers_a_question(sentence: Sentence) -> bool:
    """Whether a sentence begins with the case in which something is to be done: "*if so,* close it"."""
    kind, _ = shipped_links().answer_at([word.form.lower() for word in _spoken(sentence)])
    return kind is not None


def tells_how_long(sentence: Sentence) -> bool:
    """Whether a sentence only says how long something goes on: "*until* she is in the hall", "*for* five minutes"."""
    words = _spoken(sentence)
    link, _ = shipped_links().link_at([word.form.lower() for word in words])
    if link is not None:
        return link.kind in (LinkKind.UNTIL, LinkKind.WHILE)
    behind = frozenset(word.index for word in words[1:] if word.upos != "PUNCT")
    amounts = find_amounts(sentence.tree, sorted(behind)) if words and words[0].form.lower() == "for" else ()
    return any(amount.quantity == "duration" and behind <= frozenset(amount.positions) for amount in amounts)


def _spoken(sentence: Sentence) -> List[Word]:
    hidden = sentence.tree.abandoned | sentence.tree.fillers
    return [word for word in sentence.tree.words if word.index not in hidden]


@dataclass
class _Finder:
    sentence: Sentence
    known: FramedLexicon
    words: List[Word] = field(default_factory=list)
    forms: List[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.words = _spoken(self.sentence)
        self.forms = [word.form.lower() for word in self.words]

    def find(self) -> Joints:
        found: List[Joint] = []
        limits: List[Joint] = []
        question = ""
        unknown: Tuple[int, ...] = ()
        open_time: Optional[Joint] = None
        place = 0
        while place < len(self.words):
            if self.words[place].index in self.sentence.tree.quoted:
                place += 1
                continue
            bound, end = self._bound(place)
            if bound is not None:
                limits.append(bound)
                place = end
                continue
            clock = self._clock(place)
            if clock is not None and clock.when is None:
                if not question:
                    question, (open_time, _) = clock.question, self._at(place, clock)
                place += clock.length
                continue
            joint, end = self._at(place, clock) if clock is not None else self._timed(place)
            # "After that" joins two deeds, though "after" stands before conditions too.
            links, joins = (at(self.forms[place:])[1] for at in (shipped_links().link_at, shipped_links().joiner_at))
            joins = 0 if self._has_more(place, joins) else joins
            finders = (self._joiner, self._linked) if joins > links else (self._linked, self._joiner)
            for find in (
                self._checked,
                self._manner,
                self._of_persons,
                *finders,
                self._sequenced,
                self._beforehand,
                self._item_order,
            ):
                if joint is None:
                    joint, end = find(place)
            if joint is not None:
                found.append(joint)
                place = end
                continue
            checked = shipped_links().check_at(self.forms[place:])
            if checked:
                # "At six, check if it is open": what is to be found out is no condition.
                place += checked
                continue
            link, length = shipped_links().link_at(self.forms[place:])
            is_last = self._is_end(place + length)
            is_number = is_last and self.forms[place + length - 1] in _TIMES  # "Only once".
            is_asked = self.forms[place + length : place + length + 1] == ["to"]  # "Tell Bob *when to come*".
            is_other = is_number or is_asked
            if link is not None and not is_other and (is_last or self._is_subordinating(place, length)):
                rest = [word.index for word in self.words[place:] if word.upos != "PUNCT"]
                if not question and not unknown and len(rest) == length:
                    question = link.question
                last = self._last_before_deed(place)
                unknown = unknown or tuple(index for index in rest if index <= last)
            place += 1
        joints = with_limits(found, limits)
        for joint in joints:
            if joint.condition is not None and self._is_cut_short(joint, joints):
                return Joints((), question, unknown or tuple(sorted(joint.positions)))
        return Joints(tuple(joints), question, unknown, open_time)

    def _last_before_deed(self, place: int) -> int:
        """Return the position of the last word before a comma and a deed; of all words if there is no such comma."""
        for comma, behind in zip(self.words[place:], self.words[place + 1 :]):
            if comma.form == "," and self.known.verbs_beginning_with(behind.lemma.lower()):
                return comma.index
        return self.words[-1].index

    def _is_cut_short(self, joint: Joint, joints: Sequence[Joint]) -> bool:
        """Whether a condition has more words than were understood: "if the door is open *and you are tired*"."""
        tree = self.sentence.tree
        joining = frozenset().union(*(other.positions for other in joints))
        for word in self.words:
            if word.index in joining or word.head not in joint.positions or word.upos == "PUNCT":
                continue
            if word.form.lower() in _BORDERS or word.deprel == "cc":
                continue
            children = tree.children(word.index)
            is_deed = bool(self.known.verbs_beginning_with(word.lemma.lower())) and not any(
                child.deprel.startswith("nsubj") or child.deprel == "cop" for child in children
            )
            if not is_deed or word.deprel in _INNER - {"xcomp"}:
                return True
        return False

    def _is_subordinating(self, place: int, length: int) -> bool:
        words = self.words[place : place + length]
        return any(word.upos == "SCONJ" or word.deprel in ("mark", "advmod") for word in words)

    def _linked(self, place: int) -> Tuple[Optional[Joint], int]:
        """Return the condition behind a link, and the place behind it: the most words that make a condition."""
        link, length = shipped_links().link_at(self.forms[place:])
        return (None, 0) if link is None else self._condition(link, place, length)

    def _condition(self, link: Link, place: int, length: int) -> Tuple[Optional[Joint], int]:
        start = place + length
        is_order = link.kind is LinkKind.UNTIL and bool(self._denial())
        for end in range(len(self.words), start, -1):
            if not self._may_end(start, end):
                continue
            words = self.words[start:end]
            while words and words[-1].upos == "PUNCT":
                words = words[:-1]
            condition = read_condition(
                self.sentence,
                self.known,
                [word.index for word in words],
                is_until=link.kind is LinkKind.UNTIL,
                must_last=link.kind is LinkKind.WHILE,
                is_of_the_past=is_order or link.kind in _OF_THE_PAST,
            )
            if condition is not None:
                return self._put_off(self._joint(link, place, end, length, condition)), end
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
        tree = self.sentence.tree
        (top,) = tree.children(0)[:1]
        children = tree.children(top.index)
        denying = [child for child in children if child.deprel in ("aux", "advmod") and child.index < top.index]
        forms = [child.form.lower() for child in denying]
        is_denied = len(forms) == 2 and forms[0] in _DO and forms[1] in _NEGATIONS
        if not is_denied or any(child.deprel.startswith("nsubj") for child in children):
            return frozenset()
        return frozenset(child.index for child in denying)

    def _checked(self, place: int) -> Tuple[Optional[Joint], int]:
        """Return a condition that is checked first: "*check if the door is open, and if so,* close it", "*is the door
        open? If so,* close it".
        """
        length = shipped_links().check_at(self.forms[place:])
        is_question = is_auxiliary(self.words[place]) and (not place or self.forms[place - 1] in SENTENCE_ENDS)
        for behind in range(place + length + 1, len(self.words)) if length or is_question else ():
            kind, words_behind = shipped_links().answer_at(self.forms[behind:])
            end = behind + words_behind
            if kind is None or self._is_end(end):
                continue
            said = [word.index for word in self.words[place + length : behind] if word.upos != "PUNCT"]
            condition = read_asked(self.sentence, self.known, said)
            joint = self._joint(Link(kind.value, kind), place, end, length, condition)
            return (joint, end) if condition is not None else (None, 0)
        return None, 0

    def _manner(self, place: int) -> Tuple[Optional[Joint], int]:
        """Return an order of a list or of deeds ("in any order"), or a least or largest number of times."""
        times = times_at(self.forms[place:])
        if times is not None:
            end = place + times.length
            joint = self._joint(Link(times.kind.value, times.kind), place, end, times.length, None)
            return replace(joint, number=times.number), end
        link, length = shipped_links().order_at(self.forms[place:])
        if link is not None and (link.kind is LinkKind.AT_A_TIME or self._may_end(place, place + length)):
            return self._joint(link, place, place + length, length, None), place + length
        return None, 0

    def _of_persons(self, place: int) -> Tuple[Optional[Joint], int]:
        """Return what each of many persons does: "greet everybody *who comes in*", "greet whoever *comes in*"."""
        if not place or self.forms[place - 1] not in _MANY:
            return None, 0
        person = self.words[place - 1].index
        start = place + (self.forms[place] in _WHO)
        for end in range(len(self.words), start, -1):
            words = [word.index for word in self.words[start:end] if word.upos != "PUNCT"]
            if not words or not self._may_end(start, end):
                continue
            condition = read_condition(self.sentence, self.known, [person, *words], somebody=person)
            if condition is not None:
                link = Link(LinkKind.WHENEVER.value, LinkKind.WHENEVER)
                return replace(self._joint(link, place, end, end - place, condition), is_of_persons=True), end
        return None, 0

    def _item_order(self, place: int) -> Tuple[Optional[Joint], int]:
        """Return which item of a list comes before which: "but not the hall before the office"."""
        of_all = end_order(self.words, place, frozenset(word.lemma.lower() for word in self.words[:place]))
        if of_all is not None:
            link, behind = Link(LinkKind.IN_ORDER.value, LinkKind.IN_ORDER), place + of_all.length
            return replace(self._joint(link, place, behind, of_all.length, None), order=of_all), behind
        order = item_order(self.words, place)
        if order is None or (order.is_list and self._linked(order.border)[0] is not None):
            return None, 0  # "Open the door after the bell rings" waits for the bell.
        end = place + order.length
        joint = self._joint(Link(LinkKind.IN_ORDER.value, LinkKind.IN_ORDER), place, end, order.length, None)
        if not order.is_list:
            return replace(joint, order=order), end
        # The items of a new list stay in the sentence.
        last = max(at for at in range(place, order.border) if self.words[at].upos in ("NOUN", "PROPN"))
        between = frozenset(word.index for word in self.words[last + 1 : order.border])
        items = (self.words[last].index, self.words[order.border].index, self.words[end - 1].index)
        return replace(joint, positions=between, first=items[1], order=order, items=items), end

    def _sequenced(self, place: int) -> Tuple[Optional[Joint], int]:
        """Return words before a deed that follows or precedes another one: "before you go", "after closing"."""
        deed = deed_behind(self.words[place:], self.forms[place:], self.known)
        if deed is None:
            return None, 0
        before = self.forms[place - 1] if place else "."
        is_front = self.words[place - 1].upos == "PUNCT" or before in _BORDERS if place else True
        if before == "," and "," not in self.forms[place:]:
            is_front = False  # "Close the door, before you go."
        kind = deed.kind
        if kind is LinkKind.MEANWHILE and is_front:
            return None, 0  # "While you drive, sing": which of them ends the other?
        if kind is not LinkKind.MEANWHILE and is_front != (kind is LinkKind.BEFORE):
            kind = LinkKind.THEN  # The deeds are said in the order in which they are done.
        joint = self._joint(Link(kind.value, kind), place, place + deed.length, deed.length, None)
        return replace(joint, verb=deed.verb), place + deed.length

    def _beforehand(self, place: int) -> Tuple[Optional[Joint], int]:
        """Return what may happen in the meantime: "close the door *before Anna comes in*"."""
        link, length = shipped_links().deed_link_at(self.forms[place:])
        if link is None or link.kind is not LinkKind.BEFORE:
            return None, 0
        return self._condition(Link(link.name, LinkKind.BEFOREHAND), place, length)

    def _joint(self, link: Link, place: int, end: int, length: int, condition: Optional[ConditionPart]) -> Joint:
        words = self.words[place:end]
        while words and words[-1].upos == "PUNCT":
            words = words[:-1]
        said = self.sentence.text([word.index for word in self.words[place : place + length]])
        return Joint(link.kind, self.words[place].index, frozenset(word.index for word in words), condition, words=said)

    def _may_end(self, start: int, end: int, *, is_clock: bool = True) -> bool:
        """Whether a condition may end before a place: at a mark, before a conjunction, a link, a time or a verb.

        Args:
            start: where it begins
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
        if self._bound(end)[0] is not None or self._timed(end)[0] is not None:
            return True
        if is_clock and self._clock(end) is not None:
            return True
        is_verb = bool(self.known.verbs_beginning_with(word.lemma.lower()) or self.known.verbs_beginning_with(form))
        # "If you see a mug *bring* it to me": without a comma the parser takes the deed for a part of the condition.
        is_deed = word.xpos == "VB" and word.deprel == "xcomp" and self.forms[end - 1] != "to"
        return (
            is_verb
            and (is_deed or word.deprel not in _INNER)
            and word.upos in ("VERB", "NOUN", "ADJ", "PROPN", "INTJ", "X")
        )

    def _clock(self, place: int) -> Optional[ClockTime]:
        """Return the time of the clock that begins at a place: "at eight", not "at eight tables" or "until noon"."""
        if place and self.forms[place - 1] in _LIMITS:
            return None
        found = clock_time_at(self.forms[place:])
        if found is None:
            return None
        words = {word.index for word in self.words[place : place + found.length]}
        is_time = found.is_certain and any(words <= time for time in self.sentence.tree.times)
        return found if is_time or self._may_end(place, place + found.length, is_clock=False) else None

    def _at(self, place: int, clock: ClockTime) -> Tuple[Optional[Joint], int]:
        end = place + clock.length
        joint = self._joint(Link(LinkKind.CLOCK.value, LinkKind.CLOCK), place, end, clock.length, None)
        return replace(joint, when=clock.when), end

    def _timed(self, place: int) -> Tuple[Optional[Joint], int]:
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
            link = Link(kind.value, kind)
            return replace(self._joint(link, place, end, end - place, None), seconds=seconds), end
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

    def _bound(self, place: int) -> Tuple[Optional[Joint], int]:
        """Return a longest time that begins at a place: "for at most an hour", "for an hour at most"."""
        link = Link("at most", LinkKind.THEN)
        length = shipped_links().bound_at(self.forms[place:])
        for end in range(min(len(self.forms), place + length + 5), place + length, -1) if length else ():
            seconds = self._seconds(place + length, end)
            if seconds is not None:
                return replace(self._joint(link, place, end, length, None), limit_s=seconds), end
        if self.forms[place] == "for":
            for end in range(min(len(self.forms), place + 6), place + 1, -1):
                behind = shipped_links().behind_bound_at(self.forms[end:])
                seconds = self._seconds(place + 1, end) if behind else None
                if seconds is not None:
                    end += behind
                    return replace(self._joint(link, place, end, 1, None), limit_s=seconds), end
        return None, 0

    def _joiner(self, place: int) -> Tuple[Optional[Joint], int]:
        """Return a joiner that stands before a deed: "otherwise wait", "first go to the kitchen"."""
        joiner, length = shipped_links().joiner_at(self.forms[place:])
        if any(self.words[place].index in time for time in self.sentence.tree.times):
            return None, 0  # "Next week" is a time.
        is_front = self._is_front(place) or self._is_otherwise(joiner, place + length)
        if joiner is None or not is_front or self._has_more(place, length):
            # "Go to the kitchen and tell me a joke meanwhile": behind a deed only at the end of the sentence.
            is_last = joiner is not None and joiner.kind is LinkKind.MEANWHILE and self._is_end(place + length)
            if joiner is None or not is_last:
                return None, 0
        return self._joint(joiner, place, place + length, length, None), place + length

    def _has_more(self, place: int, length: int) -> bool:
        """Whether a joiner begins a condition: "*if you can't* find my keys", but not "if you can't, wait"."""
        behind = self.words[place + length : place + length + 1]
        inside = self.words[place : place + length]
        return any(word.deprel in ("aux", "cop") and word.head == verb.index for verb in behind for word in inside)

    def _is_otherwise(self, joiner: Optional[Link], behind: int) -> bool:
        """Whether a deed stands behind a joiner for the other case, without a comma: "close it *otherwise* wait"."""
        is_other = joiner is not None and joiner.kind in (LinkKind.OTHERWISE, LinkKind.OR_ELSE)
        deeds = self.words[behind : behind + 1] if is_other else []
        return any(one.upos == "VERB" and bool(self.known.verbs_beginning_with(one.lemma.lower())) for one in deeds)

    def _is_front(self, place: int) -> bool:
        before = self.words[place - 1] if place else None
        return before is None or before.upos in ("PUNCT", "CCONJ") or self.forms[place - 1] in _BORDERS

    def _is_end(self, place: int) -> bool:
        return all(word.upos == "PUNCT" for word in self.words[place:])
