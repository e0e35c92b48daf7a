"""Whoever is followed walks when the robot is there, and ends it when they have arrived."""

from typing import Mapping, Union

from .commands import Command

#: Where somebody walks to when the command does not say; to the second when they are at the first.
_ANYWHERE = ("living_room", "kitchen")
#: They are asked so often whether they go before they do: the robot has to have met them.
_WAITS = 20


class Walk:
    """The walk of who is followed.

    Args:
        command: of which the walk is
    """

    def __init__(self, command: Command) -> None:
        form = command.form.arguments[0] if command.form.predicate == "sequence" else command.form
        is_followed = getattr(form, "predicate", "") == "follow"
        self.person = form.persons[0].name if is_followed else ""
        #: Where somebody is followed to: nobody goes elsewhere.
        ends = [one for one in form.arguments[1:] if isinstance(one, str)] if is_followed else []
        self._goal = command.destination or next(iter(ends), "")
        #: Whether the robot follows to a goal of its own knowledge; otherwise whoever is followed ends it.
        self._has_goal = bool(self._goal) or command.form.predicate == "sequence"
        self._is_part = command.form.predicate == "sequence"
        self._waits = _WAITS
        self._is_met = False
        self._has_begun = False
        self._has_walked = False
        self.is_over = False
        self.has_ended = False

    def order(self, truth: Mapping[str, Union[str, bool, float]]) -> str:
        """Return what the person does now, as the topic ``home/person`` has it; empty for nothing new."""
        if not self.person or self.is_over:
            return ""
        # Behind a wall the robot has met nobody, however near they are.
        is_near = bool(truth[f"{self.person}.is_near"]) and truth[f"{self.person}.room"] == truth["robot.room"]
        is_walking = truth[f"{self.person}.posture"] == "walking"
        self._has_walked = self._has_walked or (self._has_begun and is_walking)
        # The robot passes people while it still looks for them.
        self._is_met = self._is_met or (is_near and truth["robot.looks_at"] == self.person)
        self._waits -= is_near and self._is_met
        if not self._has_begun and is_near and self._waits <= 0:
            self._has_begun = True
            anywhere = next(room for room in _ANYWHERE if room != truth[f"{self.person}.room"])
            return f"{self.person} walk {self._goal or anywhere}"
        if self._has_walked and not is_walking and is_near and not self._has_goal:
            self.is_over = True
        return ""

    @property
    def must_end(self) -> bool:
        """Whether whoever is followed has arrived, and the robot has more to do than to follow."""
        return self._has_walked and self._is_part

    def end(self) -> None:
        """The command has ended by itself."""
        self.has_ended = True
