"""Writes a language as a grammar in the JSpeech Grammar Format: classes for slots, right recursion only."""

import re
from typing import Dict, FrozenSet, Iterable, List, Sequence, Tuple, Union

from voice_recognition.spoken_language import Slot, SpokenLanguage, Words
from voice_recognition.voice_words import voice_words

#: A trie of parts; the empty string marks the end of a command.
_Trie = Dict[Union[str, Tuple[str]], "_Trie"]
END = ""


def write_grammar(
    language: SpokenLanguage, *, phrases: Iterable[Words] = (), without: FrozenSet[str] = frozenset()
) -> str:
    """Return the grammar of the commands.

    Templates that begin alike share their beginning, which keeps the search small.

    Args:
        language: what can be said
        phrases: what can be said besides, such as "stop"
        without: words that nobody can pronounce; whatever contains them is left out
    """
    rules: Dict[str, str] = {}
    names: Dict[str, str] = {}
    for template in language.templates:
        for slot in template.slots:
            if slot.filled_from not in names:
                ways = [
                    way
                    for filler in language.classes[slot.filled_from]
                    for way in filler.ways
                    if not without & set(way)
                ]
                if ways:
                    names[slot.filled_from] = f"class{len(names)}"
                    rules[names[slot.filled_from]] = _alternatives(ways)
    root: _Trie = {}
    for template in language.templates:
        words = {part for part in template.parts if isinstance(part, str)}
        if words & without or any(slot.filled_from not in names for slot in template.slots):
            continue
        node = root
        for part in template.parts:
            key = (f"<{names[part.filled_from]}>",) if isinstance(part, Slot) else part
            node = node.setdefault(key, {})
        node[END] = {}
    for phrase in phrases:
        node = root
        for word in phrase:
            node = node.setdefault(word, {})
        node[END] = {}
    known = voice_words()
    before = _alternatives(phrase for phrase in known.polite_before if not without & set(phrase))
    after = _alternatives(phrase for phrase in known.polite_after if not without & set(phrase))
    lines = ["#JSGF V1.0;", "grammar robot;", f"public <said> = [ {before} ] <command> [ {after} ];"]
    lines.append(f"<command> = {_of_trie(root)};")
    lines += [f"<{name}> = {alternatives};" for name, alternatives in rules.items()]
    return "\n".join(lines) + "\n"


def write_phrases(phrases: Iterable[Words]) -> str:
    """Return a grammar of some phrases, such as answers."""
    return f"#JSGF V1.0;\ngrammar phrases;\npublic <said> = {_alternatives(phrases)};\n"


def _alternatives(ways: Iterable[Sequence[str]]) -> str:
    """Return ways of saying something that share their beginnings."""
    root: _Trie = {}
    for way in ways:
        node = root
        for word in way:
            node = node.setdefault(word, {})
        node[END] = {}
    return _of_trie(root)


def _of_trie(node: "_Trie") -> str:
    options: List[str] = []
    for key, below in node.items():
        if key == END:
            continue
        word = key if isinstance(key, str) else key[0]
        rest = _of_trie(below) if set(below) != {END} else ""
        options.append(f"{_escaped(word)} {rest}".strip())
    joined = " | ".join(options)
    if END not in node and len(options) > 1:
        return f"({joined})"
    return f"[ {joined} ]" if END in node else joined


def _escaped(word: str) -> str:
    """Return a word without the signs that the grammar uses itself."""
    return word if word.startswith("<") else re.sub(r"[^\w'.-]", "", word)
