"""Where something that is spoken of is, by its name."""

from typing import Iterable, Optional, Tuple

from robot_fleet.designators import tokens_of

Place = Tuple[float, float]


def place_in(text: str, places: Iterable[Tuple[str, Place]]) -> Optional[Place]:
    """Return where the thing is that a text names; of several, the one with the longest name; None for none.

    Args:
        text: what was said
        places: names in lower case, and metres in the frame of the map
    """
    said = f" {' '.join(token.word for token in tokens_of(text))} "
    found = [(len(name), place) for name, place in places if name and f" {name} " in said]
    return max(found)[1] if found else None
