"""Tells of which verbs a word may be the gerund."""

from typing import List

_ENDING = "ing"


def bases_of_gerund(form: str) -> List[str]:
    """Return the possible base forms of a gerund, "scrub" and "scrubb" for "scrubbing"; none if it cannot be one.

    Args:
        form: in lower case
    """
    stem = form[: -len(_ENDING)] if form.endswith(_ENDING) else ""
    doubled = [stem[:-1]] if stem[-1:] == stem[-2:-1] else []
    tied = [stem[:-1] + "ie"] if stem.endswith("y") else []
    return [stem, stem + "e", *doubled, *tied] if len(stem) > 1 else []
