"""Rewrites what a tokenizer trained on text does not split: "90°", "3ft", "-3", "gonna"."""
import re
from dataclasses import dataclass
from typing import Callable, List, Tuple, Union

from stanford_parser_ros.contractions import CONTRACTION, written_out

_RULES: Tuple[Tuple["re.Pattern[str]", Union[str, Callable[["re.Match[str]"], str]]], ...] = (
    # Marks of transcribers and of speech recognisers: "<pause>", "<no speech>".
    (re.compile(r"<[a-zA-Z _-]{1,30}>"), " "),
    (re.compile(r"[‘’ʼ`]"), "'"),
    (re.compile(r"[“”]"), '"'),
    (re.compile(r"[–—]"), "-"),
    (re.compile(r"(?<=\d)\s*°"), " degrees"),
    (re.compile(r"(?<=\d)(?=(ft|cm|mm|km|dm|m|in|yd|s|min|h|deg|rad|feet|metres?|meters?|degrees?|seconds?)\b)"), " "),
    (re.compile(r"(?<!\S)-(?=\d)"), "minus "),
    (CONTRACTION, written_out),
    (re.compile(r"\s+"), " "),
)


@dataclass(frozen=True)
class Spelling:
    """A text as the parser gets it.

    Attributes:
        text: rewritten
        origins: for each character of the text, and one past its end, the position in the text as it was said
    """

    text: str
    origins: Tuple[int, ...]

    def part(self, start: int, end: int) -> "Spelling":
        """Return what stands between two positions of the rewritten text."""
        return Spelling(self.text[start:end], self.origins[start : end + 1])


def rewrite(said: str) -> Spelling:
    """Rewrite a text, and remember where each character came from."""
    text = said
    origins: List[int] = list(range(len(said) + 1))
    for pattern, replacement in _RULES:
        pieces: List[str] = []
        sources: List[int] = []
        position = 0
        for match in pattern.finditer(text):
            pieces.append(text[position:match.start()])
            sources += origins[position:match.start()]
            written = replacement if isinstance(replacement, str) else replacement(match)
            pieces.append(written)
            sources += [origins[match.start()]] * len(written)
            position = match.end()
        pieces.append(text[position:])
        sources += origins[position:]
        text, origins = "".join(pieces), sources
    lead = len(text) - len(text.lstrip())
    stripped = text.strip()
    return Spelling(text=stripped, origins=tuple(origins[lead:lead + len(stripped)] + [origins[lead + len(stripped)]]))
