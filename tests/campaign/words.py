"""Odd utterances and odd files, drawn at random from those that ship."""

import random
import re
from pathlib import Path
from typing import List, Sequence, Tuple

_ODD = (
    "", " ", "?", "...", "\t", "\n", "\x00", "\x1b[31m", "é", "ß", "ﬀ", "左", "🤖", "\u202e", "’", "“", "--", "-",
    "1e5", "e5", "1/0", "-0", "NaN", "inf", "1,5", "½", "٣", "0x10", "10^3", "3 1/2", "ninety-nine", "and", "or", "not",
    "if", "until", "don't", "stop", "please", "the the the", "\"", "(", ")", "[[x]]", "%s", "{}", "${HOME}", "<b>",
)  # fmt: skip


def odd_text(examples: Sequence[str], chance: random.Random) -> str:
    """Return an utterance: an example, or several, with words dropped, doubled, moved, cut or strewn in."""
    text = " ".join(chance.choice(examples) for _ in range(chance.choice((1, 1, 1, 2, 3))))
    words = text.split(" ")
    for _ in range(chance.randint(0, 5)):
        at = chance.randrange(len(words)) if words else 0
        change = chance.randrange(6)
        if change == 0 and len(words) > 1:
            del words[at]
        elif change == 1:
            words.insert(at, words[at] if words else "go")
        elif change == 2:
            words.insert(at, chance.choice(_ODD))
        elif change == 3 and words:
            words[at] = words[at][: chance.randint(0, len(words[at]))]
        elif change == 4:
            chance.shuffle(words)
        elif words:
            words[at] = chance.choice((words[at].upper(), words[at][::-1], words[at] + chance.choice(_ODD)))
    if chance.random() < 0.02:
        words = [chance.choice(words or ["a"])] * chance.choice((60, 150, 400))
    return " ".join(words)[:1500]


def yaml_texts(folder: Path) -> Tuple[List[str], List[str]]:
    """Return the texts of the shipped frame files and of the lexical unit files."""
    files = sorted(folder.rglob("*.yaml"))
    texts = {path: path.read_text(encoding="utf-8") for path in files}
    return (
        [text for path, text in texts.items() if path.parent.name == "frames"],
        [text for path, text in texts.items() if path.parent.name != "frames"],
    )


def malformed(text: str, chance: random.Random) -> bytes:
    """Return a file in which something is wrong, most of the time."""
    lines = text.splitlines()
    at = chance.randrange(len(lines))
    change = chance.randrange(12)
    if change == 0:
        lines[at] = re.sub(r"(\w+):", lambda match: match.group(1)[::-1] + "x:", lines[at], count=1)
    elif change == 1:
        lines.insert(at, lines[at])
    elif change == 2:
        lines[at] = "\t" + lines[at]
    elif change == 3:
        lines[at] = lines[at].replace(":", "", 1)
    elif change == 4:
        lines.insert(at, "unknown_key: [1, {a: !!python/object:os.system x}]")
    elif change == 5:
        lines[at] += " &a [*a]"
    elif change == 6:
        lines = lines[:at]
    elif change == 7:
        lines.append("x: " + "[" * 3000)
    elif change == 8:
        return "\n".join(lines).encode("utf-16")
    elif change == 9:
        return "\n".join(lines).encode() + bytes(chance.randrange(256) for _ in range(20))
    elif change == 10:
        lines += [f"key_{number}: {number}" for number in range(chance.choice((50, 2000)))]
    else:
        lines.insert(at, "---")
    return "\n".join(lines).encode("utf-8", "surrogateescape")
