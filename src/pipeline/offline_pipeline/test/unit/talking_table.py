"""Tables of utterances as people make them, and the judge of what came out."""

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Iterable, Tuple

from offline_pipeline.pipeline import Pipeline, Understanding
from semantic_framer.values.dialogue import Context
from typed_arguments import Source, TypedArgument

TABLES = Path(__file__).resolve().parent / "talking"
# A value may hold commas.
_NEXT_ELEMENT = re.compile(r", (?=\w+=)")


@dataclass(frozen=True)
class Line:
    """One line of a table.

    Attributes:
        is_held_out: whether the line was set aside until the rules were written
        said: the utterances, in order
        expected: what the last one may lead to
    """

    is_held_out: bool
    said: Tuple[str, ...]
    expected: Tuple[str, ...]

    def __str__(self) -> str:
        return " | ".join(self.said)


def read_table(name: str) -> Tuple[Line, ...]:
    """Return the lines of a table."""
    lines = (TABLES / f"{name}.tsv").read_text(encoding="utf-8").splitlines()
    rows = [line.split("\t") for line in lines if line and not line.startswith("#")]
    return tuple(
        Line(kind == "held", tuple(said.split(" | ")), tuple(expected.split(" | "))) for kind, said, expected in rows
    )


def outcome_of(pipeline: Pipeline, said: Tuple[str, ...]) -> Understanding:
    """Understand utterances of one person, one after the other; return what the last one led to."""
    context = Context()
    for text in said:
        understanding = pipeline.understand_safely(text, context)
        context = understanding.context
    return understanding


def described(understanding: Understanding) -> str:
    """Return the frames with their elements, without defaults; for a refusal or a question, its code."""
    if understanding.reply.outcome != "DONE" or not understanding.readings:
        return understanding.reply.code
    return " + ".join(
        f"{reading.unit.frame_name}({_elements(reading.arguments)})" for reading in understanding.readings
    )


def _elements(arguments: Iterable[TypedArgument]) -> str:
    said = (one for one in arguments if one.source is not Source.DEFAULT and one.text.lower() != "you")
    return ", ".join(sorted(f"{one.name}={one.text}" for one in said))


def _sorted(frame: str) -> str:
    name, _, elements = frame.partition("(")
    return f"{name}({', '.join(sorted(_NEXT_ELEMENT.split(elements.rstrip(')'))))})" if elements else frame


def is_right(understanding: Understanding, expected: Tuple[str, ...]) -> bool:
    """Whether an utterance led to what was expected."""
    reply = understanding.reply
    if reply.code == "STAGE_ERROR":
        return False
    found = described(understanding).lower()
    wanted = [" + ".join(map(_sorted, one.split(" + "))).lower() for one in expected]
    is_asked, is_refused = reply.outcome == "NEEDS_INFORMATION", reply.outcome == "REFUSED"
    return found in wanted or ("asks" in expected and is_asked) or ("no" in expected and (is_asked or is_refused))
