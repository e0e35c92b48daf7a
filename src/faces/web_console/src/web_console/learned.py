"""The panel of what persons taught the robot."""

from dataclasses import dataclass
from typing import Tuple

from roboframenet_msgs.msg import Learned


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


def learned_view(message: Learned) -> LearnedView:
    """Return what was taught."""
    items = (
        LearnedItemView(
            said=one.said,
            meaning=one.meaning,
            who=one.who,
            when_s=one.stamp.to_sec(),
            sentence=one.sentence,
            forgets=f'Forget what I taught you about "{one.said}".',
        )
        for one in message.items
    )
    return LearnedView(tuple(items), int(message.left_out))
