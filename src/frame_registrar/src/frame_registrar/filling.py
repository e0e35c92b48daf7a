"""Fills frames with the arguments of a lexical unit or of a parent frame."""

import operator
from dataclasses import dataclass
from typing import Mapping, Optional, Tuple

import word_classes
from semantic_frames.frame import (
    ConstantArgument,
    ElementMapping,
    FrameElement,
    Quantity,
    RelatedFrame,
    SemanticFrame,
    ValueCondition,
)
from spoken_quantities import QuantityError, parse_measure, parse_number


@dataclass(frozen=True)
class FilledFrame:
    """A frame whose elements have arguments.

    Attributes:
        name: name of the frame
        arguments: element name and argument, in the order of the frame's file; elements without one are left out
        server: name of the action server that carries it out; empty while none is chosen
    """

    name: str
    arguments: Tuple[Tuple[str, str], ...]
    server: str = ""

    def argument(self, element: str) -> str:
        """Return the argument of an element; empty if it has none."""
        return dict(self.arguments).get(element, "")


class Unfillable(ValueError):
    """A frame cannot be filled with these arguments.

    Attributes:
        code: VALUE_NOT_ALLOWED, LIMIT or MISSING_ELEMENT
    """

    def __init__(self, code: str, sentence: str) -> None:
        """
        Args:
            code: stable name of the reason
            sentence: for a person
        """
        super().__init__(sentence)
        self.code = code


def fill(frame: SemanticFrame, arguments: Mapping[str, str]) -> FilledFrame:
    """Fill a frame, with defaults for what was not said, and check the values against its file.

    Args:
        frame: the frame to fill
        arguments: by element name; names that the frame does not have are ignored
    Returns:
        the filled frame
    Raises:
        Unfillable: a value that is not allowed, an amount beyond its limit, a core element without argument
    """
    filled = tuple((element.name, arguments.get(element.name) or element.default) for element in frame.frame_elements)
    result = FilledFrame(name=frame.name, arguments=tuple((name, argument) for name, argument in filled if argument))
    for element in frame.frame_elements:
        argument = result.argument(element.name)
        if not argument:
            if element.is_core:
                raise Unfillable(
                    "MISSING_ELEMENT",
                    element.question or f"The {spoken_name(element.name)} of {spoken_name(frame.name)} is missing.",
                )
            continue
        if element.values and argument.lower() not in [value.lower() for value in element.values]:
            raise Unfillable(
                "VALUE_NOT_ALLOWED",
                f'The {spoken_name(element.name)} cannot be "{argument}", only {join_with_or(element.values)}.',
            )
        _check_amount(frame, element, argument, result)
    return result


def _check_amount(frame: SemanticFrame, element: FrameElement, argument: str, filled: FilledFrame) -> None:
    if element.quantity is None:
        return
    try:
        if element.quantity is Quantity.NUMBER:
            amount = parse_number(argument)
        else:
            unit = filled.argument(element.unit_element) if element.unit_element else ""
            amount = parse_measure(f"{argument} {unit}".strip(), quantity=element.quantity.value).si_amount
    except QuantityError as error:
        code = "LIMIT" if error.code == "NOT_FINITE" else "VALUE_NOT_ALLOWED"
        raise Unfillable(
            code, f"I cannot use the {spoken_name(element.name)} of {spoken_name(frame.name)}: {error}"
        ) from error
    for limit, is_beyond, word in (
        (element.maximum, operator.gt, "more"),
        (element.minimum, operator.lt, "less"),
    ):
        if limit is not None and is_beyond(amount, limit):
            said = " ".join(part for part in (argument, filled.argument(element.unit_element)) if part)
            raise Unfillable(
                "LIMIT",
                f"{said} is {word} than I may do: the limit is {limit:g} {SI_UNITS[element.quantity]}.".replace(
                    " .", "."
                ),
            )


#: Units for limits in sentences.
SI_UNITS = {Quantity.NUMBER: "", Quantity.LENGTH: "metres", Quantity.ANGLE: "radians", Quantity.DURATION: "seconds"}


def child_arguments(parent: FilledFrame, child: RelatedFrame) -> Optional[Mapping[str, str]]:
    """Map the arguments of a filled frame to a child.

    Args:
        parent: the filled parent
        child: a child in the parent's file
    Returns:
        arguments by element of the child; None if the parent does not meet a value condition of the child
    """
    if unmet_condition(parent, child) is not None:
        return None
    arguments = {}
    for relation in child.frame_element_relations:
        if isinstance(relation, ConstantArgument):
            arguments[relation.child_name] = relation.parent_value
        elif isinstance(relation, ElementMapping) and parent.argument(relation.parent_name):
            arguments[relation.child_name] = parent.argument(relation.parent_name)
    return arguments


def unmet_condition(parent: FilledFrame, child: RelatedFrame) -> Optional[ValueCondition]:
    """Return the first value condition of a child that its filled parent does not meet; None if it meets all."""
    for relation in child.frame_element_relations:
        if isinstance(relation, ValueCondition):
            said = without_determiner(parent.argument(relation.parent_name))
            if said not in [without_determiner(value) for value in relation.child_values]:
                return relation
    return None


def without_determiner(argument: str) -> str:
    """Return an argument in the form that value conditions compare: "glass" for "The glass"."""
    return word_classes.without_determiner(argument).lower()


def spoken_name(name: str) -> str:
    """Return the name of a frame or an element in words: "moving forward" for "moving_forward"."""
    return name.replace("_", " ")


def join_with_or(values: Tuple[str, ...]) -> str:
    """Return a list of values in words: "left, right or around"."""
    return values[0] if len(values) == 1 else ", ".join(values[:-1]) + " or " + values[-1]
