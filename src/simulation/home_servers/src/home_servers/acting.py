"""What a robot in a home does with places and things that it knows: it puts right what fails, as far as that goes."""

import contextlib
import math
from typing import Dict, Iterator, List, Optional, Tuple

from home_servers.body import Body, CannotDo
from home_servers.doing import doing
from home_servers.memory import Known
from home_servers.places import RELATIONS
from roboframenet_ros.spoken_text import join_with_and
from roboframenet_sim.home_actions import Action, Failure

#: How often an action is tried again after a failure of one kind was put right.
_MOST_TRIES = 3
#: To put an action right, others are done, and others to put these right; so deep at most.
_DEEPEST = 8
#: A blocked door may be free after this time.
_BLOCKED_S = 25.0
_HANDS = 2
#: Hand height above which the lift is raised.
_LIFT_UP_M = 0.3


class Acting:
    """Actions over a body. Each ends well, or raises :class:`CannotDo` with the reason.

    Args:
        body: what acts
    """

    def __init__(self, body: Body) -> None:
        self.body = body
        self.memory = body.memory
        self.avoided = ""  # Ids of rooms and doors that no way of this goal leads through, with blanks between.
        self.answers: List[str] = []
        self._opens_doors = True
        self._opened: List[str] = []
        self._depth = 0
        self._looking = ""  # For what, and where.

    def attempt(self, kind: str, **values: object) -> None:
        """Do an action; go nearer, open, lift, switch on and try again as its failures ask for.

        Raises:
            CannotDo: with the sentence of the failure that remains
        """
        if self._depth > _DEEPEST:
            raise CannotDo("I am stuck.")
        self._depth += 1
        try:
            self._attempt(Action(kind, avoided=self.avoided if kind == "go" else "", **values))  # type: ignore[arg-type]
        finally:
            self._depth -= 1

    def _attempt(self, action: Action) -> None:
        seen: Dict[str, int] = {}
        while True:
            # Who looks for something does not say each door and each turn.
            words = self._looking or doing(action, self.memory)
            if words:
                self.body.show_doing(words)
            failure = self.body.do(action)
            if failure is None:
                return
            seen[failure.code] = seen.get(failure.code, 0) + 1
            if seen[failure.code] > _MOST_TRIES or not self._put_right(action, failure):
                raise CannotDo(failure.sentence)

    def _put_right(self, action: Action, failure: Failure) -> bool:
        if failure.code == "too_far" and failure.entity and action.kind != "go":
            self.go(failure.entity)
        elif failure.code == "closed" and failure.entity and failure.entity != action.theme:
            return self._open_way(failure.entity)
        elif failure.code == "too_high":
            if action.kind == "lift":
                return False
            self.attempt("lift", amount=_LIFT_UP_M)
        elif failure.code == "too_low":
            self.attempt("lift", amount=0.0)
        elif failure.code == "slipped":
            if action.kind != "grasp":
                self.attempt("grasp", theme=action.theme)
        elif failure.code == "blocked":
            self.attempt("wait", amount=_BLOCKED_S)
        elif failure.code == "off" and failure.entity:
            self.attempt("switch", theme=failure.entity, value="on")
        else:
            return False
        return True

    def _open_way(self, ident: str) -> bool:
        known = self.memory.get(ident)
        is_door = known is not None and known.sort == "door"
        if is_door and not self._opens_doors:
            return False
        self.attempt("open", theme=ident)
        if known is not None and is_door:
            here = self.body.room()
            self.memory.opened[ident] = next((room for room in known.attributes if room != here), "")
        else:
            self._opened.append(ident)
        return True

    def tidy(self) -> None:
        """Close the furniture that was opened on the way; where that is not possible, it stays open."""
        while self._opened:
            try:
                self.attempt("close", theme=self._opened.pop())
            except CannotDo:
                continue

    def go(self, target: str, *, reach_m: float = math.nan) -> None:
        """Drive to an entity; open doors on the way, and close them behind."""
        known = self.memory.get(target)
        # The other side of a door may be where the robot shall not go.
        if self.memory.opened and not self.avoided and known is not None and self.body.room() != known.room:
            self._close_behind(self.body.room())
        self.attempt("go", goal=target, amount=reach_m)

    def _close_behind(self, room: str) -> None:
        """Leave a room through a door that the robot has opened, and close it; what cannot be closed stays open."""
        for ident in [door for door, behind in self.memory.opened.items() if behind == room]:
            del self.memory.opened[ident]
            door = self.memory.get(ident)
            outside = next((one for one in door.attributes if one != room), "") if door is not None else ""
            if not outside:
                continue
            try:
                self.attempt("go", goal=outside)
                self.attempt("close", theme=ident)
            except CannotDo:
                continue

    def wait(self, seconds: float) -> None:
        """Stay."""
        self.attempt("wait", amount=seconds)

    def say(self, text: str) -> List[Tuple[str, str]]:
        """Say something, and return what persons answer."""
        return self.body.say(text)

    def answer(self, text: str, *, reply: str = "") -> None:
        """Say what was found out; the reply to the command has it too.

        Args:
            text: what is said
            reply: what the reply says; empty for the same
        """
        self.body.say(text)
        self.answers.append(reply or text)

    def look_in(self, place: Known) -> None:
        """Go to a room or furniture, open what is closed, and look."""
        self.go(place.id)
        if place.sort == "furniture" and "closed" in (self.memory.get(place.id) or place).states:
            self._open_way(place.id)
        if place.sort == "furniture":
            self.attempt("look", theme=place.id)
        self.attempt("look")

    def take(self, thing: Known) -> None:
        """Hold a thing."""
        if thing.id in self.body.held():
            return
        if thing.sort != "thing":
            raise CannotDo(f"I cannot take {thing.the_name}.")
        if thing.relation == "held" and thing.holder:
            self.go(thing.holder)
            self.attempt("receive", theme=thing.id)
            return
        try:
            self.attempt("grasp", theme=thing.id)
        except CannotDo:
            self.memory.forget_place(thing.id)
            self.attempt("look")
            again = self.memory.get(thing.id)
            if again is None or not again.relation or again.relation == "held":
                raise
            self.attempt("grasp", theme=thing.id)
        self.attempt("lift", amount=0.0)

    @contextlib.contextmanager
    def borrowed(self, thing: Optional[Known]) -> Iterator[None]:
        """Hold a tool for a task, and put it back where it was when the task ends, whether that was done or not.

        What the robot held before, somebody wanted it to hold: it stays in the hand.

        Args:
            thing: the tool; None for bare hands
        Raises:
            CannotDo: the hands are full, it cannot be taken, or the task was done and it cannot be put back
        """
        held = self.body.held()
        if thing is None or thing.id in held:
            yield
            return
        if len(held) >= _HANDS:
            names = join_with_and(one.the_name for one in map(self.memory.get, held) if one is not None)
            raise CannotDo(f"My hands are full: I hold {names}. I need a hand for {thing.the_name}.")
        self.take(thing)
        try:
            yield
        except CannotDo as reason:
            try:
                self._put_back(thing)
            except CannotDo:
                raise CannotDo(f"{reason} I still hold {thing.the_name}.") from reason
            raise
        self._put_back(thing)

    def _put_back(self, thing: Known) -> None:
        """
        Raises:
            CannotDo: it cannot be put where it was
        """
        place = self.memory.get(thing.holder)
        if thing.id not in self.body.held():
            return
        if place is None:
            raise CannotDo(f"I do not know where {thing.the_name} was, and still hold it.")
        try:
            self.put(thing.id, place, "to" if place.sort == "person" else thing.relation)
        except CannotDo as reason:
            raise CannotDo(f"I cannot put {thing.the_name} back: {reason}") from reason

    def put(self, thing: str, place: Known, relation: str) -> None:
        """Put a held thing on, in, under, beside a place; "to" and "at" are on or in, whatever goes.

        Raises:
            CannotDo: the relation is none of these
        """
        relations = RELATIONS.get(relation, ())
        if not relations or (place.sort == "room" and len(relations) == 1 and relations[0] not in ("on", "in")):
            raise CannotDo(f"I cannot put anything {relation.replace('_', ' ')} {place.the_name}.")
        if place.sort == "person" and ("on" in relations or "in" in relations):
            self.go(place.id)
            self.attempt("give", theme=thing, goal=place.id)
            return
        if place.sort == "room":
            self.go(place.id)
            self.attempt("put", theme=thing, goal=place.id, relation="on")
            return
        for index, one in enumerate(relations):
            try:
                self.go(place.id)
                self.attempt("put", theme=thing, goal=place.id, relation=one)
                return
            except CannotDo:
                if index == len(relations) - 1:
                    raise

    def put_down(self, thing: str) -> None:
        """Put a held thing on the floor."""
        here = self.room_here()
        if here is None:
            raise CannotDo("I do not know where I am.")
        self.attempt("put", theme=thing, goal=here.id, relation="on")

    def room_here(self) -> Optional[Known]:
        """Return the room where the robot is."""
        return self.memory.get(self.body.room())
