"""The words beside a cry that nobody carries out: "the dishwasher" of "Stop the dishwasher."

A cry stops the robot whatever else is said, and the rest of the utterance is not parsed. Names, politeness, warnings
("you will hit the lamp") and what the stop itself fulfils ("stop following me") ask for nothing more. Everything else
may, and is named in the reply.
"""

from typing import FrozenSet, List, Mapping, Sequence, Tuple

from command_server.command_behind import NO_COMMANDS
from command_server.cries import (
    BEFORE_PLACES,
    CRIES,
    FILLER_PHRASES,
    FILLERS,
    LASTS,
    LEADS,
    NO_CONDITIONS,
    NO_PLACES,
    OBJECTS,
    OPENINGS,
    SOFT,
    TRAILS,
    WARNINGS,
)
from command_server.orders_back import said_behind
from command_server.spoken_words import Phrase, phrase_at, phrases_by_first_word, plain_text, tokens_of
from command_server.stop_words import find_cry

#: What opens with one of these says how things are: "it is too close".
_TELLING: FrozenSet[str] = (WARNINGS - FILLERS) | frozenset(
    "you yourself he she they there these those somebody someone what whatever why how because".split()
)
#: While these last, the robot stands still anyway: "don't move until I come back".
_LASTING: FrozenSet[str] = LASTS | {"for"}
_AROUND: FrozenSet[str] = FILLERS | SOFT
_JOINING: FrozenSet[str] = frozenset(" ".join(OPENINGS).split())
#: They are said like a name, "left, stop", and are none.
_NO_NAMES: FrozenSet[str] = frozenset(["left", "right"])
_CRY_PHRASES = tuple(phrase.strip() for _, _, phrases in CRIES for phrase in phrases.split(";"))
_PHRASES: Mapping[str, Tuple[Phrase, ...]] = phrases_by_first_word(
    (*FILLER_PHRASES, *LEADS, *TRAILS, *OPENINGS, *_CRY_PHRASES)
)
_HOW = phrases_by_first_word((*NO_PLACES, *NO_CONDITIONS))
_PAUSES = frozenset(",.")


def words_not_done(text: str) -> Tuple[str, ...]:
    """Return the words beside a cry that may ask for something, as they were said; empty for none, or no cry.

    A command behind the cry ("Stop and come back.") has a reply of its own, and is not among them.

    Args:
        text: in any spelling; only the beginning of a very long text counts
    """
    cry = find_cry(text)
    if cry is None:
        return ()
    plain = plain_text(cry.rest)[0].strip()
    behind = said_behind(cry)
    rest = plain[: -len(behind)] if behind and plain.endswith(behind) else plain
    return tuple(dict.fromkeys((*_left_of(cry.before, is_behind=False), *_left_of(rest, is_behind=True))))


def _left_of(text: str, *, is_behind: bool) -> List[str]:
    """Return the parts of a text that ask for something.

    Args:
        text: the words before a cry, or those behind it
        is_behind: which of both
    """
    tokens = tokens_of(text)
    words = [token.word for token in tokens]
    ends = [at for at, word in enumerate(words) if word in _PAUSES] + [len(words)] * bool(words)
    found: List[str] = []
    for first, end in zip([0] + [at + 1 for at in ends], ends):
        begin, last = _without_fillers(words[:end], first)
        is_object = is_behind and first == 0 and not text[: tokens[first].start].strip()
        if begin == last or _asks_for_nothing(words[begin:last], is_object=is_object):
            continue
        said = text[tokens[begin].start : tokens[last - 1].end]
        # Who is called stands right before the cry, or behind a pause.
        is_called = said.istitle() and first > 0 if is_behind else set(words[end:]) <= _AROUND | {","}
        if last - begin > 1 or not is_called or words[begin] in _NO_NAMES:
            found.append(said)
    return found


def _without_fillers(words: Sequence[str], begin: int) -> Tuple[int, int]:
    """Return the range without the fillers, introductions and other cries at its begin and its end."""
    end = len(words)
    while begin < end:
        length = phrase_at(words, begin, _PHRASES)
        if not length and (words[begin] not in _AROUND or words[begin] in _TELLING):
            break
        begin += length or 1
    while end > begin and words[end - 1] in _AROUND | _JOINING:
        end -= 1
    return begin, end


def _asks_for_nothing(words: Sequence[str], *, is_object: bool) -> bool:
    """Whether words only tell, warn, or say what the stop fulfils already.

    Args:
        words: without fillers
        is_object: whether they stand right behind the cry
    """
    if words[0] in _TELLING | _LASTING:
        return True
    if not is_object:
        return words[0] in NO_COMMANDS  # "The baby, stop!" names what is in danger.
    how = next((at for at, word in enumerate(words) if word not in BEFORE_PLACES), 0)
    return bool(
        words[0].endswith("ing") or phrase_at(words, how, _HOW) or all(word in OBJECTS | _AROUND for word in words)
    )
