"""Reads the conditions of binding files: frames that are watched on topics."""

import math
from dataclasses import dataclass, field
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple

import yaml

from checked_files.marked_yaml import Reader, describe, did_you_mean, line_of
from checked_files.problem import Problem
from frame_bindings.field_conditions import ORDERED, Comparison, FieldCondition, Operand
from frame_bindings.statements import read_statement
from semantic_frames.server_statement import STATEMENT_KEYS
from typed_arguments.parts import PARTS
from word_classes import without_determiner

_STATEMENT_KEYS = tuple(key for key in STATEMENT_KEYS if key != "purpose")
CONDITION_KEYS = (
    "frame",
    "name",
    "topic",
    "type",
    "entries",
    "where",
    "field",
    "comparison",
    "value",
    "of_list",
    "timeout_s",
    "event_s",
    *_STATEMENT_KEYS,
)
_OPERAND_KEYS = ("element", "default", "values", "factor")


@dataclass(frozen=True)
class ConditionBinding:
    """A frame that is watched on a topic.

    Attributes:
        frame_name: the frame
        name: action that takes the frame; by default the name of the frame
        topic: the topic
        type_name: "sensor_msgs/BatteryState"
        condition: on its messages
        timeout_s: after which a topic without a message is dead; 0 for a topic that speaks only of changes
        event_s: for how long a message holds that is an event; 0 for messages that say how things are
        statement: what the server states about itself, see :mod:`semantic_frames.server_statement`
        path: the file
        lines: line of the file, by key; the key "" for that of the condition
    """

    frame_name: str
    name: str
    topic: str
    type_name: str
    condition: FieldCondition
    timeout_s: float = 0.0
    event_s: float = 0.0
    statement: Mapping[str, Any] = field(default_factory=dict)
    path: str = ""
    lines: Mapping[str, int] = field(default_factory=dict)

    def problem(self, code: str, key: str, found: str, expected: str, hint: str = "") -> Problem:
        """Return a problem of a key that shows only when the type of the topic is known."""
        line = self.lines.get(key.partition(".")[0], self.lines.get("", 1))
        return Problem(code, self.path, line, f"conditions {self.name}.{key}", found, expected, hint)


def read_condition(reader: Reader, node: yaml.Node, key: str) -> ConditionBinding:
    """Read an entry of the key ``conditions``; the problems are reported."""
    entries = reader.mapping(node, key, CONDITION_KEYS, required=("frame", "topic", "type"))
    type_name = reader.name(entries.get("type"), f"{key}.type")
    if type_name and type_name.count("/") != 1:
        reader.report("NOT_A_TYPE", entries["type"], f"{key}.type", f"'{type_name}'", "package/Type")
    if "field" not in entries and "event_s" not in entries:
        reader.report(
            "MISSING_KEY",
            node,
            f"{key}.field",
            "nothing",
            "the key 'field' with what says how things are, or 'event_s' if each message is an event",
        )
    for name in ("comparison", "value", "of_list"):
        if name in entries and "field" not in entries:
            reader.report("UNKNOWN_KEY", entries[name], f"{key}.{name}", name, "only beside 'field'")
    if "where" in entries and "entries" not in entries:
        reader.report("UNKNOWN_KEY", entries["where"], f"{key}.where", "where", "only beside 'entries'")
    frame_name = reader.name(entries.get("frame"), f"{key}.frame")
    return ConditionBinding(
        frame_name=frame_name,
        name=reader.text(entries.get("name"), f"{key}.name", frame_name),
        topic=reader.name(entries.get("topic"), f"{key}.topic"),
        type_name=type_name,
        condition=_field_condition(reader, entries, key),
        timeout_s=reader.seconds(entries["timeout_s"], f"{key}.timeout_s", 1.0) if "timeout_s" in entries else 0.0,
        event_s=reader.seconds(entries["event_s"], f"{key}.event_s", 1.0) if "event_s" in entries else 0.0,
        statement=read_statement(reader, node, key, entries, _STATEMENT_KEYS),
        path=reader.path,
        lines={"": line_of(node), **{name: line_of(value) for name, value in entries.items()}},
    )


def _field_condition(reader: Reader, entries: Mapping[str, yaml.Node], key: str) -> FieldCondition:
    names = [one.value for one in Comparison]
    chosen = reader.choice(entries.get("comparison"), f"{key}.comparison", names, Comparison.EQUALS.value)
    comparison = Comparison(chosen)
    operand = Operand("true")
    if "value" in entries:
        operand = _operand(reader, entries["value"], f"{key}.value")
        if comparison in ORDERED:
            _check_numbers(reader, entries["value"], f"{key}.value", operand)
    elif "comparison" in entries:
        reader.report("MISSING_KEY", entries["comparison"], f"{key}.value", "nothing", "the key 'value'")
    where: List[Tuple[str, Operand]] = []
    for path, value in reader.free_mapping(entries.get("where"), f"{key}.where"):
        name = reader.name(path, f"{key}.where")
        where.append((name, _operand(reader, value, f"{key}.where.{name}")))
    return FieldCondition(
        entries=reader.text(entries.get("entries"), f"{key}.entries"),
        where=tuple(where),
        field=reader.text(entries.get("field"), f"{key}.field"),
        comparison=comparison,
        operand=operand,
        is_all=reader.choice(entries.get("of_list"), f"{key}.of_list", ("any", "all"), "any") == "all",
    )


def _operand(reader: Reader, node: yaml.Node, key: str) -> Operand:
    if isinstance(node, yaml.ScalarNode):
        return Operand(reader.name(node, key))
    parts = reader.mapping(node, key, _OPERAND_KEYS, required=("element",))
    element = reader.name(parts.get("element"), f"{key}.element")
    part = element.partition(".")[2]
    if part and part not in PARTS:
        reader.report(
            "UNKNOWN_PART",
            parts["element"],
            f"{key}.element",
            f"'{part}'",
            f"a part of an argument: {', '.join(PARTS)}",
            did_you_mean(part, PARTS),
        )
    table = {
        without_determiner(reader.name(words, f"{key}.values")).lower(): reader.name(value, f"{key}.values")
        for words, value in reader.free_mapping(parts.get("values"), f"{key}.values")
    }
    factor = 1.0
    if "factor" in parts:
        text = reader.text(parts["factor"], f"{key}.factor")
        factor = _finite(text)
        if math.isnan(factor):
            reader.report("NOT_A_NUMBER", parts["factor"], f"{key}.factor", describe(parts["factor"]), "a number")
            factor = 1.0
    return Operand(
        element=element, default=reader.text(parts.get("default"), f"{key}.default"), values=table, factor=factor
    )


def _finite(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        return math.nan
    return value if math.isfinite(value) else math.nan


def _check_numbers(reader: Reader, node: yaml.Node, key: str, operand: Operand) -> None:
    """Report what is compared as a number and is none."""
    default = "" if operand.values else operand.default
    for text in filter(None, (operand.value, default, *operand.values.values())):
        if math.isnan(_finite(text)):
            reader.report("NOT_A_NUMBER", node, key, f"'{text}'", "a number, for this comparison")


def path_problem(binding: ConditionBinding, key: str, path: str, fields: Mapping[str, Any]) -> Optional[Problem]:
    """Return what is wrong with the path of a field.

    Args:
        binding: the condition
        key: of the path
        path: such as "pose.position.x"
        fields: names of the fields of the message, with those of each field that is a message; None for a value
    """
    place: Optional[Mapping[str, Any]] = fields
    for name in path.split("."):
        known: Sequence[str] = tuple(place or ())
        if place is None or name not in known:
            return binding.problem(
                "UNKNOWN_FIELD",
                key,
                f"'{path}'",
                f"a field of {binding.type_name}; there is no '{name}' among {', '.join(known) or 'none'}",
                did_you_mean(name, known),
            )
        place = place[name]
    return None


def fields_below(fields: Mapping[str, Any], path: str) -> Dict[str, Any]:
    """Return the fields of the entries at a path that is right."""
    for name in filter(None, path.split(".")):
        fields = fields[name] or {}
    return dict(fields)
