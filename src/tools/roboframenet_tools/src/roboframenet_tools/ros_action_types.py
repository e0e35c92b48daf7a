"""Elements of a frame for the goals of an action type."""

from typing import Any, List, Sequence, Tuple

import roslib.message

from rfnserver.goal_types import Filling, GoalField
from rfnserver.ros_goal_messages import fields_of, goal_type_of
from roboframenet_tools.scaffold import Element

_NUMBERS = ("seven", "5", "twelve")


class UnknownAction(ValueError):
    """There is no such action type; the message says what was looked for."""


def action_class(text: str) -> Tuple[Tuple[str, str], Any]:
    """Find an action type.

    Args:
        text: "pkg/Name.action", "pkg/NameAction" or "pkg/Name"
    Returns:
        the package and the name of the type, and its class
    Raises:
        UnknownAction: it is not built in a workspace that is sourced
    """
    package, _, name = text.partition("/")
    name = name[: -len(".action")] if name.endswith(".action") else name
    name = name if name.endswith("Action") else f"{name}Action"
    found = roslib.message.get_message_class(f"{package}/{name}") if package and "/" in text else None
    if found is None:
        raise UnknownAction(
            f"there is no action type {package}/{name}: expected PACKAGE/NAME.action of a package that is built and "
            "sourced"
        )
    return (package, name), found


def elements_of(kind: Any) -> Tuple[Element, ...]:
    """Return an element for each field of a goal that words can fill; the first is core, and has examples.

    A goal without fields gives a frame without elements.

    Raises:
        UnknownAction: words can fill no field
    """
    everything = fields_of(goal_type_of(kind))
    fields = [field for field in everything if field.filling is not None]
    if everything and not fields:
        raise UnknownAction("words can fill no field of its goals: write a frame_callback (docs/porting.md)")
    words_first = sorted(fields, key=lambda field: field.filling not in (Filling.STRING, Filling.PLACE))
    elements: List[Element] = []
    for field in words_first:
        if field.element not in [element.name for element in elements]:
            elements.append(_element(field, _choices(field, fields), is_first=not elements))
    return tuple(elements)


def _choices(field: GoalField, fields: Sequence[GoalField]) -> Tuple[str, ...]:
    """Return the words for the constants of a field; none if they may be those of another field of its message."""
    holder = field.path.rpartition(".")[0]
    others = [one for one in fields if one.filling is Filling.INTEGER and one.path.rpartition(".")[0] == holder]
    return tuple(field.own_choices or (field.choices if len(others) == 1 else ()))


def _element(field: GoalField, choices: Tuple[str, ...], *, is_first: bool) -> Element:
    is_number = field.filling in (Filling.INTEGER, Filling.FLOAT) and not choices and not field.is_list
    quantity = "number" if is_number else "duration" if field.filling is Filling.DURATION else ""
    values = ("on", "off") if field.filling is Filling.BOOLEAN else choices
    if not is_first:
        relations = ("measure",) if field.filling is Filling.DURATION else ("advmod", "acomp") if values else ()
        return Element(field.element, is_core=False, quantity=quantity, values=values, relations=relations)
    if choices:
        texts = tuple(f"{start} to {choice}{end}" for start, choice, end in zip(_STARTS, choices, _ENDS))
        relations = ("prep_to", "advmod", "dobj")
        return Element(field.element, values=values, relations=relations, arguments=choices, examples=texts)
    if is_number:
        return Element(
            field.element,
            quantity=quantity,
            relations=("prep_to", "prep_by"),
            arguments=_NUMBERS,
            examples=tuple(f"{start} to {number}{end}" for start, number, end in zip(_STARTS, _NUMBERS, _ENDS)),
        )
    if field.filling is Filling.DURATION:
        texts = ("ten seconds", "two minutes", "an hour")
        return Element(
            field.element,
            quantity=quantity,
            relations=("measure",),
            arguments=texts,
            examples=tuple(f"{start} for {text}{end}" for start, text, end in zip(_STARTS, texts, _ENDS)),
        )
    if field.filling is Filling.BOOLEAN:
        return Element(
            field.element,
            values=values,
            relations=("prt", "advmod"),
            arguments=("on", "off"),
            examples=("{Verb} on.", "please {verb} off"),
        )
    return Element(field.element, is_list=field.is_list)


_STARTS = ("{Verb}", "please {verb}", "Could you {verb}")
_ENDS = (".", "", "?")
