"""Divides a text into tokens, and tokens such as "don't" into words."""

import re
from typing import Any, List, NamedTuple, Tuple

import numpy as np

from stanford_parser_ros.words.word_folder import UNKNOWN, WordFiles

_BLANK_LINE = re.compile("\n[\\s\u0080-\u009f]*\n")
_SPACE = re.compile("[\\s\u0080-\u009f]")
#: An address is one token, whatever the model says.
_ADDRESS = re.compile(
    r"[\w.!#$%&'*+/=?^`{|}~-]+@[a-z0-9-]+(?:\.[a-z0-9-]+)+|https?://[^\s\"]+\.[^\s\"]{2,}|www\.[^\s\"]+\.[^\s\"]{2,}"
)
#: What stands for a token with more letters than the model takes.
_TOO_LONG = "<UNK>"
#: Space, capital, digit, end and start of the paragraph.
_FEATURES = 5


class Token(NamedTuple):
    """A token of the text.

    Attributes:
        text: its letters
        start, end: positions of its first character and after its last one
        is_compound: whether it may hold several words
    """

    text: str
    start: int
    end: int
    is_compound: bool


class Tokenizer:
    """Stanza's tokenizer: a network that says of each character whether a token ends there."""

    def __init__(self, files: WordFiles, network: Any) -> None:
        """
        Args:
            files: of the folder of words
            network: session of ONNX Runtime
        """
        self._numbers = files.text_characters
        self._longest = files.longest_token
        self._network = network

    def tokens(self, text: str) -> List[Token]:
        """Return the tokens of the first paragraph of a text."""
        characters, places = _paragraph(text)
        ends, are_compounds = self._ends(characters)
        for address in _ADDRESS.finditer("".join(characters)):
            ends[address.start() : address.end() - 1] = False
            if not ends[address.end() - 1]:
                ends[address.end() - 1] = True
                are_compounds[address.end() - 1] = False
        tokens, start = [], 0
        for last in np.flatnonzero(ends):
            stop = int(last) + 1
            letters = "".join(characters[start:stop])
            stripped = letters.lstrip()
            if stripped:
                begin = places[start + len(letters) - len(stripped)]
                end = places[last] + 1
                if len(stripped) > self._longest:
                    # Stanza counts the letters of what stands for the token.
                    stripped = _TOO_LONG
                    end = begin + len(_TOO_LONG)
                tokens.append(Token(stripped, begin, end, bool(are_compounds[last])))
            start = stop
        return tokens

    def _ends(self, characters: List[str]) -> Tuple[Any, Any]:
        """Return whether a token ends at each character, and whether it is one of several words."""
        # One more, which stands for what follows the paragraph, as Stanza has it.
        count = len(characters)
        numbers = [self._numbers.get(character, UNKNOWN) for character in characters]
        features = np.zeros((count + 1, _FEATURES), np.float32)
        features[:count, 0] = [character == " " for character in characters]
        features[:count, 1] = [character.isupper() for character in characters]
        features[:count, 2] = [character.isdecimal() for character in characters]
        features[count - 1, 3] = features[0, 4] = 1.0
        inputs = {"numbers": np.array([*numbers, 0], np.int64), "features": features}
        # Of each character: 0 inside a token, 1 its end, 2 that of a sentence, 3 of several words, 4 of both.
        classes = self._network.run(None, inputs)[0][:count]
        ends = classes > 0
        ends[-1] = True
        return ends, classes >= 3


def _paragraph(text: str) -> Tuple[List[str], List[int]]:
    """Return the characters of the first paragraph, no two spaces in a row, and the place of each in the text."""
    start = 0
    for blank in [*_BLANK_LINE.finditer(text), None]:
        end = blank.start() if blank else len(text)
        end = start + len(text[start:end].rstrip())
        if end > start or blank is None:
            break
        start = blank.end()
    characters: List[str] = []
    places: List[int] = []
    for place in range(start, end):
        character = _SPACE.sub(" ", text[place])
        if character != " " or not characters or characters[-1] != " ":
            characters.append(character)
            places.append(place)
    return characters, places


class Expander:
    """Stanza's expander of multi-word tokens: a dictionary, and for others a network that says where to cut."""

    def __init__(self, files: WordFiles, network: Any) -> None:
        """
        Args:
            files: of the folder of words
            network: session of ONNX Runtime
        """
        self._dictionary = files.expansions
        self._numbers = files.token_characters
        self._network = network

    def words(self, token: str) -> List[str]:
        """Return the words of a token that may hold several; itself if it holds one."""
        words = (self._known(token) or self._cut(token)).split()
        return words if len(words) > 1 else [token]

    def _known(self, token: str) -> str:
        """Return the expansion that the dictionary has for a token, empty if none."""
        expansion = self._dictionary.get(token, "")
        if not expansion and token.isupper():
            expansion = self._dictionary.get(token.lower(), "").upper()
        if not expansion and token[0].isupper() and token[1:].islower():
            expansion = self._dictionary.get(token.lower(), "")
            expansion = expansion[:1].upper() + expansion[1:]
        return expansion

    def _cut(self, token: str) -> str:
        numbers = [self._numbers.get(character, UNKNOWN) for character in ("<SOS>", *token, "<EOS>")]
        (cuts,) = self._network.run(None, {"numbers": np.array(numbers, np.int64)})
        return "".join(f" {character}" if cut else character for character, cut in zip(token, cuts))
