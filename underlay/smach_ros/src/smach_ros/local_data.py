"""Userdata as text: a pickle for viewers, which is only written, and JSON, which is read. Reading runs no code."""

import base64
import json
import math
import pickle
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
    """The value in types that every program can load: no class of the user, and nothing that JSON lacks."""
    if value is None or isinstance(value, bool):
        return value
    # Of a subclass only the plain value, because the class may be missing where the text is read.
    if isinstance(value, int):
        return int.__int__(value)
    if isinstance(value, float) and math.isfinite(value):
        return float.__float__(value)
    if isinstance(value, str):
        return str.__str__(value)
    if depth < 5 and type(value) in (list, tuple):
        return [_plain(item, depth + 1) for item in value]
    if depth < 5 and type(value) is dict:
        return {str(key): _plain(item, depth + 1) for key, item in value.items()}
    return _describe(value)


def _plain_dict(userdata: smach.UserData) -> Dict[str, Any]:
    return {str(key): _plain(userdata[key]) for key in userdata.keys()}


def to_pickle(userdata: smach.UserData) -> str:
    """Write userdata as smach_viewer reads it: the base64 text of a pickled dictionary.

    A value that JSON cannot hold becomes its repr, cut to a bound: to load the dictionary takes no class.
    """
    return base64.b64encode(pickle.dumps(_plain_dict(userdata), 2)).decode("ascii")


# What other implementations of SMACH send for no userdata. It is compared, never loaded.
_NO_USERDATA = to_pickle(smach.UserData())


def to_json(userdata: smach.UserData) -> str:
    """Write userdata as the text of a JSON object; a value that JSON cannot hold becomes its repr, cut to a bound.

    No userdata becomes the text that other implementations of SMACH understand, too.
    """
    return json.dumps(_plain_dict(userdata), sort_keys=True) if userdata.keys() else _NO_USERDATA


def from_json(text: str) -> Dict[str, Any]:
    """Read what to_json() writes; an empty text is no userdata.

    Raises:
        ValueError: it is something else, or a key begins with an underscore
    """
    if text.strip() in ("", _NO_USERDATA):
        return {}
    values = json.loads(text)
    if not isinstance(values, dict):
        raise ValueError(f"expected the text of a JSON object, found {type(values).__name__}")
    hidden = sorted(key for key in values if key.startswith("_"))
    if hidden:
        raise ValueError(f"userdata keys must not begin with an underscore: {hidden}")
    return values
