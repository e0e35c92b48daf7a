"""What the framer makes of an utterance."""

from dataclasses import dataclass
from typing import Optional, Tuple

from semantic_framer.dialogue import Context
from semantic_framer.outcome import Outcome
from semantic_framer.readings import ClauseReadings
from semantic_framer.sentence import Sentence


@dataclass(frozen=True)
class Heard:
    """The result of an utterance.

    Attributes:
        outcome: what to do, why nothing is done, or what to ask
        context: what to remember
        sentence: the sentence that was read; None if the person must first say what was meant
        clauses: the clauses of the sentence with their readings; empty if no clause was read
        is_small_talk: whether it is small talk from end to end, which is against nothing that runs
    """

    outcome: Outcome
    context: Context
    sentence: Optional[Sentence] = None
    clauses: Tuple[ClauseReadings, ...] = ()
    is_small_talk: bool = False
