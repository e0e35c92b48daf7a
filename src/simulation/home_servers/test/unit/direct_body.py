"""A body in a home without ROS: acts and perceives at once."""

import datetime

from perception import known_of_map, known_of_sight

from home_servers.body import Interrupted
from home_servers.memory import Known, Memory
from roboframenet_sim.home_state import ROBOT


class DirectBody:
    """The body of a home's robot.

    Args:
        home: a Home
        most_s: home time after which the goal is preempted
    """

    STEP_S = 0.2

    def __init__(self, home, *, most_s=900.0):
        self.home = home
        self.memory = Memory()
        self.said = []
        self.told = []
        self._end_s = home.state.time_s + most_s
        self.memory.update(known_of_map(home.plan))
        self._look()

    def _look(self):
        state = self.home.state
        self.memory.update(known_of_sight(self.home.plan, state, self.home.floor.visible(state)))

    def do(self, action):
        failure = self.home.begin(action)
        if failure is not None:
            self._look()
            return failure
        step = 0
        while True:
            self.home.step(self.STEP_S)
            step += 1
            for outcome in self.home.outcomes():
                if outcome.action is action:
                    self._look()
                    return outcome.failure
            if step % 5 == 0:
                self._look()
            if self.home.state.time_s > self._end_s:
                self.home.preempt()
                self.home.outcomes()
                raise Interrupted("the time is over")

    def say(self, text):
        self.said.append(text)
        before = len(self.home.state.events)
        self.home.say(ROBOT, text)
        names = self.home.plan.entities
        return [(names[event.who].name, event.what) for event in self.home.state.events[before:] if event.who != ROBOT]

    def show_doing(self, words):
        self.shown = [*getattr(self, "shown", []), words]

    def tell(self, told):
        self.told.append(told)

    def now_s(self):
        return self.home.state.time_s

    def clock(self):
        return datetime.datetime(2026, 3, 2, 9, 30)

    def held(self):
        return self.home.state.held_by(ROBOT)

    def place(self):
        return self.home.plan.position(self.home.state, ROBOT)

    def room(self):
        return self.home.plan.room_at(self.place())


__all__ = ["DirectBody", "Known"]
