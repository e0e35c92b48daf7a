"""Which verbs mean what a known verb means, by WordNet: "fetch" means "bring", and to veer is to turn."""

from functools import lru_cache
from typing import Collection, Dict, Iterable, List, Mapping, Tuple

from semantic_types.parts_of_speech import ADJECTIVE, ADVERB, parts_of_speech
from semantic_types.wordnet import NOUN, VERB, Sense, WordNet, shipped_wordnet

#: A verb means what another one means if it does so in this share of its uses.
_OFTEN = 0.25
#: A known verb stands for a sense that has this share of its uses: "take" seldom means to go, as in "take this road".
_USUAL_SHARE = 0.15


class Verbs:
    """The verbs of WordNet, compared with known ones."""

    def __init__(self, verbs: WordNet, nouns: WordNet) -> None:
        """
        Args:
            verbs: WordNet's verbs
            nouns: WordNet's nouns; a word that is said more often as a noun is left out
        """
        self._verbs = verbs
        self._nouns = nouns

    def like(self, known: Collection[str]) -> Mapping[str, Tuple[str, ...]]:
        """Return other verbs that mean mostly what a known verb means, or a way to do it: verbs by known verb.

        Each verb stands with one known verb, the one whose senses it has most often. Verbs that WordNet's texts never
        have, verbs of several words, and words that are other parts of speech too are left out.

        Args:
            known: base forms of verbs
        """
        usual = {verb: self._usual(verb) for verb in sorted(known)}
        near: Dict[str, None] = {}
        for synsets in usual.values():
            for synset in synsets:
                for other in (synset, *self._verbs.alike(synset), *self._verbs.hyponyms(synset)):
                    near.update(dict.fromkeys(word.lower() for word in self._verbs.words(other)))
        found: Dict[str, List[str]] = {}
        for verb in near:
            if verb not in usual and verb.isalpha() and self._is_verb(verb):
                shares = self._shares(verb, usual)
                best = max(shares, key=lambda one: shares[one], default="")
                if best and shares[best][0] >= _OFTEN:
                    found.setdefault(best, []).append(verb)
        return {verb: tuple(sorted(others)) for verb, others in found.items()}

    def same(self, known: Collection[str]) -> Mapping[str, Tuple[str, ...]]:
        """Return the known verbs that usually mean the same as each known verb: "go" and "move".

        Args:
            known: base forms of verbs
        """
        usual = {verb: frozenset(self._usual(verb)) for verb in sorted(known)}
        found = {
            verb: tuple(other for other in usual if other != verb and usual[verb] & usual[other]) for verb in usual
        }
        return {verb: others for verb, others in found.items() if others}

    def _usual(self, verb: str) -> Mapping[int, float]:
        """Return the synsets of the usual senses of a verb, with their shares."""
        return {synset: share for synset, share in self._weighted(verb) if share >= _USUAL_SHARE}

    def _shares(self, verb: str, usual: Mapping[str, Mapping[int, float]]) -> Mapping[str, Tuple[float, float]]:
        """Return, for each known verb, the share of the uses of a verb that means what it means, and how usual these
        meanings are for the known verb: "go" means to travel more often than "move" does.
        """
        shares: Dict[str, Tuple[float, float]] = {}
        for synset, share in self._weighted(verb):
            near = {synset, *self._verbs.alike(synset), *self._verbs.hypernyms(synset)}
            for known, synsets in usual.items():
                common = near.intersection(synsets)
                if common:
                    before = shares.get(known, (0.0, 0.0))
                    shares[known] = (before[0] + share, before[1] + sum(synsets[one] for one in common))
        return shares

    def _weighted(self, verb: str) -> List[Tuple[int, float]]:
        """Return the synsets of a verb, each with its share; a sense that was never counted weighs by its place."""
        senses = self._verbs.senses(verb)
        weights = [sense.count + 1.0 / place for place, sense in enumerate(senses, start=1)]
        return [(sense.synset, weight / sum(weights)) for sense, weight in zip(senses, weights)]

    def _is_verb(self, word: str) -> bool:
        """Whether a word is mostly a verb: "near", "free" and "table" are not."""
        is_other = parts_of_speech(word) & {ADJECTIVE, ADVERB}
        return not is_other and _count(self._verbs.senses(word)) > _count(self._nouns.senses(word))


def _count(senses: Iterable[Sense]) -> int:
    return sum(sense.count for sense in senses)


@lru_cache(maxsize=None)
def shipped_verbs() -> Verbs:
    """Return the verbs of the machine's WordNet.

    Raises:
        NoWordNet: the database is not installed
    """
    return Verbs(shipped_wordnet(VERB), shipped_wordnet(NOUN))
