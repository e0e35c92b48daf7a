"""The semantic types of English nouns, from WordNet."""

from functools import lru_cache
from pathlib import Path
from typing import Dict, FrozenSet, Set, Tuple

from checked_files.source_files import read_text
from semantic_frames.semantic_type import with_parents
from semantic_types.likelihood import UNTYPED, Likelihoods, of_names, of_weights
from semantic_types.noun_file import NounFile, load_noun_file
from semantic_types.wordnet import Sense, WordNet, shipped_wordnet

#: The file is beside this module in the source, devel and install space.
NOUN_FILE = Path(__file__).resolve().parent / "nouns.yaml"
#: A sense is rare when it is said less often than this share of the most frequent one.
FREQUENT_SHARE = 0.3
#: WordNet counts senses in texts of newspapers and novels. A person who talks to a robot means what can be seen and
#: touched more often: "table" is the piece of furniture, though WordNet counts the one in a text twice as often.
PHYSICAL_WEIGHT = 3.0
#: Bounds of the memory for words and synsets; a household has fewer.
MOST_WORDS = 4096
MOST_SYNSETS = 16384


class Nouns:
    """The types of nouns, by WordNet's senses and a file that maps synsets to types."""

    def __init__(self, wordnet: WordNet, file: NounFile) -> None:
        self._wordnet = wordnet
        self._file = file
        self.types = lru_cache(maxsize=MOST_WORDS)(self._types)
        self.kinds = lru_cache(maxsize=MOST_WORDS)(self._kinds)
        self.synsets = lru_cache(maxsize=MOST_WORDS)(self._synsets)
        self._of_synset = lru_cache(maxsize=MOST_SYNSETS)(self._find_of_synset)

    def _types(self, noun: str, is_name: bool = False) -> Likelihoods:
        """Return the types of a noun.

        Args:
            noun: singular, or a plural that WordNet has ("scissors"); words are separated by blanks
            is_name: whether the noun is a proper noun: then only senses that are spelled with a capital count
        Returns:
            its types; none if WordNet has no such noun, or no sense of it has a type
        """
        key = noun.lower()
        if not is_name and key in self._file.words:
            return of_names(self._file.words[key])
        senses = self._wordnet.senses(noun)
        bases = {sense.spelling.lower() for sense in senses}
        if not is_name and key not in bases:
            # The plural of a noun of the file: "mugs".
            listed = [self._file.words[base] for base in sorted(bases) if base in self._file.words]
            if listed:
                return of_names(listed[0])
        if is_name:
            # "Maria" is a tree, too, but nobody says so with its name.
            alike = (sense for sense in senses if _is_spelled_alike(sense.spelling, noun))
            senses = tuple(sense for sense in alike if "Plant" not in self._of_synset(sense.synset))
        weights: Dict[str, float] = {}
        total = 0.0
        for place, sense in enumerate(senses, start=1):
            for name, weight in self._weights(sense, place).items():
                weights[name] = weights.get(name, 0.0) + weight
                total += weight
        return of_weights(weights) if total else UNTYPED

    def _synsets(self, noun: str, is_person: bool = False, is_of_one: bool = False) -> FrozenSet[int]:
        """Return the senses of a noun that can be seen and touched; none for an unknown noun.

        A rare sense is left out where another one is frequent: a "plate" on the table is no bag of baseball.

        Args:
            noun: as for ``types``
            is_person: whether senses of persons count instead of those of things: a "chair" may lead a meeting
            is_of_one: whether it is said of one thing: then "glasses" are spectacles, and not several glasses
        """
        said = self._wordnet.senses(noun)
        own = [sense for sense in said if is_of_one and sense.spelling.lower() == noun.lower()]
        senses = [
            sense
            for sense in own or said
            for types in [frozenset().union(*map(with_parents, self._of_synset(sense.synset)))]
            if "Physical_entity" in types and ("Sentient" in types) == is_person
        ]
        # A banana in a home is a fruit.
        others = [sense for sense in senses if "Plant" not in self._of_synset(sense.synset)]
        senses = others or senses
        most = max((sense.count for sense in senses), default=0)
        return frozenset(sense.synset for sense in senses if sense.count >= FREQUENT_SHARE * most)

    def _kinds(self, noun: str, is_person: bool = False) -> FrozenSet[int]:
        """Return what one thing of a noun is a kind of: its senses and every more general synset, by the file too."""
        found: Set[int] = set()
        left = list(self.synsets(noun, is_person=is_person, is_of_one=True))
        while left:
            synset = left.pop()
            if synset not in found:
                found.add(synset)
                left += (*self._wordnet.hypernyms(synset), *self._file.kinds.get(synset, ()))
        return frozenset(found)

    def _weights(self, sense: Sense, place: int) -> Dict[str, float]:
        """Return the weight of each type of a sense; a sense that was never counted weighs by its place."""
        weight = sense.count + 1.0 / place
        types = self._of_synset(sense.synset)
        return {name: weight * (PHYSICAL_WEIGHT if "Physical_entity" in with_parents(name) else 1.0) for name in types}

    def _find_of_synset(self, synset: int) -> Tuple[str, ...]:
        """Return the types of the nearest synsets that the file maps, upwards."""
        if synset in self._file.synsets:
            return self._file.synsets[synset]
        found = [name for above in self._wordnet.hypernyms(synset) for name in self._of_synset(above)]
        return tuple(dict.fromkeys(found))


def _is_spelled_alike(known: str, said: str) -> bool:
    """Whether a name may be what was said: it has a capital, and "Sam" is no abbreviation SAM."""
    return known[:1].isupper() and (said.isupper() or not known.isupper())


@lru_cache(maxsize=None)
def shipped_nouns() -> Nouns:
    """Return the nouns of the machine's WordNet with the types of ``nouns.yaml``, read once.

    Raises:
        NoWordNet: the database is not installed
        FileRefused: the file is wrong
    """
    wordnet = shipped_wordnet()
    return Nouns(wordnet, load_noun_file(read_text(str(NOUN_FILE)), str(NOUN_FILE), wordnet))
