"""Words that say when a command begins, while another one runs: "then go home", "meanwhile say hello".

The framer does not know what runs. It passes on what was said, and the executor decides.
"""

from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import FrozenSet, List, Mapping, Optional, Sequence, Tuple

from checked_files.marked_yaml import Reader
from checked_files.source_files import read_text
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.phrase_table import PhraseTable
from semantic_framer.values.sentence import Sentence
from utterance_passes.asides.objections import plain
from utterance_passes.trees.formula_file import is_filler
from utterance_passes.trees.tree import ASIDE, DependencyTree, Word
from utterance_passes.trees.tree_edits import NotATree, mark_times, set_aside
from word_classes import word_class

#: Next to this module in the source, devel and install space.
BEGINNINGS_FILE = Path(__file__).resolve().parent / "beginnings.yaml"
_PREPOSITIONS = word_class("place_prepositions_alike")
_KINDS = ("follow", "beside")
_PLACES = ("front", "behind")

#: By kind and place. A phrase behind a command is kept by its last word first: that word ends the utterance.
_Phrases = Mapping[Tuple[str, str], PhraseTable[str]]


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
            found[kind, place] = PhraseTable({_from(place, phrase.split()): phrase for phrase in phrases})
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
    while words and is_filler(words[0].form) and not shipped_beginnings()["follow", "front"].at([plain(words[0])])[1]:
        words.pop(0)
    while words and is_filler(words[-1].form):
        words.pop()
    forms = [plain(word) for word in words]
    for kind in _KINDS:
        for place in _PLACES:
            length = _length(shipped_beginnings()[kind, place], _from(place, forms))
            if 0 < length < len(words) and not (place == "front" and " ".join(forms[:2]) in _PREPOSITIONS):
                said: List[Word] = words[-length:] if place == "behind" else words[:length]
                return Beginning(kind.upper(), frozenset(word.index for word in said))
    return None


def without_beginning(sentence: Sentence, beginning: Beginning, known: FramedLexicon) -> Optional[Sentence]:
    """Return a sentence with the words that say when it begins set aside; None if the other words make no tree."""
    tree = sentence.tree

    def is_verb(word: Word) -> bool:
        return word.upos == "VERB" or bool(known.verbs_beginning_with(word.lemma.lower()))

    # A time among these words is accounted for.
    times = tuple(time for time in tree.times if not time <= beginning.positions)
    try:
        made = set_aside(tree, beginning.positions, ASIDE, is_verb)
    except NotATree:
        return None
    return Sentence(mark_times(made, times), known.types)


def _from(place: str, words: Sequence[str]) -> Tuple[str, ...]:
    """Return words as they are counted from the end of the utterance at which a phrase stands."""
    return tuple(reversed(words)) if place == "behind" else tuple(words)


def _length(phrases: PhraseTable[str], forms: Sequence[str]) -> int:
    """Return the number of words of the longest phrase that words begin with; 0 for none."""
    near = phrases.begins_with(forms[0]) if forms else ()
    return next((len(phrase) for phrase, _ in near if _are_same(forms[: len(phrase)], phrase)), 0)


def _are_same(forms: Sequence[str], phrase: Tuple[str, ...]) -> bool:
    """Whether words are those of a phrase; a contraction ends like its word: "'re" and "are"."""
    return len(forms) == len(phrase) and all(
        form == word or (form[0] in "'\u2019" and word.endswith(form[1:])) for form, word in zip(forms, phrase)
    )
