"""Turns what is said of hearers into what is said to them: "everybody has to stop" is "stop".

A safety rule: whoever says that all must stand still waits for no parser.
"""

from typing import List, Optional, Sequence, Tuple

from command_server.cries import (
    BANS,
    BANS_OF_NOBODY,
    CLAUSES,
    COMMAND_VERBS,
    DUTIES,
    FILLER_PHRASES,
    FILLERS,
    HEARERS,
    IMPERSONAL,
    LEADS,
    NO_NAMES,
    NOBODIES,
    OPENINGS,
    SAYING,
    WISHES,
)
from command_server.spoken_words import Token, phrase_at, phrases_by_first_word

_FRONTS = phrases_by_first_word((*FILLER_PHRASES, *LEADS, *OPENINGS))
_HEARERS = phrases_by_first_word(HEARERS)
_NOBODIES = phrases_by_first_word(NOBODIES)
_DUTIES = phrases_by_first_word(DUTIES)
_BANS = phrases_by_first_word(BANS)
_BANS_OF_NOBODY = phrases_by_first_word(BANS_OF_NOBODY)
_WISHES = phrases_by_first_word(WISHES)
_NO_SUBJECTS = NO_NAMES | SAYING | COMMAND_VERBS | {"one"}
#: Of somebody with a name only these are said to stop: "Anna must wait" tells of Anna.
_OF_NAMES = frozenset("stop halt stand keep hold not".split())


def said_to_hearers(tokens: Sequence[Token]) -> List[Token]:
    """Return the tokens of a sentence with an order in the place of a duty of its hearers; the same ones for none.

    The first word of the order takes over the places of the words that it stands for.

    Args:
        tokens: of one sentence, without full stops
    """
    words = [token.word for token in tokens]
    at = 0
    while at < len(words):
        found = _duty_at(words, at)
        if found is not None:
            behind, is_ban = found
            if is_ban:
                order = [Token("do", tokens[at].start, tokens[behind - 1].end), tokens[behind - 1]._replace(word="not")]
                return [*tokens[:at], *order, *tokens[behind:]]
            return [*tokens[:at], tokens[behind]._replace(start=tokens[at].start), *tokens[behind + 1 :]]
        length = phrase_at(words, at, _FRONTS) or int(words[at] in FILLERS or words[at] == ",")
        if not length:
            break
        at += length
    return list(tokens)


def _duty_at(words: Sequence[str], at: int) -> Optional[Tuple[int, bool]]:
    """Return where the words behind "everybody must" begin, and whether they are forbidden."""
    wish = phrase_at(words, at, _WISHES)
    hearer = phrase_at(words, at + wish, _HEARERS)
    if wish:
        behind = at + wish + hearer
        return (behind + 1, False) if hearer and words[behind : behind + 1] == ["to"] and words[behind + 1 :] else None
    nobody = phrase_at(words, at, _NOBODIES)
    is_name = not hearer and not nobody and words[at].isalpha() and words[at] not in _NO_SUBJECTS
    behind = at + (nobody or hearer or is_name)
    if nobody and words[behind : behind + 1] in (["but"], ["except"]):
        behind += 2  # "Nobody but Alpha may move": a stop too many is the lesser harm.
    ban = phrase_at(words, behind, _BANS_OF_NOBODY if nobody else _BANS)
    begin = behind + (ban or (0 if nobody else phrase_at(words, behind, _DUTIES)))
    if at == behind or begin in (behind, len(words)):
        return None
    # "Robot, can we stop" asks.
    is_order = words[begin] in _OF_NAMES if is_name else words[begin] not in CLAUSES | IMPERSONAL
    return (begin, ban > 0) if ban or is_order else None
