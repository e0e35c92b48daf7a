"""Recognises cries that must stop the robot, by words alone.

The stop path must not wait for a parser, a file or another node, and does not know what runs: `cries` holds every word
that it needs. An utterance is a cry if one of its sentences begins with a phrase of `CRIES`, or with only fillers,
politeness, a name or a warning before such a phrase, and if the words after it do not make another command of it:
"stop, you will hit the lamp" is a cry, "stop at the door" and "wait for me" are not.
"""

from typing import Dict, FrozenSet, Mapping, Optional, Sequence, Tuple

from command_server.cries import (
    AMOUNTS,
    BEFORE_PLACES,
    BLOCKING,
    CLAUSES,
    COMMAND_VERBS,
    COMPOUNDS,
    CONDITIONS,
    CRIES,
    ENGLISH,
    FILLER_PHRASES,
    FILLERS,
    IMPERSONAL,
    LEADS,
    LENGTHS,
    NO_CONDITIONS,
    NO_NAMES,
    NO_PLACES,
    NOBODIES,
    OBJECTS,
    OPENINGS,
    PLACES,
    SAYING,
    SET_OFF,
    SOFT,
    STRONG,
    SUBJECTS,
    TAIL_WORDS,
    TRAILS,
    TYPED,
    VERBS_OF_IT,
    WARNINGS,
    WEAK_OBJECTS,
    Cry,
    Kind,
    Tail,
)
from command_server.said_of_hearers import said_to_hearers
from command_server.spoken_words import Phrase, phrase_at, phrases_by_first_word, plain_text, tokens_of

#: Neither a name of the robot nor a warning begins with these: "at the door, stop", "turn left, stop".
_NO_ADDRESS: FrozenSet[str] = (
    PLACES
    | CONDITIONS
    | BLOCKING
    | COMMAND_VERBS
    | (AMOUNTS - {"a", "and"})
    | {"first", "next", "last", "to", "from", "with"}
)
_NOT_FIRST = NO_NAMES | SAYING | COMMAND_VERBS | {"one"}
# Words: longer sequences of fillers are not examined.
_LONGEST_WARNING = 12
_LONGEST_TRAIL = 24
_PAUSES = frozenset(",.")
_ADDRESSING = (FILLERS - WARNINGS) | {","}
_AUXILIARIES = frozenset("do does did will would can could should must may might need".split())
_ENTRIES: Mapping[Phrase, Tuple[Kind, Tail]] = {
    tuple(phrase.split()): (kind, tail) for kind, tail, phrases in CRIES for phrase in phrases.split(";")
}
_CRIES = phrases_by_first_word(" ".join(phrase) for phrase in _ENTRIES)
_BEGINNINGS = frozenset(_CRIES) | {phrase.split()[0] for phrase in NOBODIES}
_OPENINGS = phrases_by_first_word(FILLER_PHRASES + LEADS + OPENINGS)
_LEADS = phrases_by_first_word(FILLER_PHRASES + LEADS)
_TRAILS = phrases_by_first_word(FILLER_PHRASES + TRAILS)
_NO_PLACES = phrases_by_first_word(NO_PLACES + NO_CONDITIONS)


def _slips() -> Mapping[str, Kind]:
    """Return the typing errors of each cry: two letters swapped, one left out, or one typed twice."""
    found: Dict[str, Kind] = {}
    for word, kind in TYPED.items():
        swapped = {word[:at] + word[at + 1] + word[at] + word[at + 2 :] for at in range(len(word) - 1)}
        short = {word[:at] + word[at + 1 :] for at in range(len(word))}
        double = {word[:at] + word[at] + word[at:] for at in range(len(word))}
        found.update({slip: kind for slip in swapped | short | double if slip != word and slip not in ENGLISH})
    return found


_SLIPS = _slips()


def _is_of_amounts(word: str) -> bool:
    return word in AMOUNTS or word[0].isdigit()


class _Sentence:
    """A sentence in plain words, with "," for pauses."""

    def __init__(self, words: Sequence[str], *, is_first: bool) -> None:
        self._words = list(words)
        self._openings = _OPENINGS if is_first else _LEADS
        self._fronts = self._find_fronts()
        self._first_block = next((at for at, word in enumerate(words) if word in BLOCKING), len(words))
        # Where the sentence begins behind "hey robot,".
        self._start = next((at for at, word in enumerate(words) if word not in _ADDRESSING), len(words))
        self._is_warning = self._start < len(words) and words[self._start] in WARNINGS

    def cry(self) -> Optional[Tuple[Kind, int, int]]:
        """Return the kind of the first cry, its position, and the position after it."""
        for position in range(len(self._words)):
            for phrase in _CRIES.get(self._words[position], ()):
                end = position + len(phrase)
                kind, tail = _ENTRIES[phrase]
                if (
                    tuple(self._words[position:end]) == phrase
                    and self._may_begin(position, phrase)
                    and self._may_end(end, tail, phrase)
                    and not (kind is Kind.PAUSE and self._corrects_an_amount(position, end))
                ):
                    return kind, position, end
        return None

    def _corrects_an_amount(self, position: int, end: int) -> bool:
        """Whether nothing but another amount follows: "move forward one metre, no wait, two metres"."""
        behind = [word for word in self._words[end:] if word not in _ADDRESSING]
        before = self._words[:position]
        has_amount = any(unit in LENGTHS and _is_of_amounts(word) for word, unit in zip(before, before[1:]))
        return has_amount and behind[-1:] != [] and behind[-1] in LENGTHS and all(map(_is_of_amounts, behind[:-1]))

    def _find_fronts(self) -> Mapping[int, bool]:
        """Return the positions with only a name, fillers and introductions before them, and whether there is a name."""
        position, has_name, has_lead = 0, False, False
        fronts: Dict[int, bool] = {}
        while position < len(self._words):
            fronts[position] = has_name
            word = self._words[position]
            length = phrase_at(self._words, position, self._openings)
            if not length and word not in FILLERS and word != ",":
                if has_name or has_lead or not word.isalpha() or word in _NOT_FIRST:
                    break
                has_name = True
            has_lead = has_lead or length > 0
            position += max(length, 1)
        return fronts

    def _may_begin(self, position: int, phrase: Phrase) -> bool:
        is_strong = phrase[0] in STRONG
        has_name = self._fronts.get(position)
        if has_name is not None:
            # "Rosie stop" and "Rosie hold on", but not "warm enough".
            return is_strong or not has_name or (len(phrase) > 1 and phrase[0] != "no" and phrase != ("do", "not"))
        if not self._start < position <= min(self._first_block, self._start + _LONGEST_WARNING):
            return False
        before = self._words[self._start : position]
        last = next((word for word in reversed(before) if word != ","), "")
        if before[-1] == "," and last not in ("not", "never", "to", "and", "or"):
            # "My dear robot, stop"; "the lamp, stop": but not "at the door, stop".
            return self._is_warning or (len(before) <= 4 and before[0] not in _NO_ADDRESS)
        return (
            is_strong
            and not self._is_negated(position)
            and (
                self._is_set_off(before)
                or self._is_guided(before)
                or (
                    last not in NO_NAMES
                    and (self._is_warning or self._words[position + 1 : position + 2] == [phrase[0]])
                )
            )
        )

    def _is_negated(self, position: int) -> bool:
        """Whether the cry is negated: "don't ever stop"."""
        return any(
            self._words[at] == "not" and self._words[at - 1] in _AUXILIARIES
            for at in range(max(1, position - 3), position)
        )

    @staticmethod
    def _is_set_off(before: Sequence[str]) -> bool:
        """Whether an interjection precedes a cry; "no" is not one in "there is no stop here"."""
        is_determiner = before[-1] == "no" and before[-2:-1] and before[-2] in ("is", "are", "have", "has", "see")
        return before[-1] in SET_OFF and not is_determiner

    @staticmethod
    def _is_guided(before: Sequence[str]) -> bool:
        """Whether the words before a cry are repeated, as when a robot is guided: "back back back stop"."""
        return any(
            len(before) % length == 0 and list(before) == list(before[:length]) * (len(before) // length)
            for length in (1, 2, 3)
            if 2 * length <= len(before)
        )

    def _may_end(self, end: int, tail: Tail, phrase: Phrase) -> bool:
        if tail is Tail.ANYTHING:
            return not self._goes_on_as_command(end)
        if tail in (Tail.OBJECT, Tail.NEEDS_OBJECT):
            behind = self._behind_object(end)
            if tail is Tail.NEEDS_OBJECT and behind == end:
                return False
            end = behind
        position = end
        while position < min(len(self._words), end + _LONGEST_TRAIL):
            word = self._words[position]
            if tail is not Tail.NOTHING and (
                phrase_at(self._words, position, _CRIES)
                or self._is_clause(position)
                or word in TAIL_WORDS.get(tail, ())
            ):
                return True
            if (
                tail is Tail.ACTIVITY
                and position == end
                and ((word.endswith("ing") and len(word) > 4) or word in ("it", "that", "this"))
            ):
                return True
            is_again = tuple(self._words[position : position + len(phrase)]) == phrase
            length = len(phrase) if is_again else phrase_at(self._words, position, _TRAILS)
            if not length and word not in FILLERS and word != ",":
                return False
            position += max(length, 1)
        return True

    def _is_clause(self, position: int) -> bool:
        """Whether a separate clause begins here: "wait, I see", "wait it's hot"."""
        word = self._words[position]
        is_impersonal = word in IMPERSONAL and self._words[position + 1 : position + 2]
        return word == "," or word in CLAUSES or bool(is_impersonal and self._words[position + 1] in VERBS_OF_IT)

    def _behind_object(self, position: int) -> int:
        """Return the position after an object ("the last command", "what I said"); the same position for none."""
        end = position
        while (
            end < len(self._words)
            and self._words[end] in OBJECTS
            and (self._words[end] not in SUBJECTS or "what" in self._words[position:end])
        ):
            end += 1
        return position if set(self._words[position:end]) <= WEAK_OBJECTS else end

    def _goes_on_as_command(self, position: int) -> bool:
        """Whether a place, a distance, a time or a condition follows: "stop at the door", "stop when you see me"."""
        words = self._words
        if position < len(words) and words[position] in COMPOUNDS:
            return True
        while position < len(words) and words[position] in BEFORE_PLACES:
            position += 1
        if position < len(words) and words[position] in PLACES:
            # "Stop before *opening* the door": no place is named so.
            is_deed = words[position] == "before" and "".join(words[position + 1 : position + 2]).endswith("ing")
            return not is_deed and not phrase_at(words, position, _NO_PLACES)
        behind = position
        while behind < len(words) and _is_of_amounts(words[behind]):
            behind += 1
        if position < behind < len(words) and words[behind] in LENGTHS:
            return True
        for word, following, at in zip(words[position:], words[position + 1 :], range(position, len(words))):
            if word in CLAUSES or word == "," or (word, following) == ("it", "is"):
                return False
            is_after = word == "after" and (following in AMOUNTS or following.isdigit())
            if is_after or (word in CONDITIONS and at + 2 < len(words)):
                return not phrase_at(words, at, _NO_PLACES)
        return False


def find_cry(text: str) -> Optional[Cry]:
    """Find out whether an utterance stops the robot.

    Args:
        text: in any spelling; only the beginning of a very long text counts
    Returns:
        the cry; None if the utterance goes to the parser
    """
    said, unquoted = plain_text(text)
    spoken = tokens_of(unquoted)
    # "Just a moment" is a cry by itself.
    tokens = [
        token
        for token, following in zip(spoken, spoken[1:] + spoken[:1])
        if token.word not in SOFT or (token.word == "just" and following.word == "a")
    ]
    different = {token.word for token in tokens} - _PAUSES
    if len(different) == 1 and different <= _SLIPS.keys():
        return Cry(_SLIPS[different.pop()])
    if different.isdisjoint(_BEGINNINGS):
        return None
    ends = [at for at, token in enumerate(tokens) if token.word == "."] + [len(tokens)]
    for first, last in zip([0] + [end + 1 for end in ends], ends):
        sentence = said_to_hearers(tokens[first:last])
        words = [token.word for token in sentence]
        if _CRIES.keys().isdisjoint(words):
            continue
        found = _Sentence(words, is_first=first == 0).cry()
        if found is not None:
            kind, begin, end = found
            return Cry(kind, said[sentence[end - 1].end :], said[: sentence[begin].start])
    return None


def is_stop(text: str) -> bool:
    """Whether an utterance stops the robot: `find_cry` without its kind."""
    return find_cry(text) is not None
