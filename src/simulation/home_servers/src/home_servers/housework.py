"""Frames of cooking, cleaning and washing: a thing, a tool in the hand, a station."""

from typing import Dict, List, Optional, Tuple

from home_servers.body import CannotDo
from home_servers.handling import goal_of
from home_servers.memory import Known
from home_servers.skills import Skill, Skills, argument, said
from roboframenet_ros.spoken_text import join_with_and
from typed_arguments import FilledFrame, TypedArgument

#: What a robot knows of tools and stations: the names of tools for each treatment, the best first.
TOOLS: Dict[str, Tuple[str, ...]] = {
    "wipe": ("cloth", "sponge"),
    "scrub": ("sponge", "cloth"),
    "dry": ("towel", "cloth"),
    "sweep": ("broom",),
    "cut": ("knife",),
    "chop": ("knife",),
    "slice": ("knife",),
    "peel": ("knife",),
    "mix": ("spoon", "fork"),
    "iron": ("iron",),
}
#: Where a treatment is done, and the relation of the thing to it.
STATIONS: Dict[str, Tuple[str, str]] = {
    "rinse": ("sink", "into"),
    "wash_dish": ("sink", "into"),
    "boil": ("stove", "on"),
    "fry": ("stove", "on"),
    "bake": ("oven", "into"),
    "wash_cloth": ("washing machine", "into"),
    "iron": ("ironing board", "on"),
}
#: What is switched on for a treatment and off after it.
HEATED = ("boil", "fry", "bake", "wash_cloth")
#: Things that are meant by a word for many.
KINDS: Dict[str, Tuple[str, str]] = {
    "dish": ("category", "dish"),
    "dishes": ("category", "dish"),
    "laundry": ("category", "clothes"),
    "clothes": ("category", "clothes"),
    "washing": ("category", "clothes"),
}


def treat(treatment: str, element: str, tool_element: str = "instrument") -> Skill:
    """Return the skill that treats what an element names: all of them when it is plural."""

    def act(skills: Skills, frame: FilledFrame) -> None:
        targets = targets_of(skills, argument(frame, element), treatment)
        if said(frame, "other_part"):
            targets += targets_of(skills, argument(frame, "other_part"), treatment)
        container = argument(frame, "container")
        with skills.borrowed(find_tool(skills, treatment, argument(frame, tool_element))):
            for target in targets:
                if treatment == "mix" and container.text:
                    _put_together(skills, target, container)
                treat_one(skills, treatment, target, container=container, least_s=_duration_s(frame))

    return act


def _put_together(skills: Skills, part: Known, container: TypedArgument) -> None:
    """Put what is mixed into its container, unless it is there."""
    vessel = skills.find(container, "thing", "furniture")
    if not skills.is_at(skills.memory.get(part.id) or part, vessel):
        skills.take(part)
        skills.put(part.id, vessel, "into")


def _duration_s(frame: FilledFrame) -> float:
    """Return how long something was said to take, seconds; 0 when nothing was said."""
    return argument(frame, "duration").si or 0.0


def targets_of(skills: Skills, words: TypedArgument, treatment: str) -> List[Known]:
    """Return what is treated: members of a list one by one."""
    if words.members:
        return [one for member in words.members for one in targets_of(skills, member, treatment)]
    kind = KINDS.get((words.lemma or words.text).lower()) or KINDS.get(words.head.lower())
    if kind is not None:
        found = _of_kind(skills, kind[1])
        if found:
            return found
    if treatment == "sweep":
        return _floors(skills, words)
    return skills.find_all(words, "thing", "furniture")


def _of_kind(skills: Skills, category: str) -> List[Known]:
    def seen() -> List[Known]:
        return [
            one
            for one in skills.memory.all("thing")
            if one.is_a(category) and one.relation not in ("", "held") and "dirty" in one.states
        ]

    if not seen():
        for place in ("laundry basket",) if category == "clothes" else ("kitchen table", "counter"):
            for one in skills.memory.find(TypedArgument(text=place), "furniture")[:1]:
                skills.look_in(one)
    return seen()


def _floors(skills: Skills, words: TypedArgument) -> List[Known]:
    """Return the rooms that were named, or the room where the robot is: "the floor"."""
    if skills.memory.find(words, "room"):
        return skills.find_all(words, "room")
    here = skills.room_here()
    if here is None:
        raise CannotDo("I do not know where I am.")
    return [here]


def find_tool(skills: Skills, treatment: str, named: TypedArgument) -> Optional[Known]:
    """Return the tool that was named, or one that is good for it, rather one that is held; None for bare hands."""
    if named.text:
        return skills.find(named, "thing")
    names = TOOLS.get(treatment, ())
    held = skills.body.held()
    known = [one for name in names for one in skills.memory.find(TypedArgument(text=name), "thing") if one.relation]
    known.sort(key=lambda one: one.id not in held)
    if known or not names:
        return known[0] if known else None
    return _search_tool(skills, names)


#: Where tools are kept, as everybody knows.
_KEPT: Dict[str, str] = {"knife": "drawer", "cloth": "counter", "sponge": "counter", "spoon": "kitchen table"}


def _search_tool(skills: Skills, names: Tuple[str, ...]) -> Known:
    for name in names:
        for place in skills.memory.find(TypedArgument(text=_KEPT.get(name, "")), "furniture")[:1]:
            skills.look_in(place)
            found = [one for one in skills.memory.find(TypedArgument(text=name), "thing") if one.relation]
            if found:
                return found[0]
    return skills.find(TypedArgument(text=names[0]), "thing")


def treat_one(
    skills: Skills,
    treatment: str,
    target: Known,
    *,
    container: Optional[TypedArgument] = None,
    least_s: float = 0.0,
) -> None:
    """Treat one thing, at its station when it has one; it stays there for so long at least."""
    station_name, relation = STATIONS.get(treatment, ("", ""))
    if not station_name:
        skills.go(target.id)
        skills.attempt("treat", theme=target.id, value=treatment)
        return
    station = skills.find(TypedArgument(text=station_name), "furniture")
    if target.sort == "thing" and not skills.is_at(skills.memory.get(target.id) or target, station):
        vessel = _vessel(skills, station, container)
        skills.take(target)
        skills.put(target.id, vessel or station, "into" if vessel else relation)
    if treatment in HEATED:
        skills.attempt("switch", theme=station.id, value="on")
    skills.go(target.id if target.sort == "thing" else station.id)
    begin_s = skills.body.now_s()
    try:
        skills.attempt("treat", theme=target.id, value=treatment)
        if least_s > skills.body.now_s() - begin_s:
            skills.wait(least_s - (skills.body.now_s() - begin_s))
    finally:
        if treatment in HEATED:
            skills.attempt("switch", theme=station.id, value="off")


def _vessel(skills: Skills, station: Known, container: Optional[TypedArgument]) -> Optional[Known]:
    """Return the pot or pan that was named, on the station.

    Raises:
        CannotDo: other furniture was named
    """
    if container is None or not container.text:
        return None
    found = [one for one in skills.find_all(container, "thing", "furniture") if one.id != station.id]
    if not found:
        return None
    if found[0].sort != "thing":
        raise CannotDo(f"I can do that only with {station.the_name}, not with {found[0].the_name}.")
    if not skills.is_at(found[0], station):
        skills.take(found[0])
        skills.put(found[0].id, station, "on")
    return found[0]


def cook(skills: Skills, frame: FilledFrame) -> None:
    """Cook food as its container says; boil it when nothing is said."""
    heater, heaters = argument(frame, "heating_instrument"), ("dish", STATIONS["boil"][0], STATIONS["bake"][0])
    if heater.text and skills.find(heater, "furniture", "thing").category not in heaters:
        raise CannotDo(f"I cannot cook with {heater.text}.")
    words = f"{frame.text('container')} {frame.text('heating_instrument')}"
    how = "bake" if "oven" in words else "fry" if any(one in words for one in ("pan", "wok", "skillet")) else "boil"
    for target in targets_of(skills, argument(frame, "food"), how):
        treat_one(skills, how, target, container=argument(frame, "container"), least_s=_duration_s(frame))


def clean(skills: Skills, frame: FilledFrame) -> None:
    """Make something clean: a floor is swept, dishes are washed, the rest is wiped or scrubbed."""
    words = argument(frame, "object")
    found = skills.memory.find(words, "room", "furniture", "thing")
    target = found[0] if found else skills.find(words)
    if target.sort == "room":
        treat("sweep", "object")(skills, frame)
    elif target.is_a("dish") or target.is_a("cup"):
        treat("wash_dish", "object")(skills, frame)
    elif target.is_a("clothes"):
        treat("wash_cloth", "object")(skills, frame)
    elif target.sort == "furniture":
        with skills.borrowed(find_tool(skills, "wipe", argument(frame, "instrument"))):
            treat_one(skills, "wipe", target)
    else:
        raise CannotDo(f"I cannot clean {target.the_name}.")


def tidy(skills: Skills, frame: FilledFrame) -> None:
    """Look what lies about, and say that the robot does not know where it belongs.

    Raises:
        CannotDo: something lies about
    """
    place = skills.find(argument(frame, "object"), "room", "furniture")
    skills.look_in(place)
    lying = [one.the_name for one in skills.memory.all("thing") if one.holder == place.id and one.relation == "on"]
    if lying:
        names = join_with_and(dict.fromkeys(lying))
        raise CannotDo(f"On {place.the_name} I see {names}. I do not know where that belongs: tell me where to put it.")
    skills.answer(f"Nothing lies on {place.the_name}.")


def pour(skills: Skills, frame: FilledFrame) -> None:
    """Pour a liquid from its bottle into something."""
    fluid = skills.find(argument(frame, "fluid"), "thing")
    with skills.borrowed(fluid):
        vessel = skills.find(argument(frame, "goal"), "thing", "furniture")
        skills.attempt("pour", theme=fluid.id, goal=vessel.id)


def hang(skills: Skills, frame: FilledFrame) -> None:
    """Hang clothes up, on the line when no place is named."""
    for one in targets_of(skills, argument(frame, "clothes"), "hang"):
        place = (
            goal_of(skills, argument(frame, "goal"))
            if said(frame, "goal")
            else skills.find(TypedArgument(text="clothes line"), "furniture")
        )
        skills.take(one)
        relation = argument(frame, "goal").relation
        skills.put(one.id, place, "on" if relation in ("", "over") else relation)


def sort_laundry(skills: Skills, frame: FilledFrame) -> None:
    """Take each piece out, and sort it."""
    for one in targets_of(skills, argument(frame, "clothes"), "sort"):
        skills.attempt("treat", theme=one.id, value="sort")
