"""Finds phrases that say when: "tomorrow", "on Monday", "next week", "at five".

They are read from the words, not from the tree: the parser attaches a time at either end of a command to any word.
"""

from functools import lru_cache
from typing import FrozenSet, Iterator, List, Tuple

from spoken_quantities import find_number
from utterance_passes.phrases.amounts import read_amounts
from utterance_passes.phrases.clock_times import clock_time_at
from utterance_passes.trees.tree import NOUNS, DependencyTree
from word_classes import word_class

_ADVERBS = word_class("time_adverbs")
_ASKING = word_class("question_words")
_BE = word_class("forms_of_be")
_BEFORE_NOW = word_class("limits_before_times")
_CHOOSING = word_class("time_determiners")
_CLOCK = word_class("clock_words")
_CLOCK_PREPOSITIONS = word_class("clock_prepositions")
_HEDGES = word_class("hedges_of_times")
_MEALS = word_class("meals")
_MODIFIERS = word_class("time_modifiers")
_MONTHS = word_class("months")
_NOT_BEFORE_WEEKDAYS = word_class("directional_prepositions") - {"for"}
_PERIODS = word_class("periods")
_PREPOSITIONS = word_class("time_prepositions")
_SHORT_PERIODS = word_class("short_periods")
_TIMES_OF_DAY = word_class("times_of_day")
_WEEKDAYS = word_class("weekdays")
#: "What *day* is tomorrow", "which *date* is tomorrow".
_DAYS_ASKED = _PERIODS | {"date"}
_DAYS = _PERIODS | _WEEKDAYS | _TIMES_OF_DAY
_TIMES = _DAYS | _MEALS | _MONTHS | _CLOCK
_BEFORE_TIMES = _MODIFIERS | _CHOOSING
#: "This time", "the next times".
_OCCASIONS = ("time", "times")
_AFTER_TIMES = _TIMES_OF_DAY | _CLOCK
#: Prepositions before a time of the clock, "*until* 20:15"; "at" is read with it.
_BEFORE_CLOCKS = _CLOCK_PREPOSITIONS | _PREPOSITIONS


def find_times(tree: DependencyTree) -> Tuple[FrozenSet[int], ...]:
    """Find the phrases that say when, in order, each with its preposition; adjacent phrases count as one.

    Whatever reads a time of the clock later (:mod:`utterance_passes.phrases.clock_times`) finds its words among these.
    So no such word is left to be a part of a thing or of a place.
    """
    forms = [word.said for word in tree.words]
    found: List[Tuple[int, int]] = []
    for end in range(1, len(forms) + 1):
        start = _start(tree, forms, end)
        if not start and found and found[-1][1] == end - 1 and forms[end - 1] in _AFTER_TIMES:
            start = end
        if not start:
            continue
        if found and found[-1][1] >= start - 1:
            start = min(found.pop()[0], start)
        found.append((start, end))
    for start, end in _clock_times(tree, forms):
        beside = [one for one in found if one[0] <= end + 1 and start <= one[1] + 1]
        found = [one for one in found if one not in beside]
        found.append((min([start, *(one[0] for one in beside)]), max([end, *(one[1] for one in beside)])))
    return tuple(frozenset(range(start, end + 1)) for start, end in sorted(found))


def _clock_times(tree: DependencyTree, forms: List[str]) -> Iterator[Tuple[int, int]]:
    """Yield the first and the last word of each time that is written or marked as one of the clock: "at 20:15", "until
    six thirty", "by 8 pm"; "the 9:15 bus" is a thing."""
    place = 0
    while place < len(forms):
        clock = clock_time_at(forms[place:])
        end = place + clock.length if clock is not None else place
        # "Turn to 3 o'clock" says where to.
        is_goal = place > 0 and forms[place - 1] == "to" and not (place > 1 and _is_of_a_time(forms[place - 2]))
        is_time = clock is not None and clock.is_certain and not is_goal
        if clock is None or not is_time or _modifies(tree, end) or _is_measured(tree, end):
            place += 1
            continue
        has_preposition = place > 0 and forms[place - 1] in _BEFORE_CLOCKS
        yield place + 1 - has_preposition, end
        place = end


def _modifies(tree: DependencyTree, end: int) -> bool:
    """Whether a word belongs to a noun behind it: "the 18:30 *report*", "six thirty *cups*"."""
    word = tree.word(end)
    return word.head > end and tree.governor(word).upos in NOUNS and not word.deprel.startswith("obl")


def _start(tree: DependencyTree, forms: List[str], end: int) -> int:
    """Return the start of the phrase of time that ends at a word; 0 if none ends there."""
    word = forms[end - 1]
    if word in _ADVERBS:
        if _is_asked_about(forms[: end - 1]):
            return 0
        before = forms[end - 2] if end > 1 else ""
        return end - 1 if before in _PREPOSITIONS else end
    if word == "now" and end > 1 and forms[end - 2] in _BEFORE_NOW:
        return end - 1
    word = "o'clock" if word == "o’clock" else word
    singular = word[:-1] if word.endswith("s") and word[:-1] in _DAYS else word
    is_time, is_number = singular in _TIMES, _is_number(word)
    is_last = is_time or is_number or word in _OCCASIONS
    if not is_last or _continues(tree, end, is_number=is_number):
        return 0
    first = _first(forms, end)
    if first > 2 and forms[first - 2] in _HEDGES and forms[first - 3] in _PREPOSITIONS:
        first -= 1  # "At *about* six".
    preposition = forms[first - 2] if first > 1 else ""
    # "Turn to 3 o'clock" says where to; "ten to 3 o'clock" is a time.
    if word in _CLOCK and preposition == "to" and not (first > 2 and _is_of_a_time(forms[first - 3])):
        return 0
    # "Hold on a second" says how long, not when.
    if preposition == "on" and singular in _SHORT_PERIODS:
        return 0
    if is_time and preposition in _PREPOSITIONS:
        return first - 1
    is_chosen = any(form in _CHOOSING for form in forms[first - 1 : end - 1])
    if is_chosen and ((is_time and singular not in _MEALS) or word in _OCCASIONS):
        return first
    if singular in _WEEKDAYS and preposition not in _NOT_BEFORE_WEEKDAYS:
        return first
    if word in _CLOCK and end > 1 and _is_number(forms[end - 2]):
        return first
    is_single = is_number and (first == end or forms[end - 2] in _HEDGES)
    if is_single and preposition in _CLOCK_PREPOSITIONS and not _is_measured(tree, end):
        return first - 1
    return 0


def _first(forms: List[str], end: int) -> int:
    """Return the first word of the phrase of time that ends at a word, without its preposition: "the last two days".

    A number before a word that chooses is a time of its own: "at *six* that dinner is ready".
    """
    first = end
    while first > 1:
        is_number = forms[first - 1] not in _CHOOSING and _is_number(forms[first - 2])
        if not is_number and forms[first - 2] not in _BEFORE_TIMES:
            break
        first -= 1
    return first


def _is_asked_about(before: List[str]) -> bool:
    """Whether the words before a day ask about it: "what day *tomorrow* is", "which date is *tomorrow*"."""
    if before and before[-1] in _BE:
        before = before[:-1]
    return len(before) > 1 and before[-1] in _DAYS_ASKED and before[-2] in _ASKING


def _is_of_a_time(form: str) -> bool:
    return form in _TIMES or _is_number(form)


def _continues(tree: DependencyTree, end: int, *, is_number: bool) -> bool:
    """Whether a word begins a longer name or an amount: "morning paper", "day's work", "5 degrees"."""
    if end == len(tree.words):
        return False
    following = tree.word(end + 1)
    if following.said in _AFTER_TIMES or following.said in _ADVERBS:
        return False
    if following.said in ("'s", "’s") or tree.word(end).deprel in ("compound", "nmod:poss", "amod"):
        return True
    # At the front of a command, the parser takes the verb after a time for a noun: "at five turn left".
    if end == 2 and tree.word(1).said == "at":
        return False
    # "Two of the cups" counts.
    is_counting = following.upos in ("NOUN", "PROPN", "ADJ", "NUM") or following.said == "of"
    return is_number and is_counting


def _is_measured(tree: DependencyTree, index: int) -> bool:
    """Whether a number has a unit: "around forty-five degrees"."""
    amounts = read_amounts(tree, [word.index for word in tree.words])
    return any(index in amount.positions and amount.unit for amount in amounts)


@lru_cache(maxsize=4096)
def _is_number(form: str) -> bool:
    return form not in ("a", "an") and find_number(form) is not None
