"""Writes a binding for a live action server, service or topic; ``rfn bind`` prints it."""

import re
from typing import Dict, FrozenSet, Iterable, List, Mapping, Optional, Sequence, Set, Tuple

from rfnserver.goal_binding import BindingError, BoundElement, plan_goal
from rfnserver.goal_types import Filling, GoalField, element_name
from roboframenet_tools.verb_forms import verb_of

#: Elements that name a place in the shipped frames.
_PLACES = ("goal", "location", "place", "destination")
#: Keys of a binding, and the fields of std_srvs that they name.
_RESPONSE = (("success_field", "success"), ("text_field", "message"))
#: As many frames are offered.
MOST_OFFERED = 5
#: Words of names that say nothing about what a server does.
_EMPTY_WORDS = frozenset({"action", "server", "goal", "msgs", "srvs", "std", "set", "data", "name", "header"})


def guessed_fields(fields: Sequence[GoalField], elements: Iterable[BoundElement]) -> Dict[str, str]:
    """Return the fields, by path, that elements of other names may fill; a person has to look at each.

    A field for a place comes first, for an element that names one or for the core element that is left over. Only then
    a string: any words fit it.
    """
    known = list(elements)
    names = {name for field in fields for name in (field.name, field.element)}
    left = [element for element in known if element.name not in names]
    own = {element.name for element in known}
    free = [field for field in fields if field.filling is not None and not own & {field.name, field.element}]
    places = [field.path for field in free if field.filling is Filling.PLACE]
    strings = [field.path for field in free if field.filling is Filling.STRING]
    named = [element.name for element in left if element.name in _PLACES]
    cores = [element.name for element in left if element.is_core]
    guesses: Dict[str, str] = {}
    for paths, candidates in ((places, named), (places, cores), (strings, cores)):
        open_ones = [name for name in candidates if name not in guesses.values()]
        open_paths = [path for path in paths if path not in guesses]
        if len(open_paths) == 1 and len(open_ones) == 1:
            guesses[open_paths[0]] = open_ones[0]
    return guesses


def words_of(*names: str) -> FrozenSet[str]:
    """Return the words in names of types, fields and servers, with the verb of those that end with -ing."""
    found: Set[str] = set()
    for name in names:
        found.update(word for part in re.split(r"[^A-Za-z0-9]+", name) for word in element_name(part).split("_"))
    found.update(filter(None, (verb_of(word, found.__contains__) for word in tuple(found) if word.endswith("ing"))))
    return frozenset(found - _EMPTY_WORDS - {""})


def frames_that_fit(
    fields: Sequence[GoalField],
    frames: Mapping[str, Sequence[BoundElement]],
    *,
    words: FrozenSet[str] = frozenset(),
    verbs: Optional[Mapping[str, Iterable[str]]] = None,
) -> Tuple[str, ...]:
    """Return the frames that the server may be for, the likeliest first, at most :data:`MOST_OFFERED`.

    A word of the server that is also a verb or a word of the frame counts most, then a field with the name of an
    element, and then that a goal can be made with what is guessed.

    Args:
        fields: of the goals
        frames: elements by name of the frame
        words: of the names of the server and its type, see :func:`words_of`
        verbs: verbs that evoke a frame, by its name
    """
    named = {name for field in fields for name in (field.name, field.element)}
    ranked: List[Tuple[int, int, int, str]] = []
    for name, elements in frames.items():
        meant = len(words & (words_of(name) | set((verbs or {}).get(name, ()))))
        alike = sum(element.name in named for element in elements)
        guesses = guessed_fields(fields, elements)
        is_whole = _is_whole(fields, elements, guesses)
        is_place = any(guesses.get(field.path) in _PLACES for field in fields if field.filling is Filling.PLACE)
        if meant or alike or (is_whole and is_place):
            ranked.append((-meant, -alike, -is_whole, name))
    best = sorted(ranked)[:MOST_OFFERED]
    return tuple(name for *_, name in best)


def _is_whole(fields: Sequence[GoalField], elements: Iterable[BoundElement], guesses: Mapping[str, str]) -> bool:
    try:
        return bool(plan_goal(fields, elements, mapping=guesses).sources)
    except BindingError:
        return False


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
    """Write the entry of a binding file. What is only guessed is a comment.

    Args:
        frame_name: the frame
        elements: of the frame
        kind: "action", "service" or "topic"
        target: its name
        type_name: "move_base_msgs/MoveBaseAction"
        fields: of its goals, requests or messages
        response: names of the fields of a service's response
    Returns:
        the text, and what a person has to look at; None for nothing
    """
    lines = ["bindings:", f"  - frame: {frame_name}"]
    if target.strip("/") == frame_name:
        lines.append(f"    name: {frame_name}_binding    # the server itself has the name of the frame")
    lines += [f"    {kind}: {target}", f"    type: {type_name}"]
    fault: Optional[str] = None
    try:
        plan = plan_goal(fields, elements)
        filled = {source.field.path: source.element for source in plan.sources}
    except BindingError as error:
        fault = str(error)
        names = {element.name for element in elements}
        filled = {
            field.path: one
            for field in fields
            if field.filling is not None
            for one in (field.element, field.name)
            if one in names
        }
    guesses = guessed_fields(fields, elements)
    if guesses:
        guessed = ", ".join(f"{path} by '{element}'" for path, element in guesses.items())
        fault = f"names differ, so I only guess {guessed}: remove the '#' where that is right" + (
            f"; {fault}" if fault else ""
        )
    unfilled = [
        field.path
        for field in fields
        if field.filling is not None
        and field.path not in guesses
        and not any(_covers(path, field.path) for path in filled)
    ]
    if filled or guesses or unfilled:
        lines.append("    fields:")
    types = {field.path: field.type_name for field in fields}
    lines += [f"      {path}: {element}    # {types[path]}" for path, element in filled.items()]
    lines += [f"      # {path}: {element}    # {types[path]}: is it?" for path, element in guesses.items()]
    lines += [f"      # {path}: {types[path]}, keeps its default" for path in unfilled]
    lines += [f"    {key}: {name}" for key, name in _RESPONSE if name in response]
    if fault:
        lines.append(f"    # {fault}")
    return "\n".join(lines) + "\n", fault


def _covers(path: str, other: str) -> bool:
    return other == path or other.startswith(path + ".") or path.startswith(other + ".")
