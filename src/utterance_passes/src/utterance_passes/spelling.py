"""Rewrites what a tokenizer trained on text does not split: "90°", "3ft", "-3"."""

import re
from dataclasses import dataclass
from typing import List, Tuple

#: Marks of transcribers and of speech recognisers: "<pause>", "<no speech>".
TRANSCRIBERS_MARK = re.compile(r"<[a-zA-Z _-]{1,30}>")
APOSTROPHE = re.compile(r"[‘’ʼ`]")
QUOTATION_MARK = re.compile(r"[“”]")
DASH = re.compile(r"[–—]")
DEGREE_SIGN = re.compile(r"(?<=\d)\s*°")
#: Between a number and the unit that is written to it.
UNIT_AT_NUMBER = re.compile(
    r"(?<=\d)(?=(ft|cm|mm|km|dm|m|in|yd|s|min|h|deg|rad|feet|metres?|meters?|degrees?|seconds?)\b)"
)
MINUS_SIGN = re.compile(r"(?<!\S)-(?=\d)")
BLANKS = re.compile(r"\s+")


@dataclass(frozen=True)
class Spelling:
    """A text as the parser gets it.

    Attributes:
        text: rewritten
        origins: for each character of the text, and one past its end, the position in the text as it was said
    """

    text: str
    origins: Tuple[int, ...]


def as_said(text: str) -> Spelling:
    """Return the spelling of a text that nothing has rewritten."""
    return Spelling(text, tuple(range(len(text) + 1)))


def replaced(spelling: Spelling, pattern: "re.Pattern[str]", replacement: str) -> Spelling:
    """Rewrite a text, and remember where each character came from."""
    pieces: List[str] = []
    sources: List[int] = []
    position = 0
    for match in pattern.finditer(spelling.text):
        pieces.append(spelling.text[position : match.start()])
        sources += spelling.origins[position : match.start()]
        pieces.append(replacement)
        sources += [spelling.origins[match.start()]] * len(replacement)
        position = match.end()
    if not pieces:
        return spelling
    pieces.append(spelling.text[position:])
    sources += spelling.origins[position:]
    return Spelling("".join(pieces), tuple(sources))


def stripped(spelling: Spelling) -> Spelling:
    """Leave out blanks at both ends."""
    lead = len(spelling.text) - len(spelling.text.lstrip())
    text = spelling.text.strip()
    return Spelling(text, spelling.origins[lead : lead + len(text)] + (spelling.origins[lead + len(text)],))
