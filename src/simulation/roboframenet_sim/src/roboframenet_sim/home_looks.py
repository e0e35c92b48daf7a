"""How the things and persons of a home look."""

from typing import List

from roboframenet_sim.home_state import Entity, State

#: Properties that are seen, as states: (property, when true, when false).
SEEN = (
    ("is_on", "on", "off"),
    ("is_dirty", "dirty", "clean"),
    ("is_wet", "wet", ""),
    ("is_full", "full", ""),
    ("is_folded", "folded", ""),
)


def states_of(state: State, entity: Entity) -> List[str]:
    """Return how something looks."""
    found: List[str] = []
    if "closable" in entity.traits:
        found.append("open" if state.is_(entity.id, "is_open") else "closed")
    for name, yes, no in SEEN:
        if name in state.properties.get(entity.id, {}) or (name == "is_on" and "switch" in entity.traits):
            word = yes if state.is_(entity.id, name) else no
            found += [word] if word else []
    if "level" in state.properties.get(entity.id, {}):
        found.append(f"level={state.number(entity.id, 'level'):g}")
    if entity.id in state.people:
        found.append(state.people[entity.id].posture)
    return found
