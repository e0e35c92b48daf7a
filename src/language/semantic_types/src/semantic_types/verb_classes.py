"""Other verbs of the class of a known verb, by WordNet: verbs of the same sense, and direct ways to do the same.

Sisters are none of them: to raise and to lower are two ways to move. Neither is a verb that is an opposite of a known
one, or a way to do the opposite. Whether a verb is right for a robot, a person decides.
"""

from dataclasses import dataclass
from typing import Collection, Dict, Iterator, List, Mapping, Set, Tuple

from semantic_types.wordnet import WordNet

SYNONYM, HYPONYM = "the same", "a way to"
#: A sense counts if a verb has it in this share of its uses: "take" seldom means to go, as in "take this road".
_USUAL_SHARE = 0.15
#: A proposed verb has the sense in this share of its uses.
_OFTEN = 0.25


@dataclass(frozen=True)
class ClassVerb:
    """A verb of a class.

    Attributes:
        verb: its base form, with particles
        sense: that of the known verb: "get.v.01"
        reason: ``SYNONYM`` or ``HYPONYM``
        gloss: what the verb means in this sense
    """

    verb: str
    sense: str
    reason: str
    gloss: str


def class_verbs(net: WordNet, known: Collection[str], owned: Collection[str] = ()) -> Tuple[ClassVerb, ...]:
    """Return other verbs of the classes of known verbs, those of frequent senses first.

    Args:
        net: WordNet's verbs
        known: the verbs of one frame
        owned: verbs of any frame, which are left out
    """
    opposites = {word for verb in known for synset in _synsets(net, verb) for word in _opposite_words(net, synset)}
    found: List[ClassVerb] = []
    seen: Set[str] = set()
    for verb in known:
        for number, synset in enumerate(_synsets(net, verb), 1):
            if _share(net, verb, synset) < _USUAL_SHARE:
                continue
            sense = f"{verb.replace(' ', '_')}.v.{number:02}"
            for other, reason, gloss, own in _near(net, synset):
                is_new = other not in seen and other not in known and other not in owned and other not in opposites
                if is_new and _share(net, other, own) >= _OFTEN:
                    seen.add(other)
                    found.append(ClassVerb(other, sense, reason, gloss))
    return tuple(found)


def is_of_class(net: WordNet, verb: str, sense: str) -> bool:
    """Whether a verb has a sense of another one, or is a direct way to do it, and is no opposite of it.

    Args:
        net: WordNet's verbs
        verb: the verb, with particles
        sense: such as "get.v.01"
    """
    synset = net.synset(sense)
    return (
        synset is not None
        and any(near[0] == verb for near in _near(net, synset))
        and verb not in _opposite_words(net, synset)
    )


def known_verbs_near(net: WordNet, verb: str, known: Collection[str]) -> Mapping[str, str]:
    """Return those known verbs of the class of which a verb is, each with the reason; see :func:`class_verbs`.

    Args:
        net: WordNet's verbs
        verb: base form of another verb, with particles
        known: verbs
    """
    found: Dict[str, str] = {}
    for synset in _synsets(net, verb):
        if _share(net, verb, synset) < _OFTEN:
            continue
        for reason, near in ((SYNONYM, (synset,)), (HYPONYM, net.hypernyms(synset))):
            for other in near:
                for word in (word.lower() for word in net.words(other)):
                    if word in known and word != verb and _share(net, word, other) >= _USUAL_SHARE:
                        found.setdefault(word, reason)
    return found


def _synsets(net: WordNet, verb: str) -> List[int]:
    """Return the synsets of a verb in WordNet's order, whose places are the numbers of the senses."""
    found: List[int] = []
    while True:
        synset = net.synset(f"{verb.replace(' ', '_')}.v.{len(found) + 1:02}")
        if synset is None:
            return found
        found.append(synset)


def _share(net: WordNet, verb: str, synset: int) -> float:
    """Return how often a verb has a sense, as a share of its uses; each sense counts once more than WordNet's texts."""
    counts = {sense.synset: sense.count + 1 for sense in net.senses(verb)}
    return counts.get(synset, 0) / (sum(counts.values()) or 1)


def _near(net: WordNet, synset: int) -> Iterator[Tuple[str, str, str, int]]:
    for word in net.words(synset):
        yield word.lower(), SYNONYM, net.gloss(synset), synset
    for below in net.hyponyms(synset):
        for word in net.words(below):
            yield word.lower(), HYPONYM, net.gloss(below), below


def _opposite_words(net: WordNet, synset: int) -> Set[str]:
    return {
        word.lower()
        for opposite in net.opposites(synset)
        for near in (opposite, *net.hyponyms(opposite))
        for word in net.words(near)
    }
