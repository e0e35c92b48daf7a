"""The home of the package, for tests."""

import os

from roboframenet_sim.home_engine import Home
from roboframenet_sim.home_file import load_home_file
from roboframenet_sim.home_state import NO_FAULTS, PR2

HOME_FILE = os.path.join(os.path.dirname(__file__), "..", "..", "config", "home.yaml")


def make_home(*, seed=0, faults=NO_FAULTS, robot=PR2):
    plan, state = load_home_file(HOME_FILE, robot=robot)
    return Home(plan, state, seed=seed, faults=faults)
