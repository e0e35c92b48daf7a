"""Converts typed arguments to the text that travels with a goal of 2012, and back.

The action of 2012 has no field for them, and its checksums must not change. Its goal has a string that nobody uses:
``header.frame_id`` of ``FilledSemanticFrameActionGoal``. It holds ``{"typed_arguments": 1, "arguments": [...]}``: JSON
with the version, and the attributes of each argument that differ from their defaults. The text is never evaluated. If
it is malformed, the strings of 2012 remain.
"""

import json
from dataclasses import MISSING, dataclass, fields, is_dataclass
from typing import Any, Dict, List, Mapping, Sequence, Tuple, Type, Union, get_type_hints

from typed_arguments.argument import (
    MOST_LEVELS,
    EmbeddedFrame,
    Measure,
    Modifier,
    Source,
    TimeExpression,
    TypedArgument,
)

VERSION = 1
#: Characters of the text of one goal.
LONGEST_GOAL_TEXT = 65536
#: Arguments of one goal.
MOST_ARGUMENTS = 100
#: Levels of nested objects: parts of an argument, and the frames and measures between and below them.
_DEEPEST = 2 * MOST_LEVELS + 2
#: Floats represent all whole numbers below this one.
_LARGEST_WHOLE = 2**53
#: Types of the attributes of each written class.
_TYPES: Mapping[Any, Mapping[str, Any]] = {
    kind: get_type_hints(kind) for kind in (TypedArgument, Modifier, Measure, TimeExpression, EmbeddedFrame)
}


@dataclass(frozen=True)
class GoalArguments:
    """The arguments of a goal.

    Attributes:
        arguments: one for each frame element of the goal, in its order
        reason: why the arguments have only the strings of 2012; empty when they have more, or when no more was sent
    """

    arguments: Tuple[TypedArgument, ...]
    reason: str = ""


def to_goal_text(arguments: Sequence[TypedArgument]) -> str:
    """Return the text for some arguments, in ASCII.

    Raises:
        ValueError: the text would be too long, or there are too many arguments
    """
    if len(arguments) > MOST_ARGUMENTS:
        raise ValueError(f"a goal has {len(arguments)} arguments, and may have {MOST_ARGUMENTS}")
    text = json.dumps(
        {"typed_arguments": VERSION, "arguments": [to_plain(argument) for argument in arguments]},
        separators=(",", ":"),
        allow_nan=False,
    )
    if len(text) > LONGEST_GOAL_TEXT:
        raise ValueError(f"the arguments of a goal have {len(text)} characters, and may have {LONGEST_GOAL_TEXT}")
    return text


def from_goal_text(text: str, elements: Sequence[Tuple[str, str]]) -> GoalArguments:
    """Return the arguments of a goal; never raises.

    Args:
        text: ``header.frame_id`` of the goal; empty from a client that knows only 2012
        elements: name and argument of each frame element of the goal. They count: a text that contradicts them is
            ignored.
    """
    plain = tuple(TypedArgument(name=name, text=argument) for name, argument in elements)
    if not text:
        return GoalArguments(plain)
    try:
        found = _read(text, elements)
    except (ValueError, RecursionError) as error:
        reason = "it is nested too deeply" if isinstance(error, RecursionError) else str(error)
        return GoalArguments(plain, f"the goal's text of typed arguments is not used: {reason}")
    return GoalArguments(tuple(found.get(argument.name, argument) for argument in plain))


def _read(text: str, elements: Sequence[Tuple[str, str]]) -> Dict[str, TypedArgument]:
    """Return arguments by name; raises ValueError or RecursionError if the text is malformed."""
    if len(text) > LONGEST_GOAL_TEXT:
        raise ValueError(f"it has {len(text)} characters, and may have {LONGEST_GOAL_TEXT}")
    whole = json.loads(text, object_pairs_hook=_without_doubles, parse_constant=_refuse_constant)
    if not isinstance(whole, dict) or "typed_arguments" not in whole:
        raise ValueError("it is something else")
    version = whole["typed_arguments"]
    if type(version) is not int or version != VERSION:
        raise ValueError(f"its version is {version!r}, and {VERSION} is known")
    if set(whole) != {"typed_arguments", "arguments"}:
        raise ValueError(f"it has the keys {sorted(whole)}")
    said = set(elements)
    found: Dict[str, TypedArgument] = {}
    listed = whole["arguments"]
    if isinstance(listed, list) and len(listed) > MOST_ARGUMENTS:
        raise ValueError(f"it has {len(listed)} arguments, and may have {MOST_ARGUMENTS}")
    for argument in _decode_list(TypedArgument, listed, "arguments", 1):
        if (argument.name, argument.text) not in said:
            raise ValueError(f"the goal has no element {argument.name!r} with the argument {argument.text!r}")
        if argument.name in found:
            raise ValueError(f"it has two arguments for {argument.name!r}")
        found[argument.name] = argument
    if len({name for name, _ in said}) != len(said):
        raise ValueError("the goal has an element twice")
    return found


def _without_doubles(pairs: List[Tuple[str, Any]]) -> Dict[str, Any]:
    if len({key for key, _ in pairs}) != len(pairs):
        raise ValueError(f"a key stands twice: {[key for key, _ in pairs]}")
    return dict(pairs)


def _refuse_constant(name: str) -> None:
    raise ValueError(f"{name} is no number")


def to_plain(value: Any) -> Any:
    """Return an argument as a mapping of the attributes that differ from their defaults, for JSON."""
    if is_dataclass(value):
        return {
            field.name: to_plain(getattr(value, field.name))
            for field in fields(value)
            if field.default is MISSING or getattr(value, field.name) != field.default
        }
    if isinstance(value, tuple):
        return [to_plain(entry) for entry in value]
    return int(value) if isinstance(value, Source) else value


def _decode_value(kind: Type[Any], found: Any, name: str, depth: int) -> Any:
    """Make a value of a dataclass; raises ValueError."""
    if depth > _DEEPEST:
        raise ValueError(f"it has more than {_DEEPEST} levels")
    types = _TYPES[kind]
    if not isinstance(found, dict):
        raise ValueError(f"{name} is no object")
    unknown = sorted(set(found) - set(types))
    if unknown:
        raise ValueError(f"{name} has unknown keys: {', '.join(unknown[:5])}")
    missing = [field.name for field in fields(kind) if field.default is MISSING and field.name not in found]
    if missing:
        raise ValueError(f"{name} lacks {', '.join(missing)}")
    return kind(**{key: _decode(types[key], part, key, depth + 1) for key, part in found.items()})


def _decode(kind: Any, found: Any, name: str, depth: int) -> Any:
    """Make a value of an attribute's type; raises ValueError."""
    arguments: Any = getattr(kind, "__args__", ())
    if getattr(kind, "__origin__", None) is Union:  # Optional; None is left out
        return _decode(arguments[0], found, name, depth)
    if getattr(kind, "__origin__", None) is tuple:
        return tuple(_decode_list(arguments[0], found, name, depth))
    if kind in _TYPES:
        return _decode_value(kind, found, name, depth)
    if kind is Source and type(found) is int:
        return Source(found)
    if kind is float and type(found) is int and abs(found) < _LARGEST_WHOLE:
        return float(found)
    # A bool is an int in Python, but not in JSON.
    if type(found) is not kind:
        raise ValueError(f"{name} is {type(found).__name__}, and must be {kind.__name__}")
    if kind is str:
        found.encode("utf-8")  # a lone surrogate is not a character; UnicodeEncodeError is a ValueError
    return found


def _decode_list(kind: Any, found: Any, name: str, depth: int) -> List[Any]:
    if not isinstance(found, list):
        raise ValueError(f"{name} is no list")
    return [_decode(kind, entry, name, depth) for entry in found]
