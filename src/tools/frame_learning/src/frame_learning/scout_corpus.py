"""Reads ARL SCOUT (Situated Corpus of Understanding Transactions): transcripts of people who direct a robot.

Tab-separated lines ``id  time  stream  text``; the stream ``CMD`` is what the person says.
"""

import csv
import re
from pathlib import Path
from typing import List, Tuple

from frame_learning.annotated_commands import AnnotatedCommand, CorpusError, command_of


def read_scout(folder: str) -> Tuple[AnnotatedCommand, ...]:
    """Read all lines that a person said, without the remarks of the transcriber; frames are not annotated.

    Raises:
        CorpusError: there are no such files, or one of them cannot be read
    """
    commands: List[AnnotatedCommand] = []
    for path in sorted(Path(folder).glob("*_transcript.txt")):
        try:
            with open(str(path), encoding="utf-8", newline="") as file:
                rows = list(csv.reader(file, delimiter="\t", quoting=csv.QUOTE_NONE))
        except (OSError, UnicodeDecodeError, csv.Error) as error:
            raise CorpusError(f"{path}: no transcript: {error!r}") from error
        for number, row in enumerate(rows, start=1):
            if len(row) >= 4 and row[2] == "CMD":
                text = without_remarks(_unquoted(row[3]))
                commands.append(command_of(f"{path.stem}:{number}", text, text.split(), ()))
    if not commands:
        raise CorpusError(f"{folder}: no *_transcript.txt with CMD lines; expected a folder of SCOUT")
    return tuple(commands)


def _unquoted(text: str) -> str:
    return text[1:-1] if len(text) >= 2 and text.startswith('"') and text.endswith('"') else text


def without_remarks(line: str) -> str:
    """Return a line without the remarks of the transcriber: "<inhale>", "(calibrate)"."""
    return " ".join(re.sub(r"<[^>]*>|\([^)]*\)", " ", line).split())
