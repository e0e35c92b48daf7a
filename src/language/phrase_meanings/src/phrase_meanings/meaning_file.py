"""Reads the file of meanings: the spellings of relations, directions, quantifiers, bounds and measures."""

from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Dict, FrozenSet, Mapping, Optional, Sequence

import yaml

from checked_files.marked_yaml import Reader
from checked_files.source_files import read_text
from semantic_types.parts_of_speech import ADJECTIVE, base_forms

#: Next to this module in the source, devel and install space.
MEANINGS_FILE = Path(__file__).resolve().parent / "meanings.yaml"
_SECTIONS = ("relations", "directions", "quantifiers", "bounds", "measures", "exceptions")


@dataclass(frozen=True)
class Meanings:
    """The content of the file; each mapping leads from spoken words to a value of a typed argument.

    Attributes:
        relations: of prepositions: "under" for "underneath"
        directions: "counterclockwise" for "anticlockwise"
        quantifiers: "a" for "an"
        bounds: "at_most" for "up to"
        measures: of adjectives in their base form: "height" for "tall", "-size" for "small"
        exceptions: prepositions that exclude something
    """

    relations: Mapping[str, str]
    directions: Mapping[str, str]
    quantifiers: Mapping[str, str]
    bounds: Mapping[str, str]
    measures: Mapping[str, str]
    exceptions: FrozenSet[str]

    def relation(self, prepositions: str) -> str:
        """Return the relation of spoken prepositions; those without an entry are their own relation."""
        spoken = " ".join(prepositions.lower().split())
        return self.relations.get(spoken) or spoken.replace(" ", "_")

    def bound(self, before: Sequence[str]) -> str:
        """Return the bound that the last words before a number make of it; empty for none."""
        spoken = (" ".join(before[-2:]), " ".join(before[-1:]))
        return next((self.bounds[words] for words in spoken if words in self.bounds), "")


def load_meanings(text: str, path: str) -> Meanings:
    """Read a file of meanings.

    Args:
        text: content of the file
        path: path of the file, for problems
    Raises:
        FileRefused: the file is wrong; it lists every mistake
    """
    reader = Reader(path)
    sections = reader.mapping(reader.compose(text, "a mapping of meanings"), "", _SECTIONS, required=_SECTIONS)
    spellings = {name: _spellings(reader, sections.get(name), name) for name in _SECTIONS[:-1]}
    exceptions = frozenset(reader.texts(sections.get("exceptions"), "exceptions"))
    reader.refuse_if_wrong()
    return Meanings(exceptions=exceptions, **spellings)


def _spellings(reader: Reader, node: Optional[yaml.Node], section: str) -> Dict[str, str]:
    """Return the value of each spelling; a spelling with two values is a mistake."""
    found: Dict[str, str] = {}
    for name_node, words in reader.free_mapping(node, section):
        key = f"{section}.{name_node.value}"
        for spelling in reader.texts(words, key):
            if spelling in found:
                reader.report("DUPLICATE_SPELLING", words, key, spelling, "a spelling that no other entry has")
            found[spelling] = name_node.value
    return found


@lru_cache(maxsize=1024)
def measure_of(word: str) -> str:
    """Return what a word measures, with a minus for little of it: "height" for "tallest" and "height"; empty for none.

    Args:
        word: an adjective in any degree, or the name of a measure, in lower case
    """
    measures = shipped_meanings().measures
    if word in measures.values():
        return word
    return next((measures[base] for base in base_forms(word, ADJECTIVE) if base in measures), "")


@lru_cache(maxsize=None)
def shipped_meanings() -> Meanings:
    """Return the meanings of ``meanings.yaml``, read once.

    Raises:
        FileRefused: the file is wrong
    """
    return load_meanings(read_text(str(MEANINGS_FILE)), str(MEANINGS_FILE))
