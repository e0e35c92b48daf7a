"""Words that say when a command begins, while another one runs: "then go home", "meanwhile say hello".

The framer does not know what runs. It passes on what was said, and the executor decides.
"""

from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import FrozenSet, List, Mapping, Optional, Tuple

from semantic_frames.marked_yaml import Reader
from semantic_frames.source_files import read_text
from utterance_passes.formula_file import is_filler
from utterance_passes.objections import plain
from utterance_passes.tree import DependencyTree, Word

#: Next to this module in the source, devel and install space.
BEGINNINGS_FILE = Path(__file__).resolve().parent / "beginnings.yaml"
_KINDS = ("follow", "beside")
_PLACES = ("front", "behind")

#: What a contraction stands for in these phrases: "when you're done", "when that's done", "when you've finished".
_IN_FULL = {"'re": "are", "'s": "is", "'ve": "have"}

_Phrases = Mapping[Tuple[str, str], FrozenSet[Tuple[str, ...]]]


@dataclass(frozen=True)
class Beginning:
    """When a command begins.

    Attributes:
        kind: FOLLOW or BESIDE, as in the Plan message
        positions: of the words that say so
    """

    kind: str
    positions: FrozenSet[int]


def load_beginnings(text: str, path: str) -> _Phrases:
    """Read a file of such words, by kind and place.

    Args:
        text: content of the file
        path: path of the file, for problems
    Raises:
        FileRefused: lists every mistake in the file
    """
    reader = Reader(path)
    kinds = reader.mapping(reader.compose(text, "a mapping of words"), "", _KINDS, required=_KINDS)
    found = {}
    for kind in kinds:
        places = reader.mapping(kinds[kind], kind, _PLACES, required=_PLACES)
        for place in places:
            phrases = reader.texts(places[place], f"{kind}.{place}")
            found[kind, place] = frozenset(tuple(phrase.split()) for phrase in phrases)
    reader.refuse_if_wrong()
    return found


@lru_cache(maxsize=None)
def shipped_beginnings() -> _Phrases:
    """Return the words of ``beginnings.yaml``, read once.

    Raises:
        FileRefused: the file is wrong
    """
    return load_beginnings(read_text(str(BEGINNINGS_FILE)), str(BEGINNINGS_FILE))


def beginning_of(tree: DependencyTree) -> Optional[Beginning]:
    """Return when a command begins; None if nothing is said about it, or nothing else is said."""
    words = [word for word in tree.words if word.upos != "PUNCT" and word.index not in tree.quoted]
    while words and is_filler(words[0].form) and (plain(words[0]),) not in shipped_beginnings()["follow", "front"]:
        words.pop(0)
    while words and is_filler(words[-1].form):
        words.pop()
    forms = [_IN_FULL.get(plain(word).replace("’", "'"), plain(word)) for word in words]
    for kind in _KINDS:
        for place in _PLACES:
            length = _longest(forms, shipped_beginnings()[kind, place], is_behind=place == "behind")
            if 0 < length < len(words):
                said: List[Word] = words[-length:] if place == "behind" else words[:length]
                return Beginning(kind.upper(), frozenset(word.index for word in said))
    return None


def _longest(forms: List[str], phrases: FrozenSet[Tuple[str, ...]], *, is_behind: bool) -> int:
    """Return the number of words of the longest phrase at an end; 0 for none."""
    fits = (
        len(phrase)
        for phrase in phrases
        if tuple(forms[-len(phrase) :] if is_behind else forms[: len(phrase)]) == phrase
    )
    return max(fits, default=0)
