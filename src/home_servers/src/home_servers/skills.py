"""What a robot in a home can do with things, persons and places that were named in words."""

import contextlib
import math
from typing import Callable, Dict, Iterator, List, Optional, Sequence, Tuple

from home_servers.body import Body, CannotDo
from home_servers.memory import Known, is_any, is_whole
from home_servers.places import HOLDING, RELATIONS, Place
from roboframenet_ros.spoken_text import join_with_and
from roboframenet_sim.home_actions import Action, Failure
from semantic_frames.semantic_type import with_parents
from typed_arguments import FilledFrame, TypedArgument
from word_classes import without_determiner, word_class

#: How often an action is tried again after a failure of one kind was put right.
_MOST_TRIES = 3
#: To put an action right, others are done, and others to put these right; so deep at most.
_DEEPEST = 8
#: A blocked door may be free after this time.
_BLOCKED_S = 25.0
#: Words for whoever speaks, and for the robot.
SPEAKERS = frozenset("me us i we myself".split())
#: Pronouns for whom the robot has met last.
_MET = word_class("persons_met")
#: Whoever is so near is whom the robot is with, metres, for so long after they were met, seconds.
_COMPANY_M = 2.5
_COMPANY_S = 300.0
#: How persons are, as a description says it.
POSTURES = ("sitting", "standing", "walking")
HEARERS = frozenset("you yourself robot".split())
HERE = frozenset("here over here".split()) | {"over here", "down here"}
_HANDS = 2
#: FrameNet's semantic type of what can be seen somewhere.
_TOUCHABLE = "Physical_entity"
#: Hand height above which the lift is raised.
_LIFT_UP_M = 0.3


class Skills:
    """Skills over a body. Each ends well, or raises :class:`CannotDo` with the reason.

    Args:
        body: what acts
        speaker: id of the person who speaks; empty: whom the robot saw last nearby
    """

    def __init__(self, body: Body, *, speaker: str = "") -> None:
        self.body = body
        self.memory = body.memory
        self._speaker = speaker
        self.avoided = ""  # Ids of rooms and doors that no way of this goal leads through, with blanks between.
        self._opens_doors = True
        self._opened: List[str] = []
        self._depth = 0
        self.answers: List[str] = []

    # Actions, with what puts their failures right.

    def attempt(self, kind: str, **values: object) -> None:
        """Do an action; go nearer, open, lift, switch on and try again as its failures ask for.

        Raises:
            CannotDo: with the sentence of the failure that remains
        """
        if self._depth > _DEEPEST:
            raise CannotDo("I do not get any further.")
        self._depth += 1
        try:
            self._attempt(Action(kind, avoided=self.avoided if kind == "go" else "", **values))  # type: ignore[arg-type]
        finally:
            self._depth -= 1

    def _attempt(self, action: Action) -> None:
        seen: Dict[str, int] = {}
        while True:
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

    # Finding what words mean.

    def find(self, argument: TypedArgument, *sorts: str, near: Optional[TypedArgument] = None) -> Known:
        """Return what an argument means; look for it when it has not been seen.

        Args:
            argument: words and their meaning
            sorts: thing, person, room, furniture, door; all when none is given
            near: where it is said to be
        Raises:
            CannotDo: it is not known and was not found
        """
        return self.find_all(argument, *sorts, near=near)[0]

    def find_all(
        self,
        argument: TypedArgument,
        *sorts: str,
        near: Optional[TypedArgument] = None,
        least: int = 1,
        at_first: Sequence[Known] = (),
    ) -> List[Known]:
        """Return all that an argument means, as many as it counts; see :meth:`find`.

        Args:
            argument: words and their meaning
            sorts: see :meth:`find`
            near: see :meth:`find`
            least: so many are needed
            at_first: where it may be; searched before the rest of the home
        """
        if argument.text.lower() in SPEAKERS or argument.head.lower() in SPEAKERS:
            return [self.speaker()]
        met = self.memory.get(self.memory.met[0])
        if argument.text.lower() in _MET and not argument.referents and met is not None:
            return [met]
        place = self._place_of(near) if near is not None and near.text else None
        wants_all = (argument.is_plural or is_whole(argument)) and argument.count is None
        # "Everything on the table" is more than what the robot has seen there by chance.
        where = (place or self._inner_place(argument)) if wants_all else None
        self._look_in_each([where.known] if where is not None else [], lambda: True)
        found = self._matching(argument, sorts, place)
        if is_any(argument) and place is None:
            found = self._here_first(argument, sorts, found)
        need = max(least, argument.count or 1)
        if len(found) < need:
            self._seek(argument, sorts, place, need, at_first)
            found = self._matching(argument, sorts, place)
        if not found:
            raise CannotDo(self._unseen(argument, place))
        if len(found) < need:
            raise CannotDo(f"I have seen only {len(found)} of {argument.text}.")
        if found[0].sort == "person":
            self.memory.met = (found[0].id, self.body.now_s())
        return found if wants_all else found[:need]

    def _here_first(self, argument: TypedArgument, sorts: Sequence[str], found: List[Known]) -> List[Known]:
        """Return what fits, what is in the room of the robot in front; look around when nothing there does."""
        if not any(one.room == self.body.room() for one in found):
            self.attempt("look")
            found = self._matching(argument, sorts, None)
        held = self.body.held()
        return sorted(found, key=lambda one: (one.id not in held, one.room != self.body.room()))

    def _matching(self, argument: TypedArgument, sorts: Sequence[str], place: Optional[Place]) -> List[Known]:
        here = self.body.place()
        found = [one for one in self.memory.find(argument, *sorts, here=here) if one.sort != "thing" or one.relation]
        inner = self._inner_place(argument)
        for limit in (place, inner):
            if limit is not None:
                found = [one for one in found if limit.has(one, self.memory)]
        postures = frozenset(POSTURES).intersection(
            word for frame in argument.frames for word in frame.words.lower().split()
        )
        if postures:
            found = [one for one in found if one.sort != "person" or postures.intersection(one.states)]
        held = self.body.held()
        # What the robot holds comes first, then what was named most exactly; of equals the nearest.
        found.sort(key=lambda one: one.id not in held)
        return found

    def _inner_place(self, argument: TypedArgument) -> Optional[Place]:
        """Return the place inside a phrase: "the mug on the table"."""
        for frame in argument.frames:
            for element in frame.frame_elements:
                if (
                    element.relation in ("on", "in", "at", "near", "under", "beside", "next_to", "behind")
                    and element.text
                ):
                    found = self.memory.find(element, "furniture", "room", "thing", "door", here=self.body.place())
                    if found:
                        return Place(found[0], element.relation)
        return None

    def _place_of(self, argument: TypedArgument) -> Optional[Place]:
        found = self.memory.find(argument, "room", "furniture", "door", "thing", here=self.body.place())
        return Place(found[0], argument.relation) if found else None

    def is_at(self, one: Known, place: Known, relation: str = "") -> bool:
        """Whether something is in a room, or on, in, under, ... something; a person is at what is near."""
        return Place(place, relation).has(one, self.memory)

    def _seek(
        self,
        argument: TypedArgument,
        sorts: Sequence[str],
        place: Optional[Place],
        need: int,
        at_first: Sequence[Known],
    ) -> None:
        """Look where the thing is said to be, or else in every room, until it is seen.

        Raises:
            CannotDo: it is nothing that can be seen anywhere: "the speed"
        """
        if sorts and not {"thing", "person"}.intersection(sorts):
            return
        if argument.semantic_type and _TOUCHABLE not in with_parents(argument.semantic_type):
            raise CannotDo(f"I know of no {without_determiner(argument.text)}, and cannot look for it.")
        told = self.memory.get(self.memory.told_place(argument))
        inner = self._inner_place(argument)
        targets = [one.known for one in (place, inner) if one is not None] + ([told] if told is not None else [])

        def is_seen() -> bool:
            return len(self._matching(argument, sorts, place)) >= need

        if targets:
            self._look_in_each(targets, is_seen)
            return
        self._look_in_each(at_first, is_seen)
        if is_seen():
            return
        # First where no door must be opened, then behind doors, then in furniture.
        self._opens_doors = False
        try:
            shut = self._look_in_each(self._by_distance(self.memory.all("room")), is_seen)
        finally:
            self._opens_doors = True
        if is_seen() or (self._look_in_each(shut, is_seen) is not None and is_seen()):
            return
        if "thing" in sorts or not sorts:
            holding = [one for one in self.memory.all("furniture") if one.category in HOLDING]
            self._look_in_each(self._by_distance(holding), is_seen)

    def _by_distance(self, places: Sequence[Known]) -> List[Known]:
        here = self.body.place()
        return sorted(places, key=lambda one: math.hypot(one.x_m - here[0], one.y_m - here[1]))

    def _look_in_each(self, places: Sequence[Known], is_seen: Callable[[], bool]) -> List[Known]:
        """Look in places until something is seen; return the places that it did not get into."""
        left: List[Known] = []
        for place in places:
            try:
                self.look_in(place)
            except CannotDo:
                left.append(place)
                continue
            if is_seen():
                break
            self.tidy()
        return left

    def look_in(self, place: Known) -> None:
        """Go to a room or furniture, open what is closed, and look."""
        self.go(place.id)
        if place.sort == "furniture" and "closed" in (self.memory.get(place.id) or place).states:
            self._open_way(place.id)
        if place.sort == "furniture":
            self.attempt("look", theme=place.id)
        self.attempt("look")

    def _unseen(self, argument: TypedArgument, place: Optional[Place]) -> str:
        words = argument.text or argument.head
        where = f" {place.words}" if place is not None else ""
        person = argument.semantic_type in ("Human", "Sentient") or words[:1].isupper()
        return f"I have not seen {'' if person or ' ' in words else 'any '}{words}{where}."

    def speaker(self) -> Known:
        """Return the person who speaks.

        Raises:
            CannotDo: nobody was seen
        """
        if self._speaker:
            return self._known_speaker()
        people = self.memory.all("person")
        if not people:
            self.attempt("look")
            people = self.memory.all("person")
        if not people:
            raise CannotDo("I do not see you.")
        here = self.body.place()
        return min(people, key=lambda one: math.hypot(one.x_m - here[0], one.y_m - here[1]))

    def _known_speaker(self) -> Known:
        """Return the person who is known to speak: seen before, around the robot, or in one of the rooms."""

        def seen() -> Optional[Known]:
            one = self.memory.get(self._speaker)
            return one if one is not None and one.room else None

        if seen() is None:
            self.attempt("look")
        if seen() is None:
            self._look_in_each(self._by_distance(self.memory.all("room")), lambda: seen() is not None)
        found = seen()
        if found is None:
            raise CannotDo("I do not see you.")
        return found

    def person(self, argument: TypedArgument, *, near: Optional[TypedArgument] = None) -> Known:
        """Return the person whom an argument means, and go there."""
        return self._meet(self.find(argument, "person", near=near))

    def persons(self, argument: TypedArgument, *, near: Optional[TypedArgument] = None) -> Iterator[Known]:
        """Go to each person whom an argument means; see :meth:`person`."""
        return map(self._meet, self.find_all(argument, "person", near=near))

    def _meet(self, person: Known) -> Known:
        self.go(person.id)
        self.attempt("look", theme=person.id)
        now = self.memory.get(person.id) or person
        self.memory.met_at[now.id] = now.x_m, now.y_m
        return now

    def company(self) -> Optional[Known]:
        """Return whom the robot is with: whom it met last, a short time ago and near; None for nobody."""
        ident, stamp_s = self.memory.met
        person = self.memory.get(ident)
        if person is None or self.body.now_s() - stamp_s > _COMPANY_S or person.room != self.body.room():
            return None
        here = self.body.place()
        return person if math.hypot(person.x_m - here[0], person.y_m - here[1]) <= _COMPANY_M else None

    def join(self, person: Known) -> None:
        """Be with a person: go there when they are too far away to hear."""
        here = self.body.place()
        is_near = math.hypot(person.x_m - here[0], person.y_m - here[1]) <= _COMPANY_M
        if not is_near or person.room != self.body.room():
            self.go(person.id)

    # Handling things.

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
        if thing.id not in self.body.held() or place is None:
            return
        try:
            if place.sort == "furniture" and "closed" in place.states:
                self.go(place.id)
                self._open_way(place.id)
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


Skill = Callable[[Skills, FilledFrame], None]


def argument(frame: FilledFrame, element: str) -> TypedArgument:
    """Return the argument of an element; an empty one when there is none."""
    return frame.find(element) or TypedArgument(name=element)


def said(frame: FilledFrame, element: str) -> bool:
    """Whether an element has an argument."""
    return bool(frame.text(element))
