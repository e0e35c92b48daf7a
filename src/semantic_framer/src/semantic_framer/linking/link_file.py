"""Words that join deeds with conditions, times and other deeds: "until", "otherwise"; the file ``links.yaml``."""

from dataclasses import dataclass
from enum import Enum
from functools import lru_cache
from pathlib import Path
from typing import Dict, FrozenSet, List, Optional, Sequence, Tuple

import yaml

from checked_files.marked_yaml import Reader
from checked_files.source_files import read_text
from semantic_framer.values.phrase_table import PhraseTable

#: Next to this module in the source, devel and install space.
LINKS_FILE = Path(__file__).resolve().parent / "links.yaml"
_SECTIONS = ("links", "joiners", "checks", "answers", "deeds", "orders", "counts", "bounds", "bounds_behind")


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
    FOREVER = "again and again"  # until something else ends it
    AT_A_TIME = "at a time"  # a part of it each time, again and again until something else ends it
    AT_LEAST = "at least"  # so many times or more
    AT_MOST = "at most"  # so many times or fewer


@dataclass(frozen=True)
class Link:
    """A word, or several, that join something.

    Attributes:
        name: as in the file
        kind: what it means
        question: asks for what is missing behind it; empty for none
    """

    name: str
    kind: LinkKind
    question: str = ""


@dataclass(frozen=True)
class Links:
    """The content of the file.

    Attributes:
        links: what stands before a condition, by its words
        joiners: what stands before a deed, by its words
        checks: words before a condition that is checked first: "*check whether* it is open"
        answers: what stands behind such a condition, by its words: "*if so*, close it"
        deeds: what stands before a deed that another one precedes or follows, by its words
        orders: what says how several deeds, or all of them, are done, by its words
        counts: what stands before a number of times, by its words
        bounds: words before the longest time that something may take
        bounds_behind: words behind "for" and such a time: "for an hour *at most*"
    """

    links: PhraseTable[Link]
    joiners: PhraseTable[Link]
    checks: PhraseTable[bool]
    answers: PhraseTable[Link]
    deeds: PhraseTable[Link]
    orders: PhraseTable[Link]
    counts: PhraseTable[Link]
    bounds: PhraseTable[bool]
    bounds_behind: PhraseTable[bool]

    def link_at(self, forms: Sequence[str]) -> Tuple[Optional[Link], int]:
        """Return the link that words in lower case begin with, and its number of words; None and 0 for no link."""
        return self.links.at(forms)

    def joiner_at(self, forms: Sequence[str]) -> Tuple[Optional[Link], int]:
        """Return the joiner that words in lower case begin with, and its number of words; None and 0 for none."""
        return self.joiners.at(forms)

    def check_at(self, forms: Sequence[str]) -> int:
        """Return the number of words before a condition to be checked that words in lower case begin with; or 0."""
        return self.checks.at(forms)[1]

    def answer_at(self, forms: Sequence[str]) -> Tuple[Optional[LinkKind], int]:
        """Return in which case what follows is done, by the words in lower case behind a condition that is checked.

        Returns:
            IF or UNLESS, and the number of these words; None and 0 for other words
        """
        answer, length = self.answers.at(forms)
        if answer is not None:
            return answer.kind, length
        joiner, length = self.joiners.at(forms)
        is_other_case = joiner is not None and joiner.kind is LinkKind.OTHERWISE
        return (LinkKind.UNLESS, length) if is_other_case else (None, 0)

    def deed_link_at(self, forms: Sequence[str]) -> Tuple[Optional[Link], int]:
        """Return the words before a deed that words in lower case begin with, and their number; None and 0 for none."""
        return self.deeds.at(forms)

    def order_at(self, forms: Sequence[str]) -> Tuple[Optional[Link], int]:
        """Return the order that words in lower case begin with, and its number of words; None and 0 for none."""
        return self.orders.at(forms)

    def count_at(self, forms: Sequence[str]) -> Tuple[Optional[Link], int]:
        """Return the words before a number of times that words in lower case begin with, and their number."""
        return self.counts.at(forms)

    def has_manner(self, forms: FrozenSet[str]) -> bool:
        """Whether a phrase of an order, or before a number of times, may be among words in lower case."""
        near = (phrase for of in (self.orders, self.counts) for form in forms for phrase, _ in of.begins_with(form))
        return any(forms.issuperset(words) for words in near)

    def bound_at(self, forms: Sequence[str]) -> int:
        """Return the number of words of a bound that words in lower case begin with; 0 for none."""
        return self.bounds.at(forms)[1]

    def behind_bound_at(self, forms: Sequence[str]) -> int:
        """Return the number of words of a bound behind its time that words in lower case begin with; 0 for none."""
        return self.bounds_behind.at(forms)[1]


def load_links(text: str, path: str) -> Links:
    """Read a file of links.

    Args:
        text: content of the file
        path: path of the file, for problems
    Raises:
        FileRefused: the file is wrong; it lists every mistake
    """
    reader = Reader(path)
    sections = reader.mapping(reader.compose(text, "a mapping of links"), "", _SECTIONS, required=_SECTIONS)
    links, joiners, answers, deeds, orders, counts = (
        _entries(reader, sections.get(name), name)
        for name in ("links", "joiners", "answers", "deeds", "orders", "counts")
    )
    checks, bounds, behind = (
        PhraseTable({tuple(words.split()): True for words in reader.texts(sections.get(name), name)})
        for name in ("checks", "bounds", "bounds_behind")
    )
    reader.refuse_if_wrong()
    return Links(links, joiners, checks, answers, deeds, orders, counts, bounds, behind)


def _entries(reader: Reader, node: Optional[yaml.Node], section: str) -> PhraseTable[Link]:
    found: Dict[Tuple[str, ...], Link] = {}
    kinds: List[str] = [kind.name for kind in LinkKind]
    for key, item in reader.sequence(node, section):
        entries = reader.mapping(item, key, ("name", "kind", "question", "words"), required=("name", "kind", "words"))
        kind = reader.choice(entries.get("kind"), f"{key}.kind", kinds, LinkKind.THEN.name)
        name = reader.name(entries.get("name"), f"{key}.name")
        link = Link(name, LinkKind[kind], reader.text(entries.get("question"), f"{key}.question"))
        for words in reader.texts(entries.get("words"), f"{key}.words"):
            found[tuple(words.split())] = link
    return PhraseTable(found)


@lru_cache(maxsize=None)
def shipped_links() -> Links:
    """Return the links of ``links.yaml``, read once.

    Raises:
        FileRefused: the file is wrong
    """
    return load_links(read_text(str(LINKS_FILE)), str(LINKS_FILE))
