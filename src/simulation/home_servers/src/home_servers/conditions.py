"""Conditions of a home, as far as the robot knows: by what it sees now, has seen, and was told."""

import os
from dataclasses import dataclass
from functools import lru_cache
from typing import Callable, Dict, FrozenSet, List, Mapping, Protocol, Sequence

import yaml

from home_servers.memory import PERSONS, Known, Memory, is_whole, wanted_names
from home_servers.skills import HEARERS, SPEAKERS
from typed_arguments import TypedArgument
from word_classes import without_determiner

_NEAR_M = 1.5
#: Quantifiers that leave open which things are meant; none does so before a plural.
_OPEN = ("", "a", "any", "some", "no")


class CannotTell(Exception):
    """The robot does not know whether a condition holds; the message is a clause: "I have not seen the window"."""


@dataclass(frozen=True)
class Sight:
    """What the robot perceives at a time.

    Attributes:
        seen: ids of what it sees
        held: ids of what it holds
        room: id of the room where it is; empty outside
        x_m, y_m: where it is
    """

    seen: FrozenSet[str] = frozenset()
    held: FrozenSet[str] = frozenset()
    room: str = ""
    x_m: float = 0.0
    y_m: float = 0.0


class Frame(Protocol):
    """A filled frame."""

    name: str

    def __getitem__(self, element: str) -> TypedArgument:
        """Return the argument of an element; one without a text if nobody filled it."""


class Conditions:
    """Tells whether conditions hold.

    Args:
        memory: what the robot knows
        sight: what it perceives now
        speaker: id of the person who speaks; empty: nobody known
    """

    def __init__(self, memory: Memory, sight: Sight, *, speaker: str = "") -> None:
        self._memory = memory
        self._sight = sight
        self._speaker = speaker

    def holds(self, frame: Frame) -> bool:
        """Return whether a condition holds.

        Args:
            frame: one of :data:`FRAMES`
        Raises:
            CannotTell: the robot does not know
            KeyError: another frame
        """
        return FRAMES[frame.name](self, frame)

    def _is_robot(self, argument: TypedArgument) -> bool:
        return bool(HEARERS.intersection(wanted_names(argument)))

    def _find(self, argument: TypedArgument, *sorts: str) -> List[Known]:
        """Return what an argument may mean, the likeliest first; nothing for what the robot has never heard of."""
        if argument.text.lower() in SPEAKERS:
            known = self._memory.get(self._speaker)
            return [known] if known is not None else []
        if PERSONS.intersection(wanted_names(argument)):
            return self._memory.all("person")
        return self._memory.find(argument, *sorts, here=(self._sight.x_m, self._sight.y_m))

    def _place(self, argument: TypedArgument) -> Known:
        """
        Raises:
            CannotTell: it is no place that the robot knows
        """
        if argument.text.lower() in SPEAKERS:
            found = self._find(argument)
        else:
            found = self._memory.find(argument, "room", "furniture", "door", "person", "thing")
        if not found:
            raise CannotTell(f"I do not know where {argument.text} is")
        return found[0]

    def _is_at(self, one: Known, place: Known) -> bool:
        if place.sort == "room":
            return one.room == place.id
        holder = one
        for _ in range(6):
            if holder.holder == place.id:
                return True
            next_one = self._memory.get(holder.holder)
            if next_one is None:
                return False
            holder = next_one
        return False

    def _robot_is_at(self, place: Known) -> bool:
        if place.sort == "room":
            return self._sight.room == place.id
        return (place.x_m - self._sight.x_m) ** 2 + (place.y_m - self._sight.y_m) ** 2 <= _NEAR_M**2

    def _here(self, argument: TypedArgument) -> Known:
        """Return the place that an argument names, or else the room of the robot.

        Raises:
            CannotTell: there is no such place
        """
        if argument.text:
            return self._place(argument)
        here = self._memory.get(self._sight.room)
        if here is None:
            raise CannotTell("I do not know where I am")
        return here

    def is_perceived(self, frame: Frame) -> bool:
        """Whether the robot sees something now."""
        if not self._is_robot(frame["perceiver"]):
            raise CannotTell(f"I do not know what {frame['perceiver'].text} can see")
        found = [one for one in self._find(frame["phenomenon"]) if one.id in self._sight.seen]
        where = frame["location"]
        if where.text:
            place = self._place(where)
            found = [one for one in found if self._is_at(one, place)]
        return _are_enough(found, frame["phenomenon"])

    def is_present(self, frame: Frame) -> bool:
        """Whether something is in sight."""
        return _are_enough([one for one in self._find(frame["theme"]) if one.id in self._sight.seen], frame["theme"])

    def is_placed(self, frame: Frame) -> bool:
        """Whether something is where it is said to be."""
        theme, place = frame["theme"], self._place(frame["location"])
        if self._is_robot(theme):
            return self._robot_is_at(place)
        found = self._find(theme, "thing", "person", "furniture")
        if _are_enough([one for one in found if self._is_at(one, place)], theme):
            return True
        told = self._memory.told_place(theme)
        if told:
            return told == place.id
        if not any(one.room or one.holder for one in found):
            raise CannotTell(f"I have not seen {theme.text}")
        return False

    def has_come(self, frame: Frame) -> bool:
        """Whether somebody is seen at the place where they were to come."""
        place = self._here(frame["goal"])
        if self._is_robot(frame["theme"]):
            return self._robot_is_at(place)
        found = self._find(frame["theme"], "person", "thing")
        here = [one for one in found if one.id in self._sight.seen and self._is_at(one, place)]
        return _are_enough(here, frame["theme"])

    def has_left(self, frame: Frame) -> bool:
        """Whether somebody was seen elsewhere since they were at a place."""
        place = self._here(frame["source"])
        if self._is_robot(frame["theme"]):
            return not self._robot_is_at(place)
        found = [one for one in self._find(frame["theme"], "person", "thing") if one.room]
        if not found:
            raise CannotTell(f"I have not seen {frame['theme'].text}")
        return not any(self._is_at(one, place) for one in found)

    def is_in_state(self, frame: Frame) -> bool:
        """Whether something is as it was said to be, by what was last seen of it."""
        theme, word = frame["theme"], frame["state"].text.lower()
        found = self._find(theme)
        if not found:
            raise CannotTell(f"I know of no {without_determiner(theme.text)}")
        is_open = theme.quantifier in _OPEN and theme.possessor is None and not theme.referents
        if is_open and (theme.quantifier or theme.is_plural):
            # "No lights are on" denies that lights are on, whichever they are.
            seen = [one for one in found if one.states]
            return _are_enough([one for one in seen or found[:1] if self._shows(one, word)], theme)
        if is_whole(theme) or theme.is_plural:
            return all(self._shows(one, word) for one in found)
        return self._shows(found[0], word)

    def _shows(self, one: Known, word: str) -> bool:
        state = _states().get(word)
        if state is None:
            raise CannotTell(f'I cannot see whether {one.the_name_is} "{word}"')
        if not one.states and one.stamp_s < 0.0:
            raise CannotTell(f"I have not seen {one.the_name}")
        is_absent, name = state.startswith("not "), state.replace("not ", "")
        opposites = _OPPOSITES.get(name)
        if opposites is not None and not opposites.intersection(one.states):
            raise CannotTell(f"{one.the_name} does not show whether it is {word}")
        return (name in one.states) is not is_absent

    def has_started(self, frame: Frame) -> bool:
        """Whether what makes something go on runs: the music of the radio."""
        return self._runs(frame["activity"])

    def has_ended(self, frame: Frame) -> bool:
        """Whether what makes something go on does not run."""
        return not self._runs(frame["activity"])

    def _runs(self, activity: TypedArgument) -> bool:
        found = [one for one in self._find(activity, "furniture", "thing") if _RUNNING & set(one.states)]
        if not found and self._find(activity, "furniture", "thing"):
            raise CannotTell(f"I have not seen {activity.text}")
        if not found:
            raise CannotTell(f"I cannot notice whether {activity.text or 'what you mean'} goes on")
        return "on" in found[0].states

    def is_had(self, frame: Frame) -> bool:
        """Whether somebody holds something."""
        owner, found = frame["owner"], self._find(frame["possession"], "thing")
        if self._is_robot(owner):
            return any(one.id in self._sight.held for one in found)
        owners = {one.id for one in self._find(owner, "person")}
        if not owners:
            raise CannotTell(f"I have not seen {owner.text}")
        return any(one.relation == "held" and one.holder in owners for one in found)


def _are_enough(found: List[Known], argument: TypedArgument) -> bool:
    """Whether as many are found as were said: "three people"; one of them if no number was said."""
    return len(found) >= max(1, argument.count or 1)


#: States of what can run.
_RUNNING = frozenset(["on", "off"])
#: States of which something that shows either shows exactly one.
_OPPOSITES: Mapping[str, FrozenSet[str]] = {
    name: frozenset(pair) for pair in (("open", "closed"), ("on", "off"), ("dirty", "clean")) for name in pair
}


@lru_cache(maxsize=1)
def _states() -> Mapping[str, str]:
    """Return the states that words stand for."""
    path = os.path.join(os.path.dirname(os.path.realpath(__file__)), "states.yaml")
    with open(path, encoding="utf-8") as file:
        return dict(yaml.safe_load(file))


#: How each frame is told.
FRAMES: Dict[str, Callable[[Conditions, Frame], bool]] = {
    "condition_of_perceiving": Conditions.is_perceived,
    "condition_of_presence": Conditions.is_present,
    "condition_of_place": Conditions.is_placed,
    "condition_of_arriving": Conditions.has_come,
    "condition_of_departing": Conditions.has_left,
    "condition_of_state": Conditions.is_in_state,
    "condition_of_possession": Conditions.is_had,
    "condition_of_starting": Conditions.has_started,
    "condition_of_ending": Conditions.has_ended,
}
#: By frame, what the server states when it registers, so that the robot refuses at once what nobody could tell: what
#: somebody else sees, and states that nothing shows.
STATEMENTS: Mapping[str, Mapping[str, Mapping[str, Sequence[str]]]] = {
    "condition_of_perceiving": {"heeds": {"perceiver": sorted(HEARERS)}},
    "condition_of_state": {"heeds": {"state": sorted(_states())}},
}
__all__ = ["FRAMES", "STATEMENTS", "CannotTell", "Conditions", "Sight"]
