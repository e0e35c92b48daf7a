"""What a robot in a home can do with things, persons and places that were named in words."""

import math
from typing import Callable, Iterator, List, Optional, Sequence

from home_servers.acting import Acting
from home_servers.body import Body, CannotDo
from home_servers.doing import looking_for
from home_servers.memory import Known, is_any, is_whole
from home_servers.places import HOLDING, Place
from semantic_frames.semantic_type import with_parents
from typed_arguments import FilledFrame, TypedArgument
from word_classes import without_determiner, word_class

#: Words for whoever speaks, and for the robot.
SPEAKERS = frozenset("me us i we myself".split())
#: Pronouns for whom the robot has met last.
_MET = word_class("male_pronouns") | word_class("female_pronouns") | word_class("plural_pronouns")
#: Whoever is so near is whom the robot is with, metres, for so long after they were met, seconds.
_COMPANY_M = 2.5
_COMPANY_S = 300.0
#: How persons are, as a description says it.
POSTURES = ("sitting", "standing", "walking")
HEARERS = frozenset("you yourself robot".split())
HERE = frozenset("here over here".split()) | {"over here", "down here"}
#: Places told from where somebody stands, which no skill can see: "behind you", "on your left", "on the right".
_SIDES = frozenset("the a your my our you me us left right front back side hand of".split())
#: FrameNet's semantic type of what can be seen somewhere.
_TOUCHABLE = "Physical_entity"


class Skills(Acting):
    """Skills over a body. Each ends well, or raises :class:`CannotDo` with the reason.

    Args:
        body: what acts
        speaker: id of the person who speaks; empty: whom the robot saw last nearby
    """

    def __init__(self, body: Body, *, speaker: str = "") -> None:
        super().__init__(body)
        self._speaker = speaker

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
        _refuse_sides(argument)
        place = self._place_of(near) if near is not None and near.text else None
        wants_all = (argument.is_plural or is_whole(argument)) and argument.count is None
        # "Everything on the table" is more than what the robot has seen there by chance.
        where = (place or self._inner_place(argument)) if wants_all else None
        self._look_in_each([where.known] if where is not None else [], lambda: True, argument)
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
            self._look_in_each(targets, is_seen, argument)
            return
        self._look_in_each(at_first, is_seen, argument)
        if is_seen():
            return
        # First where no door must be opened, then behind doors, then in furniture.
        self._opens_doors = False
        try:
            shut = self._look_in_each(self._by_distance(self.memory.all("room")), is_seen, argument)
        finally:
            self._opens_doors = True
        if is_seen() or (self._look_in_each(shut, is_seen, argument) is not None and is_seen()):
            return
        if "thing" in sorts or not sorts:
            holding = [one for one in self.memory.all("furniture") if one.category in HOLDING]
            self._look_in_each(self._by_distance(holding), is_seen, argument)

    def _by_distance(self, places: Sequence[Known]) -> List[Known]:
        here = self.body.place()
        return sorted(places, key=lambda one: math.hypot(one.x_m - here[0], one.y_m - here[1]))

    def _look_in_each(
        self, places: Sequence[Known], is_seen: Callable[[], bool], argument: TypedArgument
    ) -> List[Known]:
        """Look in places until what an argument means is seen; return the places that it did not get into."""
        left: List[Known] = []
        for place in places:
            self._looking = looking_for(argument, place)
            try:
                self.look_in(place)
            except CannotDo:
                left.append(place)
                continue
            finally:
                self._looking = ""
            if is_seen():
                break
            self.tidy()
        return left

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
            rooms = self._by_distance(self.memory.all("room"))
            self._look_in_each(rooms, lambda: seen() is not None, TypedArgument(text="you"))
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


Skill = Callable[[Skills, FilledFrame], None]


def argument(frame: FilledFrame, element: str) -> TypedArgument:
    """Return the argument of an element; an empty one when there is none."""
    return frame.find(element) or TypedArgument(name=element)


def said(frame: FilledFrame, element: str) -> bool:
    """Whether an element has an argument."""
    return bool(frame.text(element))


def _refuse_sides(argument: TypedArgument) -> None:
    """Raise :class:`CannotDo` when only a side of somebody tells which one is meant: "the table right behind you"."""
    if argument.referents:
        return
    for frame in argument.frames:
        for element in frame.frame_elements:
            if element.relation and element.text and _SIDES.issuperset(element.text.lower().split()):
                raise CannotDo(f'I do not know what is meant by "{frame.words}".')
