"""Checks the arguments of a call against the schema of its tool: what JSON can say, before anything else is asked."""

import math
from typing import Any, Dict, Mapping, Sequence

from agent_server.frame_tool import LONGEST_ARGUMENT, Schema, spoken
from agent_server.refused import CallRefused
from roboframenet_ros.spoken_text import join_with_or

_NAMES_OF_TYPES = {"string": "a text", "number": "a number", "boolean": "true or false", "integer": "a whole number"}
#: Arguments that are named in a refusal.
_MOST_NAMED = 5
#: Characters of a value that are shown in a refusal.
_MOST_SHOWN = 60


def checked(schema: Schema, arguments: object) -> Dict[str, Any]:
    """Return the arguments of a call.

    Args:
        schema: of the tool
        arguments: as they came over the wire
    Raises:
        CallRefused: they do not fit the schema
    """
    if not isinstance(arguments, dict):
        raise CallRefused("MALFORMED", "The arguments are not an object.")
    properties: Mapping[str, Schema] = schema["properties"]
    unknown = [str(name)[:40] for name in arguments if name not in properties]
    if unknown:
        known = ", ".join(properties) or "none"
        raise CallRefused(
            "UNKNOWN_ELEMENT", f"There is no argument {', '.join(map(repr, unknown[:_MOST_NAMED]))}, only: {known}."
        )
    missing = [name for name in schema["required"] if name not in arguments]
    if missing:
        raise CallRefused("MISSING_ELEMENT", f"The {' and the '.join(map(spoken, missing))} must be given.")
    return {name: _value(name, properties[name], value) for name, value in arguments.items()}


def _value(name: str, schema: Schema, value: object) -> Any:
    if "anyOf" in schema:
        words, related = schema["anyOf"]
        if isinstance(value, dict):
            return checked(related, value)
        return _value(name, words, value)
    kind = schema["type"]
    if kind == "string" and isinstance(value, str):
        return _text(name, schema, value)
    if kind == "boolean" and isinstance(value, bool):
        return value
    # In Python, true is a number; in JSON it is none.
    if kind in ("number", "integer") and isinstance(value, (int, float)) and not isinstance(value, bool):
        return _number(name, schema, value)
    expected = _NAMES_OF_TYPES[kind]
    raise CallRefused("WRONG_TYPE", f"The {spoken(name)} must be {expected}, and is {_shown(value)}.")


def _text(name: str, schema: Schema, value: str) -> str:
    allowed: Sequence[str] = schema.get("enum", ())
    if allowed and value not in allowed:
        raise CallRefused(
            "VALUE_NOT_ALLOWED", f"The {spoken(name)} cannot be {_shown(value)}, only {join_with_or(allowed)}."
        )
    if not value.strip():
        raise CallRefused("EMPTY_TEXT", f"The {spoken(name)} is empty.")
    longest = schema.get("maxLength", LONGEST_ARGUMENT)
    if len(value) > longest:
        raise CallRefused(
            "TEXT_TOO_LONG", f"The {spoken(name)} has {len(value)} characters, and may have at most {longest}."
        )
    if not value.isprintable():
        raise CallRefused("VALUE_NOT_ALLOWED", f"The {spoken(name)} has characters that cannot be printed.")
    return value


def _number(name: str, schema: Schema, value: float) -> float:
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise CallRefused("LIMIT", f"The {spoken(name)} is not a finite number.")
    if schema["type"] == "integer" and number != int(number):
        raise CallRefused("WRONG_TYPE", f"The {spoken(name)} must be a whole number.")
    unit = f" {schema['unit']}" if "unit" in schema else ""
    least, most = schema.get("minimum", number), schema.get("maximum", number)
    if least <= number <= most:
        return number
    limit, which = (least, "less") if number < least else (most, "more")
    raise CallRefused(
        "LIMIT", f"The {spoken(name)} of {number:g}{unit} is {which} than I may do: the limit is {limit:g}{unit}."
    )


def _shown(value: object) -> str:
    shown = repr(value)
    return shown if len(shown) <= _MOST_SHOWN else f"{shown[:_MOST_SHOWN]}..."
