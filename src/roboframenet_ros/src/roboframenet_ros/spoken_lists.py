"""Lists in sentences, the way a person says them."""

from typing import Iterable


def join_with_and(parts: Iterable[str]) -> str:
    """Return parts as a list: "a, b and c"; empty for none."""
    return _joined(parts, " and ")


def join_with_or(options: Iterable[str]) -> str:
    """Return options as a list: "a, b or c"; empty for none."""
    return _joined(options, " or ")


def _joined(parts: Iterable[str], last_joint: str) -> str:
    words = list(parts)
    return last_joint.join(filter(None, (", ".join(words[:-1]), *words[-1:])))
