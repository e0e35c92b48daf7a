"""Words put together the way a person says them: lists, and beginnings of sentences."""

from typing import Iterable


def join_with_and(parts: Iterable[str]) -> str:
    """Return parts as a list: "a, b and c"; empty for none."""
    return _joined(parts, " and ")


def join_with_or(options: Iterable[str]) -> str:
    """Return options as a list: "a, b or c"; empty for none."""
    return _joined(options, " or ")


def with_capital(text: str) -> str:
    """Return a text with a capital at its beginning; the rest stays as it is."""
    return text[:1].upper() + text[1:]


def _joined(parts: Iterable[str], last_joint: str) -> str:
    words = list(parts)
    return last_joint.join(filter(None, (", ".join(words[:-1]), *words[-1:])))
