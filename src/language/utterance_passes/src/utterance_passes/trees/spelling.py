"""Defines a text as the parser receives it: each character keeps its place in what was said."""

import re
from dataclasses import dataclass
from typing import Callable, List, Tuple, Union


@dataclass(frozen=True)
class Spelling:
    """A text as the parser receives it.

    Attributes:
        text: the rewritten text
        origins: for each character of the text, and one past its end, the position in the text as it was said
    """

    text: str
    origins: Tuple[int, ...]

    def part(self, start: int, end: int) -> "Spelling":
        """Return the part between two positions of the rewritten text."""
        return Spelling(self.text[start:end], self.origins[start : end + 1])

    def without(self, start: int, end: int) -> "Spelling":
        """Return the spelling without the part between two positions of the rewritten text."""
        return Spelling(self.text[:start] + self.text[end:], self.origins[:start] + self.origins[end:])


def as_said(text: str) -> Spelling:
    """Return the spelling of a text before any rewriting."""
    return Spelling(text, tuple(range(len(text) + 1)))


def replaced(
    spelling: Spelling, pattern: "re.Pattern[str]", replacement: Union[str, Callable[["re.Match[str]"], str]]
) -> Spelling:
    """Rewrite a text, and keep the origin of each character."""
    pieces: List[str] = []
    sources: List[int] = []
    position = 0
    for match in pattern.finditer(spelling.text):
        pieces.append(spelling.text[position : match.start()])
        sources += spelling.origins[position : match.start()]
        written = replacement if isinstance(replacement, str) else replacement(match)
        pieces.append(written)
        sources += [spelling.origins[match.start()]] * len(written)
        position = match.end()
    if not pieces:
        return spelling
    pieces.append(spelling.text[position:])
    sources += spelling.origins[position:]
    return Spelling("".join(pieces), tuple(sources))


def stripped(spelling: Spelling) -> Spelling:
    """Return a spelling without blanks at both ends."""
    lead = len(spelling.text) - len(spelling.text.lstrip())
    text = spelling.text.strip()
    return Spelling(text, spelling.origins[lead : lead + len(text)] + (spelling.origins[lead + len(text)],))
