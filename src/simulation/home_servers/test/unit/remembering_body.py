"""A body that knows all of a home, does every action at once, and remembers what it did."""

import datetime

from perception import known_of_map, known_of_sight

from home_servers.body import Interrupted
from home_servers.memory import Memory

#: A goal that goes on for longer is preempted, seconds.
MOST_S = 300.0


class RememberingBody:
    """A body without a home: nothing fails.

    Args:
        plan: of the home
        state: of the home
        held: what the robot holds
    """

    def __init__(self, plan, state, *, held=()):
        self.memory = Memory()
        self.memory.update(known_of_map(plan))
        self.memory.update(known_of_sight(plan, state, [ident for ident in plan.entities if ident != "robot"]))
        self.done = []
        self._held = list(held)
        self._time_s = 0.0
        self._at = self.memory.get("hall")

    def do(self, action):
        self.done.append(action)
        self._time_s += 1.0 + (action.amount if action.kind == "wait" else 0.0)
        if self._time_s > MOST_S:
            raise Interrupted("the time is over")
        if action.kind == "go":
            self._at = self.memory.get(action.goal)
        elif action.kind == "grasp":
            self._held.append(action.theme)
        elif action.theme in self._held and action.kind in ("put", "give", "throw"):
            self._held.remove(action.theme)

    def say(self, text):
        self.done.append(text)
        return [("Anna", "Yes")]

    def show_doing(self, words):
        self.shown = [*getattr(self, "shown", []), words]

    def tell(self, told):
        self.done.append(told)

    def now_s(self):
        return self._time_s

    def clock(self):
        return datetime.datetime(2026, 3, 2, 9, 30)

    def held(self):
        return tuple(self._held)

    def place(self):
        return self._at.x_m, self._at.y_m

    def room(self):
        return self._at.id if self._at.sort == "room" else self._at.room
