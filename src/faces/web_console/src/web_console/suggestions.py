"""Sentences that can be done here and now: from frames that have a server, and from what the world has."""

from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from typing import Dict, FrozenSet, Iterable, Iterator, List, Mapping, Sequence, Tuple

import yaml

from referring_expressions.describing import is_plural_noun

#: How many sentences are suggested, and how many objects of a kind are tried for each.
MOST_SUGGESTIONS = 40
_MOST_OBJECTS = 60
_SLOT = "{"
#: The slot of a verb that agrees with the first object.
_VERB = "is"


@dataclass(frozen=True)
class Template:
    """A sentence with slots, the frame that it means, and what it needs: hand, taker or nothing."""

    frame: str
    say: str
    needs: str = ""


@dataclass(frozen=True)
class Present:
    """An object of the world, as far as suggestions need it.

    Attributes:
        name: as people say it, with what tells it apart from its like
        sort: place, person, door, device or thing
        states: open, on, ...
        is_wide: whether it has edges: rooms and furniture
        is_loose: whether it lies on or in furniture, where a hand takes it; what stands on the floor may be too heavy
        carries: whether something is on it
        holder: sort of who holds it: robot or person; empty for nobody
        is_before: whether its place is known from an earlier run only
    """

    name: str
    sort: str
    states: FrozenSet[str] = frozenset()
    is_wide: bool = False
    is_loose: bool = False
    carries: bool = False
    holder: str = ""
    is_before: bool = False


def read_templates() -> Tuple[Template, ...]:
    """Read the sentences of `suggestions.yaml`."""
    text = Path(__file__).resolve().with_name("suggestions.yaml").read_text(encoding="utf-8")
    return tuple(Template(**entry) for entry in yaml.safe_load(text))


def suggest(
    templates: Sequence[Template], frames: FrozenSet[str], world: Iterable[Present], said: Iterable[str]
) -> Tuple[str, ...]:
    """Return sentences, a mixture of all kinds, without those that were said; when all were said, all again.

    Args:
        templates: sentences with slots
        frames: that have a server
        world: what is here
        said: sentences of the last commands
    """
    world = tuple(world)
    kinds = _kinds(world)
    holders = {one.holder for one in world}
    has = {"": True, "hand": "robot" not in holders, "taker": holders == {""}}
    usable = [one for one in templates if one.frame in frames and has[one.needs]]
    old = [_plain(text) for text in said]
    known = frozenset(old)
    ranked: List[Tuple[int, str]] = []
    for template in usable:
        # Who has said a kind often gets another kind first.
        begin = _plain(template.say.partition(_SLOT)[0])
        often = sum(text.startswith(begin) for text in old)
        fresh = [text for text in _sentences(template.say, kinds) if _plain(text) not in known]
        ranked += [(often + place, text) for place, text in enumerate(fresh)]
    everything = ranked or [(0, text) for one in usable for text in _sentences(one.say, kinds)]
    return tuple(dict.fromkeys(text for _, text in sorted(everything, key=lambda pair: pair[0])))[:MOST_SUGGESTIONS]


def _plain(text: str) -> str:
    return text.lower().strip(" .!?")


def _kinds(world: Iterable[Present]) -> Mapping[str, Tuple[str, ...]]:
    """Return names by the kind of the slot; a name that two objects have means none of them."""
    objects = [one for one in world if one.name]
    names = Counter(one.name for one in objects)
    alone = [one for one in objects if names[one.name] == 1 and not one.is_before]
    found: Dict[str, List[str]] = {}
    for one in alone:
        for kind in _kinds_of(one):
            found.setdefault(kind, []).append(one.name)
    return {kind: tuple(sorted(ones))[:_MOST_OBJECTS] for kind, ones in found.items()}


def _kinds_of(one: Present) -> Iterator[str]:
    is_open, is_shut = "open" in one.states, "closed" in one.states
    if one.holder == "robot":
        yield "held"
    elif one.sort == "person":
        yield "person"
    elif one.sort == "place":
        if one.is_wide:
            yield "room"
    elif one.sort == "door":
        if is_open:
            yield "open_door"
        elif is_shut:
            yield "shut_door"
    elif one.is_wide:
        yield "furniture"
        if is_open:
            yield "open_furniture"
        elif is_shut:
            yield "shut_furniture"
        elif one.carries:
            yield "surface"
    elif one.sort == "thing" and one.is_loose:
        yield "thing"
    if one.sort == "device":
        if "on" in one.states:
            yield "on"
        elif "off" in one.states:
            yield "off"


def _sentences(say: str, kinds: Mapping[str, Tuple[str, ...]]) -> List[str]:
    """Return a sentence for each object of its first slot; a second slot takes its objects in turn."""
    slots = [part.partition("}")[0] for part in say.split(_SLOT)[1:]]
    slots = [slot for slot in slots if slot != _VERB]
    if any(not kinds.get(slot) for slot in slots):
        return []
    if not slots:
        return [say]
    found = []
    for place, name in enumerate(kinds[slots[0]]):
        names = {slot: kinds[slot][place % len(kinds[slot])] for slot in slots[1:]}
        found.append(say.format(**{_VERB: "are" if is_plural_noun(name) else "is", slots[0]: name, **names}))
    return found
