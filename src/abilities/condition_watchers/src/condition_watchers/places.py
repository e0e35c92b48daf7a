"""Whether the robot is at a place."""

import math
from typing import Tuple

#: A place is so large, metres.
HEREABOUTS_M = 0.6


def is_near(here: Tuple[float, float], place: Tuple[float, float], radius_m: float) -> bool:
    """Whether two points are at most so far apart, in metres."""
    return math.dist(here, place) <= radius_m
