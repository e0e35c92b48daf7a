"""Finds what joins the deeds of a sentence: conditions, delays, periods, bounds and joiners, each with its words."""

from dataclasses import replace
from typing import FrozenSet, List, Optional, Sequence, Tuple

from semantic_framer.clauses.conditions import is_auxiliary
from semantic_framer.linking.deed_orders import (
    deed_behind,
    end_order,
    ends_of_way,
    first_order,
    is_first_of_deeds,
    is_last_of_deed,
    item_order,
    prohibition_behind,
    times_at,
)
from semantic_framer.linking.joints import Joint, Joints, with_limits
from semantic_framer.linking.link_file import Link, LinkKind, shipped_links
from semantic_framer.linking.link_words import INNER, MANY_PERSONS, LinkWords, spoken_words
from semantic_framer.linking.linked_conditions import LinkedConditions
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.order_words import FIRST, LAST
from semantic_framer.values.sentence import Sentence
from utterance_passes.phrases.measures import find_amounts
from utterance_passes.trees.tree import NOUNS, VERBS
from word_classes import word_class

_BORDERS = word_class("clause_borders")
_GOING = word_class("verbs_of_going") | word_class("continuing_verbs")
_TIMES = word_class("iteration_adverbs")


def find_joints(sentence: Sentence, known: FramedLexicon) -> Joints:
    """Find what joins the deeds of a sentence. A link whose condition is not understood is left where it is."""
    return _Finder(sentence, known).find()


def condition_places(sentence: Sentence) -> FrozenSet[int]:
    """Return the positions at which a joint with a condition may begin; at most of them none does."""
    links = shipped_links()
    words = spoken_words(sentence)
    forms = [word.said for word in words]
    return frozenset(
        word.index
        for place, word in enumerate(words)
        if any(at(forms[place:])[1] for at in (links.link_at, links.deed_link_at))
        or (place and forms[place - 1] in MANY_PERSONS)
    )


def asks_whether(sentence: Sentence) -> bool:
    """Whether a sentence begins as one that asks for a condition: "*is* it open?", "*check whether* it is open"."""
    words = spoken_words(sentence)
    return bool(words) and (is_auxiliary(words[0]) or bool(shipped_links().check_at([word.said for word in words])))


def answers_a_question(sentence: Sentence) -> bool:
    """Whether a sentence begins with the case in which something is to be done: "*if so,* close it"."""
    kind, _ = shipped_links().answer_at([word.said for word in spoken_words(sentence)])
    return kind is not None


def tells_how_long(sentence: Sentence) -> bool:
    """Whether a sentence only says how long something goes on: "*until* she is in the hall", "*for* five minutes"."""
    words = spoken_words(sentence)
    link, _ = shipped_links().link_at([word.said for word in words])
    if link is not None:
        return link.kind in (LinkKind.UNTIL, LinkKind.WHILE)
    behind = frozenset(word.index for word in words[1:] if word.upos != "PUNCT")
    amounts = find_amounts(sentence.tree, sorted(behind)) if words and words[0].said == "for" else ()
    return any(amount.quantity == "duration" and behind <= frozenset(amount.positions) for amount in amounts)


class _Finder:
    def __init__(self, sentence: Sentence, known: FramedLexicon) -> None:
        self._said = LinkWords(sentence, known)
        self._conditions = LinkedConditions(self._said)

    def find(self) -> Joints:
        found: List[Joint] = []
        limits: List[Joint] = []
        question = ""
        unknown: Tuple[int, ...] = ()
        open_time: Optional[Joint] = None
        place = 0
        while place < len(self._said.words):
            index = self._said.words[place].index
            if index in self._said.sentence.tree.quoted or any(index in joint.positions for joint in found):
                place += 1
                continue
            bound, end = self._said.bound(place)
            if bound is not None:
                limits.append(bound)
                place = end
                continue
            clock = self._said.clock(place)
            if clock is not None and clock.when is None:
                if not question:
                    question, (open_time, _) = clock.question, self._said.at(place, clock)
                place += clock.length
                continue
            joint, end = self._said.at(place, clock) if clock is not None else self._said.timed(place)
            # "After that" joins two deeds, though "after" stands before conditions too.
            links, joins = (
                at(self._said.forms[place:])[1] for at in (shipped_links().link_at, shipped_links().joiner_at)
            )
            joins = 0 if self._has_more(place, joins) else joins
            finders = (
                (self._joiner, self._conditions.linked) if joins > links else (self._conditions.linked, self._joiner)
            )
            for find in (
                self._conditions.checked,
                self._manner,
                self._conditions.of_persons,
                self._forbidden,
                *finders,
                self._sequenced,
                self._conditions.beforehand,
                self._item_order,
            ):
                if joint is None:
                    joint, end = find(place)
            if joint is not None:
                found.append(joint)
                place = end
                continue
            checked = shipped_links().check_at(self._said.forms[place:])
            if checked:
                # "At six, check if it is open": what is to be found out is no condition.
                place += checked
                continue
            link, length = shipped_links().link_at(self._said.forms[place:])
            is_last = self._said.is_end(place + length)
            is_number = is_last and self._said.forms[place + length - 1] in _TIMES  # "Only once".
            is_asked = self._said.forms[place + length : place + length + 1] == ["to"]  # "Tell Bob *when to come*".
            is_other = is_number or is_asked
            if link is not None and not is_other and (is_last or self._is_subordinating(place, length)):
                rest = [word.index for word in self._said.words[place:] if word.upos != "PUNCT"]
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
        for comma, behind in zip(self._said.words[place:], self._said.words[place + 1 :]):
            if comma.form == "," and self._said.known.verbs_beginning_with(behind.lemma.lower()):
                return comma.index
        return self._said.words[-1].index

    def _is_cut_short(self, joint: Joint, joints: Sequence[Joint]) -> bool:
        """Whether a condition has more words than were understood: "if the door is open *and you are tired*"."""
        tree = self._said.sentence.tree
        joining = frozenset().union(*(other.positions for other in joints))
        for word in self._said.words:
            if word.index in joining or word.head not in joint.positions or word.upos == "PUNCT":
                continue
            if word.said in _BORDERS or word.deprel == "cc":
                continue
            children = tree.children(word.index)
            is_deed = bool(self._said.known.verbs_beginning_with(word.lemma.lower())) and not any(
                child.deprel.startswith("nsubj") or child.deprel == "cop" for child in children
            )
            if not is_deed or word.deprel in INNER - {"xcomp"}:
                return True
        return False

    def _is_subordinating(self, place: int, length: int) -> bool:
        words = self._said.words[place : place + length]
        return any(word.upos == "SCONJ" or word.deprel in ("mark", "advmod") for word in words)

    def _manner(self, place: int) -> Tuple[Optional[Joint], int]:
        """Return an order of a list or of deeds ("in any order"), or a least or largest number of times."""
        times = times_at(self._said.forms[place:])
        if times is not None:
            end = place + times.length
            joint = self._said.joint(Link(times.kind), place, end, times.length, None)
            return replace(joint, number=times.number), end
        link, length = shipped_links().order_at(self._said.forms[place:])
        if link is not None and link.kind in (LinkKind.ALTERNATING, LinkKind.RETURNING):
            return self._between(link, place, length)
        if link is not None and (link.kind is LinkKind.AT_A_TIME or self._said.may_end(place + length)):
            return self._said.joint(link, place, place + length, length, None), place + length
        return None, 0

    def _verbs_before(self, place: int) -> FrozenSet[str]:
        """Return the verbs before a place, in their base form."""
        return frozenset(word.lemma.lower() for word in self._said.words[:place] if word.upos in VERBS)

    def _between(self, link: Link, place: int, length: int) -> Tuple[Optional[Joint], int]:
        """Return words that say that the robot goes between two places, or several: "back and forth", "and back"."""
        words, tree = self._said.words, self._said.sentence.tree
        items, end = ends_of_way(tree), place + length
        if self._said.forms[end : end + 1] == ["to"]:
            place_behind = tree.governor(words[end])
            if items and place_behind.lemma == tree.word(items[0]).lemma:
                end = next(at for at, word in enumerate(words) if word is place_behind) + 1
            elif not items and words[place - 1].upos in NOUNS and place_behind.upos in NOUNS:
                # "To the hall *and back* to the office": a list.
                items = (words[place - 1].index, words[end].index, place_behind.index)
                return replace(self._said.joint(Link(LinkKind.IN_ORDER), place, end, length, None), items=items), end
            else:
                return None, 0
        if not items:
            return None, 0
        joint = self._said.joint(link, place, end, length, None)
        is_going = tree.verb_above(tree.word(items[0])).lemma.lower() in _GOING
        return replace(joint, items=items if is_going else ()), end  # One patrols "between", and goes "to".

    def _item_order(self, place: int) -> Tuple[Optional[Joint], int]:
        """Return which item of a list comes before which: "but not the hall before the office"."""
        first = first_order(self._said.words, place)
        if first is not None:
            return replace(self._said.joint(Link(LinkKind.IN_ORDER), place, place + 1, 1, None), order=first), place + 1
        if is_first_of_deeds(self._said.words, place):
            return self._said.joint(Link(LinkKind.BEFORE_THAT), place, place + 1, 1, None), place + 1
        if is_last_of_deed(self._said.words, place):
            return self._said.joint(Link(LinkKind.IN_ORDER), place, place + 1, 1, None), place + 1
        of_all = end_order(self._said.words, place, self._verbs_before(place))
        if of_all is not None and of_all.length == 1:
            end = next(at for at in range(place, len(self._said.words)) if self._said.words[at].said in FIRST | LAST)
            joint = self._said.joint(Link(LinkKind.IN_ORDER), end, end + 1, 1, None)
            return replace(joint, order=of_all), end + 1
        if of_all is not None:
            link, behind = Link(LinkKind.IN_ORDER), place + of_all.length
            return replace(self._said.joint(link, place, behind, of_all.length, None), order=of_all), behind
        order = item_order(self._said.words, place)
        if order is None or (order.is_list and self._conditions.linked(order.border)[0] is not None):
            return None, 0  # "Open the door after the bell rings" waits for the bell.
        end = place + order.length
        joint = self._said.joint(Link(LinkKind.IN_ORDER), place, end, order.length, None)
        if not order.is_list:
            return replace(joint, order=order), end
        # The items of a new list stay in the sentence.
        last = max(at for at in range(place, order.border) if self._said.words[at].upos in NOUNS)
        between = frozenset(word.index for word in self._said.words[last + 1 : order.border])
        items = (
            self._said.words[last].index,
            self._said.words[order.border].index,
            self._said.words[order.second].index,
        )
        return replace(joint, positions=between, first=items[1], order=order, items=items), end

    def _forbidden(self, place: int) -> Tuple[Optional[Joint], int]:
        """Return both ends of "*until you have* been to the hall*, stay out of the office*; then go there"."""
        length = prohibition_behind(self._said.words, place)
        if length:
            return self._said.joint(Link(LinkKind.NOT_BEFORE), place, place + length, length, None), place + length
        comma = self._said.forms.index(",") if place == 0 and "," in self._said.forms else 0
        return self._sequenced(place) if comma and prohibition_behind(self._said.words, comma) else (None, 0)

    def _sequenced(self, place: int) -> Tuple[Optional[Joint], int]:
        """Return words before a deed that follows or precedes another one: "before you go", "after closing"."""
        deed = deed_behind(self._said.words[place:], self._said.forms[place:], self._said.known)
        if deed is None:
            return None, 0
        before = self._said.forms[place - 1] if place else "."
        is_front = self._said.words[place - 1].upos == "PUNCT" or before in _BORDERS if place else True
        if before == "," and "," not in self._said.forms[place:]:
            is_front = False  # "Close the door, before you go."
        kind = deed.kind
        if kind is LinkKind.MEANWHILE and is_front:
            return None, 0  # "While you drive, sing": which of them ends the other?
        if kind is not LinkKind.MEANWHILE and is_front != (kind is LinkKind.BEFORE):
            kind = LinkKind.THEN  # The deeds are said in the order in which they are done.
        joint = self._said.joint(Link(kind), place, place + deed.length, deed.length, None)
        return replace(joint, verb=deed.verb, is_kept_out=deed.is_kept_out), place + deed.length

    def _joiner(self, place: int) -> Tuple[Optional[Joint], int]:
        """Return a joiner that stands before a deed: "otherwise wait", "first go to the kitchen"."""
        joiner, length = shipped_links().joiner_at(self._said.forms[place:])
        if any(self._said.words[place].index in time for time in self._said.sentence.tree.times):
            return None, 0  # "Next week" is a time.
        behind = self._said.words[place + length : place + length + 1]
        if length > 1 and behind and behind[0].said == "of":
            return None, 0  # "*At the end* of the hall turn left."
        is_front = self._is_front(place) or self._is_otherwise(joiner, place + length)
        if joiner is None or not is_front or self._has_more(place, length):
            # "Go to the kitchen and tell me a joke meanwhile": behind a deed only at the end of the sentence.
            is_last = joiner is not None and joiner.kind is LinkKind.MEANWHILE and self._said.is_end(place + length)
            if joiner is None or not is_last:
                return None, 0
        return self._said.joint(joiner, place, place + length, length, None), place + length

    def _has_more(self, place: int, length: int) -> bool:
        """Whether a joiner begins a condition: "*if you can't* find my keys", but not "if you can't, wait"."""
        behind = self._said.words[place + length : place + length + 1]
        inside = self._said.words[place : place + length]
        return any(word.deprel in ("aux", "cop") and word.head == verb.index for verb in behind for word in inside)

    def _is_otherwise(self, joiner: Optional[Link], behind: int) -> bool:
        """Whether a deed stands behind a joiner for the other case, without a comma: "close it *otherwise* wait"."""
        is_other = joiner is not None and joiner.kind in (LinkKind.OTHERWISE, LinkKind.OR_ELSE)
        deeds = self._said.words[behind : behind + 1] if is_other else []
        return any(
            one.upos == "VERB" and bool(self._said.known.verbs_beginning_with(one.lemma.lower())) for one in deeds
        )

    def _is_front(self, place: int) -> bool:
        before = self._said.words[place - 1] if place else None
        return before is None or before.upos in ("PUNCT", "CCONJ") or self._said.forms[place - 1] in _BORDERS
