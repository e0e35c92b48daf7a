"""From typed arguments to what the page shows of them."""

import math
from typing import Iterator, List, Tuple

from typed_arguments import Measure, Source, TimeExpression, TypedArgument
from web_console.views import ArgumentView, Note, TraceLine

#: SI units by the kind of a measure.
_SI_UNITS = {
    "length": "m",
    "angle": "rad",
    "duration": "s",
    "speed": "m/s",
    "temperature": "K",
    "volume": "m³",
    "mass": "kg",
}
_MOST_NOTES = 16
_MOST_TRACE_LINES = 200


def argument_view(argument: TypedArgument) -> ArgumentView:
    """Return an argument with its attributes in words."""
    notes = [Note(kind, text) for kind, text in _notes(argument)]
    return ArgumentView(argument.name, argument.text, tuple(notes[:_MOST_NOTES]))


def _notes(argument: TypedArgument) -> Iterator[Tuple[str, str]]:
    if argument.source is not Source.SAID:
        yield "source", argument.source.name.lower()
    if argument.relation:
        yield "relation", argument.relation
    if argument.is_negated:
        yield "negated", "not"
    if argument.measure is not None:
        yield "measure", measure_text(argument.measure)
    if argument.time is not None:
        yield "time", _time_text(argument.time)
    if argument.direction:
        yield "direction", argument.direction
    if argument.quantifier:
        yield "quantifier", argument.quantifier
    if argument.count is not None:
        yield "count", f"{argument.count_bound} {argument.count}".strip().replace("_", " ")
    for modifier in argument.modifiers:
        yield "modifier", f"{modifier.degree} {modifier.word}".strip()
    if argument.possessor is not None:
        yield "of", argument.possessor.text
    if argument.complement is not None:
        yield "of", argument.complement.text
    for member in argument.members:
        yield "member", member.text
    for exception in argument.exceptions:
        yield "except", exception.text
    for frame in argument.frames:
        yield "clause", f"{frame.frame_name or frame.role}: {frame.words}"
    if argument.semantic_type:
        yield "type", argument.semantic_type
    for referent in argument.referents[:3]:
        yield "refers to", referent


def measure_text(measure: Measure) -> str:
    """Return a measure in words and in SI units: "120 degrees = 2.094 rad"."""
    words = measure.words or " ".join(
        part for part in (_number(measure.amount), measure.unit.replace("_", " ")) if part
    )
    si, unit = _number(measure.si), _SI_UNITS.get(measure.kind, "")
    text = " ".join(part for part in (measure.bound.replace("_", " "), words, measure.change) if part)
    if si and unit and f"{si} {unit}" != text:
        text += f" = {si} {unit}"
    return f"{text} (assumed)" if measure.is_assumed else text


def _time_text(time: TimeExpression) -> str:
    value = time.value or _number(time.offset_s if time.offset_s is not None else time.length_s)
    return " = ".join(dict.fromkeys(part for part in (time.words, value) if part)) or time.kind


def _number(value: "float | None") -> str:
    return "" if value is None or not math.isfinite(value) else f"{value:.4g}"


def trace_lines(trace: str) -> Tuple[TraceLine, ...]:
    """Read the trace of a stage: each line is "rule: about: effect"."""
    found: List[TraceLine] = []
    for line in trace.splitlines()[:_MOST_TRACE_LINES]:
        rule, separator, rest = line.partition(": ")
        if not separator:
            rule, rest = "", line
        about, separator, effect = rest.partition(": ")
        found.append(
            TraceLine(rule.strip(), about.strip() if separator else "", (effect if separator else rest).strip())
        )
    return tuple(found)
