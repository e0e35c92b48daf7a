"""Sets a time at the front apart from the command: "at six *,* turn on the light", "after that *,* count the cups"."""

import re
from typing import Iterable

from spoken_quantities import number_words
from utterance_passes.spelling import Spelling
from utterance_passes.vocabulary import Verbs
from word_classes import word_class, word_list


def _one_of(words: Iterable[str]) -> str:
    return f"(?:{'|'.join(map(re.escape, sorted(words, key=len, reverse=True)))})"


def _any(*names: str) -> str:
    return _one_of({word for name in names for word in word_class(name)})


_WORDS = _one_of(number_words())
_NUMBER = rf"(?:\d{{1,2}}(?:[:.]\d\d)?|{_WORDS}(?:[- ]{_WORDS})?)"
_TODAY = _any("names_of_today", "names_of_tomorrow", "names_of_tonight")
_DAY = rf"(?:{_one_of(word_list('weekdays'))}|{_TODAY})"
_PART = _any("early_times_of_day", "late_times_of_day", "times_of_night")
_HOUR = rf"(?:{_NUMBER}|{_any('names_of_noon', 'names_of_midnight')})"
_PARTS_OF_AN_HOUR = rf"(?:{_any('half_hours', 'quarter_hours')}|{_NUMBER}(?: minutes?)?)"
_MINUTES = rf"(?:(?:a )?{_PARTS_OF_AN_HOUR} {_any('minutes_after', 'minutes_before')} )"
#: A time, and the word behind it.
_FRONTED = re.compile(
    rf"^\W*((?:(?:on )?{_DAY}(?: {_PART})? )?at {_MINUTES}?{_HOUR}"
    rf"(?: ?{_any('clock_words')}| {_any('exact_times')}| in the {_PART}| {_DAY}(?: {_PART})?)*)\s+([a-z]+)",
    re.IGNORECASE,
)


#: A deed before it, the word behind that, and the next word.
_AFTER_DEED = re.compile(
    rf"((?:^|(?:[,.;]|\band\b)\s+){_any('before_the_deed_before')} {_any('opinion_subjects')})"
    r"\s+([a-z]+)(?:\s+([\w']+)|\W*$)",
    re.IGNORECASE,
)
_SAYING = word_class("saying_verbs")
#: Behind a noun that could be a verb, they begin a clause: "after that dance *we* go".
_NO_OBJECTS = word_class("clause_subjects") | word_class("forms_of_be")


def with_times_set_off(spelling: Spelling, vocabulary: Verbs) -> Spelling:
    """Put a comma behind a time at the front that a verb follows: the parser takes "six turn" and "that count" for
    things."""
    found = _FRONTED.match(spelling.text) or _AFTER_DEED.search(spelling.text)
    if found is None or found.group(2).lower() not in vocabulary.words:
        return spelling
    following = (found.group(3) or "").lower() if found.re is _AFTER_DEED else ""
    is_said = following == "that" and found.group(2).lower() in _SAYING
    if following in _NO_OBJECTS | vocabulary.words and not is_said:
        return spelling
    end = found.end(1)
    text = f"{spelling.text[:end]},{spelling.text[end:]}"
    return Spelling(text, (*spelling.origins[:end], spelling.origins[end], *spelling.origins[end:]))
