"""The home of the package, for tests."""

import os
from functools import lru_cache

from roboframenet_sim.home_engine import Home
from roboframenet_sim.home_file import load_home_file
from roboframenet_sim.home_floor import Floor
from roboframenet_sim.home_state import NO_FAULTS, PR2

HOME_FILE = os.path.join(os.path.dirname(__file__), "..", "..", "config", "home.yaml")


@lru_cache(maxsize=None)
def _read(robot):
    """The file is read once, and what is worked out of its floor is kept: plan and state are values."""
    plan, state = load_home_file(HOME_FILE, robot=robot)
    return plan, state, Floor(plan)


def make_home(*, seed=0, faults=NO_FAULTS, robot=PR2):
    plan, state, floor = _read(robot)
    return Home(plan, state, seed=seed, faults=faults, floor=floor)
