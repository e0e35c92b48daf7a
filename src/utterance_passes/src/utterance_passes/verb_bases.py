"""Tells of which verbs a word may be the gerund or the participle."""

from typing import List


def bases_of_gerund(form: str) -> List[str]:
    """Return the possible base forms of a gerund, "scrub" and "scrubb" for "scrubbing"; none if it cannot be one.

    Args:
        form: in lower case
    """
    stem = _stem(form, "ing")
    tied = [stem[:-1] + "ie"] if stem.endswith("y") else []
    return [*_bases_of_stem(stem), *tied]


def bases_of_participle(form: str) -> List[str]:
    """Return the possible base forms of a regular participle, "tidy" for "tidied"; none if it cannot be one.

    Args:
        form: in lower case
    """
    stem = _stem(form, "ed")
    tidied = [stem[:-1] + "y"] if stem.endswith("i") else []
    return [*_bases_of_stem(stem), *tidied]


def _stem(form: str, ending: str) -> str:
    return form[: -len(ending)] if form.endswith(ending) and len(form) > len(ending) + 1 else ""


def _bases_of_stem(stem: str) -> List[str]:
    doubled = [stem[:-1]] if stem[-1:] == stem[-2:-1] else []
    return [stem, stem + "e", *doubled] if stem else []
