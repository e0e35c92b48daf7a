"""What was said to a robot and what came of it, in a file, and how two versions of the system differ about it."""

import json
from dataclasses import dataclass
from typing import Any, Iterable, List, Mapping, Tuple

#: Codes of refusals for which the sentence was understood: another robot would do it.
_UNDERSTOOD = frozenset(["NO_SERVER"])
_NOT_UNDERSTOOD = frozenset(["REFUSED", "NEEDS_INFORMATION"])

#: A frame with the arguments of its elements, without those that were not said and have no default.
Frame = Tuple[str, Tuple[Tuple[str, str], ...]]


class RecordingError(ValueError):
    """A line is no record; the message says which and why."""


@dataclass(frozen=True)
class Record:
    """A sentence and what came of it.

    Attributes:
        text: as it was said
        frames: the best reading of each clause, in the order of the sentence
        outcome: name of the outcome of the reply, "DONE"
        code: of the reply
        sentence: of the reply
    """

    text: str
    frames: Tuple[Frame, ...]
    outcome: str
    code: str
    sentence: str

    @property
    def is_understood(self) -> bool:
        """Whether it became frames that a robot can try."""
        return self.outcome not in _NOT_UNDERSTOOD or self.code in _UNDERSTOOD

    def __str__(self) -> str:
        if not self.is_understood:
            return f"{self.code}: {self.sentence}"
        frames = (f"{name}({', '.join(f'{element}={words}' for element, words in said)})" for name, said in self.frames)
        return ", then ".join(frames) or self.sentence


def record_to_json(record: Record) -> str:
    """Return the line of a record, in the form of ``rfn explain --json``."""
    frames = [
        {"name": name, "frame_elements": [{"name": element, "argument": words} for element, words in said]}
        for name, said in record.frames
    ]
    reply = {"outcome": record.outcome, "code": record.code, "sentence": record.sentence}
    return json.dumps({"text": record.text, "frames": frames, "reply": reply}, ensure_ascii=False)


def record_of(plain: Mapping[str, Any]) -> Record:
    """Return the record of an object, as ``rfn record`` or ``rfn explain --json`` writes it."""
    return Record(
        text=plain["text"],
        frames=tuple(
            (
                frame["name"],
                tuple(sorted((each["name"], each["argument"]) for each in frame["frame_elements"] if each["argument"])),
            )
            for frame in plain["frames"]
            if not frame.get("is_description")
        ),
        outcome=plain["reply"]["outcome"],
        code=plain["reply"]["code"],
        sentence=plain["reply"]["sentence"],
    )


def read_records(lines: Iterable[str], path: str) -> List[Record]:
    """Read a file.

    Args:
        lines: of the file
        path: where it came from, for the error
    Raises:
        RecordingError: a line is no record
    """
    records: List[Record] = []
    for number, line in enumerate(lines, start=1):
        if not line.strip():
            continue
        try:
            records.append(record_of(json.loads(line)))
        except (ValueError, KeyError, TypeError, AttributeError) as error:
            raise RecordingError(
                f"{path}:{number}: no line of 'rfn record' or 'rfn explain --json' ({type(error).__name__}: {error})"
            ) from error
    return records


def is_same(before: Record, after: Record) -> bool:
    """Whether two versions agree: the same frames with the same arguments, or the same reason for none."""
    if before.is_understood and after.is_understood:
        return before.frames == after.frames
    return before.is_understood == after.is_understood and before.code == after.code
