"""Reads the closed list of words that may go unread, each with its reason."""

from functools import lru_cache
from pathlib import Path

from checked_files.marked_yaml import Reader
from checked_files.source_files import read_text
from semantic_framer.values.phrase_table import PhraseTable

#: Next to this module in the source, devel and install space.
UNREAD_WORDS_FILE = Path(__file__).resolve().parent / "unread_words.yaml"
#: More words would hide what a person wants.
MOST_UNREAD_WORDS = 40


def load_unread_words(text: str, path: str) -> PhraseTable[str]:
    """Read the words that may go unread, each with its reason.

    Args:
        text: content of the file
        path: path of the file, for problems
    Raises:
        FileRefused: lists every mistake in the file
    """
    reader = Reader(path)
    found = {}
    root = reader.compose(text, "a list of words")
    for key, item in reader.sequence(root, ""):
        entries = reader.mapping(item, key, ("words", "reason"), required=("words", "reason"))
        reason = reader.name(entries.get("reason"), f"{key}.reason")
        for phrase in reader.texts(entries["words"], f"{key}.words") if "words" in entries else ():
            found[tuple(phrase.split())] = reason
    count = sum(map(len, found))
    if root is not None and count > MOST_UNREAD_WORDS:
        reader.report("TOO_MANY", root, "", f"{count} words", f"at most {MOST_UNREAD_WORDS}")
    reader.refuse_if_wrong()
    return PhraseTable(found)


@lru_cache(maxsize=None)
def shipped_unread_words() -> PhraseTable[str]:
    """Return the words of ``unread_words.yaml``, read once.

    Raises:
        FileRefused: the file is wrong
    """
    return load_unread_words(read_text(str(UNREAD_WORDS_FILE)), str(UNREAD_WORDS_FILE))
