"""Writes a binding for a live action server, service or topic; ``rfn bind`` prints it."""

from typing import Dict, Iterable, List, Mapping, Optional, Sequence, Tuple

from rfnserver.goal_binding import BindingError, BoundElement, plan_goal
from rfnserver.goal_types import Filling, GoalField

#: Elements that name a place in the shipped frames.
_PLACES = ("goal", "location", "place", "destination")
#: Keys of a binding, and the fields of std_srvs that they name.
_RESPONSE = (("success_field", "success"), ("text_field", "message"))


def guessed_fields(fields: Sequence[GoalField], elements: Iterable[BoundElement]) -> Dict[str, str]:
    """Return the fields, by path, that elements of other names fill: a place, or the one that is left over."""
    names = {name for field in fields for name in (field.name, field.element)}
    left = [element for element in elements if element.name not in names]
    taken: Dict[str, str] = {}
    known = {element.name for element in elements}
    free = [field for field in fields if field.filling is not None and not known & {field.name, field.element}]
    places = [field for field in free if field.filling is Filling.PLACE]
    wanted = [element for element in left if element.name in _PLACES]
    if len(places) == 1 and len(wanted) == 1:
        taken[places[0].path] = wanted[0].name
    cores = [element for element in left if element.is_core and element.name not in taken.values()]
    # Any words fit a string; whether they are yes or no, or a number, nobody knows here.
    others = [field for field in free if field.path not in taken and field.filling is Filling.STRING]
    if len(cores) == 1 and len(others) == 1:
        taken[others[0].path] = cores[0].name
    return taken


def frames_that_fit(fields: Sequence[GoalField], frames: Mapping[str, Sequence[BoundElement]]) -> Tuple[str, ...]:
    """Return the frames of which goals can be made with what is guessed; those that fill most fields come first."""
    found: List[Tuple[int, str]] = []
    for name, elements in frames.items():
        try:
            plan = plan_goal(fields, elements, mapping=guessed_fields(fields, elements))
        except BindingError:
            continue
        if plan.sources:
            found.append((-len(plan.sources), name))
    return tuple(name for _, name in sorted(found))


def binding_text(
    *,
    frame_name: str,
    elements: Sequence[BoundElement],
    kind: str,
    target: str,
    type_name: str,
    fields: Sequence[GoalField],
    response: Sequence[str] = (),
) -> Tuple[str, Optional[str]]:
    """Write the entry of a binding file.

    Args:
        frame_name: the frame
        elements: of the frame
        kind: "action", "service" or "topic"
        target: its name
        type_name: "move_base_msgs/MoveBaseAction"
        fields: of its goals, requests or messages
        response: names of the fields of a service's response
    Returns:
        the text, and what is still wrong with it; None for nothing
    """
    mapping = guessed_fields(fields, elements)
    lines = ["bindings:", f"  - frame: {frame_name}"]
    if target.strip("/") == frame_name:
        lines.append(f"    name: {frame_name}_binding    # the server itself has the name of the frame")
    lines += [f"    {kind}: {target}", f"    type: {type_name}"]
    fault: Optional[str] = None
    unfilled: Tuple[str, ...] = ()
    try:
        plan = plan_goal(fields, elements, mapping=mapping)
        filled = {source.field.path: source.element for source in plan.sources}
        unfilled = plan.unfilled
    except BindingError as error:
        fault = str(error)
        names = {element.name for element in elements}
        alike = {field.path: one for field in fields for one in (field.element, field.name) if one in names}
        filled = {**mapping, **alike}
        unfilled = tuple(field.path for field in fields if field.filling is not None and field.path not in filled)
    if filled or unfilled:
        lines.append("    fields:" if filled else "    fields: {}")
    types = {field.path: field.type_name for field in fields}
    lines += [f"      {path}: {element}    # {types[path]}" for path, element in filled.items()]
    lines += [f"      # {path}: {types[path]}, keeps its default" for path in unfilled]
    lines += [f"    {key}: {name}" for key, name in _RESPONSE if name in response]
    if fault:
        lines.append(f"    # {fault}")
    return "\n".join(lines) + "\n", fault
