"""The weather outside: for a while it is dry, then it rains for a while. No clock: the caller counts the seconds."""

import random
from typing import Tuple

#: It is dry, and it rains, for as long as lies between these, seconds.
DRY_S: Tuple[float, float] = (1200.0, 3600.0)
RAIN_S: Tuple[float, float] = (300.0, 900.0)


class Weather:
    """Changes by itself.

    Args:
        seed: of how long it rains, and how long it does not
    """

    def __init__(self, *, seed: int = 0) -> None:
        self._random = random.Random(seed)
        self._left_s = 0.0
        self.is_raining = False
        self.change(is_raining=False)

    def change(self, *, is_raining: bool) -> None:
        """From now on it rains, or it does not, for a while."""
        self.is_raining = is_raining
        self._left_s = self._random.uniform(*(RAIN_S if is_raining else DRY_S))

    def step(self, duration_s: float) -> None:
        """Advance the time."""
        self._left_s -= duration_s
        if self._left_s <= 0.0:
            self.change(is_raining=not self.is_raining)
