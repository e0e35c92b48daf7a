"""Finds words that say in which order deeds or the items of a list are done, and how often.

"Before you go, close the door", "go to the hall after closing the door", "visit the hall and the office in any order",
"visit the office only after the hall", "at least twice".
"""

from typing import FrozenSet, List, NamedTuple, Optional, Sequence, Tuple

from semantic_framer.linking.link_file import Link, LinkKind, shipped_links
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.iterations import times_said
from semantic_framer.values.order_words import FIRST, LAST
from utterance_passes.trees.tree import NOUNS, DependencyTree, Word
from word_classes import word_class

_HEARERS = word_class("hearers")
_HAVE = word_class("forms_of_have") | {"having", "'ve"}
_NEGATIONS = word_class("negations")
_ALL = word_class("determiners_of_all")
_EXACT = word_class("exact_adverbs")
_ONLY = word_class("restricting_adverbs")
_MARKS = frozenset([",", ".", "!", "?", ";"])
_LISTING = frozenset([",", "and"])
_JOINING = word_class("clause_borders") | {","}
_BEING_THERE = word_class("verbs_of_being_there")
_DOING = word_class("forms_of_do")
_ENTERING = word_class("verbs_of_going") | word_class("verbs_of_arriving")
_AVOIDING, _STAYING = word_class("verbs_of_avoiding"), word_class("verbs_of_staying")
_UNTIL = word_class("conjunctions_of_ends")
#: Where the other deed leads.
_THERE = word_class("here_and_there") | {"it"}
_CONTENT = frozenset(["NOUN", "PROPN", "ADJ", "NUM"])
#: "Visit *the office after* the hall", "go *to* the office after ...", "visit the yard *and* the office after ...".
_BEFORE_LIST = frozenset(["VERB", "ADP", "CCONJ"])
#: Tags of the verb behind "before you", "before you have" and "before".
_BARE = frozenset(["VB", "VBP"])
#: The longest phrase that names a thing, in words.
_LONGEST_PHRASE = 5


class DeedBehind(NamedTuple):
    """Words before a deed that another deed precedes or follows.

    Attributes:
        kind: BEFORE, AFTER or MEANWHILE
        length: number of the words: "before", "before you", "after having"
        verb: position of the verb of the deed in the sentence
        is_kept_out: whether the robot keeps out of where the other deed leads until then: ", but do not enter it before
            you have been to"
    """

    kind: LinkKind
    length: int
    verb: int
    is_kept_out: bool = False


class Times(NamedTuple):
    """A least or a largest number of times, and the number of its words."""

    kind: LinkKind
    number: int
    length: int


class ItemOrder(NamedTuple):
    """Which of two items of a list comes before the other.

    Attributes:
        length: number of words that say so
        earlier, later: the content words of each item; empty for all other items: "visit the office *last*"
        is_list: whether these words are the list: "the office only after the hall"; else the items were said before
        is_doubtful: whether they may say where a thing is: "the room before the office"
        border: place of "before" or "after" among the words; only for a new list
        second: place of the noun of the second item
        more: the earlier and the later item of further pairs: "the office only after the hall *and the yard*"
    """

    length: int
    earlier: FrozenSet[str]
    later: FrozenSet[str]
    is_list: bool = False
    is_doubtful: bool = False
    border: int = 0
    second: int = 0
    more: Tuple[Tuple[FrozenSet[str], FrozenSet[str]], ...] = ()


def deed_behind(words: Sequence[Word], forms: Sequence[str], known: FramedLexicon) -> Optional[DeedBehind]:
    """Return the words before a deed that some words begin with; None if they begin with others.

    Args:
        words: from the first of them to the end of the sentence
        forms: their forms in lower case
        known: lexical units; the deed must begin with one of their verbs
    """
    link, place = shipped_links().deed_link_at(forms)
    is_kept_out = False
    if link is None:
        link, place, is_kept_out = _prohibition_at(words, forms)
    if link is None and words[0].index == 1 and forms[0] in _UNTIL and "," in forms:
        # "*Until you have* been to the hall, stay out of the office; then go to the office."
        comma = list(forms).index(",")
        is_kept_out = _length_of_prohibition(words[comma + 1 :], forms[comma + 1 :]) > 1
        link, place = (Link(LinkKind.AFTER), 1) if is_kept_out else (None, 0)
    if link is None and forms[0] == "having":
        link = Link(LinkKind.AFTER)  # "*Having* closed the door, go to the hall."
    if link is None:
        return None
    tags: FrozenSet[str] = frozenset(["VBG"])
    if forms[place : place + 1] and forms[place] in _HEARERS:
        place, tags = place + 1, _BARE
    if forms[place : place + 1] and forms[place] in _HAVE:
        place, tags = place + 1, frozenset(["VBN", "VBD"])
    if place >= len(words) or words[place].xpos not in tags:
        return None
    verb = words[place]
    if verb.deprel == "cop" and list(forms[place + 1 : place + 2]) == ["to"]:
        return DeedBehind(link.kind, place, verb.index, is_kept_out)  # "After you have *been to* the hall."
    spoken = {verb.lemma.lower(), " ".join([verb.lemma, *forms[place + 1 : place + 2]]).lower()}
    if link.kind is LinkKind.BEFORE and spoken & _BEING_THERE:
        return None  # "Turn left before you reach the stairs" does not send the robot there.
    return (
        DeedBehind(link.kind, place, verb.index, is_kept_out)
        if known.verbs_beginning_with(verb.lemma.lower())
        else None
    )


def prohibition_behind(words: Sequence[Word], place: int) -> int:
    """Return the number of words of a prohibition behind its end: "until you have visited the hall*, stay out of the
    office*; then go there"; 0 for other words.

    Args:
        words: of the sentence
        place: where the words may begin
    """
    if words[0].said not in _UNTIL or words[place].said != ",":
        return 0
    behind = words[place + 1 :]
    length = _length_of_prohibition(behind, [word.said for word in behind])
    return length + 1 if length > 1 else 0


def _prohibition_at(words: Sequence[Word], forms: Sequence[str]) -> Tuple[Optional[Link], int, bool]:
    """Return the words that forbid a deed until another one is done: ", but not until", ", but do not enter it before".

    Returns:
        AFTER, the number of the words, and whether a place must not be entered; None, 0 and False for other words
    """
    place = 0
    while place < len(forms) and forms[place] in _JOINING:
        place += 1
    length = _length_of_prohibition(words[place:], forms[place:]) if place or words[0].index == 1 else 0
    is_kept_out = length > 1
    place += length
    if not length or list(forms[place : place + 1]) == [] or forms[place] not in _UNTIL:
        return None, 0, False
    return Link(LinkKind.AFTER), place + 1, is_kept_out


def _length_of_prohibition(words: Sequence[Word], forms: Sequence[str]) -> int:
    """Return the number of words that begin with "not", "do not enter it", "avoid it", "stay out of it"; 0 for none."""
    place = 0
    while forms[place : place + 1] and forms[place] in _NEGATIONS | _DOING:
        place += 1
    is_denied = any(form in _NEGATIONS for form in forms[:place])
    lemma = words[place].lemma.lower() if place < len(words) else ""
    if is_denied and lemma not in _ENTERING:
        return place if place == 1 else 0
    if is_denied == (lemma in _AVOIDING | _STAYING):
        return 0
    place += 1
    while forms[place : place + 1] and words[place].upos == "ADP":
        place += 1
    if forms[place : place + 1] and forms[place] in _THERE:
        return place + 1
    phrase = _phrase(words, place)
    is_named = phrase and _content(words[place : place + phrase]) <= _content(words[place + phrase :])
    return place + phrase if is_named else 0


def times_at(forms: Sequence[str]) -> Optional[Times]:
    """Return the least or the largest number of times that words in lower case begin with: "at least twice", "three
    times at most", "two or more times", "only once", "once or twice"."""
    links = shipped_links()
    link, place = links.count_at(forms)
    if link is not None:
        said = times_said(forms[place:])
        return Times(link.kind, said[0], place + said[1]) if said is not None else None
    if list(forms[:1]) == ["on"]:
        exact = next((place for place, form in enumerate(forms[1:], 1) if form not in _EXACT), 1)
        said = times_said(forms[exact:])
        return Times(LinkKind.TIMES, said[0], exact + said[1]) if said is not None and said[1] == 2 else None
    start = int(list(forms[:1]) == ["but"])
    if forms[start : start + 1] and forms[start] in _ONLY:
        said = times_said(forms[start + 1 :])
        end = start + 1 + said[1] if said is not None else 0
        is_last = said is not None and (end == len(forms) or forms[end] in _MARKS)
        return Times(LinkKind.AT_MOST, said[0], end) if said is not None and is_last else None
    bound, length = links.choice_at(forms[1:])
    said = times_said([*forms[:1], *forms[1 + length :]]) if bound is not None else None
    if said is not None and said[1] == 2:
        return Times(bound.kind, said[0], said[1] + length) if bound is not None else None
    said = times_said(forms)
    behind = forms[said[1] :] if said is not None else ()
    for bound, length in (links.choice_at(behind), links.count_at(behind)):
        if said is not None and bound is not None:
            return Times(bound.kind, said[0], said[1] + length)
    other = times_said(behind[1:]) if list(behind[:1]) == ["or"] else None
    if said is not None and other is not None and other[0] > said[0]:
        return Times(LinkKind.AT_MOST, other[0], said[1] + 1 + other[1])
    return None


def first_order(words: Sequence[Word], place: int) -> Optional[ItemOrder]:
    """Return which item is the first one, by the word behind it at a place: "the kitchen *first*, then the office".

    Args:
        words: of the sentence
        place: where the word may be
    """
    item = words[place - 1] if place and words[place].said in FIRST else None
    behind = words[place + 1 :]
    if item is None or item.upos not in NOUNS or not behind or behind[0].said not in _JOINING:
        return None
    if not any(one.deprel == "conj" and one.head == item.index for one in behind):
        return None
    start = place - 1
    while start and words[start].upos in _CONTENT:
        start -= 1
    return ItemOrder(1, _content(words[start:place]), frozenset())


def is_first_of_deeds(words: Sequence[Word], place: int) -> bool:
    """Whether a word at a place says that the last deed comes first: "..., but go to the hall *first*"."""
    return _is_of_last_deed(words, place) and words[place].said in FIRST


def is_last_of_deed(words: Sequence[Word], place: int) -> bool:
    """Whether a word at a place says that the last deed is the last one: "but go to the office *last*"."""
    return _is_of_last_deed(words, place) and words[place].said in LAST


def _is_of_last_deed(words: Sequence[Word], place: int) -> bool:
    word = words[place]
    verbs = [one for one in words[:place] if one.upos == "VERB"]
    is_end = all(one.upos == "PUNCT" for one in words[place + 1 :])
    return is_end and len(verbs) > 1 and word.deprel == "advmod" and word.head == verbs[-1].index


def end_order(words: Sequence[Word], place: int, verbs: FrozenSet[str]) -> Optional[ItemOrder]:
    """Return which item is the first or the last one: ", the kitchen first", "and visit the office last".

    An item that was not said before stays in the list: its order has the length 1, of the last word.

    Args:
        words: of the sentence
        place: where the words may begin
        verbs: of the sentence, in their base form; one may be said again
    """
    start = place
    while start < len(words) and words[start].said in _JOINING:
        start += 1
    if start == place or not place:
        return None
    if start < len(words) and words[start].lemma.lower() in verbs:
        start += 1
    item = _phrase(words, start, before=FIRST | LAST)
    end = start + item
    if not item or end >= len(words) or words[end].said not in FIRST | LAST:
        return None
    if end + 1 < len(words) and words[end + 1].upos != "PUNCT":
        return None
    name, none = _content(words[start:end]), frozenset()  # type: FrozenSet[str], FrozenSet[str]
    is_first = words[end].said in FIRST
    is_said = name <= _content(words[:place])
    is_joined = words[start - 1].upos == "CCONJ" and not any(word.said in _ALL for word in words[:place])
    # "Visit every room, the kitchen first": it is no further room.
    length = end + 1 - place if is_said or not is_joined else 1
    return ItemOrder(length, name if is_first else none, none if is_first else name) if name else None


def item_order(words: Sequence[Word], place: int) -> Optional[ItemOrder]:
    """Return the order of two items that begins at a place: ", but not the hall before the office".

    Args:
        words: of the sentence
        place: where the words may begin
    """
    start, is_denied = place, False
    while start < len(words) and words[start].said in _JOINING | _NEGATIONS | _ONLY:
        is_denied = is_denied or words[start].said in _NEGATIONS
        start += 1
    one = _phrase(words, start, before=LAST)
    border = start + one
    behind, is_only, is_not = _restriction(words, border)
    border = behind
    if not one or border >= len(words):
        return None
    link, length = shipped_links().deed_link_at([word.said for word in words[border:]])
    other = _phrase(words, border + length) if link is not None and length else 0
    if link is None or link.kind is LinkKind.MEANWHILE or not other:
        return None
    end = border + length + other
    noun = end - 1
    more = _further_items(words, end)
    end += sum(length for _, length in more)
    if end < len(words) and words[end].upos not in ("PUNCT", "CCONJ") and words[end].said not in _JOINING:
        return None
    first, second = _content(words[start : start + one]), _content(words[noun + 1 - other : noun + 1])
    if not first or not second or first == second:
        return None
    is_before = link.kind is LinkKind.BEFORE
    items = [second, *(item for item, _ in more)]
    is_first = is_before != (is_denied or is_not)
    pairs = [(first, item) if is_first else (item, first) for item in items]
    said = _content(words[:place])
    (earlier, later), others = pairs[0], tuple(pairs[1:])
    if start > place and all(item <= said for pair in pairs for item in pair):
        return ItemOrder(end - place, earlier, later, more=others)
    if start > place or not place or length > 1 or words[place - 1].upos not in _BEFORE_LIST:
        return None
    is_doubtful = not is_not and (is_before or not is_only)
    return ItemOrder(end - place, earlier, later, True, is_doubtful, border, noun, others)


def _further_items(words: Sequence[Word], place: int) -> List[Tuple[FrozenSet[str], int]]:
    """Return the items of a list behind its first one: the content words of each, and the number of words up to its
    end."""
    start = place
    while start < len(words) and words[start].said in _LISTING:
        start += 1
    length = _phrase(words, start) if start > place else 0
    if not length:
        return []
    end = start + length
    return [(_content(words[start:end]), end - place), *_further_items(words, end)]


def ends_of_way(tree: DependencyTree) -> Tuple[int, ...]:
    """Return the positions of the first of two places, of the word between them, of the second one and of the word
    before them: "*between* the hall *and* the office", "*from* the hall *to* the office"; nothing for another sentence.
    """
    for place in tree.words:
        cases = {case.said: case.index for case in tree.prepositions(place.index)}
        joined = [child for child in tree.children(place.index) if child.deprel == "conj"]
        if "between" in cases and joined:
            border = [child.index for child in tree.children(joined[-1].index) if child.deprel == "cc"]
            return (place.index, border[0], joined[-1].index, cases["between"]) if border else ()
        if "from" not in cases:
            continue
        for other in tree.words[place.index :]:
            border = [case.index for case in tree.prepositions(other.index) if case.said == "to"]
            if other.deprel in ("obl", "nmod") and border and other.head in (place.head, place.index):
                return place.index, border[0], other.index, cases["from"]
    return ()


def _restriction(words: Sequence[Word], place: int) -> Tuple[int, bool, bool]:
    """Return the place behind the words between an item and "before", and whether they have an "only" and a "not": "the
    hall *only* after the office", "the hall, *but not* before the office"."""
    end, is_only, is_not = place, False, False
    while end < len(words) and words[end].said in _JOINING | LAST:
        is_only = is_only or words[end].said in LAST  # "The hall *last*, after the office."
        end += 1
    begin = end - is_only
    while end < len(words) and words[end].said in _ONLY | _NEGATIONS:
        is_only = is_only or words[end].said in _ONLY
        is_not = is_not or words[end].said in _NEGATIONS
        end += 1
    return (end, is_only, is_not) if end > begin else (place, False, False)


def _phrase(words: Sequence[Word], start: int, *, before: FrozenSet[str] = frozenset()) -> int:
    """Return the number of words of the noun phrase with an article that begins at a place; 0 for none.

    Args:
        words: of the sentence
        start: the place
        before: words that the phrase ends before
    """
    if start >= len(words) or words[start].upos not in ("DET", "PROPN"):
        return 0
    end = start + 1
    while end < len(words) and end - start < _LONGEST_PHRASE and words[end].upos in _CONTENT:
        if words[end].said in before:
            break
        end += 1
    return end - start if words[end - 1].upos in NOUNS else 0


def _content(words: Sequence[Word]) -> FrozenSet[str]:
    found: List[str] = [word.said for word in words if word.upos in _CONTENT]
    return frozenset(found)


def sorted_by(names: Sequence[FrozenSet[str]], orders: Sequence[ItemOrder]) -> Optional[Tuple[int, ...]]:
    """Return the places of items in an order that obeys all orders; None if there is none, or an item is not there.

    Args:
        names: the content words of each item
        orders: what must come before what
    """
    left: List[int] = list(range(len(names)))
    done: List[int] = []
    pairs = []
    for order in orders:
        for both in ((order.earlier, order.later), *order.more):
            pair = [[place for place, name in enumerate(names) if item and item <= name] for item in both]
            if any(item and len(found) != 1 for found, item in zip(pair, both)):
                return None
            earlier, later = (found or [place for place in left if place not in pair[0] + pair[1]] for found in pair)
            pairs += [(one, other) for one in earlier for other in later]
    while left:
        free = [place for place in left if not any(later == place and earlier in left for earlier, later in pairs)]
        if not free:
            return None
        done.append(free[0])
        left.remove(free[0])
    return tuple(done)
