"""Fills frames with the arguments of a lexical unit or of a parent frame."""

import math
import operator
from dataclasses import replace
from typing import Dict, Iterable, Mapping, Optional, Tuple

import word_classes
from roboframenet_ros.spoken_text import join_with_or
from semantic_frames.extra_thematic import extra_thematic_of_arguments
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
from typed_arguments import FilledFrame, Measure, Source, TypedArgument


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


def fill(frame: SemanticFrame, arguments: Mapping[str, TypedArgument]) -> FilledFrame:
    """Fill a frame, with defaults for what was not said, and check the arguments against its file.

    Args:
        frame: the frame to fill
        arguments: by name of an element or of an extra-thematic element; other names are ignored
    Returns:
        the filled frame; an element with a quantity has its measure, and extra-thematic arguments come last
    Raises:
        Unfillable: a value that is not allowed, an amount beyond its limit, a core element without argument
    """
    found: Dict[str, TypedArgument] = {}
    for element in frame.frame_elements:
        argument = arguments.get(element.name)
        if argument is not None and argument.text:
            found[element.name] = argument if argument.name == element.name else replace(argument, name=element.name)
        elif element.default:
            found[element.name] = TypedArgument(element.name, element.default, Source.DEFAULT)
    for element in frame.frame_elements:
        if element.name not in found:
            if element.is_core:
                question = element.question or f"The {spoken_name(element.name)} is missing."
                raise Unfillable("MISSING_ELEMENT", question)
            continue
        allowed = [value.lower() for value in element.values]
        if allowed and found[element.name].text.lower() not in allowed:
            found[element.name] = _without_article(found[element.name])
        text = found[element.name].text
        if allowed and text.lower() not in allowed:
            raise Unfillable(
                "VALUE_NOT_ALLOWED",
                f'The {spoken_name(element.name)} cannot be "{text}", only {join_with_or(element.values)}.',
            )
        check_expressible(element, found[element.name])
        if element.quantity is not None:
            found[element.name] = _measured(element, element.quantity, found)
    extra = extra_thematic_arguments(frame, arguments.values())
    return FilledFrame(name=frame.name, arguments=(*found.values(), *extra))


def _without_article(argument: TypedArgument) -> TypedArgument:
    """Return an argument whose text is its head: "left" for "the left", but "the left door" stays as it is."""
    text = word_classes.without_determiner(argument.text)
    return replace(argument, text=text) if text.lower() == argument.head.lower() else argument


def check_expressible(element: FrameElement, argument: TypedArgument) -> None:
    """Check that an element can express the relation, the count and the quantifier of its argument.

    Raises:
        Unfillable: it cannot
    """
    allowed = ""
    relation = argument.relation
    if element.relations and relation and relation not in element.relations:
        allowed = f"{join_with_or(other.replace('_', ' ') for other in element.relations)} something"
    elif element.counts and not _is_countable(argument, element.counts):
        most = max(element.counts)
        numbers = join_with_or(map(str, element.counts))
        allowed = f"{numbers} {'thing' if most == 1 else 'things'} at a time"
    elif element.quantifiers and argument.quantifier and argument.quantifier not in element.quantifiers:
        allowed = f"{join_with_or(other.replace('_', ' ') for other in element.quantifiers)} something"
    if allowed:
        said = argument.words or f"{relation.replace('_', ' ')} {argument.text}".strip()
        raise Unfillable(
            "VALUE_NOT_ALLOWED",
            f'The {spoken_name(element.name)} cannot be "{said}", only {allowed}.',
        )


def _is_countable(argument: TypedArgument, counts: Tuple[int, ...]) -> bool:
    """Whether an argument names one of these numbers of things; a plural without a number names several."""
    if argument.members and argument.conjunction != "or":
        return len(argument.members) in counts
    if argument.count is not None:
        return argument.count in counts
    return max(counts) > 1 if argument.is_plural else 1 in counts


def extra_thematic_arguments(
    frame: Optional[SemanticFrame], arguments: Iterable[TypedArgument]
) -> Tuple[TypedArgument, ...]:
    """Return the arguments of extra-thematic elements, which every frame inherits; its own elements hide them."""
    names = extra_thematic_of_arguments()
    return tuple(
        argument
        for argument in arguments
        if argument.name in names and argument.text and (frame is None or frame.element(argument.name) is None)
    )


def _measured(element: FrameElement, quantity: Quantity, found: Mapping[str, TypedArgument]) -> TypedArgument:
    """Return the argument of an element with a quantity, with its measure.

    Raises:
        Unfillable: it is no such quantity, or beyond a limit
    """
    argument = found[element.name]
    unit = found[element.unit_element].text if element.unit_element in found else ""
    said = f"{argument.text} {unit}".strip()
    si = argument.si if argument.measure is not None and argument.measure.kind == quantity.value else None
    if si is None:
        # A default, a constant of a relation, or the words of an element that asks for no measure.
        try:
            number = parse_number(argument.text) if quantity is Quantity.NUMBER else None
            measure = None if number is not None else parse_measure(said, quantity=quantity.value)
        except QuantityError as error:
            code = "LIMIT" if error.code == "NOT_FINITE" else "VALUE_NOT_ALLOWED"
            raise Unfillable(code, f"I cannot use the {spoken_name(element.name)}: {error}") from error
        amount, name = (number, "") if measure is None else (measure.amount, measure.unit)
        si = number if measure is None else measure.si_amount
        argument = replace(argument, measure=Measure(quantity.value, said, amount, name, si))
    for limit, is_beyond, word in ((element.maximum, operator.gt, "more"), (element.minimum, operator.lt, "less")):
        if limit is not None and si is not None and is_beyond(si, limit):
            sentence = f"{said} is {word} than I may do: the limit is {spoken_limit(limit, quantity)}."
            raise Unfillable("LIMIT", sentence)
    return argument


#: Units for limits in sentences, the largest first: a limit has the first of which it is a whole number.
_UNITS = {
    Quantity.LENGTH: ((1.0, "metre"),),
    Quantity.ANGLE: ((math.radians(1.0), "degree"),),
    Quantity.DURATION: ((3600.0, "hour"), (60.0, "minute"), (1.0, "second")),
}


def spoken_limit(si: float, quantity: Quantity) -> str:
    """Return a limit for a person: "5 minutes"; a number has no unit.

    Args:
        si: the limit in metres, radians or seconds
        quantity: what it limits
    """
    units = _UNITS.get(quantity)
    if units is None:
        return f"{si:g}"
    # Angles are written in degrees and kept in radians.
    amounts = [(round(si / factor, 6), unit) for factor, unit in units]
    amount, unit = next((one for one in amounts if one[0] >= 1.0 and one[0] == int(one[0])), amounts[-1])
    return f"{amount:g} {unit}" if amount == 1.0 else f"{amount:g} {unit}s"


def child_arguments(parent: FilledFrame, child: RelatedFrame) -> Optional[Mapping[str, TypedArgument]]:
    """Map the arguments of a filled frame to a child.

    Args:
        parent: the filled parent
        child: a child in the parent's file
    Returns:
        arguments by element of the child; None if the parent does not meet a value condition of the child
    """
    if unmet_condition(parent, child) is not None:
        return None
    arguments: Dict[str, TypedArgument] = {}
    for relation in child.frame_element_relations:
        name = relation.child_name if not isinstance(relation, ValueCondition) else ""
        if isinstance(relation, ConstantArgument):
            arguments[name] = TypedArgument(name, relation.parent_value, Source.DEFAULT)
        elif isinstance(relation, ElementMapping):
            argument = parent.find(relation.parent_name)
            if argument is not None:
                meant = relation.relation or argument.relation
                is_same = argument.name == name and argument.relation == meant
                arguments[name] = argument if is_same else replace(argument, name=name, relation=meant)
    return arguments


def unmet_condition(parent: FilledFrame, child: RelatedFrame) -> Optional[ValueCondition]:
    """Return the first value condition of a child that its filled parent does not meet; None if it meets all."""
    for relation in child.frame_element_relations:
        if isinstance(relation, ValueCondition):
            said = without_determiner(parent.text(relation.parent_name))
            if said not in [without_determiner(value) for value in relation.child_values]:
                return relation
    return None


def without_determiner(argument: str) -> str:
    """Return an argument in the form that value conditions compare: "glass" for "The glass"."""
    return word_classes.without_determiner(argument).lower()


def spoken_name(name: str) -> str:
    """Return the name of a frame or an element in words: "moving forward" for "moving_forward"."""
    return name.replace("_", " ")
