"""A frame as a tool: its elements as a JSON schema."""

from dataclasses import dataclass
from typing import Any, Dict, Iterable, List, Mapping, Sequence, Tuple

from roboframenet_ros.spoken_text import join_with_or
from semantic_frames.extra_thematic import extra_thematic_of_arguments
from semantic_frames.frame import FrameElement, Quantity, SemanticFrame
from semantic_frames.semantic_type import SEMANTIC_TYPES
from semantic_frames.server_profile import Purpose, ServerProfile

#: Characters of the argument of an element.
LONGEST_ARGUMENT = 500
#: When a called frame begins; each word with the value of ``Plan.beginning`` that it stands for.
BEGINNINGS: Mapping[str, str] = {"now": "REPLACE", "after": "FOLLOW", "beside": "BESIDE"}
#: The property that says when a called frame begins.
BEGIN = "begin"
#: Properties of an argument that says how it is related to the action.
THING, RELATION = "thing", "relation"
#: Name and symbol of the SI unit of each quantity.
UNITS: Mapping[Quantity, Tuple[str, str]] = {
    Quantity.LENGTH: ("metres", "m"),
    Quantity.ANGLE: ("radians", "rad"),
    Quantity.DURATION: ("seconds", "s"),
    Quantity.NUMBER: ("", ""),
}
#: Names of the tools that are no frames; a frame of such a name gets a prefix.
OWN_TOOLS = ("say", "stop", "world", "deeds", "explain")

Schema = Mapping[str, Any]


@dataclass(frozen=True)
class Server:
    """A living server that acts.

    Attributes:
        name: of its action
        profile: what it states about itself
    """

    name: str
    profile: ServerProfile


@dataclass(frozen=True)
class FrameTool:
    """A frame that an agent can call.

    Attributes:
        name: of the tool
        frame: what is called
        servers: that carry it out
        description: for the agent; it holds words of robot programmers only, and none that the robot has perceived
        schema: the JSON schema of the arguments
    """

    name: str
    frame: SemanticFrame
    servers: Tuple[Server, ...]
    description: str
    schema: Schema

    @property
    def may_want_yes(self) -> bool:
        """Whether a person must say yes before the frame is carried out, at least for some arguments."""
        return self.frame.is_confirmed or any(element.confirmed_values for element in self.frame.frame_elements)


def frame_tools(frames: Iterable[SemanticFrame], servers: Mapping[str, Sequence[Server]]) -> Dict[str, FrameTool]:
    """Return the tools for what living servers carry out, by name.

    Args:
        frames: that are known
        servers: that live, by the frame that they registered for
    """
    tools: Dict[str, FrameTool] = {}
    for frame in sorted(frames, key=lambda frame: frame.name):
        acting = tuple(one for one in servers.get(frame.name, ()) if one.profile.purpose is Purpose.ACTS)
        if acting and not frame.is_condition:
            name = f"frame_{frame.name}" if frame.name in OWN_TOOLS else frame.name
            tools[name] = FrameTool(name, frame, acting, _description(frame, acting), _schema(frame, acting))
    return tools


def spoken(name: str) -> str:
    """Return a name in words."""
    return name.replace("_", " ")


def _description(frame: SemanticFrame, servers: Sequence[Server]) -> str:
    parts = [" ".join(frame.description.split()) or f"Carries out the frame {spoken(frame.name)}."]
    if frame.is_question:
        parts.append("It answers, and changes nothing.")
    if frame.is_confirmed:
        parts.append("A person must say yes first.")
    for element in frame.frame_elements:
        if element.confirmed_values and not frame.is_confirmed:
            values = join_with_or(element.confirmed_values)
            parts.append(f"A person must say yes first where the {spoken(element.name)} is {values}.")
    parts.append(f"Servers: {', '.join(one.name for one in servers)}.")
    return " ".join(parts)


def _schema(frame: SemanticFrame, servers: Sequence[Server]) -> Schema:
    units = {element.unit_element for element in frame.frame_elements}
    properties: Dict[str, Schema] = {}
    required: List[str] = []
    for element in frame.frame_elements:
        is_needed = element.is_core and not element.default
        if element.name in units or not (is_needed or _is_heeded(element.name, frame, servers)):
            continue
        properties[element.name] = _property(element, frame, servers)
        if is_needed:
            required.append(element.name)
    for name in extra_thematic_of_arguments():
        if frame.element(name) is None and _is_heeded(name, frame, servers):
            properties[name] = _words(FrameElement(name), frame, servers)
    if BEGIN not in properties and not frame.is_question:
        properties[BEGIN] = {
            "type": "string",
            "enum": list(BEGINNINGS),
            "default": "now",
            "description": "When it begins: now, in the place of what runs; after what runs; or beside it.",
        }
    return {"type": "object", "properties": properties, "required": required, "additionalProperties": False}


def _is_heeded(name: str, frame: SemanticFrame, servers: Sequence[Server]) -> bool:
    return any(one.profile.heeded(name, frame) for one in servers)


def _property(element: FrameElement, frame: SemanticFrame, servers: Sequence[Server]) -> Schema:
    return _words(element, frame, servers) if element.quantity is None else _amount(element, element.quantity)


def _amount(element: FrameElement, quantity: Quantity) -> Schema:
    name, symbol = UNITS[quantity]
    amount: Dict[str, Any] = {"type": "number"}
    said = f"The {spoken(element.name)}" + (f", in {name}" if name else "")
    if element.default:
        said += f"; {element.default} of the frame's own unit if it is left out"
    amount["description"] = f"{said}."
    if symbol:
        amount["unit"] = symbol
    if element.minimum is not None:
        amount["minimum"] = element.minimum
    if element.maximum is not None:
        amount["maximum"] = element.maximum
    return amount


def _words(element: FrameElement, frame: SemanticFrame, servers: Sequence[Server]) -> Schema:
    values = list(element.values) or _stated_values(element.name, frame, servers)
    words: Dict[str, Any] = {"type": "string"}
    if values:
        words["enum"] = values
    else:
        words.update(minLength=1, maxLength=LONGEST_ARGUMENT)
    about = [f"The {spoken(element.name)}"]
    if element.semantic_types:
        about.append(join_with_or(SEMANTIC_TYPES[kind].words for kind in element.semantic_types))
        about.append("the id of an object of `world`, or words such as its name")
    if element.answer:
        about.append(f"for instance: {element.answer}")
    words["description"] = "; ".join(about) + "."
    if element.semantic_types:
        words["semanticTypes"] = list(element.semantic_types)
    if element.default:
        words["default"] = element.default
    relations = _relations(element, frame, servers)
    if not relations:
        return words
    description = words.pop("description")
    related = {
        "type": "object",
        "properties": {THING: dict(words), RELATION: {"type": "string", "enum": relations}},
        "required": [THING],
        "additionalProperties": False,
    }
    return {"description": description, "anyOf": [words, related]}


def _stated_values(name: str, frame: SemanticFrame, servers: Sequence[Server]) -> List[str]:
    """Return the only values that the servers heed; none if one of them heeds any."""
    found: List[str] = []
    for server in servers:
        for heeded in server.profile.heeded(name, frame):
            if not heeded.values:
                return []
            found += heeded.values
    # Servers list "slow" and "slow pace"; the one word is enough for both.
    single = [value for value in found if " " not in value]
    return list(dict.fromkeys(single or found))


def _relations(element: FrameElement, frame: SemanticFrame, servers: Sequence[Server]) -> List[str]:
    """Return the relations that the frame and its servers know of an element; none if neither lists any."""
    stated = [
        relation
        for server in servers
        for heeded in server.profile.heeded(element.name, frame)
        for relation in heeded.relations
    ]
    return list(dict.fromkeys(stated or element.relations))
