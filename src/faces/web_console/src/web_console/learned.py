"""The panel of what persons taught the robot."""

from dataclasses import dataclass
from typing import Tuple


@dataclass(frozen=True)
class LearnedItemView:
    """Something that was taught.

    Attributes:
        said: the words
        meaning: what they mean, as a sentence
        who: taught it; empty when nobody was known
        when_s: when, seconds since 1970
        sentence: in which the words were said
        forgets: the sentence by which it is forgotten
    """

    said: str
    meaning: str
    who: str
    when_s: float
    sentence: str
    forgets: str


@dataclass(frozen=True)
class LearnedView:
    """What was taught, the last first, and how many more there are."""

    items: Tuple[LearnedItemView, ...] = ()
    more: int = 0
