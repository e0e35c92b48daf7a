"""What is remembered from one utterance to the next: an open question, and what was spoken of."""

from dataclasses import dataclass, replace
from typing import Optional, Tuple

from semantic_framer.reading import Reading
from utterance_passes.utterance_pass import Choice
from word_classes import word_class

PRONOUNS = word_class("pronouns")
#: Of them, those that may be what was said.
DEMONSTRATIVES = word_class("demonstrative_pronouns")
PLACE_PRONOUNS = frozenset(["there"])
_AGREEMENTS = word_class("agreements")
_REFUSALS = word_class("refusals")


@dataclass(frozen=True)
class Pending:
    """A question that the next utterance may answer.

    Attributes:
        clauses: what was understood so far; the clause that asks holds the readings that it asks for
        clause: its position among them
        elements: the element that was asked for, of each of these readings; none for a question of yes or no
        choices: the only answers, as they were offered; empty where every answer may be given
        expires_s: on the clock of the caller; later the question is forgotten
        readings: those of the sentence that one is to be chosen from; nothing else was understood so far then
    """

    clauses: Tuple[Tuple[Reading, ...], ...]
    clause: int
    elements: Tuple[str, ...]
    expires_s: float
    choices: Tuple[str, ...] = ()
    readings: Tuple[Choice, ...] = ()


@dataclass(frozen=True)
class Context:
    """What is remembered.

    Attributes:
        pending: an open question, None for none
        thing: the last thing that was spoken of, "the mug"; empty for none
        place: the last place, "the kitchen"; empty for none
    """

    pending: Optional[Pending] = None
    thing: str = ""
    place: str = ""

    def at(self, now_s: float) -> "Context":
        """Return what is still remembered at a time."""
        if self.pending is not None and now_s > self.pending.expires_s:
            return replace(self, pending=None)
        return self


def is_yes(text: str) -> bool:
    """Whether an utterance agrees."""
    return _bare(text) in _AGREEMENTS


def is_no(text: str) -> bool:
    """Whether an utterance declines."""
    return _bare(text) in _REFUSALS


def _bare(text: str) -> str:
    return " ".join(text.lower().replace(",", " ").strip(" .!?").split())
