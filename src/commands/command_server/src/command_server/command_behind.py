"""The command that follows a cry: "come back" of "Stop and come back."

Most often a warning ("stop, you will hit the lamp"), an explanation or the same cry follows a cry. So only words after
"and" or "then" count as one, and words after a pause that begin like a command or say what was meant instead ("no,
wait, I meant the plate"); the pipeline decides whether it can be carried out.
"""

from typing import FrozenSet, Sequence

from command_server.cries import COMMAND_VERBS, FILLERS, SOFT
from command_server.spoken_words import Token, plain_text, tokens_of
from command_server.stop_words import is_stop

#: No command begins with these: "stop and you will be fine".
NO_COMMANDS: FrozenSet[str] = frozenset(
    (
        "you i he she it we they there that this these those the a an my your his her our their is are was were what "
        "who where when why how or so because all both not if else"
    ).split()
)
_REQUESTS: FrozenSet[str] = frozenset("can could will would".split())
#: Words after these belong to the cry and are not a command.
_NO_OBJECTS: FrozenSet[str] = frozenset(
    "you i we they he she because or so but until till when whenever if once unless while before is are".split()
)
_PAUSES: FrozenSet[str] = frozenset(",.")
_JOINING: FrozenSet[str] = frozenset(["and", "then"])
#: What is wanted instead, in one word: "no wait, right".
_SIDES: FrozenSet[str] = frozenset(["left", "right"])
#: What was meant instead follows these. "Stop, I mean it" only repeats the cry.
_MEANING: FrozenSet[str] = frozenset(["mean", "meant"])
_OF_THE_CRY: FrozenSet[str] = frozenset("it that this what so now really business".split())
#: Words in "ing" that are not participles.
_IN_ING: FrozenSet[str] = frozenset("bring sing ring swing fling cling".split())


def command_behind(rest: str) -> str:
    """Find the command after a cry.

    Args:
        rest: the text after the last word of the cry (`Cry.rest`)
    Returns:
        the words of the command; empty if it is not certain that there is one
    """
    text, unquoted = plain_text(rest)
    tokens = tokens_of(unquoted)
    words = [token.word for token in tokens]
    # A full stop right after the cry does not belong to the rest.
    is_pause = unquoted.lstrip()[:1] in tuple(".,!?;:-\u2026\u2013\u2014")
    position = 0
    while position < len(words):
        word = words[position]
        if word in _JOINING:
            behind = _behind_joining(words, position)
            is_certain = "then" in words[position:behind] or _is_cry_alone(words[:position])
            if behind < len(words) and (is_certain or words[behind] in COMMAND_VERBS):
                return _command_at(text, tokens, behind)
            position = max(behind, position + 1)
            continue
        if is_pause and word in COMMAND_VERBS:
            return _command_at(text, tokens, position)
        if is_pause and word in _SIDES and all(one in _SIDES | _PAUSES | SOFT for one in words[position:]):
            return text[tokens[position].start :].strip()
        if is_pause and word in _REQUESTS and words[position + 1 : position + 2] == ["you"]:
            position += 2
            continue
        if is_pause and word == "i" and _says_what_is_meant(words[position + 1 : position + 3]):
            meant = text[tokens[position].start :].strip()
            return "" if is_stop(text[tokens[position + 2].start :]) else meant
        if word in _NO_OBJECTS:
            return ""
        is_pause = word in _PAUSES or (is_pause and (word in FILLERS or word in SOFT))
        position += 1
    return ""


def _says_what_is_meant(behind: Sequence[str]) -> bool:
    """Whether words behind "I" say what was meant: "meant the plate"."""
    return len(behind) == 2 and behind[0] in _MEANING and behind[1] not in _OF_THE_CRY | _PAUSES


def _behind_joining(words: Sequence[str], position: int) -> int:
    while position < len(words) and words[position] in _JOINING | _PAUSES:
        position += 1
    return position


def _is_cry_alone(words: Sequence[str]) -> bool:
    """Whether "and" can only join the cry: "stop moving and", but not "stop following me and Anna"."""
    return all(
        word in FILLERS or word in SOFT or word in _PAUSES or (word.endswith("ing") and word not in _IN_ING)
        for word in words
    )


def _command_at(text: str, tokens: Sequence[Token], position: int) -> str:
    words = [token.word for token in tokens[position:] if token.word not in (FILLERS | SOFT) - NO_COMMANDS]
    if not words or words[0] in NO_COMMANDS or (words[0].endswith("ing") and words[0] not in _IN_ING):
        return ""
    command = text[tokens[position].start :].strip()
    return "" if is_stop(command) else command
