"""Chooses what was said among what may have been: by how likely it sounds, and by what the robot knows."""

import math
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Dict, List, Mapping, Sequence, Tuple

from voice_recognition.agreement import Heard, Verdict
from voice_recognition.command_reading import Meaning, Sense
from voice_recognition.offers import Offer
from voice_recognition.spoken_language import spoken_words
from voice_recognition.whisper_model import Sentence

#: The logarithm of how much less likely a sentence is said to a robot: by what it is to the robot, and for each word
#: that the robot does not know.
LESS_LIKELY: Mapping[Sense, float] = MappingProxyType(
    {Sense.NONE: -6.0, Sense.REFUSED: -5.0, Sense.ASKED: -1.0, Sense.COMMAND: 0.0, Sense.STOP: -1.0}
)
PER_UNKNOWN_WORD = -8.0
#: A sentence whose words are known and heard so well, and that outweighs all others so far, is sure.
SURE_PER_TOKEN, SURE_SHARE = -0.4, 0.9
#: Where the likeliest sentence sounds less likely, nothing was heard; what only sounds like it may sound less likely.
LEAST_PER_TOKEN, LEAST_PER_TOKEN_ALIKE = -2.2, -4.0
#: Another command with such a share is offered as well.
CHOICE_SHARE = 0.25
#: From this share on, a command is offered alone.
LIKELY_SHARE = 0.4


@dataclass(frozen=True)
class Candidate:
    """A sentence that may have been said.

    Attributes:
        sentence: with its probability
        meaning: what the robot makes of it
        is_heard: whether a recogniser heard it; otherwise it only sounds like what was heard
    """

    sentence: Sentence
    meaning: Meaning
    is_heard: bool = True

    @property
    def weight(self) -> float:
        """The logarithm of how likely it was said to this robot."""
        rare = PER_UNKNOWN_WORD * len(self.meaning.unknown)
        return self.sentence.log_probability + LESS_LIKELY[self.meaning.sense] + rare


@dataclass(frozen=True)
class _Group:
    """Sentences of one meaning."""

    best: Candidate
    share: float


def choose(candidates: Sequence[Candidate]) -> Heard:
    """Return what was heard.

    Args:
        candidates: of one utterance
    """
    groups = _groups(candidates)
    if not groups:
        return Heard(Verdict.NOTHING)
    first, rest = groups[0], groups[1:]
    words = spoken_words(first.best.sentence.text)
    plain = max(candidates, key=lambda one: (one.is_heard, one.sentence.log_probability)).sentence
    heard = Heard(Verdict.AGAIN, (), words, spoken_words(plain.text))
    meaning, per_token = first.best.meaning, first.best.sentence.per_token
    if plain.per_token < LEAST_PER_TOKEN or per_token < LEAST_PER_TOKEN_ALIKE:
        return replace(heard, verdict=Verdict.NOTHING)
    if meaning.sense is Sense.STOP:
        return replace(heard, verdict=Verdict.SURE, is_stop=True, by_ngram=words)
    is_clear = per_token >= SURE_PER_TOKEN and first.share >= SURE_SHARE and first.best.is_heard
    if meaning.offer is None or meaning.sense < Sense.ASKED:
        if is_clear:
            # The person learns from the reply why it is not done.
            said = Offer("", (), first.best.sentence.text.rstrip(".!?"))
            return replace(heard, verdict=Verdict.LIKELY, offers=(said,))
        return heard if meaning.sense is not Sense.NONE else replace(heard, verdict=Verdict.NOTHING)
    if is_clear and not meaning.unknown:
        return replace(heard, verdict=Verdict.SURE, offers=(meaning.offer,))
    others = [
        one.best.meaning.offer
        for one in rest
        if one.share >= CHOICE_SHARE and one.best.meaning.sense in (Sense.ASKED, Sense.COMMAND)
    ]
    other = next((offer for offer in others if offer is not None), None)
    if other is not None:
        return replace(heard, verdict=Verdict.CHOICE, offers=(meaning.offer, other))
    return replace(heard, verdict=Verdict.LIKELY, offers=(meaning.offer,)) if first.share >= LIKELY_SHARE else heard


def _groups(candidates: Sequence[Candidate]) -> List[_Group]:
    """Return the meanings with their shares, the likeliest first."""
    by_meaning: Dict[Tuple[object, ...], List[Candidate]] = {}
    for one in candidates:
        by_meaning.setdefault(_key(one), []).append(one)
    if not by_meaning:
        return []
    # The spellings of one sentence are one way to say it: the likeliest counts.
    best = [max(same, key=lambda one: (one.weight, one.is_heard)) for same in by_meaning.values()]
    highest = max(one.weight for one in best)
    powers = [math.exp(one.weight - highest) for one in best]
    total = sum(powers)
    groups = [_Group(one, power / total) for one, power in zip(best, powers)]
    return sorted(groups, key=lambda group: -group.share)


def _key(candidate: Candidate) -> Tuple[object, ...]:
    offer, sense = candidate.meaning.offer, candidate.meaning.sense
    if sense is Sense.STOP:
        return (sense,)
    if offer is None or sense < Sense.ASKED:
        return ("text", spoken_words(candidate.sentence.text))
    return ("offer", offer.frame, _lower(offer))


def _lower(offer: Offer) -> Tuple[Tuple[str, str], ...]:
    return tuple((name, value.lower()) for name, value in offer.elements)
