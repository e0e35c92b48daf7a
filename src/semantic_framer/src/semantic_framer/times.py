"""Phrases that say when: "tomorrow", "on Monday", "next week", "at five". Read from the words one after the other, since a
time at either end of a command hangs on anything in its tree.
"""

from typing import FrozenSet, List, Tuple

from spoken_quantities import QuantityError, parse_number

from semantic_framer.amounts import read_amounts
from semantic_framer.sentence import Sentence

#: Words that say when on their own.
ADVERBS = frozenset(
    "later tomorrow tonight today soon afterwards afterward someday sometime eventually hourly daily nightly weekly "
    "monthly yearly".split()
)
_WEEKDAYS = frozenset("monday tuesday wednesday thursday friday saturday sunday".split())
_MONTHS = frozenset("january february march april may june july august september october november december".split())
_CLOCK = frozenset("o'clock am pm a.m. p.m.".split())
#: Times of the day.
_TIMES_OF_DAY = frozenset(
    "morning noon midday afternoon evening night midnight sunrise sunset dawn dusk daytime bedtime lunchtime summer "
    "autumn winter".split()
)
_MEALS = frozenset("breakfast brunch lunch dinner supper".split())
#: Stretches of time, which say when only behind a preposition ("in five minutes") or "next" and the like; "for five
#: minutes" and "five minutes" say how long.
_PERIODS = frozenset(
    "second sec moment instant minute min hour day weekend week fortnight month season year while bit meantime".split()
)
_SHORT = frozenset("second sec moment instant minute min hour bit while".split())
_PREPOSITIONS = frozenset(
    "in at on by before after until till during since from within around over throughout past".split()
)
#: What a bare number says when behind: "at five", but not "in five" or "by five".
_CLOCK_PREPOSITIONS = frozenset("at before after until till since around past".split())
_CHOOSING = frozenset("this next last following coming every each any some another other that these all".split())
_ARTICLES = frozenset("a an the same very early late whole first end of few couple".split())


def find_times(sentence: Sentence) -> Tuple[FrozenSet[int], ...]:
    """Find the phrases of a sentence that say when, in order, each with its preposition; phrases that touch are one."""
    forms = [word.form.lower() for word in sentence.tree.words]
    found: List[Tuple[int, int]] = []
    for end in range(1, len(forms) + 1):
        start = _start(sentence, forms, end)
        if not start and found and found[-1][1] == end - 1 and forms[end - 1] in _TIMES_OF_DAY | _CLOCK:
            start = end
        if not start:
            continue
        if found and found[-1][1] >= start - 1:
            start = min(found.pop()[0], start)
        found.append((start, end))
    return tuple(frozenset(range(start, end + 1)) for start, end in found)


def _start(sentence: Sentence, forms: List[str], end: int) -> int:
    """Return where the phrase that says when and ends at a word begins; 0 where none ends there."""
    word = forms[end - 1]
    if word in ADVERBS:
        before = forms[end - 2] if end > 1 else ""
        return end - 1 if before in _PREPOSITIONS else end
    if word == "now" and end > 1 and forms[end - 2] in ("from", "after", "until", "till", "before"):
        return end - 1
    if _continues(sentence, forms, end):
        return 0
    word = "o'clock" if word == "o’clock" else word
    singular = word[:-1] if word.endswith("s") and word[:-1] in _PERIODS | _WEEKDAYS | _TIMES_OF_DAY else word
    first = end
    while first > 1 and (forms[first - 2] in _ARTICLES | _CHOOSING or _is_number(forms[first - 2])):
        first -= 1
    preposition = forms[first - 2] if first > 1 else ""
    # "Hold on a second": how long, and not when.
    if preposition == "on" and singular in _SHORT:
        return 0
    is_time = singular in _PERIODS | _WEEKDAYS | _TIMES_OF_DAY | _MEALS | _MONTHS | _CLOCK
    if is_time and preposition in _PREPOSITIONS:
        return first - 1
    is_chosen = any(form in _CHOOSING for form in forms[first - 1 : end - 1])
    if is_chosen and ((is_time and singular not in _MEALS) or word in ("time", "times")):
        return first
    if singular in _WEEKDAYS and preposition not in ("to", "as", "with"):
        return first
    if word in _CLOCK and end > 1 and _is_number(forms[end - 2]):
        return first
    if _is_number(word) and end > 1 and forms[end - 2] in _CLOCK_PREPOSITIONS and not _is_measured(sentence, end):
        return end - 1
    return 0


def _continues(sentence: Sentence, forms: List[str], end: int) -> bool:
    """Whether a word is the first part of a name or of an amount: "morning paper", "day's work", "5 degrees"."""
    if end == len(forms):
        return False
    following = sentence.word(end + 1)
    if following.form.lower() in _TIMES_OF_DAY | _CLOCK | ADVERBS:
        return False
    if following.form.lower() in ("'s", "’s") or sentence.word(end).deprel in ("compound", "nmod:poss", "amod"):
        return True
    # At the front of a command the parser takes the verb behind a time for a noun: "at five turn left".
    if end == 2 and forms[0] == "at":
        return False
    return _is_number(forms[end - 1]) and following.upos in ("NOUN", "PROPN", "ADJ", "NUM")


def _is_measured(sentence: Sentence, index: int) -> bool:
    """Whether a number has a unit: "around forty-five degrees"."""
    amounts = read_amounts(sentence, [word.index for word in sentence.tree.words])
    return any(index in amount.positions and amount.unit for amount in amounts)


def _is_number(form: str) -> bool:
    try:
        parse_number(form)
    except QuantityError:
        return False
    return form not in ("a", "an")
