"""Reads the file of formulas: patterns of the words that people say around a command, each with an example."""

import re
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Dict, Iterable, List, Mapping, Pattern, Sequence, Tuple

import yaml

from checked_files.marked_yaml import Reader
from checked_files.source_files import read_text
from word_classes import read_pattern, word_class

#: The file is next to this module in the source, devel and install spaces.
FORMULAS_FILE = Path(__file__).resolve().parent / "formulas.yaml"
KINDS = (
    "openings",
    "modal_openings",
    "gerund_openings",
    "anywhere",
    "apart",
    "comparisons",
    "endings",
    "tails",
    "set_off_tails",
    "objections",
    "editing_terms",
    "withdrawals",
    "fillers",
    "phrases_of_hesitation",
    "contractions",
)
_KEYS = ("pattern", "example")
#: What an example is without its formula, if the file does not say.
_LEFT = "turn left"
#: The kind whose formulas also have a full form.
WRITTEN_OUT = "contractions"


@dataclass(frozen=True)
class Formula:
    """A pattern of words.

    Attributes:
        pattern: must match all of some words, in lower case, with one blank between them
        example: a sentence that contains the formula
        becomes: the example without the formula; the file need not name the usual one
        written: the full form, with the groups of the pattern as ``\\1``; empty if the formula is left out
    """

    pattern: Pattern[str]
    example: str
    becomes: str = ""
    written: str = ""


def load_formulas(
    text: str, path: str, kinds: Sequence[str] = KINDS, keys: Sequence[str] = _KEYS
) -> Mapping[str, Tuple[Formula, ...]]:
    """Read a file of formulas.

    Args:
        text: content of the file
        path: path of the file, for problems
        kinds: kinds that the file must have
        keys: keys that each formula must have
    Returns:
        formulas by kind
    Raises:
        FileRefused: lists every mistake in the file
    """
    reader = Reader(path)
    nodes = reader.mapping(reader.compose(text, "a mapping of formulas"), "", kinds, required=kinds)
    found: Dict[str, Tuple[Formula, ...]] = {}
    for kind, node in nodes.items():
        formulas: List[Formula] = []
        for key, item in reader.sequence(node, kind):
            wanted = (*keys, "becomes", "written") if kind == WRITTEN_OUT else keys
            entries = reader.mapping(item, key, (*wanted, "becomes"), required=wanted)
            written = reader.name(entries.get("written"), f"{key}.written") if "written" in entries else ""
            example = reader.name(entries.get("example"), f"{key}.example")
            becomes = reader.name(entries.get("becomes"), f"{key}.becomes") if "becomes" in entries else _LEFT
            if "pattern" in entries:
                pattern = _pattern(reader, entries["pattern"], f"{key}.pattern")
                formulas.append(Formula(pattern, example, becomes, written))
        if not formulas:
            reader.report("EMPTY", node, kind, "nothing", "a list of patterns")
        found[kind] = tuple(formulas)
    reader.refuse_if_wrong()
    return found


def _pattern(reader: Reader, node: yaml.Node, key: str) -> Pattern[str]:
    text = reader.name(node, key)
    if text.replace("(?P<", "(?p<") != text.lower():
        reader.report("NOT_LOWER_CASE", node, key, f"'{text}'", f"'{text.lower()}'")
    return read_pattern(reader, node, key)


@lru_cache(maxsize=None)
def shipped_formulas() -> Mapping[str, Tuple[Formula, ...]]:
    """Return the formulas of ``formulas.yaml``, read once.

    Raises:
        FileRefused: the file has mistakes
    """
    return load_formulas(read_text(str(FORMULAS_FILE)), str(FORMULAS_FILE))


def pattern_of(kind: str) -> Pattern[str]:
    """Return a pattern that matches whatever any shipped formula of a kind matches."""
    return any_of(shipped_formulas()[kind])


def any_of(formulas: Iterable[Formula]) -> Pattern[str]:
    """Return a pattern that matches whatever any of some formulas matches."""
    return re.compile("|".join(f"(?:{formula.pattern.pattern})" for formula in formulas))


_FILLER = pattern_of("fillers")
_PADDING = word_class("padding")


@lru_cache(maxsize=4096)
def is_filler(form: str) -> bool:
    """Whether people say a word only while they think: "um", "uhhh"."""
    return _FILLER.fullmatch(form.lower()) is not None


def without_padding(forms: Iterable[str]) -> str:
    """Return words in the form that the patterns of openings expect: in lower case, without commas and padding."""
    said = (form.lower().replace("’", "'") for form in forms)
    return " ".join(form for form in said if form not in _PADDING and form != ",")
