"""Problems of files that robot programmers write."""

from dataclasses import dataclass, fields
from typing import List, Sequence, Tuple

#: Problems of one file that are told; people mend the first ones, and then read the file again.
MOST_PROBLEMS = 20
#: Most characters of each text of a problem. The file is in the hands of its author, and problems are published.
MOST_CHARACTERS = {"path": 1000, "key": 120, "found": 80, "expected": 1000, "hint": 200}


@dataclass(frozen=True)
class Problem:
    """One mistake in a YAML file.

    Its texts are cut to `MOST_CHARACTERS`, and characters that cannot be printed are escaped.

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

    def __post_init__(self) -> None:
        for field in fields(self):
            most = MOST_CHARACTERS.get(field.name)
            if most is not None:
                object.__setattr__(self, field.name, _shown(getattr(self, field.name), most))

    def __str__(self) -> str:
        text = f"{self.path}:{self.line}: {self.code} {self.key}: found {self.found}, expected {self.expected}"
        return f"{text} ({self.hint})" if self.hint else text


class FileRefused(ValueError):
    """A file was refused; the exception carries all of its problems.

    Attributes:
        problems: at least one problem, at most `MOST_PROBLEMS` and one that says that there are more
    """

    def __init__(self, problems: Sequence[Problem]) -> None:
        told: List[Problem] = list(problems[:MOST_PROBLEMS])
        for further in problems[MOST_PROBLEMS : MOST_PROBLEMS + 1]:
            told.append(
                Problem(
                    "MORE_PROBLEMS",
                    further.path,
                    further.line,
                    "file",
                    "further mistakes",
                    f"at most {MOST_PROBLEMS} at a time",
                    "the others are told when these are corrected",
                )
            )
        super().__init__("\n".join(str(problem) for problem in told))
        self.problems: Tuple[Problem, ...] = tuple(told)


def _shown(text: str, most: int) -> str:
    """Return a text on one line, without characters that move a cursor, and cut to a length."""
    cut = text[: most + 1]
    if not cut.isprintable():
        cut = "".join(one if one.isprintable() else one.encode("unicode_escape").decode("ascii") for one in cut)
    return cut if len(cut) <= most else f"{cut[: most - 3]}..."
