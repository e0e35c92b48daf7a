"""Writes to the trace what became of a lexical unit that was tried."""

from typing import Optional, Sequence, Tuple

from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from semantic_frames.lexical_unit import ElementRelation, LexicalUnit
from utterance_passes.engine.trace import Trace
from utterance_passes.phrases.verb_matching import VerbMatch

#: The trace shows at most this many relations or words that the sentence does not have.
_SHOWN = 8


def write_unit(
    trace: Trace,
    sentence: Sentence,
    match: VerbMatch,
    unit: LexicalUnit,
    reading: Optional[Reading],
    unfilled: Tuple[ElementRelation, ...],
) -> None:
    """Write to the trace that a unit was tried, and why it does not fit."""
    missing = frozenset(element.name for element in reading.missing) if reading else frozenset()
    looked_for = [
        f"no {_some(' or ', list(map(str, relation.relations)))}"
        + (f" ({_some(', ', relation.words + relation.semantic_types)})" if relation.is_limited else "")
        + f" for {relation.name}"
        for relation in unfilled
        if (reading is None and relation.is_required) or relation.name in missing
    ]
    verdict = "no" if reading is None else "incomplete" if looked_for or missing else "fits"
    left_over = sentence.text(reading.left_over) if reading else ""
    parts = [verdict] + looked_for + ([f"left over: {left_over}"] if left_over else [])
    place = f"{unit.path.rsplit('/', 1)[-1]}:{unit.line}"
    trace.add(
        "unit",
        f"{match.verb} -> {reading or unit.frame_name}",
        after="; ".join(parts) + f" [{place}]",
        positions=match.positions,
    )


def _some(separator: str, texts: Sequence[str]) -> str:
    """Join the first few texts, with dots if there are more."""
    return separator.join(texts[:_SHOWN]) + (f"{separator}..." if len(texts) > _SHOWN else "")
