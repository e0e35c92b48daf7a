"""Problems of files that robot programmers write."""

from dataclasses import dataclass
from typing import Sequence, Tuple


@dataclass(frozen=True)
class Problem:
    """One mistake in a YAML file.

    Attributes:
        code: stable name of the kind of mistake, such as ``UNKNOWN_KEY``
        path: the file
        line: line of the file, from 1
        key: the key the mistake is about, as a path such as ``children[0].name``
        found: the text that was found
        expected: what was expected instead
        hint: how to correct it; empty for none
    """

    code: str
    path: str
    line: int
    key: str
    found: str
    expected: str
    hint: str = ""

    def __str__(self) -> str:
        text = f"{self.path}:{self.line}: {self.code} {self.key}: found {self.found}, expected {self.expected}"
        return f"{text} ({self.hint})" if self.hint else text


class FileRefused(ValueError):
    """A file was refused; the exception carries all of its problems.

    Attributes:
        problems: at least one problem
    """

    def __init__(self, problems: Sequence[Problem]) -> None:
        super().__init__("\n".join(str(problem) for problem in problems))
        self.problems: Tuple[Problem, ...] = tuple(problems)
