"""Finds and reads the files that robot programmers write."""

import os
import stat
from typing import Iterable, Iterator, List, Tuple

from checked_files.problem import FileRefused, Problem

#: Names of the folders of a domain.
FRAMES_FOLDER = "frames"
LEXICAL_UNITS_FOLDER = "lexical_units"

#: Bytes; nothing that people write by hand is longer, and four bytes make the longest character.
LARGEST_FILE_BYTES = 4_000_000
#: Problems of all files that are kept; those of the files that were refused last.
MOST_KEPT_PROBLEMS = 500


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

    The path may come from another process, so nothing here waits or swells: pipes, devices, folders and files of more
    than `LARGEST_FILE_BYTES` are refused before they are read.

    Raises:
        FileRefused: it is no regular file, is too large, cannot be read, or is not UTF-8
    """
    if not path.isprintable():
        raise _refused(path, "UNREADABLE", "a path with control characters", "a path of printable characters")
    try:
        # A device may react to being opened, so the kind is known before.
        _check_kind(path, os.stat(path))
        # Another file may have taken its place meanwhile: a pipe is opened without waiting for its writer.
        with open(os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC), "rb") as file:
            _check_kind(path, os.fstat(file.fileno()))
            content = file.read(LARGEST_FILE_BYTES + 1)
        if len(content) > LARGEST_FILE_BYTES:
            raise _too_large(path, "a file that grows")
        return content.decode("utf-8").replace("\r\n", "\n").replace("\r", "\n")
    except OSError as error:
        raise _refused(path, "UNREADABLE", error.strerror or str(error), "a file that can be read") from error
    except UnicodeDecodeError as error:
        raise _refused(path, "NOT_UTF8", f"byte {error.start} is not UTF-8", "UTF-8 text") from error


def _check_kind(path: str, status: os.stat_result) -> None:
    if not stat.S_ISREG(status.st_mode):
        raise _refused(path, "UNREADABLE", "a folder, a pipe or a device", "a regular file")
    if status.st_size > LARGEST_FILE_BYTES:
        raise _too_large(path, f"{status.st_size} bytes")


def _too_large(path: str, found: str) -> FileRefused:
    return _refused(path, "TOO_LARGE", found, f"at most {LARGEST_FILE_BYTES} bytes")


def _refused(path: str, code: str, found: str, expected: str) -> FileRefused:
    return FileRefused([Problem(code, path, 1, "file", found, expected)])


def replace_problems(problems: Iterable[Problem], path: str, new: Iterable[Problem]) -> Tuple[Problem, ...]:
    """Replace the problems of one file; a mended file has none. Beyond `MOST_KEPT_PROBLEMS` the oldest are dropped."""
    kept: List[Problem] = [problem for problem in problems if problem.path != path]
    return (tuple(kept) + tuple(new))[-MOST_KEPT_PROBLEMS:]
