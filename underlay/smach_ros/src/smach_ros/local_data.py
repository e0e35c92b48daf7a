"""Userdata as JSON text, never as a pickle: reading it runs no code."""

import json
from typing import Any, Dict

import smach

# Introspection is for people, so longer texts are cut.
MAX_REPR_LENGTH = 200


def _describe(value: Any) -> str:
    try:
        text = repr(value)
    except Exception as error:  # boundary: userdata may hold any object, with any __repr__
        text = f"<{type(value).__name__}, whose repr raised {type(error).__name__}>"
    return text if len(text) <= MAX_REPR_LENGTH else text[:MAX_REPR_LENGTH] + "..."


def _plain(value: Any, depth: int = 0) -> Any:
    if value is None or isinstance(value, (bool, int, float, str)):
        return value
    if depth < 5 and type(value) in (list, tuple):
        return [_plain(item, depth + 1) for item in value]
    if depth < 5 and type(value) is dict:
        return {str(key): _plain(item, depth + 1) for key, item in value.items()}
    return _describe(value)


def to_json(userdata: smach.UserData) -> str:
    """Write userdata as the text of a JSON object; a value that JSON cannot hold becomes its repr, cut to a bound."""
    return json.dumps({str(key): _plain(userdata[key]) for key in userdata.keys()}, sort_keys=True)


def from_json(text: str) -> Dict[str, Any]:
    """Read the text of a JSON object; an empty text is an empty object.

    Raises:
        ValueError: it is something else, or a key begins with an underscore
    """
    if not text.strip():
        return {}
    values = json.loads(text)
    if not isinstance(values, dict):
        raise ValueError(f"expected the text of a JSON object, found {type(values).__name__}")
    hidden = sorted(key for key in values if key.startswith("_"))
    if hidden:
        raise ValueError(f"userdata keys must not begin with an underscore: {hidden}")
    return values
