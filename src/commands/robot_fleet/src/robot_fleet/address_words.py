"""The words of ``addresses.yaml``, as phrases by their first word."""

from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Dict, FrozenSet, Iterable, List, Mapping, Sequence, Tuple

import yaml

from checked_files.source_files import read_text

#: The file is beside this module in the source, devel and install space.
ADDRESSES_FILE = Path(__file__).resolve().parent / "addresses.yaml"

Phrase = Tuple[str, ...]


class Phrases:
    """Phrases, of which the longest at a place counts."""

    def __init__(self, phrases: Iterable[str]) -> None:
        self._by_first: Dict[str, List[Phrase]] = {}
        for words in sorted({tuple(phrase.split()) for phrase in phrases}, key=len, reverse=True):
            self._by_first.setdefault(words[0], []).append(words)

    def length_at(self, words: Sequence[str], position: int) -> int:
        """Return the number of words of the longest phrase at a position; 0 for none."""
        found = self._by_first.get(words[position], ()) if position < len(words) else ()
        return next((len(one) for one in found if tuple(words[position : position + len(one)]) == one), 0)

    def __contains__(self, words: object) -> bool:
        """Whether a text is one of the phrases."""
        phrase = tuple(str(words).split())
        return bool(phrase) and phrase in self._by_first.get(phrase[0], ())


@dataclass(frozen=True)
class AddressWords:
    """The lists of the file: ``designators`` by kind, ``phrases`` and ``words`` by the name of their list.

    Attributes:
        designators: words for robots without a name, by their kind
        phrases: the other lists
        words: the same as sets
        numbers: "three", by the word
        ordinals: "third", by the word
        sounds_like: the number that a word after a title may stand for
        of_you: the form of a modal with "you"
    """

    designators: Mapping[str, Phrases]
    phrases: Mapping[str, Phrases]
    words: Mapping[str, FrozenSet[str]]
    numbers: Mapping[str, int]
    ordinals: Mapping[str, int]
    sounds_like: Mapping[str, str]
    of_you: Mapping[str, str]


@lru_cache(maxsize=None)
def address_words() -> AddressWords:
    """Return the words; the file is read once."""
    content = yaml.safe_load(read_text(str(ADDRESSES_FILE)))
    designators = content.pop("designators")
    numbers, ordinals = ({word: at for at, word in enumerate(content.pop(name))} for name in ("numbers", "ordinals"))
    sounds_like, of_you = content.pop("sounds_like"), content.pop("of_you")
    return AddressWords(
        designators={kind: Phrases(phrases) for kind, phrases in designators.items()},
        phrases={name: Phrases(phrases) for name, phrases in content.items()},
        words={name: frozenset(phrases) for name, phrases in content.items()},
        numbers=numbers,
        ordinals=ordinals,
        sounds_like=sounds_like,
        of_you=of_you,
    )
