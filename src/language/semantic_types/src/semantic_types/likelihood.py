"""The semantic types that a word may have, each with its likelihood."""

from dataclasses import dataclass
from enum import IntEnum
from typing import Dict, Iterable, Mapping, Sequence, Tuple

from semantic_frames.semantic_type import with_parents

#: From this likelihood on, a type is one that the word usually has.
LIKELY = 0.3
#: Below this likelihood, nobody means the word in this sense.
UNLIKELY = 0.03
#: Weight of a type in a list without numbers, relative to the one before. Only the first of two types is LIKELY.
_NEXT = 0.4


class Fit(IntEnum):
    """How well a word fits some types; a smaller number is better."""

    LIKELY = 0
    POSSIBLE = 1  # in a rare sense
    UNKNOWN = 2  # the word has no type
    WRONG = 3


@dataclass(frozen=True)
class Likelihoods:
    """The types of a word.

    Attributes:
        types: each type with its likelihood, more than 0 and at most 1, the likeliest first; a word that means a sense
            of two types counts for both; empty for a word without a type
    """

    types: Tuple[Tuple[str, float], ...] = ()

    @property
    def names(self) -> Tuple[str, ...]:
        """The types, the likeliest first."""
        return tuple(name for name, _ in self.types)

    def share(self, accepted: Iterable[str]) -> float:
        """Return how likely it is that the word has one of some types, or a type below them, 0 to 1."""
        wanted = frozenset(accepted)
        return min(1.0, sum(likelihood for name, likelihood in self.types if with_parents(name) & wanted))

    def fit(self, accepted: Sequence[str]) -> Fit:
        """Return how well the word fits some types; a word without a type fits none of them, and contradicts none."""
        if not self.types:
            return Fit.UNKNOWN
        share = self.share(accepted)
        if share >= LIKELY:
            return Fit.LIKELY
        return Fit.POSSIBLE if share >= UNLIKELY else Fit.WRONG

    def likeliest(self, accepted: Sequence[str] = ()) -> str:
        """Return the likeliest type; if types are given, the likeliest of those that are among them or below them.

        Args:
            accepted: the types of the element that the word fills; empty for any
        Returns:
            the name of a type; empty for a word without one
        """
        wanted = frozenset(accepted)
        for name, likelihood in self.types:
            if likelihood >= UNLIKELY and with_parents(name) & wanted:
                return name
        return self.types[0][0] if self.types else ""


#: The types of a word that nothing is known about.
UNTYPED = Likelihoods()


def of_weights(weights: Mapping[str, float]) -> Likelihoods:
    """Return likelihoods from weights of types; types with the same weight keep their order."""
    total = sum(weights.values())
    ordered = sorted(weights.items(), key=lambda item: -item[1])
    return Likelihoods(tuple((name, weight / total) for name, weight in ordered if weight > 0.0))


def of_names(names: Sequence[str]) -> Likelihoods:
    """Return likelihoods of types in the order of likelihood: each weighs less than half of the one before."""
    return of_weights({name: _NEXT**place for place, name in enumerate(names)})


def combined(parts: Iterable[Tuple[Likelihoods, float]]) -> Likelihoods:
    """Return the likelihoods of several possibilities, each with its own likelihood; untyped ones do not count."""
    weights: Dict[str, float] = {}
    for types, share in parts:
        for name, likelihood in types.types:
            weights[name] = weights.get(name, 0.0) + share * likelihood
    return of_weights(weights) if weights else UNTYPED
