"""Finds and reads the files that robot programmers write."""

import os
from typing import Iterable, Iterator, List, Tuple

from semantic_frames.problem import FileRefused, Problem

#: Names of the folders of a domain.
FRAMES_FOLDER = "frames"
LEXICAL_UNITS_FOLDER = "lexical_units"


def yaml_files(paths: Iterable[str], folder_name: str) -> Iterator[str]:
    """Find the YAML files below some paths.

    Args:
        paths: files, which are taken as they are, and folders, below which the YAML files of every folder named
            ``folder_name`` are taken
        folder_name: :data:`FRAMES_FOLDER` or :data:`LEXICAL_UNITS_FOLDER`
    Returns:
        absolute paths, in the order of the paths and by name within a folder
    """
    for path in paths:
        if not os.path.isdir(path):
            yield os.path.abspath(path)
            continue
        for folder, folders, names in os.walk(path):
            folders.sort()
            if os.path.basename(os.path.abspath(folder)) == folder_name:
                yield from (
                    os.path.abspath(os.path.join(folder, name))
                    for name in sorted(names)
                    if name.endswith((".yaml", ".yml"))
                )


def read_text(path: str) -> str:
    """Read a file that a robot programmer wrote.

    Raises:
        FileRefused: it cannot be read, or is not UTF-8
    """
    try:
        with open(path, encoding="utf-8") as file:
            return file.read()
    except OSError as error:
        raise FileRefused(
            [Problem("UNREADABLE", path, 1, "file", error.strerror or str(error), "a file that can be read")]
        ) from error
    except UnicodeDecodeError as error:
        raise FileRefused(
            [Problem("NOT_UTF8", path, 1, "file", f"byte {error.start} is not UTF-8", "UTF-8 text")]
        ) from error


def replace_problems(problems: Iterable[Problem], path: str, new: Iterable[Problem]) -> Tuple[Problem, ...]:
    """Replace the problems of one file; a corrected file has none."""
    kept: List[Problem] = [problem for problem in problems if problem.path != path]
    return tuple(kept) + tuple(new)
