"""The word classes of ``words.yaml``, by name."""

from functools import lru_cache
from pathlib import Path
from typing import FrozenSet, Mapping, Optional, Tuple

from checked_files.marked_yaml import did_you_mean
from checked_files.source_files import read_text
from word_classes.word_file import WordClass, load_word_classes

#: The file is beside this module in the source, devel and install space.
WORDS_FILE = Path(__file__).resolve().parent / "words.yaml"


class UnknownWordClass(LookupError):
    """No class has this name."""


@lru_cache(maxsize=None)
def word_classes() -> Mapping[str, WordClass]:
    """Return all classes; the file is read once.

    Raises:
        FileRefused: the file is wrong
    """
    return load_word_classes(read_text(str(WORDS_FILE)), str(WORDS_FILE))


def word_list(name: str) -> Tuple[str, ...]:
    """Return the words of a class in the order of the file.

    Raises:
        UnknownWordClass: no class has this name
    """
    known = word_classes()
    if name not in known:
        raise UnknownWordClass(f"{WORDS_FILE}: no class '{name}' {did_you_mean(name, known)}".strip())
    return known[name].words


@lru_cache(maxsize=None)
def word_class(name: str) -> FrozenSet[str]:
    """Return the words of a class.

    Raises:
        UnknownWordClass: no class has this name
    """
    return frozenset(word_list(name))


def without_determiner(name: str, determiners: Optional[FrozenSet[str]] = None) -> str:
    """Return a name without its determiner: "office" for "the office", "the" for "the".

    Args:
        name: the spoken name
        determiners: words to leave out; None for the class of that name
    """
    first, _, rest = name.strip().partition(" ")
    known = word_class("determiners") if determiners is None else determiners
    return rest.strip() if rest and first.lower() in known else name.strip()
