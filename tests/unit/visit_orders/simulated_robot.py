"""A robot that carries out plans of visits in a home, and makes its way as badly as the plan allows.

The hall lies in the middle, with a door to every other room; these lie around it in a ring, each with a door to the
next one. In this way each room can be reached without each other one.
"""

from collections import deque
from dataclasses import dataclass
from itertools import permutations
from typing import Dict, FrozenSet, Iterator, List, Sequence, Tuple

from visit_orders.ltl import Lasso

HALL = "hall"
#: Where the robot begins; no order names this room.
START = "study"
RING = (START, "kitchen", "office", "bedroom", "library", "living_room", "garage", "bathroom")
_AROUND: Dict[str, Tuple[str, ...]] = {
    room: (RING[place - 1], RING[(place + 1) % len(RING)], HALL) for place, room in enumerate(RING)
}
DOORS: Dict[str, Tuple[str, ...]] = {HALL: RING, **_AROUND}
ROOMS = tuple(DOORS)
#: Rounds after which a repetition without an end must have begun to repeat itself.
_MOST_ROUNDS = 50


class NoWay(ValueError):
    """No way leads to a room without rooms that are to be avoided."""


@dataclass(frozen=True)
class Visit:
    """Go to a room, and not through others.

    Attributes:
        room: one of `ROOMS`
        avoided: rooms to keep out of on the way
    """

    room: str
    avoided: FrozenSet[str] = frozenset()


@dataclass(frozen=True)
class InOrder:
    """One after the other."""

    parts: Tuple["Order", ...]


@dataclass(frozen=True)
class InAnyOrder:
    """One after the other, in an order that the robot chooses; `after` has the parts that come before each part."""

    parts: Tuple["Order", ...]
    after: Tuple[Tuple[int, ...], ...] = ()


@dataclass(frozen=True)
class Again:
    """So many times; 0 for no end."""

    part: "Order"
    times: int = 0


Order = object


def runs_of(order: Order) -> Iterator[Lasso]:
    """Yield runs of an order: with each choice it leaves, on ways through each room that it allows.

    A state holds `in_room` for the room in which the robot is, and `room` where a visit of it ends. After its last
    visit the robot stays where it is.

    Raises:
        NoWay: the avoided rooms leave none
    """
    for chosen in _choices(order):
        for detour in ("", *ROOMS):
            yield _Walk(detour).run(chosen)


def _choices(order: Order) -> Iterator[Order]:
    """Yield an order with each sequence for parts in any order."""
    if isinstance(order, Again):
        for part in _choices(order.part):
            yield Again(part, order.times)
    elif isinstance(order, InOrder):
        for parts in _all_choices(order.parts):
            yield InOrder(parts)
    elif isinstance(order, InAnyOrder):
        after = order.after or tuple(() for _ in order.parts)
        for places in permutations(range(len(order.parts))):
            if all(places.index(before) < places.index(place) for place in places for before in after[place]):
                for parts in _all_choices([order.parts[place] for place in places]):
                    yield InOrder(parts)
    else:
        yield order


def _all_choices(parts: Sequence[Order]) -> Iterator[Tuple[Order, ...]]:
    if not parts:
        yield ()
        return
    for first in _choices(parts[0]):
        for rest in _all_choices(parts[1:]):
            yield (first, *rest)


class _Endless(Exception):
    """The order has no end; what comes after it is never done."""

    def __init__(self, loop: int) -> None:
        super().__init__()
        self.loop = loop


class _Walk:
    def __init__(self, detour: str) -> None:
        self._detour = detour
        self._room = START
        self._states: List[FrozenSet[str]] = [frozenset([f"in_{START}"])]

    def run(self, order: Order) -> Lasso:
        try:
            self._do(order)
        except _Endless as endless:
            return Lasso(tuple(self._states), endless.loop)
        self._states.append(frozenset([f"in_{self._room}"]))
        return Lasso(tuple(self._states), len(self._states) - 1)

    def _do(self, order: Order) -> None:
        if isinstance(order, Visit):
            self._visit(order)
        elif isinstance(order, InOrder):
            for part in order.parts:
                self._do(part)
        elif isinstance(order, Again) and order.times:
            for _ in range(order.times):
                self._do(order.part)
        elif isinstance(order, Again):
            self._do_without_end(order.part)
        else:
            raise TypeError(f"{order!r} is no order of visits")

    def _do_without_end(self, order: Order) -> None:
        # The way of a round depends on where it begins alone.
        begun: Dict[str, int] = {}
        for _ in range(_MOST_ROUNDS):
            if self._room in begun:
                raise _Endless(begun[self._room])
            begun[self._room] = len(self._states)
            self._do(order)
        raise AssertionError("a repetition that does not repeat itself")

    def _visit(self, visit: Visit) -> None:
        for room in self._way(visit):
            self._states.append(frozenset([f"in_{room}"]))
        self._states.append(frozenset([f"in_{visit.room}", visit.room]))
        self._room = visit.room

    def _way(self, visit: Visit) -> Tuple[str, ...]:
        """Return the rooms between where the robot is and a room: through the detour, where it is not to be avoided."""
        if visit.room == self._room:
            return ()
        detour = self._detour
        if detour and detour not in visit.avoided and detour not in (self._room, visit.room):
            try:
                first = _shortest(self._room, detour, visit.avoided | {visit.room})
                return (*first, detour, *_shortest(detour, visit.room, visit.avoided))
            except NoWay:
                pass
        return _shortest(self._room, visit.room, visit.avoided)


def _shortest(start: str, end: str, avoided: FrozenSet[str]) -> Tuple[str, ...]:
    """Return the rooms between two rooms on the shortest way without some others."""
    if end in avoided:
        raise NoWay(f"{end} is to be avoided")
    ways = deque([(start,)])
    seen = {start}
    while ways:
        way = ways.popleft()
        for room in DOORS[way[-1]]:
            if room == end:
                return way[1:]
            if room not in seen and room not in avoided:
                seen.add(room)
                ways.append((*way, room))
    raise NoWay(f"no way from {start} to {end} without {sorted(avoided)}")
