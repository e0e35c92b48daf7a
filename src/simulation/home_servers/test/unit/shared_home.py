"""The home that the tests share: its file is read once, and what is worked out of its floor is kept.

Plan and state are values: what one test does in its home is not in that of another.
"""

import os
from functools import lru_cache

from roboframenet_sim.home_engine import Home
from roboframenet_sim.home_file import load_home_file
from roboframenet_sim.home_floor import Floor
from roboframenet_sim.home_state import NO_FAULTS, PR2

HOME_FILE = os.path.join(os.path.dirname(__file__), "..", "..", "..", "roboframenet_sim", "config", "home.yaml")


@lru_cache(maxsize=None)
def _read(robot):
    plan, state = load_home_file(HOME_FILE, robot=robot)
    return plan, state, Floor(plan)


def make_home(*, robot=PR2, faults=NO_FAULTS, seed=0, robot_state=None):
    """Return a home; robot_state: what is otherwise of the robot at the beginning."""
    plan, state, floor = _read(robot)
    return Home(plan, state.with_robot(**(robot_state or {})), seed=seed, faults=faults, floor=floor)
