"""Recognises utterances that take back or forbid what was said before ("no, go to the garage"), by words alone.

Any stage may refuse such an utterance, or hang, but the commands that it takes back must end in any case. So the
command server decides this itself, without a parser or a file.
"""

from typing import FrozenSet, Optional, Sequence, Tuple

from command_server.cries import FILLER_PHRASES, FILLERS, LEADS, SOFT
from command_server.spoken_words import plain_text, tokens_of

#: Openings of corrections and prohibitions, in plain words: contractions are spelled out.
OBJECTIONS: Tuple[str, ...] = (
    "no",
    "nope",
    "nah",
    "not",
    "wrong",
    "do not",
    "never",
    "i mean",
    "i meant",
    "i said",
    "i wanted",
    "i do not want",
    "i do not need",
    "the other one",
    "the other way",
    "the other side",
    "the other direction",
    "the other hand",
    "other way",
    "that is not",
    "that is wrong",
    "that was not",
    "that was wrong",
    "this is not",
    "this is wrong",
    "it is not",
    "it is wrong",
    "you are not",
    "you are wrong",
)
#: Openings that take nothing back when they are said alone: "sorry".
WEAK_OBJECTIONS: Tuple[str, ...] = ("oops", "sorry", "actually", "rather", "instead")
#: Ends of corrections: "go to the garage instead".
BEHIND: Tuple[str, ...] = ("instead", "rather", "i mean", "i meant")
#: After "no" and "not" these take nothing back: "no problem", "not yet".
TALK: FrozenSet[str] = frozenset(
    "thanks thank problem problems worries worry idea doubt hurry rush need matter bad yet sure now one at".split()
)
#: Negated, these mean to continue: "no, don't stop".
ENDING: FrozenSet[str] = frozenset(
    "stop halt pause wait hesitate worry forget hurry rush panic mind freeze quit cancel abort bother".split()
)
#: What tells the robot to go on, when nothing else is said: "no, keep going".
GOING_ON: Tuple[str, ...] = (
    "keep going",
    "keep moving",
    "keep on",
    "keep at it",
    "keep it up",
    "continue",
    "go on",
    "go ahead",
    "carry on",
    "move on",
    "proceed",
    "resume",
    "as you were",
)
#: Before an activity: "no, keep following me".
KEEPING: Tuple[str, ...] = ("keep", "keep on", "continue", "go on", "carry on")
#: They end like an activity, and are none.
NO_ACTIVITIES: FrozenSet[str] = frozenset(
    "nothing anything something everything morning evening building ceiling during king string".split()
)
#: What may stand behind "go on".
ON_TAILS: Tuple[str, ...] = (
    "like that",
    "like this",
    "as before",
    "as you were",
    "with it",
    "with that",
    "with this",
    "what you are doing",
    "with what you are doing",
    "doing that",
    "doing what you are doing",
)
#: Words among the fillers that say where to, or no.
_NO_FILLERS: FrozenSet[str] = frozenset("no nope right there here back".split())
_INTRODUCTIONS: Tuple[str, ...] = ("nah", "oops", "rather", "i mean", "i meant", *LEADS)
_PAUSES: FrozenSet[str] = frozenset(",.")
_NEGATIONS: FrozenSet[str] = frozenset(["not", "never"])
_ENDS_ACTIVITY: FrozenSet[str] = _PAUSES | _NEGATIONS | frozenset("no nope and but then instead rather".split())
_EMPHASIS: FrozenSet[str] = frozenset(["ever", "even"])
_AROUND: FrozenSet[str] = (FILLERS | SOFT | _PAUSES) - {phrase.split()[0] for phrase in OBJECTIONS + WEAK_OBJECTIONS}
# Words: "you must not ever stop".
_LONGEST_AUXILIARY = 4


def takes_back(text: str) -> bool:
    """Whether an utterance opens or ends like a correction of what was said before, or opens like a prohibition.

    Args:
        text: in any spelling; only the beginning of a very long text counts
    """
    if tells_to_go_on(text):
        return False
    words = [token.word for token in tokens_of(plain_text(text)[1])]
    front = _behind_fillers(words, 0)
    if _phrase_at(words, front, WEAK_OBJECTIONS) is not None:
        return _behind_fillers(words, front + 1) < len(words) and not _goes_on(words)
    opening = _phrase_at(words, front, OBJECTIONS)
    if opening is None:
        said = [word for word in words if word not in _PAUSES]
        return any(len(said) > len(phrase) and said[-len(phrase) :] == phrase for phrase in map(str.split, BEHIND))
    behind = words[front + len(opening.split()) :]
    if opening in ("no", "not") and behind and behind[0] in TALK:
        return False
    return not _goes_on(words[front:])


def tells_to_go_on(text: str) -> bool:
    """Whether an utterance asks for nothing but to go on with what runs: "no, keep going", "no, keep following me".

    Args:
        text: in any spelling; of a very long one only the beginning counts
    """
    words = [token.word for token in tokens_of(plain_text(text)[1])]
    front = _behind(words, 0, phrases=_INTRODUCTIONS, fillers=_PAUSES | SOFT | FILLERS)
    keeping = _phrase_at(words, front, KEEPING)
    if keeping is not None:
        activity, *behind = words[front + len(keeping.split()) :] or [""]
        # More than one thing may be said after a pause, an "and" or a "not".
        if activity.endswith("ing") and activity not in NO_ACTIVITIES and not _ENDS_ACTIVITY & set(behind):
            return True
    return _asks_to_go_on(words, front)


def asks_to_go_on(text: str) -> bool:
    """Whether an utterance says to go on, and not with what: "go on", "carry on as before", but not "keep driving"."""
    words = [token.word for token in tokens_of(plain_text(text)[1])]
    return _asks_to_go_on(words, _behind(words, 0, phrases=_INTRODUCTIONS, fillers=_PAUSES | SOFT | FILLERS))


def _asks_to_go_on(words: Sequence[str], front: int) -> bool:
    going_on = _phrase_at(words, front, GOING_ON)
    if going_on is None:
        return False
    end = _behind(
        words,
        front + len(going_on.split()),
        phrases=ON_TAILS + FILLER_PHRASES,
        fillers=(_PAUSES | SOFT | FILLERS) - _NO_FILLERS,
    )
    return end == len(words)


def _behind(words: Sequence[str], position: int, *, phrases: Sequence[str], fillers: FrozenSet[str]) -> int:
    """Return the position behind all phrases and fillers."""
    while position < len(words):
        phrase = _phrase_at(words, position, phrases)
        if phrase is None and words[position] not in fillers:
            break
        position += len(phrase.split()) if phrase else 1
    return position


def _behind_fillers(words: Sequence[str], position: int) -> int:
    while position < len(words) and words[position] in _AROUND:
        position += 1
    return position


def _phrase_at(words: Sequence[str], position: int, phrases: Sequence[str]) -> Optional[str]:
    """Return the longest phrase at a position, None for none."""
    found = [phrase for phrase in phrases if list(words[position : position + len(phrase.split())]) == phrase.split()]
    return max(found, key=len) if found else None


def _goes_on(words: Sequence[str]) -> bool:
    """Whether the utterance forbids to stop: "no, don't stop"."""
    for position, word in enumerate(words):
        if word in _NEGATIONS:
            following = words[position + 1 : position + _LONGEST_AUXILIARY]
            behind = [other for other in following if other not in _AROUND | _EMPHASIS]
            if behind and behind[0] in ENDING:
                return True
    return False
