"""Words that join deeds with conditions, times and other deeds: "until", "otherwise"; the file ``links.yaml``."""

from dataclasses import dataclass
from enum import Enum
from functools import lru_cache
from pathlib import Path
from typing import Dict, FrozenSet, Mapping, Optional, Sequence, Tuple

import yaml

from checked_files.marked_yaml import Reader
from checked_files.source_files import read_text
from semantic_framer.linking.elliptic_clauses import Case, elliptic_clause
from semantic_framer.values.phrase_table import PhraseTable
from word_classes import word_class

#: Next to this module in the source, devel and install space.
LINKS_FILE = Path(__file__).resolve().parent / "links.yaml"
_TABLES = ("links", "joiners", "afterwards", "answers", "deeds", "orders", "limits")
_LISTS = ("checks", "adverbs", "adverbs_of_nearness", "reversals")
_WHETHER = word_class("whether_words")
_NOT = word_class("not")
_CONJUNCTIONS = word_class("linking_conjunctions") | {"or"}
_ONLY = word_class("restricting_adverbs")
_ITERATIONS = word_class("iteration_nouns")
_WISHING = word_class("wishing_verbs") | {"want"}
_HEADS_OF_ORDER = frozenset(["order", "sequence"])
_BEFORE_ORDER = word_class("articles") | word_class("exact_adverbs")
_POINTING = word_class("pronouns_of_things")
#: What leaves an order open: "in *any* order", "in *no* particular order", besides "in *whatever* order".
_ANY = frozenset(["no"]) | word_class("indefinite_articles") - word_class("articles")
#: The most words of "in any order that you like" before and behind "order".
_LONGEST_ORDER = 6
#: Limits that need no preposition: "*minimum* two times".
_ADVERBIAL = frozenset(["minimum", "maximum"])
#: Comparatives of a limit: "no *more* than", "no *fewer* than".
_COMPARATIVES = frozenset(["more", "longer"]), frozenset(["less", "fewer"])


class LinkKind(Enum):
    """What a word means for what it joins."""

    UNTIL = "until"  # what runs ends when the condition holds
    WHILE = "while"  # what runs ends when the condition ends
    IF = "if"  # whether the condition holds now
    UNLESS = "unless"  # whether it does not hold now
    WHEN = "when"  # as soon as it holds; now, if it holds already
    ANEW = "next time"  # as soon as it begins to hold
    WHENEVER = "whenever"  # each time that it begins to hold
    CLOCK = "at"  # at a time of the clock
    DELAY = "delay"  # after a time
    PERIOD = "period"  # again and again, after a time each
    OTHERWISE = "otherwise"  # if the condition does not hold
    OR_ELSE = "or else"  # if what was said before fails
    MEANWHILE = "meanwhile"  # at the same time as what was said before
    THEN = "then"  # after what was said before
    BEFORE = "before"  # the deed behind it follows the others
    AFTER = "after"  # the deed behind it comes before the others
    BEFOREHAND = "beforehand"  # what may happen meanwhile, and nobody waits for: "before Anna comes in"
    ANY_ORDER = "in any order"  # a list, or deeds, in any order
    IN_ORDER = "in this order"  # in the order in which they are said
    REVERSED = "in reverse order"  # the last one first
    ROUND = "and so on"  # all deeds before it again and again
    NOT_BEFORE = "not until then"  # what is forbidden until another deed is done, behind that deed
    BEFORE_THAT = "before that"  # the last deed comes before the one before it
    ALTERNATING = "back and forth"  # from the first to the last one and back, again and again
    RETURNING = "and back"  # from the first to the last one and back
    FOREVER = "again and again"  # until something else ends it
    AT_A_TIME = "at a time"  # a part of it each time, again and again until something else ends it
    TIMES = "times"  # so many times
    AT_LEAST = "at least"  # so many times or more
    AT_MOST = "at most"  # so many times or fewer


@dataclass(frozen=True)
class Link:
    """A word, or several, that join something.

    Attributes:
        kind: what it means
    """

    kind: LinkKind

    @property
    def question(self) -> str:
        """Asks for the condition that is missing behind it."""
        return f"{self.kind.value.capitalize()} {'when' if self.kind is LinkKind.UNTIL else 'what'}?"


@dataclass(frozen=True)
class Links:
    """The content of the file, and the rules that make longer words of it.

    Attributes:
        links: what stands before a condition, by its words
        joiners: what stands before a deed, by its words
        afterwards: the joiners that also stand behind a deed
        checks: verbs before a condition that is checked first: "*check* whether it is open"
        answers: what stands behind a condition that is checked, by its words: "*if so*, close it"
        deeds: what stands before a deed that another one precedes or follows, by its words
        adverbs: may stand before a link: "*only* when"
        adverbs_of_nearness: may stand before "before" and "after"
        orders: what says how several deeds, or all of them, are done, by its words
        reversals: what turns the order round, before "order"
        limits: a least or a largest number, by its superlative: "at the *most*"
    """

    links: PhraseTable[Link]
    joiners: PhraseTable[Link]
    afterwards: PhraseTable[Link]
    checks: FrozenSet[str]
    answers: PhraseTable[Link]
    deeds: PhraseTable[Link]
    adverbs: FrozenSet[str]
    adverbs_of_nearness: FrozenSet[str]
    orders: PhraseTable[Link]
    reversals: FrozenSet[str]
    limits: Mapping[str, Link]

    def link_at(self, forms: Sequence[str]) -> Tuple[Optional[Link], int]:
        """Return the link that words in lower case begin with, and its number of words; None and 0 for no link."""
        return self._behind_adverbs(self.links, forms)

    def deed_link_at(self, forms: Sequence[str]) -> Tuple[Optional[Link], int]:
        """Return the words before a deed that words in lower case begin with, and their number; None and 0 for none."""
        return self._behind_adverbs(self.deeds, forms)

    def _behind_adverbs(self, table: PhraseTable[Link], forms: Sequence[str]) -> Tuple[Optional[Link], int]:
        """Return the link behind adverbs and "but": "*but only* if", "*right* after"."""
        place = int(list(forms[:1]) == ["but"])
        while forms[place : place + 1] and forms[place] in self.adverbs | self.adverbs_of_nearness:
            place += 1
        link, length = table.at(forms[place:])
        adverbs = forms[:place]
        is_of_time = forms[place : place + 1] and forms[place] in ("before", "after")
        is_said = is_of_time or (adverbs[-1:] and adverbs[-1] in self.adverbs) or not adverbs
        return (link, place + length) if link is not None and is_said else (None, 0)

    def joiner_at(self, forms: Sequence[str]) -> Tuple[Optional[Link], int]:
        """Return the joiner that words in lower case begin with, and its number of words; None and 0 for none."""
        joiner, length = self.joiners.at(forms)
        if joiner is not None:
            return joiner, length
        place = 0
        while forms[place : place + 1] and forms[place] in _CONJUNCTIONS | _ONLY:
            place += 1
        joiner, length = self.joiners.at(forms[place:])
        if joiner is None:
            clause = elliptic_clause(forms[place:])
            kind = _JOINERS.get(clause.case) if clause is not None else None
            joiner, length = (Link(kind), clause.length) if clause is not None and kind else (None, 0)
        return (joiner, place + length) if joiner is not None else (None, 0)

    def beginning_at(self, forms: Sequence[str], *, is_front: bool) -> Tuple[Optional[LinkKind], int]:
        """Return when a command begins, by words in lower case before or behind it.

        Returns:
            THEN or MEANWHILE, and the number of these words: "and then", "meanwhile"; None and 0 for other words
        """
        place = int(list(forms[:1]) == ["and"]) if is_front else 0
        has_then = is_front and list(forms[place : place + 1]) == ["then"]
        place += has_then
        joiner, length = self.afterwards.at(forms[place:])
        if joiner is None:
            joiner, length = self.joiners.at(forms[place:])
            is_next = is_front and list(forms[place : place + 1]) == ["next"]
            joiner = joiner if joiner is not None and (is_next or joiner.kind is LinkKind.MEANWHILE) else None
        clause = None if joiner is not None else elliptic_clause(forms[place:])
        kind = joiner.kind if joiner is not None else None
        if clause is not None and clause.case in (Case.DONE, Case.GOES_ON):
            kind, length = _JOINERS[clause.case], clause.length
        if kind is not None:
            return kind, place + length
        return (LinkKind.THEN, place) if has_then else (None, 0)

    def check_at(self, forms: Sequence[str]) -> int:
        """Return the number of words before a condition to be checked that words in lower case begin with; or 0."""
        place = 1 if forms and forms[0] in self.checks else 0
        place += list(forms[place : place + 1]) == ["out"]
        place += 2 * (list(forms[place : place + 2]) == ["to", "see"])
        return place + 1 if place and forms[place : place + 1] and forms[place] in _WHETHER else 0

    def answer_at(self, forms: Sequence[str]) -> Tuple[Optional[LinkKind], int]:
        """Return in which case what follows is done, by the words in lower case behind a condition that is checked.

        Returns:
            IF or UNLESS, and the number of these words; None and 0 for other words
        """
        length = self.case_at(forms)
        if length:
            return LinkKind.IF, length
        joiner, length = self.joiner_at(forms)
        is_other_case = joiner is not None and joiner.kind is LinkKind.OTHERWISE
        return (LinkKind.UNLESS, length) if is_other_case else (None, 0)

    def case_at(self, forms: Sequence[str]) -> int:
        """Return the number of words that words in lower case begin with for "if so"; 0 for other words."""
        place = int(list(forms[:1]) == ["and"])
        place += place and int(list(forms[place : place + 1]) == [","])
        clause = elliptic_clause(forms[place:])
        length = clause.length if clause is not None and clause.case is Case.HOLDS else 0
        length = length or self.answers.at(forms[place:])[1]
        return place + length if length else 0

    def order_at(self, forms: Sequence[str]) -> Tuple[Optional[Link], int]:
        """Return the order that words in lower case begin with, and its number of words; None and 0 for none."""
        link, length = self.orders.at(forms)
        if link is not None or list(forms[:1]) != ["in"]:
            return link, length
        head = next((place for place, form in enumerate(forms[:_LONGEST_ORDER]) if form in _HEADS_OF_ORDER), 0)
        before = frozenset(forms[1:head])
        more = _length_of_wish(forms[head + 1 :])
        if head and before & self.reversals and before <= self.reversals | _BEFORE_ORDER:
            return Link(LinkKind.REVERSED), head + 1
        if len(before) == 1 and before <= _POINTING:
            return Link(LinkKind.IN_ORDER), head + 1
        is_open = more or any(form in _ANY or form.endswith("ever") for form in before)
        return (Link(LinkKind.ANY_ORDER), head + 1 + more) if head and is_open else (None, 0)

    def count_at(self, forms: Sequence[str]) -> Tuple[Optional[Link], int]:
        """Return the words before a number of times that words in lower case begin with, and their number."""
        kind, length = self._limit_at(forms)
        return (Link(kind), length) if kind is not None else (None, 0)

    def choice_at(self, forms: Sequence[str]) -> Tuple[Optional[Link], int]:
        """Return the words behind a number that make a bound of it, and their number: "or more", "or less"."""
        more, less = _COMPARATIVES
        if list(forms[:1]) != ["or"] or len(forms) < 2 or forms[1] not in more | less:
            return None, 0
        return Link(LinkKind.AT_LEAST if forms[1] in more else LinkKind.AT_MOST), 2

    def has_manner(self, forms: FrozenSet[str]) -> bool:
        """Whether a phrase of an order, or before a number of times, may be among words in lower case."""
        near = (phrase for form in forms for phrase, _ in self.orders.begins_with(form))
        more, less = _COMPARATIVES
        words = _HEADS_OF_ORDER | self.limits.keys() | more | less | _ONLY | _ITERATIONS | {"than", "up"}
        return bool(forms & words) or any(forms.issuperset(words) for words in near)

    def _limit_at(self, forms: Sequence[str]) -> Tuple[Optional[LinkKind], int]:
        """Return whether words in lower case begin with a least or a largest number, and the number of words of the
        limit: "at the most", "no fewer than", "a maximum of".
        """
        place = int(list(forms[:1]) in (["but"], ["on"]))
        said = list(forms[place : place + 3])
        if said[:2] == ["up", "to"]:
            return LinkKind.AT_MOST, place + 2
        if said[:2] == ["at", "the"]:
            said, place = ["at", *forms[place + 2 : place + 3]], place + 1
        limit = self.limits.get(said[1]) if len(said) > 1 else None
        if said[:1] and said[0] in _ADVERBIAL and said[0] in self.limits:
            return self.limits[said[0]].kind, place + 1
        if limit is not None and said[0] == "at":
            return limit.kind, place + 2
        if limit is not None and said[0] == "a" and said[2:] == ["of"]:
            return limit.kind, place + 3
        more, less = _COMPARATIVES
        if len(said) == 3 and said[0] in _NOT | {"no"} and said[2] == "than" and said[1] in more | less:
            return LinkKind.AT_MOST if said[1] in more else LinkKind.AT_LEAST, place + 3
        return None, 0

    def bound_at(self, forms: Sequence[str]) -> int:
        """Return the number of words of a bound that words in lower case begin with; 0 for none."""
        place = int(list(forms[:1]) == ["but"])
        place += list(forms[place : place + 1]) == ["for"]
        kind, length = self._limit_at(forms[place:])
        return place + length if kind is LinkKind.AT_MOST else 0

    def behind_bound_at(self, forms: Sequence[str]) -> int:
        """Return the number of words of a bound behind its time that words in lower case begin with; 0 for none."""
        kind, length = self._limit_at(forms) if list(forms[:1]) == ["at"] else (None, 0)
        return length if kind is LinkKind.AT_MOST else 0


#: What a clause without a deed of its own means before a deed.
_JOINERS = {
    Case.HOLDS_NOT: LinkKind.OTHERWISE,
    Case.FAILED: LinkKind.OR_ELSE,
    Case.DONE: LinkKind.THEN,
    Case.GOES_ON: LinkKind.MEANWHILE,
}


def _length_of_wish(forms: Sequence[str]) -> int:
    """Return the number of words behind "order" that leave it open: "you like", "that you want"."""
    place = int(list(forms[:1]) == ["that"])
    is_wish = list(forms[place : place + 1]) == ["you"] and forms[place + 1 : place + 2]
    return place + 2 if is_wish and forms[place + 1] in _WISHING else 0


def load_links(text: str, path: str) -> Links:
    """Read a file of links.

    Args:
        text: content of the file
        path: path of the file, for problems
    Raises:
        FileRefused: the file is wrong; it lists every mistake
    """
    reader = Reader(path)
    sections = (*_TABLES, *_LISTS)
    nodes = reader.mapping(reader.compose(text, "a mapping of links"), "", sections, required=sections)
    words = {name: _words(reader, nodes.get(name), name) for name in _TABLES}
    lists = {name: frozenset(reader.texts(nodes.get(name), name)) for name in _LISTS}
    reader.refuse_if_wrong()
    words["joiners"].update(words["afterwards"])
    table = {name: PhraseTable(phrases) for name, phrases in words.items()}
    return Links(
        links=table["links"],
        joiners=table["joiners"],
        afterwards=table["afterwards"],
        checks=lists["checks"],
        answers=table["answers"],
        deeds=table["deeds"],
        adverbs=lists["adverbs"],
        adverbs_of_nearness=lists["adverbs_of_nearness"],
        orders=table["orders"],
        reversals=lists["reversals"],
        limits={phrase[0]: link for phrase, link in words["limits"].items()},
    )


def _words(reader: Reader, node: Optional[yaml.Node], section: str) -> Dict[Tuple[str, ...], Link]:
    kinds = [kind.name for kind in LinkKind]
    entries = reader.mapping(node, section, kinds) if node is not None else {}
    return {
        tuple(words.split()): Link(LinkKind[kind])
        for kind, item in entries.items()
        for words in reader.texts(item, f"{section}.{kind}")
    }


@lru_cache(maxsize=None)
def shipped_links() -> Links:
    """Return the links of ``links.yaml``, read once.

    Raises:
        FileRefused: the file is wrong
    """
    return load_links(read_text(str(LINKS_FILE)), str(LINKS_FILE))
