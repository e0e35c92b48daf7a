"""Reads tagE (Sarkar et al., "tagE: Enabling an Embodied Agent to Understand Human Instructions", EMNLP 2023).

Rows of CSV files: the instruction, and ``first last Task ; first last Argument ; ... | ...`` with positions of words
from 0. Qualities of an argument (``-9 9 isColour``) are ignored: they are inside its span or beside it.
"""

import csv
import re
from pathlib import Path
from typing import Dict, List, Tuple

from frame_learning.annotated_commands import (
    AnnotatedCommand,
    AnnotatedElement,
    AnnotatedFrame,
    CorpusError,
    command_of,
)

_PART = re.compile(r"\s*(\d+)\s+(\d+)\s+([A-Za-z_]+)")


def read_tage(folder: str) -> Tuple[AnnotatedCommand, ...]:
    """Read all rows of the CSV files of a folder.

    Raises:
        CorpusError: there are no such files, or one of them has other columns
    """
    commands: List[AnnotatedCommand] = []
    for path in sorted(Path(folder).glob("*.csv")):
        try:
            with open(str(path), encoding="utf-8", newline="") as file:
                for number, row in enumerate(csv.DictReader(file), start=2):
                    commands.append(_command(f"{path.stem}:{number}", row))
        except (OSError, UnicodeDecodeError, KeyError, csv.Error) as error:
            raise CorpusError(f"{path}: no tagE rows: {error!r}") from error
    if not commands:
        raise CorpusError(f"{folder}: no *.csv file with rows; expected a folder of tagE")
    return tuple(commands)


def _command(name: str, row: Dict[str, str]) -> AnnotatedCommand:
    tokens = row["input"].split()
    frames = []
    for task in row["tage_output"].split("|"):
        parts = [match for match in (_PART.match(part) for part in task.split(";")) if match is not None]
        if not parts:
            continue
        spans = [(int(part.group(1)) + 1, int(part.group(2)) + 1, part.group(3)) for part in parts]
        first, last, task_name = spans[0]
        frames.append(
            AnnotatedFrame(
                name=task_name,
                lexical_unit=tuple(range(first, last + 1)),
                elements=tuple(
                    # The head of an English noun phrase is its last word, apart from what follows the head.
                    AnnotatedElement(name=name, tokens=frozenset(range(start, end + 1)), head=end)
                    for start, end, name in spans[1:]
                ),
            )
        )
    return command_of(name, row["input"].strip(), tokens, frames)
