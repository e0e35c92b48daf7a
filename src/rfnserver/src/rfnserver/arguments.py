"""Reads the arguments of a filled frame: words, lengths, angles."""

from typing import Any

from spoken_quantities import QuantityError, parse_measure, parse_number


class ArgumentError(ValueError):
    """An argument is missing or of the wrong kind; the message is a sentence for the person."""


def argument(frame: Any, name: str, default: str = "") -> str:
    """Return the argument of a frame element.

    Args:
        frame: anything with ``frame_elements`` that have ``name`` and ``argument``, such as the message
            FilledSemanticFrame, and perhaps with ``arguments``, as :class:`rfnserver.TypedFrame`
        name: of the element
        default: returned when the element has no argument
    """
    return next(
        (element.argument for element in frame.frame_elements if element.name == name and element.argument), default
    )


def required(frame: Any, name: str) -> str:
    """Return the argument of a frame element that must have one.

    Raises:
        ArgumentError: it has none
    """
    words = argument(frame, name)
    if not words:
        raise ArgumentError(f"The {name.replace('_', ' ')} is missing.")
    return words


def number(frame: Any, name: str) -> float:
    """Return the number in a frame element.

    Raises:
        ArgumentError: missing, or not a finite number
    """
    try:
        return parse_number(required(frame, name))
    except QuantityError as error:
        raise ArgumentError(f"I cannot use the {name.replace('_', ' ')}: {error}") from error


def length_m(frame: Any, name: str, *, unit_element: str = "", default_unit: str = "") -> float:
    """Return the length in a frame element, in metres.

    Args:
        frame: see :func:`argument`
        name: of the element with the number, and the unit where there is no ``unit_element``
        unit_element: the element that holds the unit
        default_unit: of a bare number
    Raises:
        ArgumentError: missing, not a length, or not finite
    """
    return _si_amount(frame, name, "length", unit_element, default_unit)


def angle_rad(frame: Any, name: str, *, unit_element: str = "", default_unit: str = "") -> float:
    """Return the angle in a frame element, in radians; see :func:`length_m`."""
    return _si_amount(frame, name, "angle", unit_element, default_unit)


def duration_s(frame: Any, name: str, *, unit_element: str = "", default_unit: str = "") -> float:
    """Return the duration in a frame element, in seconds; see :func:`length_m`."""
    return _si_amount(frame, name, "duration", unit_element, default_unit)


def _si_amount(frame: Any, name: str, quantity: str, unit_element: str, default_unit: str) -> float:
    typed = frame[name] if hasattr(frame, "__getitem__") else None
    if typed is not None and typed.si is not None and typed.measure.kind == quantity:
        return float(typed.si)
    said = f"{required(frame, name)} {argument(frame, unit_element)}".strip()
    try:
        return parse_measure(said, quantity=quantity, default_unit=default_unit).si_amount
    except QuantityError as error:
        raise ArgumentError(f"I cannot use the {name.replace('_', ' ')}: {error}") from error
