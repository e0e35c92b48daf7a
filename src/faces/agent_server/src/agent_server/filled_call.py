"""A call of a frame, checked and filled."""

from dataclasses import dataclass
from typing import Any, Dict, List, Mapping, Tuple

from agent_server.frame_tool import BEGIN, BEGINNINGS, RELATION, THING, UNITS, FrameTool, spoken
from agent_server.schema_check import checked
from agent_server.things import meant
from semantic_frames.frame import FrameElement, Quantity, SemanticFrame
from typed_arguments import Measure, TypedArgument
from world_model import World

#: Units in the singular, as measures have them.
_SINGULAR: Mapping[Quantity, str] = {
    Quantity.LENGTH: "metre",
    Quantity.ANGLE: "radian",
    Quantity.DURATION: "second",
    Quantity.NUMBER: "",
}
#: Digits of an amount in its text; the measure has all of them.
_DIGITS = 12


@dataclass(frozen=True)
class FilledCall:
    """A call of a frame.

    Attributes:
        frame_name: of the frame
        arguments: of its elements
        beginning: when it begins, by the name of the constant of ``Plan``
        doubts: why a person must say yes first, in sentences; empty when nobody need be asked
    """

    frame_name: str
    arguments: Tuple[TypedArgument, ...]
    beginning: str = "REPLACE"
    doubts: Tuple[str, ...] = ()

    @property
    def words(self) -> str:
        """The call in words, for people: "bringing (theme: the mug, goal: the table)"."""
        told = ", ".join(f"{spoken(one.name)}: {one.words or one.text}" for one in self.arguments)
        return f"{spoken(self.frame_name)} ({told})" if told else spoken(self.frame_name)


def filled_call(tool: FrameTool, arguments: object, world: World) -> FilledCall:
    """Check and fill a call.

    Args:
        tool: that is called
        arguments: as they came over the wire
        world: what the robot knows
    Raises:
        CallRefused: it cannot be meant; the limits of the frame and of its servers are checked again by the robot
    """
    values = checked(tool.schema, arguments)
    frame = tool.frame
    beginning = "now" if frame.element(BEGIN) is not None else str(values.pop(BEGIN, "now"))
    filled: List[TypedArgument] = []
    doubts: List[str] = []
    kinds: Dict[str, Tuple[str, ...]] = {}
    for name, value in values.items():
        element = frame.element(name) or FrameElement(name)
        if element.quantity is not None:
            filled += _amounts(element, element.quantity, float(value), frame)
            continue
        text, relation = _thing(value)
        found = meant(element, text, relation, frame, world)
        filled.append(found.argument)
        kinds[name] = found.kinds
        doubts += found.doubts
    if frame.wants_yes(kinds):
        doubts.append("Somebody must say yes to it first.")
    return FilledCall(frame.name, tuple(filled), BEGINNINGS[beginning], tuple(doubts))


def _thing(value: Any) -> Tuple[str, str]:
    if isinstance(value, dict):
        return str(value[THING]), str(value.get(RELATION, ""))
    return str(value), ""


def _amounts(element: FrameElement, quantity: Quantity, amount: float, frame: SemanticFrame) -> List[TypedArgument]:
    """Return an amount, with its unit in the element that holds it, or in its own text."""
    number, unit = f"{amount:.{_DIGITS}g}", UNITS[quantity][0]
    words = f"{number} {unit}".strip()
    measure = Measure(quantity.value, words, amount, _SINGULAR[quantity], amount)
    has_unit = bool(element.unit_element) and frame.element(element.unit_element) is not None
    found = [TypedArgument(element.name, number if has_unit else words, words=words, measure=measure)]
    if has_unit:
        found.append(TypedArgument(element.unit_element, unit))
    return found
