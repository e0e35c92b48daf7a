"""Splits an utterance by whom its parts address: "Alpha, go to the kitchen, and Beta, follow me"."""

from dataclasses import dataclass, replace
from typing import FrozenSet, List, Optional, Tuple

from command_server.cries import Kind as Cries
from command_server.stop_words import find_cry
from robot_fleet.address_words import address_words
from robot_fleet.designators import Group, Kind, called_ordinal_at, group_at, tokens_of
from robot_fleet.robot_names import Names, is_titled
from robot_fleet.vocatives import Calls

_MARKS = frozenset(",;:.!?…—–")
_ENDS = frozenset(".!?;…")
#: Whoever may begin a part of its own.
_CALLED = frozenset([Kind.NAME, Kind.UNKNOWN, Kind.OTHERS, Kind.OTHER_ONE, Kind.EVERYBODY])
#: More words than this do not stand between the beginning of a cry and whom it stops: "please stop moving, Alpha".
_LONGEST_CRY = 4


@dataclass(frozen=True)
class Part:
    """Words for certain robots.

    Attributes:
        group: who is addressed; None if the words do not say it
        text: what is said to them, without the address; empty for an address alone
        is_after: it is to be done after the parts before it
        is_told: somebody else is asked to pass it on ("tell Beta to ..."): "you" in it means that one
        told_by: who is asked to, if the words say it
    """

    group: Optional[Group]
    text: str
    is_after: bool = False
    is_told: bool = False
    told_by: Optional[Group] = None


def split_by_address(text: str, names: Names, verbs: FrozenSet[str]) -> Tuple[Part, ...]:
    """Split an utterance into parts, each for certain robots.

    Args:
        text: what was said
        names: of the robots
        verbs: words with which a command begins, in lower case
    Returns:
        at least one part, in the order in which they were said
    """
    return _Utterance(text, names, verbs).parts()


class _Utterance:
    def __init__(self, text: str, names: Names, verbs: FrozenSet[str]) -> None:
        self._text = text
        self._tokens = tokens_of(text)
        self._words = [token.word for token in self._tokens]
        self._names = names
        self._verbs = verbs
        known = address_words()
        self._lists, self._single = known.phrases, known.words
        self._calls = Calls(self._words, verbs)

    def parts(self) -> Tuple[Part, ...]:
        """Return the parts."""
        behind_front = self._behind_front()
        if behind_front:
            front = self._slice(0, behind_front)
            inner = _Utterance(self._text[self._tokens[behind_front].start :], self._names, self._verbs).parts()
            if all(part.text for part in inner):
                return tuple(replace(part, text=f"{front}, {part.text}") for part in inner)
        return self._told_behind_front() or self._parts()

    def _parts(self) -> Tuple[Part, ...]:
        parts: List[Part] = []
        position = 0
        while position < len(self._words):
            behind = self._behind_address(position)
            is_told = self._told_at(self._skip(position, len(self._words), "greetings")) is not None
            stopped = self._stopped_at(position, len(self._words))
            behind = behind if stopped is None else stopped[2]
            has_address = bool(parts) or behind > position or is_told
            end = self._next_address(behind, begin=position, has_address=has_address)
            parts.append(replace(self._part(position, end), is_after=bool(parts) and self._is_sequel(position)))
            position = end
        return tuple(part for part in parts if part.text or part.group) or (Part(None, self._text),)

    # Where an address begins.

    def _behind_front(self) -> int:
        """Return where an address begins behind "when the bell rings,", which is for all parts; 0 for none."""
        first = self._skip(0, len(self._words), "greetings")
        if not self._lists["fronts"].length_at(self._words, first):
            return 0
        for at in range(first + 2, len(self._words)):
            if self._words[at - 1] in _ENDS:
                return 0
            is_listed = self._names.at(self._words, at - 2)[0] or self._words[at - 2] in self._single["prepositions"]
            if self._words[at - 1] != "," or is_listed:
                continue
            group, behind = self._group_at(at, len(self._words))
            if group is not None and behind < len(self._words) and self._is_addressed(behind, needs_verb=True):
                return at
        return 0

    def _told_behind_front(self) -> Tuple[Part, ...]:
        """Return the parts of "Alpha, when the bell rings, tell Beta to go": Beta waits; empty for other texts."""
        begin = self._behind_address(0)
        first = self._skip(begin, len(self._words), "greetings")
        if not self._lists["fronts"].length_at(self._words, first):
            return ()
        for at in range(first + 2, len(self._words)):
            if self._words[at - 1] in _ENDS:
                return ()
            if self._words[at - 1] != "," or not (self._words[at] in self._verbs or self._told_at(at)):
                continue
            front = self._slice(first, at)
            # Nobody else can wait for what the robot itself does or sees.
            if any(word in self._single["you"] for word in self._words[first:at]):
                return ()
            address = self._text[: self._tokens[first].start] if begin else ""
            rest = address + self._text[self._tokens[at].start :]
            inner = _Utterance(rest, self._names, self._verbs).parts()
            if not any(part.is_told for part in inner):
                return ()
            return tuple(
                replace(part, text=f"{front}, {part.text}") if part.is_told or not number else part
                for number, part in enumerate(inner)
            )
        return ()

    def _is_sequel(self, position: int) -> bool:
        """Whether the part at a position is to be done after those before it."""
        while self._words[position] in _MARKS:
            position += 1
        return self._lists["sequels"].length_at(self._words, position) > 0

    def _behind_address(self, position: int) -> int:
        """Return where the words behind an address begin, if one stands at a position; else that position."""
        start = self._skip(position, len(self._words), "greetings")
        if not self._group_at(start, len(self._words))[0]:
            start = self._skip(start, len(self._words), "kept_before")
        behind = self._group_at(start, len(self._words))[1]
        return behind if behind > start else position

    def _group_at(self, position: int, end: int) -> Tuple[Optional[Group], int]:
        """Return who is addressed at a position: also a name that no robot has, where somebody is called by it."""
        group, behind = called_ordinal_at(self._words[:end], position, self._names)
        if group is not None and self._calls.is_called(behind):
            return group, behind
        group, behind = group_at(self._words[:end], position, self._names)
        called, behind_called = group_at(self._words[:end], position, self._names, self._calls.is_name)
        if behind_called > behind and self._calls.is_called(behind_called):
            return called, behind_called
        return group, behind

    def _next_address(self, position: int, *, begin: int, has_address: bool) -> int:
        """Return where the next part begins, behind the one from `begin` on, whose address ends at `position`."""
        for at in range(position + 1, len(self._words)):
            before = self._words[at - 1]
            is_set_off = before in _MARKS
            links = self._links_at(at)
            if not is_set_off and not links:
                continue
            if before in _ENDS and self._is_apart(begin, at):
                return at
            group, behind = self._group_at(at + links, len(self._words))
            if group is not None and group.kinds & _CALLED:
                is_new_sentence = before in _ENDS and not links
                is_last = behind >= len(self._words) or all(word in _MARKS for word in self._words[behind:])
                if is_last or not (
                    has_address or is_new_sentence or (links and self._is_second_order(begin, at, behind))
                ):
                    continue
                if self._is_addressed(behind, needs_verb=True):
                    return at
            elif links and self._is_for_another(at + links, begin):
                return at
        return len(self._words)

    def _is_second_order(self, begin: int, link: int, behind: int) -> bool:
        """Whether "turn left and Beta turn right" are two orders; "when Alpha and Beta come here" only names them."""
        first = self._skip(begin, link, "greetings")
        if self._lists["fronts"].length_at(self._words, first):
            return self._calls.is_called(behind, needs_pause=True)
        is_list = any(group_at(self._words[:link], at, self._names)[1] == link for at in range(begin, link))
        return self._calls.is_called(behind, needs_pause=is_list or not self._calls.begins_order(first))

    def _is_for_another(self, position: int, begin: int) -> bool:
        """Whether an order for somebody else begins behind "and": not where a front holds for the whole."""
        if self._lists["fronts"].length_at(self._words, self._skip(begin, position, "greetings")):
            return False
        if (self._told_at(position) or self._stopped_at(position, len(self._words))) is not None:
            return True
        is_asked = self._words[position : position + 1] and self._words[position] in self._single["auxiliaries"]
        group, behind = self._group_at(position + 1, len(self._words)) if is_asked else (None, position)
        return group is not None and self._is_verb_at(behind)

    def _is_apart(self, begin: int, end: int) -> bool:
        """Whether an address ends the sentences before a position, or the one behind it: each is for its own robot."""
        following = next((at for at in range(end, len(self._words)) if self._words[at] in _ENDS), len(self._words))
        return self._trailing(begin, end) is not None or self._trailing(end, following) is not None

    def _links_at(self, at: int) -> int:
        """Return the number of words at a position that link two orders: "and", "then"."""
        return self._lists["sequels"].length_at(self._words, at) or self._lists["connectors"].length_at(self._words, at)

    def _is_addressed(self, behind: int, *, needs_verb: bool = False) -> bool:
        """Whether what stands before a position is addressed, by what follows it."""
        if behind >= len(self._words) or self._calls.modal_at(behind) is not None:
            return True
        word = self._words[behind]
        following = self._words[behind + 1] if behind + 1 < len(self._words) else ""
        if word in _MARKS:
            # "Beta, go to the hall, and Gamma, you go to the office."
            at = behind + 2 if following in self._single["you"] else behind + 1
            following = self._words[at] if at < len(self._words) else ""
            is_verb = following in self._verbs or following in self._single["behind_names"]
            return not needs_verb or is_verb or self._lists["polite"].length_at(self._words, behind + 1) > 0
        if word in self._single["before_you"]:
            return following in self._single["you"]
        return word in self._verbs or word in self._single["behind_names"]

    # One part.

    def _part(self, begin: int, end: int) -> Part:
        position = begin
        if begin:
            while position < end and (self._words[position] in _MARKS or self._links_at(position)):
                position += max(1, self._links_at(position))
        kept = position
        stopped = self._stopped_at(position, end)
        if stopped is not None:
            group, start, behind = stopped
            return Part(group, self._joined(position, start, behind, end))
        skipped = self._skip(position, end, "greetings")
        for start in dict.fromkeys((skipped, self._skip(position, end, "kept_before"))):
            part = self._leading(kept, start, end)
            if part is not None:
                return part
        told = self._told_at(skipped)
        if told is not None and told[1] < end:
            group, vp, negation = told
            return Part(group, negation + self._slice(vp, end), is_told=True)
        return self._trailing(position, end) or self._inner(position, end) or Part(None, self._slice(position, end))

    def _skip(self, position: int, end: int, name: str) -> int:
        while position < end:
            length = self._lists[name].length_at(self._words, position)
            if not length and self._words[position] != ",":
                break
            position += max(1, length)
        return position

    def _leading(self, begin: int, start: int, end: int) -> Optional[Part]:
        """An address before the words: "Hey Alpha, come here", "could somebody come here"."""
        group, behind = self._group_at(start, end)
        modal = self._calls.modal_at(behind) if group is not None else None
        if modal is not None and modal[1] < end:
            return Part(group, f"{modal[0]} {self._slice(modal[1], end)}")
        if group is not None and self._is_addressed(min(behind, end)):
            rest = behind
            while rest < end and self._words[rest] in _MARKS:
                rest += 1
            told = self._told_at(self._skip(rest, end, "greetings")) if rest < end else None
            if told is not None and told[1] < end:
                return Part(told[0], told[2] + self._slice(told[1], end), is_told=True, told_by=group)
            if all(word in _MARKS or word in self._lists["polite"] for word in self._words[rest:end]):
                return Part(group, "")
            is_kept = begin < start and self._words[begin] in self._single["kept_before"]
            before = self._text[self._tokens[begin].start : self._tokens[start].start] if is_kept else ""
            return Part(group, (before + self._slice(rest, end)).strip())
        word = self._words[start] if start < end else ""
        if word in self._single["auxiliaries"]:
            group, behind = self._group_at(start + 1, end)
            if group is not None and behind < end and self._is_verb_at(behind):
                return Part(group, f"{word} you {self._slice(behind, end)}")
        return None

    def _is_verb_at(self, position: int) -> bool:
        position += self._lists["polite"].length_at(self._words, position)
        return position < len(self._words) and self._words[position] in self._verbs

    def _told_at(self, position: int) -> Optional[Tuple[Group, int, str]]:
        """Return who is told something at a position, where that begins, and its negation: "tell Beta not to wait"."""
        position += self._lists["polite"].length_at(self._words, position)
        for name, needs_to in (("tell_to", True), ("want_to", True), ("have", False)):
            length = self._lists[name].length_at(self._words, position)
            if not length:
                continue
            group, behind = group_at(self._words, position + length, self._names)
            if group is None:
                group, behind = self._stopped_by_name(position + length)
            if group is None or behind >= len(self._words):
                continue
            is_negated = self._words[behind] in self._single["negations"]
            at = behind + is_negated
            if at < len(self._words) and self._words[at] == "to" and at + 1 < len(self._words):
                return group, at + 1, "don't " if is_negated else ""
            if not needs_to and self._words[behind] in self._verbs:
                return group, behind, ""
            if needs_to and self._words[behind] == ":" and behind + 1 < len(self._words):
                return group, behind + 1, ""
        return None

    def _stopped_by_name(self, position: int) -> Tuple[Optional[Group], int]:
        """Return who is told to stop by a name that no robot has, which may be misheard: "tell *Luna* to stop"."""
        group, behind = group_at(self._words, position, self._names, self._calls.is_name)
        negated = self._words[behind : behind + 1] == ["not"]
        at = behind + negated
        at += self._words[at : at + 1] == ["to"]
        order = ["do not"] * negated + self._words[at:]
        cry = find_cry(" ".join(order)) if group is not None else None
        return (group, behind) if cry is not None and cry.kind is Cries.STOP and not cry.before else (None, position)

    def _stopped_at(self, begin: int, end: int) -> Optional[Tuple[Group, int, int]]:
        """Return who is stopped without a comma, and where that stands: "stop Alpha", "stop Alpha and go back"."""
        if self._behind_address(begin) > begin:
            return None
        for start in range(begin + 1, min(end, begin + _LONGEST_CRY + 1)):
            group, behind = group_at(self._words[:end], start, self._names, self._is_marked_name)
            if group is None:
                continue
            before = self._words[start - 1]
            if before in _MARKS or before in self._single["prepositions"] or self._is_done_to_it(before):
                return None
            is_end = all(word in _MARKS for word in self._words[self._behind_last(behind, end) : end])
            if not is_end and not self._links_at(behind):
                return None
            is_cry = find_cry(" ".join(self._words[begin:start])) is not None
            return (group, start, behind) if is_cry else None
        return None

    def _is_marked_name(self, word: str) -> bool:
        """Whether a word behind a cry is no thing: it has a capital or a title, "stop Luna", "stop robot max"."""
        return self._calls.is_name(word) and any(
            token.word == word and (self._text[token.start].isupper() or is_titled(self._words, at))
            for at, token in enumerate(self._tokens)
            if at
        )

    def _is_done_to_it(self, word: str) -> bool:
        """Whether a name behind a word is rather its object: "stop following Alpha"."""
        return word.endswith("ing") and word not in self._single["motions"]

    def _behind_last(self, position: int, end: int) -> int:
        """Return the position behind what may follow a name at the end: "please", "right now"."""
        while position < end:
            length = max(self._lists[name].length_at(self._words, position) for name in ("polite", "behind_last_names"))
            if not length and self._words[position] != ",":
                break
            position += max(1, length)
        return position

    def _joined(self, begin: int, start: int, behind: int, end: int) -> str:
        """Return the text of words without those from one position to another."""
        first, second = self._slice(begin, start), self._slice(behind, end)
        return f"{first}{second}" if second[:1] in _MARKS else f"{first} {second}".strip()

    def _trailing(self, begin: int, end: int) -> Optional[Part]:
        """An address behind the words: "come here, Alpha"."""
        last = end
        while last > begin and (self._words[last - 1] in _MARKS or self._words[last - 1] in self._single["polite"]):
            last -= 1
        for start in range(begin + 1, last):
            group, behind = group_at(self._words[:last], start, self._names)
            if (group is None or behind != last) and self._words[start - 1] == ",":
                group, behind = self._unknown_at(start, last)
            if group is None or behind != last:
                continue
            if self._is_set_off_at(start, begin, group):
                return Part(group, self._slice(begin, start))
        return None

    def _unknown_at(self, start: int, end: int) -> Tuple[Optional[Group], int]:
        """Return a name behind a comma that no robot has: "turn left, Luna". A list of several may be of things."""
        group, behind = group_at(self._words[:end], start, self._names, self._calls.is_name)
        if group is None or (len(group.unknown) > 1 and not group.names):
            return None, start
        first = next((at for at in range(start) if self._calls.begins_order(at)), None)
        is_order = first is not None or find_cry(" ".join(self._words[: start - 1])) is not None
        return (group, behind) if is_order else (None, start)

    def _is_set_off_at(self, start: int, begin: int, group: Group) -> bool:
        before = self._words[start - 1]
        if before == ",":
            # "To Alpha, Beta, Gamma" is a list.
            is_list = start - 4 >= begin and self._words[start - 3] == "," and self._names.at(self._words, start - 4)[0]
            return self._words[start - 2] not in self._single["prepositions"] and not is_list
        if (
            self._calls.ends_amount(start)
            or before in self._single["before_last_names"]
            or (Kind.BOTH in group.kinds or (Kind.EVERYBODY in group.kinds and len(self._words[start:]) > 1))
        ):
            return before not in self._single["prepositions"] and before not in self._verbs
        first = self._words[begin]
        return before in self._single["pronouns"] and first not in self._single["ditransitives"]

    def _inner(self, begin: int, end: int) -> Optional[Part]:
        """An address between commas: "go to the kitchen, Alpha, and bring me a cup"."""
        for start in range(begin + 2, end):
            if self._words[start - 1] != ",":
                continue
            group, behind = group_at(self._words[:end], start, self._names)
            if group is None:
                group, behind = self._unknown_at(start, end)
            if group is None or behind >= end or self._words[behind] != ",":
                continue
            if self._names.at(self._words, start - 2)[0] or self._words[start - 2] in self._single["prepositions"]:
                continue
            joined = " " if self._links_at(behind + 1) else ", "
            return Part(group, f"{self._slice(begin, start)}{joined}{self._slice(behind + 1, end)}".strip(" ,"))
        return None

    def _slice(self, begin: int, end: int) -> str:
        """Return the text of words, without the commas around it."""
        while begin < end and self._words[begin] in (",", ":", "—", "–"):
            begin += 1
        while end > begin and self._words[end - 1] in (",", ":", ";", "—", "–"):
            end -= 1
        if begin >= end:
            return ""
        behind = self._tokens[end].start if end < len(self._tokens) else len(self._text)
        text = self._text[self._tokens[begin].start : behind].strip(" ,:")
        return text if text.count('"') % 2 == 0 else text.replace('"', "").strip()
