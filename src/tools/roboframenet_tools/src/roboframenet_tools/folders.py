"""Folders of frames and units in the arguments of commands."""

import os
from typing import Iterable, List


def folders_of(texts: Iterable[str]) -> List[str]:
    """Return the folders of arguments in which commas separate them, as in the launch files.

    Raises:
        NotADirectoryError: one does not exist
    """
    folders = [folder.strip() for text in texts for folder in text.split(",") if folder.strip()]
    for folder in folders:
        if not os.path.exists(folder):
            raise NotADirectoryError(f"there is no folder {folder}")
    return folders
