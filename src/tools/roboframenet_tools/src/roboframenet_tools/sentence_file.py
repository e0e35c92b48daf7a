"""Files of ``rfn test``: sentences, each with the reading that it must have."""

from dataclasses import dataclass, replace
from typing import Any, Dict, List, Tuple

import yaml

from checked_files.marked_yaml import Reader, line_of
from roboframenet_tools.recording import Frame, Record

_EXPECTED = "a list of sentences, each with 'frames', 'code' or 'means'"
#: In the place of a code that no reply has.
_NOT_UNDERSTOOD = "NOT UNDERSTOOD"


@dataclass(frozen=True)
class ExpectedReading:
    """What a sentence must come to.

    Attributes:
        text: the sentence
        frames: its frames with all of their arguments, in the order of the sentence; empty where ``code`` says why
        code: of the reply; empty when it is understood
        line: of the file, from 1
        means: another sentence, which has to be understood, and in the same way
    """

    text: str
    frames: Tuple[Frame, ...] = ()
    code: str = ""
    line: int = 0
    means: str = ""

    def as_meant(self, meaning: Record) -> "ExpectedReading":
        """Return what it must come to, given the reading of the other sentence."""
        if meaning.is_understood:
            return replace(self, frames=meaning.frames)
        return replace(self, code=f"{_NOT_UNDERSTOOD} ({meaning.code})")

    def agrees(self, record: Record) -> bool:
        """Whether a sentence was read like this."""
        if self.code:
            return record.code == self.code and (not self.frames or record.frames == self.frames)
        return record.is_understood and record.frames == self.frames

    def __str__(self) -> str:
        meant = f'as "{self.means}":' if self.means else ""
        return " ".join(part for part in (meant, self.code, frames_in_words(self.frames)) if part)


def frames_in_words(frames: Tuple[Frame, ...]) -> str:
    """Return frames for a person."""
    return ", then ".join(f"{name}({', '.join(f'{one}={words}' for one, words in said)})" for name, said in frames)


def load_sentences(text: str, path: str) -> Tuple[ExpectedReading, ...]:
    """Read a file.

    Args:
        text: content of the file
        path: where it came from, for problems
    Raises:
        FileRefused: the file has mistakes; the exception carries all of them
    """
    reader = Reader(path)
    found: List[ExpectedReading] = []
    for key, node in reader.sequence(reader.compose(text, _EXPECTED), "sentences"):
        entry = reader.mapping(node, key, ("text", "frames", "code", "means"), required=("text",))
        frames: List[Frame] = []
        for frame_key, frame in reader.sequence(entry.get("frames"), f"{key}.frames"):
            for name, elements in reader.free_mapping(frame, frame_key):
                said = reader.free_mapping(elements, f"{frame_key}.{reader.name(name, frame_key)}")
                pairs = [(reader.name(one, frame_key), reader.text(words, frame_key)) for one, words in said]
                frames.append((reader.name(name, frame_key), tuple(sorted(pairs))))
        code = reader.text(entry.get("code"), f"{key}.code")
        means = reader.text(entry.get("means"), f"{key}.means")
        if entry and not frames and not code and not means:
            expected = "'frames', the 'code' of the reply, or what it 'means'"
            reader.report("EMPTY", node, key, "no reading", expected)
        if means and (frames or code):
            reader.report("TWO_READINGS", node, key, "'means' beside 'frames' or 'code'", "one of them")
        text = reader.name(entry.get("text"), f"{key}.text")
        found.append(ExpectedReading(text, tuple(frames), code, line_of(node), means))
    reader.refuse_if_wrong()
    return tuple(found)


def sentence_in_file(expected: ExpectedReading, remark: str) -> str:
    """Return the lines of a sentence in such a file.

    Args:
        expected: the sentence
        remark: for the person who reads the file; it becomes a comment
    """
    entry: Dict[str, Any] = {"text": expected.text}
    if expected.frames:
        entry["frames"] = [{name: dict(said)} for name, said in expected.frames]
    if expected.code:
        entry["code"] = expected.code
    lines = yaml.safe_dump([entry], sort_keys=False, allow_unicode=True, width=1000)
    return f"# {' '.join(remark.split())}\n{lines}"
