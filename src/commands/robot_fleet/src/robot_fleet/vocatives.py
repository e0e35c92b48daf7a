"""Where words call somebody: "Luna, turn left", "could Luna turn left?", "Luna must stop".

An address is found by where it stands, by commas and by what follows it, whether or not a robot has the name: what is
said to a robot that is not here is for no other one.
"""

from typing import FrozenSet, Optional, Sequence, Tuple

from command_server.cries import AMOUNTS, COMMAND_VERBS, FILLERS, LENGTHS, NO_NAMES, SAYING, STRONG, WARNINGS
from command_server.stop_words import find_cry
from robot_fleet.address_words import address_words
from robot_fleet.robot_names import number_of

_NEGATED = "n't"


class Calls:
    """Judges the words of one utterance."""

    def __init__(self, words: Sequence[str], verbs: FrozenSet[str]) -> None:
        """
        Args:
            words: in lower case, and marks
            verbs: words with which a command begins
        """
        self._words, self._verbs = words, verbs
        known = address_words()
        self._lists, self._single = known.phrases, known.words

    def is_name(self, word: str) -> bool:
        """Whether a word can be the name of somebody: it is no verb, number, adverb or small word."""
        single = self._single
        return (
            len(word) > 1
            and word[0].isalpha()
            and "'" not in word
            and not word.endswith("ly")
            and number_of(word) is None
            and word not in self._verbs
            and word not in _NO_NAMES
            and not any(word in words for words in single.values())
            and find_cry(word) is None
        )

    def is_called(self, position: int, *, needs_pause: bool = False) -> bool:
        """Whether what stands before a position is called, by what follows: an order, or a question to it.

        Args:
            position: behind the name
            needs_pause: a comma must stand there
        """
        at = position
        while at < len(self._words) and self._words[at] in ",:!—–":
            at += 1
        if needs_pause and at == position:
            return False
        if self.modal_at(at) is not None:
            return at == position
        while at < len(self._words):
            word = self._words[at]
            if word in self._single["auxiliaries"] or word in self._single["before_you"]:
                return self._words[at + 1 : at + 2] == ["you"]
            if self.begins_order(at) or (at > position and self._asks_or_waits(at)):
                return True
            length = self._lists["polite"].length_at(self._words, at) or self._lists["greetings"].length_at(
                self._words, at
            )
            length = length or int(word.endswith("ly") or word in self._single["polite"] or word in self._single["you"])
            if not length:
                break
            at += length
        return False

    def begins_order(self, position: int) -> bool:
        """Whether an order begins at a position."""
        if position >= len(self._words):
            return False
        word = self._words[position]
        return word in self._verbs or word in COMMAND_VERBS or word in STRONG or word in self._single["order_starts"]

    def _asks_or_waits(self, position: int) -> bool:
        return (
            self._words[position] in self._single["questions"]
            or self._lists["fronts"].length_at(self._words, position) > 0
        )

    def modal_at(self, position: int) -> Optional[Tuple[str, int]]:
        """Return what is said to "you" in the place of a modal, and where its verb begins: "has to" is "you have to".

        None where no modal stands, or none that asks for something: "Beta must be in the kitchen" is a report.
        """
        length = self._lists["modals"].length_at(self._words, position)
        is_negated = False
        if not length and position < len(self._words) and self._words[position].endswith(_NEGATED):
            length = int(self._words[position][: -len(_NEGATED)] in self._single["modals"])
            is_negated = length > 0
        if not length:
            return None
        behind = position + length
        if self._words[behind : behind + 1] == ["not"]:
            is_negated, behind = True, behind + 1
        while behind < len(self._words) and (
            self._words[behind] in self._single["polite"] or self._words[behind].endswith("ly")
        ):
            behind += 1
        modal = " ".join(address_words().of_you.get(word, word) for word in self._words[position : position + length])
        said = "don't" if is_negated else f"you {modal}"
        rest = " ".join(self._words[behind:])
        word = self._words[behind] if behind < len(self._words) else ""
        if not (word in COMMAND_VERBS or word in STRONG or find_cry(f"{said} {rest}")):
            return None
        return said, behind

    def ends_amount(self, position: int) -> bool:
        """Whether the word before a position is a unit or a number: what follows is no part of it."""
        before = self._words[position - 1]
        return before in LENGTHS or before in self._single["units"] or number_of(before) is not None


_NO_NAMES = NO_NAMES | SAYING | COMMAND_VERBS | STRONG | WARNINGS | FILLERS | AMOUNTS | LENGTHS
