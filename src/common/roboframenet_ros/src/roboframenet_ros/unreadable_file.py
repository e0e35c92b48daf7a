"""What becomes of a file that cannot be read."""

import os
from typing import Sequence


def set_aside(path: str, *, journals: Sequence[str] = ()) -> str:
    """Rename a file that cannot be read, so that nothing overwrites what somebody may still mend.

    Args:
        path: of the file
        journals: endings of the files that belong to it, if they are there
    Returns:
        its new path
    Raises:
        OSError: it cannot be renamed
    """
    path = os.path.realpath(path)
    number = 1
    while os.path.lexists(f"{path}.unreadable.{number}"):
        number += 1
    aside = f"{path}.unreadable.{number}"
    os.rename(path, aside)
    for journal in journals:
        if os.path.lexists(path + journal):
            os.rename(path + journal, aside + journal)
    return aside
