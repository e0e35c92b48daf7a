"""Sounds of words in ARPAbet: from the dictionary of the acoustic model, and from espeak-ng for other words."""

import shutil
import subprocess
from functools import lru_cache
from typing import Callable, Dict, FrozenSet, Iterable, List, Mapping, Optional, Tuple

from voice_recognition.voice_words import voice_words

#: The ways to pronounce each word.
Dictionary = Mapping[str, Tuple[str, ...]]
#: Seconds for espeak-ng.
TIMEOUT_S = 5.0
_LONGEST_MNEMONIC = 4


@lru_cache(maxsize=2)
def read_dictionary(path: str) -> Dictionary:
    """Read a dictionary in the form of the CMU's; further ways of a word have a number behind it: "the(2)"."""
    found: Dict[str, List[str]] = {}
    with open(path, encoding="utf-8", errors="replace") as file:
        for line in file:
            word, _, sounds = line.strip().partition(" ")
            if sounds:
                found.setdefault(word.split("(")[0], []).append(sounds.strip())
    return {word: tuple(ways) for word, ways in found.items()}


def pronounce(
    words: Iterable[str], known: Dictionary, guess: Optional[Callable[[str], str]] = None
) -> Tuple[Dictionary, FrozenSet[str]]:
    """Find the sounds of words.

    Args:
        words: in lower case
        known: the dictionary
        guess: the sounds of a word that it lacks, empty for none; None asks espeak-ng
    Returns:
        a dictionary of the words, and the words that nobody can pronounce
    """
    found: Dict[str, Tuple[str, ...]] = {}
    unknown: List[str] = []
    for word in sorted(set(words)):
        ways = known.get(word) or _of_parts(word, known)
        if not ways:
            sounds = (guess or sounds_by_espeak)(word)
            ways = (sounds,) if sounds else ()
        if ways:
            found[word] = ways
        else:
            unknown.append(word)
    return found, frozenset(unknown)


def _of_parts(word: str, known: Dictionary) -> Tuple[str, ...]:
    """Return the sounds of a word with a hyphen or a genitive from those of its parts."""
    if word.endswith("'s") and word[:-2] in known:
        sounds = known[word[:-2]][0]
        last = sounds.split()[-1]
        ending = "IH Z" if last in ("S", "Z", "SH", "ZH", "CH", "JH") else "S" if last in ("P", "T", "K", "F") else "Z"
        return (f"{sounds} {ending}",)
    parts = word.split("-")
    if len(parts) > 1 and all(part in known for part in parts):
        return (" ".join(known[part][0] for part in parts),)
    return ()


@lru_cache(maxsize=5000)
def sounds_by_espeak(word: str) -> str:
    """Return the sounds that espeak-ng gives a word, in ARPAbet; empty when it gives none."""
    program = shutil.which("espeak-ng")
    if program is None:
        return ""
    try:
        answer = subprocess.run(
            [program, "-q", "-v", "en-us", "-x", "--sep= ", "--", word],
            capture_output=True,
            text=True,
            timeout=TIMEOUT_S,
            check=True,
        )
    except (OSError, subprocess.SubprocessError):
        return ""
    return to_arpabet(answer.stdout)


def to_arpabet(mnemonics: str) -> str:
    """Return ARPAbet for espeak-ng's mnemonics, "f 'oU n i:m": empty when one of them is unknown."""
    table = voice_words().sounds
    found: List[str] = []
    for part in mnemonics.split():
        rest = part.lstrip("',%=")
        while rest:
            length = next((n for n in range(min(_LONGEST_MNEMONIC, len(rest)), 0, -1) if rest[:n] in table), 0)
            if not length:
                if rest[0] in "',%=_:;|!~^-":
                    rest = rest[1:]
                    continue
                return ""
            found += table[rest[:length]]
            rest = rest[length:]
    return " ".join(found)
