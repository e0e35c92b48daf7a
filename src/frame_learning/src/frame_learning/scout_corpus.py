"""Reads ARL SCOUT (Situated Corpus of Understanding Transactions): transcripts of people who direct a robot.

Tab-separated lines ``id  time  stream  text``; the stream ``CMD`` is what the person says.
"""

import csv
import re
from pathlib import Path
from typing import List, Tuple

from frame_learning.annotated_commands import CorpusError


def read_scout(folder: str) -> Tuple[str, ...]:
    """Read every line that a person said, as it was transcribed.

    Raises:
        CorpusError: no such files, or one of them cannot be read
    """
    lines: List[str] = []
    for path in sorted(Path(folder).glob("*_transcript.txt")):
        try:
            with open(str(path), encoding="utf-8", newline="") as file:
                rows = list(csv.reader(file, delimiter="\t", quoting=csv.QUOTE_NONE))
        except (OSError, UnicodeDecodeError, csv.Error) as error:
            raise CorpusError(f"{path}: no transcript: {error!r}") from error
        lines += [_unquoted(row[3]) for row in rows if len(row) >= 4 and row[2] == "CMD"]
    if not lines:
        raise CorpusError(f"{folder}: no *_transcript.txt with CMD lines; expected a folder of SCOUT")
    return tuple(lines)


def _unquoted(text: str) -> str:
    return text[1:-1] if len(text) >= 2 and text.startswith('"') and text.endswith('"') else text


def without_remarks(line: str) -> str:
    """Return a line without what the transcriber remarked: "<inhale>", "(calibrate)"."""
    return " ".join(re.sub(r"<[^>]*>|\([^)]*\)", " ", line).split())
