"""Texts that come from outside, made fit for logs and messages: bounded, and without characters that move a cursor."""

import re

#: Most characters of a sentence for a person; servers may send any text.
MAX_SENTENCE = 2_000
_LINE_BREAKS = re.compile(r"\s*[\r\n\v\f\x1c-\x1e\x85\u2028\u2029]\s*")
#: Most characters of a trace; that of a sentence of ten words has about three thousand.
MAX_LENGTH = 20_000


def bounded(text: str, max_length: int = MAX_LENGTH) -> str:
    """Return the first lines of a text, up to a length, and the number of the lines left out."""
    if len(text) <= max_length:
        return text
    kept = text[:max_length].rpartition("\n")[0]
    more = text[len(kept) :].strip("\n").count("\n") + 1
    return f"{kept}\n... {more} more lines".lstrip("\n")


def one_line(text: str, max_length: int = MAX_SENTENCE) -> str:
    """Return a text on one line, with its control characters escaped, and cut to a length."""
    cut = _escaped(_LINE_BREAKS.sub(" ", text[: max_length + 1]))
    return cut if len(text) <= max_length else f"{cut[: max_length - 3]}..."


def as_log_lines(text: str) -> str:
    """Return a text for a log: further lines are indented, so that none looks like a record of its own, and control
    characters are escaped.
    """
    return "\n    ".join(_escaped(line) for line in re.split(r"\r\n|[\r\n\v\f\x85\u2028\u2029]", text))


def _escaped(text: str) -> str:
    if text.isprintable():
        return text
    return "".join(
        one if one.isprintable() else " " if one.isspace() else one.encode("unicode_escape").decode("ascii")
        for one in text
    )
