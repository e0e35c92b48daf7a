"""What the robot knows of a home from its map, and what it perceives in it."""

from typing import Iterable, List

from home_servers.memory import Known
from roboframenet_sim.home_looks import states_of
from roboframenet_sim.home_state import Entity, Plan, State


def known_of_map(plan: Plan) -> List[Known]:
    """Return rooms, doors and furniture, as a map has them: whether they are open or on is not known.

    The attributes of a door are the rooms that it joins.
    """
    return [
        _known(plan, entity, room=entity.room or (entity.id if entity.kind == "room" else ""), states=(), stamp_s=-1.0)
        for entity in plan.entities.values()
        if entity.kind in ("room", "door", "furniture")
    ]


def _known(
    plan: Plan,
    entity: Entity,
    *,
    room: str,
    states: "tuple[str, ...]",
    stamp_s: float,
    relation: str = "",
    holder: str = "",
    point: "tuple[float, float] | None" = None,
) -> Known:
    x_m, y_m = point or entity.centre
    attributes = entity.rooms if entity.kind == "door" else tuple(value for _, value in entity.attributes)
    return Known(
        entity.id,
        entity.kind,
        entity.names,
        entity.category,
        attributes,
        relation,
        holder,
        room,
        states,
        x_m,
        y_m,
        stamp_s,
    )


def known_of_sight(plan: Plan, state: State, seen: Iterable[str]) -> List[Known]:
    """Return what the robot knows of what it sees now, and of what it holds."""
    found: List[Known] = []
    for ident in dict.fromkeys([*seen, *state.held_by("robot")]):
        entity = plan.entities[ident]
        place = state.places.get(ident)
        point = plan.position(state, ident)
        found.append(
            _known(
                plan,
                entity,
                room=ident if entity.kind == "room" else entity.room or plan.room_at(point),
                states=tuple(states_of(state, entity)),
                stamp_s=state.time_s,
                relation=place.relation if place else "",
                holder=place.holder if place else "",
                point=point,
            )
        )
    return found
