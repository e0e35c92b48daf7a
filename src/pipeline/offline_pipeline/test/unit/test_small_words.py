"""Sentences that differ in one small word: their typed arguments differ, or the robot says what it cannot express."""

from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any, List, Tuple

import pytest

from offline_pipeline.pipeline import Pipeline, Understanding

PAIRS = [
    tuple(line.split("\t"))
    for line in (Path(__file__).resolve().parent / "small_words.tsv").read_text(encoding="utf-8").splitlines()
    if not line.startswith("#")
]
#: Attributes that repeat the words as they were said; what they mean must be in the others.
WORDS = ("text", "words", "positions", "head_position", "position")


def plain(value: Any) -> Any:
    """Return a typed argument as nested tuples, without the words."""
    if is_dataclass(value):
        return tuple(
            (field.name, plain(getattr(value, field.name))) for field in fields(value) if field.name not in WORDS
        )
    return tuple(plain(part) for part in value) if isinstance(value, tuple) else value


def meaning(understanding: Understanding) -> List[Tuple[str, Any]]:
    return [
        (reading.unit.frame_name, sorted(map(plain, reading.arguments), key=str)) for reading in understanding.readings
    ]


def test_there_are_many_pairs() -> None:
    assert len(set(PAIRS)) >= 150


@pytest.mark.parametrize("first, second", PAIRS)
def test_pair_means_two_things(pipeline: Pipeline, first: str, second: str) -> None:
    one, other = pipeline.understand_safely(first), pipeline.understand_safely(second)
    assert "STAGE_ERROR" not in (one.reply.code, other.reply.code)
    assert meaning(one) != meaning(other)
    assert one.reply.outcome == "DONE" or other.reply.outcome == "DONE" or one.reply.sentence != other.reply.sentence
