"""Pieces of words, as the encoder knows them: WordPiece over lower-case letters without accents."""

import unicodedata
from functools import lru_cache
from typing import Dict, List, NamedTuple, Sequence, Tuple

UNKNOWN, START, END = "[UNK]", "[CLS]", "[SEP]"
#: Longest word that is looked up; a longer one is unknown.
_LONGEST = 100
#: Shapes of words: what writing in lower case loses.
SHAPES = ("lower", "Title", "UPPER", "mixed", "number", "other")


class Pieces(NamedTuple):
    """A sentence in pieces.

    Attributes:
        numbers: of the pieces, with those of start and end
        shapes: of the word of each piece
        first: place of the first piece of each word
    """

    numbers: List[int]
    shapes: List[int]
    first: List[int]


def shape(word: str) -> int:
    """Return the number of the shape of a word in ``SHAPES``."""
    if any(character.isdigit() for character in word):
        return 4
    if not any(character.isalpha() for character in word):
        return 5
    if word.islower():
        return 0
    if word[0].isupper() and (len(word) == 1 or word[1:].islower()):
        return 1
    return 2 if word.isupper() else 3


def _plain(word: str) -> str:
    """Return a word in lower case, without accents and control characters."""
    decomposed = unicodedata.normalize("NFD", word.lower())
    return "".join(c for c in decomposed if unicodedata.category(c) not in ("Mn", "Cc", "Cf"))


def _parts(word: str) -> List[str]:
    """Split a word at each sign that is no letter or digit, as the encoder was trained."""
    parts: List[str] = []
    inside = False
    for character in word:
        if character.isspace():
            inside = False
        elif character.isalnum():
            if inside:
                parts[-1] += character
            else:
                parts.append(character)
            inside = True
        else:
            parts.append(character)
            inside = False
    return parts


class PieceVocabulary:
    """The pieces of an encoder."""

    def __init__(self, pieces: Sequence[str]) -> None:
        """
        Args:
            pieces: in the order of their numbers
        Raises:
            KeyError: one of the special pieces is missing
        """
        self._numbers: Dict[str, int] = {piece: number for number, piece in enumerate(pieces)}
        self.unknown, self.start, self.end = (self._numbers[piece] for piece in (UNKNOWN, START, END))
        self._of_word = lru_cache(maxsize=8192)(self._split)

    def __len__(self) -> int:
        return len(self._numbers)

    def of_word(self, word: str) -> Tuple[int, ...]:
        """Return the numbers of the pieces of a word; there is at least one."""
        return self._of_word(word)

    def _split(self, word: str) -> Tuple[int, ...]:
        found: List[int] = []
        for part in _parts(_plain(word)):
            found += self._of_part(part)
        return tuple(found) or (self.unknown,)

    def _of_part(self, part: str) -> List[int]:
        if len(part) > _LONGEST:
            return [self.unknown]
        found: List[int] = []
        start = 0
        while start < len(part):
            end = len(part)
            while end > start:
                number = self._numbers.get(("##" if start else "") + part[start:end])
                if number is not None:
                    break
                end -= 1
            else:
                return [self.unknown]
            found.append(number)
            start = end
        return found

    def of_sentence(self, words: Sequence[str], longest_word: int = 16) -> Pieces:
        """Return the pieces of a sentence.

        Args:
            words: of the sentence
            longest_word: pieces that are kept of one word
        """
        numbers, shapes, first = [self.start], [len(SHAPES) - 1], []
        for word in words:
            pieces = self.of_word(word)[:longest_word]
            first.append(len(numbers))
            numbers += pieces
            shapes += [shape(word)] * len(pieces)
        return Pieces([*numbers, self.end], [*shapes, len(SHAPES) - 1], first)
