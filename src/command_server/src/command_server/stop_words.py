"""Whether an utterance means: stop, whatever you are doing.

The short way of "Stop." must not wait for a parser, so this looks at words alone. It is a closed rule: every word
must be known, because "Stop at the kitchen." and "Don't stop." are commands of another kind. A word that does not fit
sends the utterance the long way.
"""
import re
import unicodedata
from typing import FrozenSet, List, Tuple

STOP_WORDS: FrozenSet[str] = frozenset({"stop", "halt", "freeze", "abort", "whoa", "estop"})

# Each of these means stop as a whole.
STOP_PHRASES: Tuple[Tuple[str, ...], ...] = (
    ("e", "stop"), ("emergency", "stop"), ("emergency", "halt"), ("full", "stop"), ("stand", "still"),
    ("hold", "still"), ("don't", "move"), ("do", "not", "move"))

# Words that change nothing, before or after.
FILLERS: FrozenSet[str] = frozenset({
    "please", "robot", "now", "right", "immediately", "hey", "oh", "ok", "okay", "no", "just", "at", "once", "you",
    "the", "it", "that", "this", "everything", "all", "here", "there", "where", "are", "instantly", "quickly",
    "ah", "god", "my", "i", "said"})

# What a robot that moves may be told to stop: "stop turning left" stops, so the words behind these are free.
ACTIVITIES: FrozenSet[str] = frozenset({
    "moving", "going", "driving", "turning", "rotating", "spinning", "rolling", "running", "walking", "following",
    "coming", "approaching", "navigating", "backing", "reversing", "doing", "working"})

# An activity followed by one of these goes on to ask for something else, which must not be lost.
_CONTINUATIONS: FrozenSet[str] = frozenset({
    "and", "then", "but", "until", "when", "if", "after", "before", "while", "unless"})

# Fillers that do not carry a stop by themselves: "stop at" or "stop the" is the beginning of something longer.
_OPEN_ENDS: FrozenSet[str] = frozenset({"at", "the", "my", "where", "i", "said"})

# A longer utterance is not a cry.
_MOST_WORDS = 12


def _words(text: str) -> List[str]:
    plain = unicodedata.normalize("NFKC", text).replace("\u2019", "'").replace("\u2018", "'").lower()
    return re.findall(r"\w+(?:'\w+)*", plain)


def _without_stops(words: List[str]) -> Tuple[List[str], bool]:
    """Take the stop words and phrases out; say whether there were any."""
    rest: List[str] = []
    found = False
    index = 0
    while index < len(words):
        phrase = next((phrase for phrase in STOP_PHRASES if tuple(words[index:index + len(phrase)]) == phrase), None)
        if phrase is not None:
            found = True
            index += len(phrase)
            continue
        if words[index] in STOP_WORDS:
            found = True
        else:
            rest.append(words[index])
        index += 1
    return rest, found


def _stops_an_activity(words: List[str]) -> bool:
    for index in range(len(words) - 1):
        if words[index] == "stop" and words[index + 1] in ACTIVITIES:
            before, after = words[:index], words[index + 2:]
            return set(before) <= FILLERS | STOP_WORDS and not set(after) & _CONTINUATIONS
    return False


def is_stop(text: str) -> bool:
    """Whether the text says stop and nothing else.

    Args:
        text: an utterance in any spelling; punctuation, case and repetition do not matter
    """
    words = _words(text)
    if not words or len(words) > _MOST_WORDS:
        # "Stop stop stop ..." may be as long as the person has breath.
        return bool(words) and set(words) <= STOP_WORDS
    if _stops_an_activity(words):
        return True
    rest, found = _without_stops(words)
    if not found or not set(rest) <= FILLERS:
        return False
    # "at once", "where you are" and "I said stop" are whole; "stop at" and "stop the" wait for more.
    return words[-1] not in _OPEN_ENDS
