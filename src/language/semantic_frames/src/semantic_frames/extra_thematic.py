"""Extra-thematic frame elements, which every frame inherits: how, how long, how often, why, where."""

from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from types import MappingProxyType
from typing import FrozenSet, List, Mapping, Tuple

from checked_files.marked_yaml import Reader
from checked_files.source_files import read_text

#: Next to this module in the source, devel and install space.
EXTRA_THEMATIC_FILE = Path(__file__).resolve().parent / "extra_thematic.yaml"
_KEYS = ("name", "prepositions", "adverbs", "heads", "measure", "clauses")


@dataclass(frozen=True)
class ExtraThematicElement:
    """An element that belongs to no frame in particular.

    Attributes:
        name: FrameNet's name
        prepositions: prepositions of its phrases
        adverbs: adverbs and adverbial phrases
        endings: endings of further adverbs: "ly"
        heads: heads of its phrases; empty for any
        measure: kind of measure that its phrases must have; empty for any phrase
        clauses: words that begin its clauses
    """

    name: str
    prepositions: FrozenSet[str] = frozenset()
    adverbs: FrozenSet[str] = frozenset()
    endings: Tuple[str, ...] = ()
    heads: FrozenSet[str] = frozenset()
    measure: str = ""
    clauses: FrozenSet[str] = frozenset()


def load_extra_thematic(text: str, path: str) -> Tuple[ExtraThematicElement, ...]:
    """Read a file of extra-thematic elements.

    Args:
        text: content of the file
        path: path of the file, for problems
    Raises:
        FileRefused: the file is wrong; it lists every mistake
    """
    reader = Reader(path)
    found: List[ExtraThematicElement] = []
    for key, node in reader.sequence(reader.compose(text, "a list of elements"), ""):
        entries = reader.mapping(node, key, _KEYS, required=("name",))
        adverbs = reader.texts(entries.get("adverbs"), f"{key}.adverbs")
        found.append(
            ExtraThematicElement(
                name=reader.name(entries.get("name"), f"{key}.name"),
                prepositions=frozenset(reader.texts(entries.get("prepositions"), f"{key}.prepositions")),
                adverbs=frozenset(adverb for adverb in adverbs if not adverb.startswith("-")),
                endings=tuple(adverb[1:] for adverb in adverbs if adverb.startswith("-")),
                heads=frozenset(reader.texts(entries.get("heads"), f"{key}.heads")),
                measure=reader.text(entries.get("measure"), f"{key}.measure"),
                clauses=frozenset(reader.texts(entries.get("clauses"), f"{key}.clauses")),
            )
        )
    reader.refuse_if_wrong()
    return tuple(found)


@lru_cache(maxsize=None)
def extra_thematic_elements() -> Tuple[ExtraThematicElement, ...]:
    """Return the elements that every frame inherits; the file is read once.

    Raises:
        FileRefused: the file is wrong
    """
    return load_extra_thematic(read_text(str(EXTRA_THEMATIC_FILE)), str(EXTRA_THEMATIC_FILE))


@lru_cache(maxsize=None)
def extra_thematic_names() -> FrozenSet[str]:
    """Return the names of the elements that every frame inherits."""
    return frozenset(element.name for element in extra_thematic_elements())


@lru_cache(maxsize=None)
def is_of_every_action(preposition: str, head: str) -> bool:
    """Whether a phrase says how an action is done because of its head: "by hand", "at a safe distance", and not "by the
    door".
    """
    return any(
        preposition in element.prepositions and head.lower() in element.heads for element in extra_thematic_elements()
    )


@lru_cache(maxsize=None)
def extra_thematic_of_arguments() -> Mapping[str, str]:
    """Return FrameNet's name of each extra-thematic element, by the name of its arguments: "Manner" by "manner"."""
    return MappingProxyType({name.lower(): name for name in sorted(extra_thematic_names())})
