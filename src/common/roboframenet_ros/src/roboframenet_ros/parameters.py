"""Parameters of a node as fields of a frozen dataclass, each with its range::

    @dataclass(frozen=True)
    class Settings(Parameters):
        timeout_s: float = parameter(2.0, least=0.1, most=60.0)
        max_waiting: int = parameter(100, least=1, most=1000)
        topics: Tuple[str, ...] = parameter(("cmd_vel",))
        mode: Mode = parameter(Mode.OWN)

The type of the default is the type of the parameter; a float takes an integer too, and a member of an enum the text of
its value. The unit is the suffix of the name.
"""

import enum
import math
from dataclasses import Field, dataclass, field, fields
from typing import Any, Mapping, Optional, Tuple, Type, Union

#: Suffixes of names, and how the error says the unit.
_UNITS: Mapping[str, str] = {"s": " s", "hz": " Hz", "m": " m", "rad": " rad"}
_RANGE = "range"
#: Types of values, and how a person calls them; a bool is an int, too.
_TYPES = ((bool, "bool"), (int, "int"), (float, "float"), (str, "string"), (tuple, "list of strings"))


class ParameterError(ValueError):
    """A parameter has the wrong type or is out of its range; the message says which one and what is expected."""


@dataclass(frozen=True)
class _Range:
    """Allowed values of a parameter; None for no bound."""

    least: Optional[float] = None
    most: Optional[float] = None
    above: Optional[float] = None
    may_be_empty: bool = True
    may_be_single: bool = False
    is_live: bool = False

    def holds(self, value: float) -> bool:
        """Whether a number is finite and within the bounds."""
        return (
            math.isfinite(value)
            and (self.least is None or self.least <= value)
            and (self.most is None or value <= self.most)
            and (self.above is None or value > self.above)
        )

    def __str__(self) -> str:
        if self.above is not None:
            return f"more than {self.above:g}"
        if self.least is None or self.most is None:
            return ""
        return f"{self.least:g} to {self.most:g}"


def parameter(
    default: Any,
    *,
    least: Optional[float] = None,
    most: Optional[float] = None,
    above: Optional[float] = None,
    may_be_empty: bool = True,
    may_be_single: bool = False,
    is_live: bool = False,
) -> Any:
    """Declare a field of a class of `Parameters`.

    Args:
        default: its value when the parameter is not set: a bool, number, string, tuple of strings, or member of an enum
            whose values are strings
        least: bound of a number; both bounds or none
        most: the other bound
        above: in place of both: the number must be larger
        may_be_empty: of a string
        may_be_single: of a list: one string stands for a list that holds only it
        is_live: it can be changed while the node runs (`roboframenet_ros.ros_live_parameters`); no list
    """
    allowed = _Range(least, most, above, may_be_empty, may_be_single, is_live)
    return field(default=default, metadata={_RANGE: allowed})


def is_parameter(declared: "Field[Any]") -> bool:
    """Whether a field was declared with `parameter`."""
    return _RANGE in declared.metadata


@dataclass(frozen=True)
class LiveParameter:
    """A parameter that can be changed while the node runs.

    Attributes:
        name: of the parameter
        default: its value when it is not set; the text of a member of an enum
        least, most: bounds of a number; None for no bound
        choices: what the value of an enum can be; empty for other types
    """

    name: str
    default: Union[bool, int, float, str]
    least: Optional[float]
    most: Optional[float]
    choices: Tuple[str, ...] = ()


def live_parameters(kind: "Type[Parameters]") -> Tuple[LiveParameter, ...]:
    """Return the parameters of a class that were declared as live."""
    found = []
    for declared in fields(kind):  # type: ignore[arg-type]  # subclasses are dataclasses
        if not is_parameter(declared) or not declared.metadata[_RANGE].is_live:
            continue
        allowed: _Range = declared.metadata[_RANGE]
        default: Any = declared.default
        members: Any = type(default) if isinstance(default, enum.Enum) else ()
        found.append(
            LiveParameter(
                name=declared.name,
                default=plain(default),
                least=allowed.least if allowed.above is None else allowed.above,
                most=allowed.most,
                choices=tuple(member.value for member in members),
            )
        )
    return tuple(found)


@dataclass(frozen=True)
class DeclaredParameter:
    """What a person has to know of a parameter in order to set it; its meaning is in the docstring of its class.

    Attributes:
        name: of the parameter
        type: "bool", "int", "float", "string" or "list of strings"
        default: its value when it is not set, as the parameter server holds it
        allowed: what it may be: "0.1 to 60", "own, service, launch"; empty for anything of its type
        is_live: whether it can be changed while the node runs
    """

    name: str
    type: str
    default: Union[bool, int, float, str, Tuple[str, ...]]
    allowed: str
    is_live: bool


def declared_parameters(kind: "Type[Parameters]") -> Tuple[DeclaredParameter, ...]:
    """Return the parameters of a class, in their order."""
    found = []
    for declared in fields(kind):  # type: ignore[arg-type]  # subclasses are dataclasses
        if is_parameter(declared):
            default: Any = declared.default
            allowed: _Range = declared.metadata[_RANGE]
            choices = ", ".join(member.value for member in type(default)) if isinstance(default, enum.Enum) else ""
            value = plain(default)
            name = next(text for type_, text in _TYPES if isinstance(value, type_))
            found.append(DeclaredParameter(declared.name, name, value, choices or str(allowed), allowed.is_live))
    return tuple(found)


def plain(value: Any) -> Any:
    """Return a value as the parameter server holds it: the text of a member of an enum."""
    return value.value if isinstance(value, enum.Enum) else value


class Parameters:
    """Base of frozen dataclasses that hold the parameters of a node. Other fields are no parameters.

    Raises:
        ParameterError: a value of another type, or out of its range
    """

    def __post_init__(self) -> None:
        for declared in fields(self):  # type: ignore[arg-type]  # subclasses are dataclasses
            if is_parameter(declared):
                value = _checked(
                    declared.name, getattr(self, declared.name), declared.default, declared.metadata[_RANGE]
                )
                object.__setattr__(self, declared.name, value)

    def __str__(self) -> str:
        """As a person would set them: "mode=own, topics=cmd_vel"."""
        shown = {one.name: getattr(self, one.name) for one in fields(self)}  # type: ignore[arg-type]
        return ", ".join(f"{name}={_shown(value)}" for name, value in shown.items())


def _shown(value: object) -> str:
    if isinstance(value, enum.Enum):
        return str(value.value)
    if isinstance(value, tuple):
        return f"[{', '.join(map(_shown, value))}]"
    if isinstance(value, float):
        return f"{value:g}"
    return str(value) if value != "" else "''"


def _checked(name: str, value: object, default: object, allowed: _Range) -> object:
    """Return the value in the type of its default.

    Raises:
        ParameterError: it has another type, or is out of its range
    """
    if isinstance(default, enum.Enum):
        members = {member.value: member for member in type(default)}
        value = members.get(value, value) if isinstance(value, str) else value
        is_right, expected = isinstance(value, type(default)), f"one of {', '.join(members)}"
    elif isinstance(default, bool):
        is_right, expected = isinstance(value, bool), "true or false"
    elif isinstance(default, int):
        is_right = isinstance(value, int) and not isinstance(value, bool) and allowed.holds(value)
        expected = f"an integer from {allowed}" if str(allowed) else "an integer"
    elif isinstance(default, float):
        is_right = isinstance(value, (int, float)) and not isinstance(value, bool) and allowed.holds(value)
        expected = f"{str(allowed) or 'a number'}{_UNITS.get(name.rpartition('_')[2], '')}"
    elif isinstance(default, str):
        is_right = isinstance(value, str) and bool(value or allowed.may_be_empty)
        expected = "a text" if allowed.may_be_empty else "a name"
    else:
        if isinstance(value, str) and allowed.may_be_single:
            value = (value,)
        is_right = isinstance(value, (list, tuple)) and all(isinstance(entry, str) and entry for entry in value)
        expected = "a list of names"
    if not is_right:
        raise ParameterError(f"~{name} must be {expected}, got {value!r}")
    return tuple(value) if isinstance(value, list) else value
