"""What lexical units tell the parser of their words: "crawl" with ``prep_up`` makes "up the wall" a phrase of "crawl".

The first tree shows where a word follows a verb whose units name it. The tree is then sought again, among those trees
only in which the word is what the units say, whatever the network thinks of it. But whether a noun is the object of a
verb that takes one ("take off the lid") is for the network to say.
"""

from enum import Enum
from functools import lru_cache
from typing import TYPE_CHECKING, Dict, FrozenSet, Iterable, Iterator, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from semantic_frames.lexical_unit import LexicalUnit
from utterance_passes.trees.tree import NOMINALS, VERBS, DependencyTree, Word
from utterance_passes.trees.vocabulary import NamedWord

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

#: Name of the rule in traces, and what it does.
RULE = "words_of_units"
WHAT = 'A word that a unit names with its verb is what the unit says: "crawl *up* the wall".'
_DIRECT = frozenset(["dobj", "obj"])
_PARTICLES = frozenset(["prt", "compound:prt"])
_ADVERB = "advmod"
_OBJECT = frozenset(["obj", "iobj"])
_BEGINS_NO_NOUN_PHRASE = frozenset(["ADP", "SCONJ", "CCONJ", "PART", "PUNCT", "INTJ"])
#: What a noun is that the network does not take for the phrase of a preposition. Measures and times have subtypes.
_MISREAD = frozenset(["obj", "iobj", "obl", "nmod", "xcomp", "ccomp", "dep", "appos", "compound"])
#: What a preposition is that the network sees.
_SEEN = frozenset(["case", "mark"])
#: What a particle is at a verb that the network does not take for one.
_LOOSE = frozenset(["advmod", "obl", "obj", "xcomp", "advcl", "dep", "acl", "compound"])


class Use(Enum):
    """How units use a word with a verb."""

    PREPOSITION = "preposition"
    PARTICLE = "particle"
    OBJECT = "object"


class Hint(NamedTuple):
    """What a unit says of a verb.

    Attributes:
        verb: in lower case, with its particle: "shut down"
        use: of the other words
        word: in lower case; empty for an object, which may be any
    """

    verb: str
    use: Use
    word: str = ""


def hints_of(units: Iterable[LexicalUnit]) -> FrozenSet[Hint]:
    """Return what some units say of their verbs.

    An element that may be an adverb, too, tells nothing of a particle: both readings of the network fill it.
    """
    return _one_object(frozenset(hint for unit in units for verb in unit.verbs for hint in _hints_of(unit, verb)))


@lru_cache(maxsize=64)
def _one_object(hints: FrozenSet[Hint]) -> FrozenSet[Hint]:
    """Return the same object for equal hints: `_uses` compares thousands of them at each parse otherwise."""
    return hints


def _hints_of(unit: LexicalUnit, verb: str) -> Iterator[Hint]:
    for element in unit.relations:
        firsts = {path.steps[0] for path in element.relations}
        # "Go home" and "walk Bob to the door" say nothing of "go down the hall".
        if firsts & _DIRECT and not (element.words or element.is_for_persons):
            yield Hint(verb, Use.OBJECT)
        if firsts & _PARTICLES and _ADVERB not in firsts:
            yield from (Hint(verb, Use.PARTICLE, word) for word in element.words)
        for path in element.relations:
            if path.preposition:
                yield Hint(verb, Use.PREPOSITION, path.preposition.replace("_", " "))


#: A verb, a preposition, a particle: one or several words.
_Words = Tuple[str, ...]


class _Uses(NamedTuple):
    """Hints by words.

    Attributes:
        prepositions: by their first word: the verbs of each
        particles: the verbs of each
        with_object: verbs that take an object, by their first word
    """

    prepositions: Dict[str, Dict[_Words, List[_Words]]]
    particles: Dict[str, List[_Words]]
    with_object: Dict[str, List[_Words]]


@lru_cache(maxsize=64)
def _uses(hints: FrozenSet[Hint]) -> _Uses:
    found = _Uses({}, {}, {})
    for hint in hints:
        verb, words = tuple(hint.verb.split()), tuple(hint.word.split())
        if hint.use is Use.PREPOSITION:
            found.prepositions.setdefault(words[0], {}).setdefault(words, []).append(verb)
        elif hint.use is Use.PARTICLE:
            found.particles.setdefault(hint.word, []).append(verb)
        else:
            found.with_object.setdefault(verb[0], []).append(verb)
    return found


def named_words(tree: DependencyTree, hints: FrozenSet[Hint]) -> Tuple[NamedWord, ...]:
    """Return the words that are something else in a tree than units say.

    Args:
        tree: what the network finds by itself
        hints: what the units say
    """
    uses = _uses(hints)
    found: List[NamedWord] = []
    for word in tree.words:
        form = word.said
        for words, verbs in uses.prepositions.get(form, {}).items():
            if len(words) == 1 or words == _forms(tree, word.index, word.index + len(words) - 1):
                found += _preposition(tree, word, len(words), verbs, uses)
        if form in uses.particles:
            found += _particle(tree, word, uses.particles[form], uses)
    return tuple(found)


def _forms(tree: DependencyTree, first: int, last: int) -> _Words:
    return tuple(word.said for word in tree.words[first - 1 : last])


def _preposition(
    tree: DependencyTree, word: Word, length: int, verbs: Sequence[_Words], uses: _Uses
) -> Tuple[NamedWord, ...]:
    if word.deprel in _SEEN and tree.governor(word).deprel not in _OBJECT:
        return ()  # mostly
    verb = _verb_before(tree, word, verbs)
    noun = _noun_behind(tree, word, length) if verb is not None else None
    if verb is None or noun is None or not _is_misread(tree, word, noun, verb):
        return ()
    may_be_object = _may_have_object_behind(tree, verb, word, uses) and word.head != noun.index
    if may_be_object and noun.head == verb.index and noun.deprel in _OBJECT:
        return ()
    return (NamedWord(word.index, length, noun.index, verb.index, is_particle=False),)


def _particle(tree: DependencyTree, word: Word, verbs: Sequence[_Words], uses: _Uses) -> Tuple[NamedWord, ...]:
    verb = _verb_before(tree, word, verbs)
    if verb is None:
        return ()
    noun = _noun_behind(tree, word, 1)
    if noun is None or noun.head not in (verb.index, word.index) or noun.deprel not in _MISREAD:
        is_loose = word.head == verb.index and word.deprel in _LOOSE
        return (NamedWord(word.index, 1, 0, verb.index, is_particle=True),) if is_loose else ()
    form = word.said
    is_preposition = _is_said(tree, verb, word, uses.prepositions.get(form, {}).get((form,), ()))
    is_seen = word.deprel == "compound:prt" and noun.deprel == "obj"
    if is_preposition or is_seen or not _may_have_object_behind(tree, verb, word, uses):
        return ()
    return (NamedWord(word.index, 1, noun.index, verb.index, is_particle=True),)


def _is_said(tree: DependencyTree, verb: Word, word: Word, verbs: Iterable[_Words]) -> bool:
    """Whether a verb is one of some verbs, with their other words behind it and up to another word."""
    behind = _forms(tree, verb.index + 1, word.index)
    return any(one[0] == verb.lemma.lower() and set(one[1:]).issubset(behind) for one in verbs)


def _may_have_object_behind(tree: DependencyTree, verb: Word, word: Word, uses: _Uses) -> bool:
    between = (one.deprel == "obj" and verb.index < one.index < word.index for one in tree.children(verb.index))
    return _is_said(tree, verb, word, uses.with_object.get(verb.lemma.lower(), ())) and not any(between)


def _verb_before(tree: DependencyTree, word: Word, verbs: Sequence[_Words]) -> Optional[Word]:
    """Return the last verb before a word, if it is one of some verbs, and all words between are its own."""
    verb = next((one for one in reversed(tree.words[: word.index - 1]) if one.upos in VERBS), None)
    if verb is None or not _is_said(tree, verb, word, verbs):
        return None
    own = tree.subtree(verb.index) | tree.subtree(word.index)
    return verb if own.issuperset(range(verb.index, word.index)) else None


def _noun_behind(tree: DependencyTree, word: Word, length: int) -> Optional[Word]:
    """Return the head of the noun phrase that begins right behind a word."""
    position = word.index + length
    if position > len(tree.words) or tree.word(position).upos in _BEGINS_NO_NOUN_PHRASE:
        return None
    noun = tree.word(position)
    while noun.head > noun.index:
        noun = tree.governor(noun)
    begins_before = any(one.index < word.index for one in tree.children(noun.index))
    return noun if noun.upos in NOMINALS and not begins_before else None


def _is_misread(tree: DependencyTree, word: Word, noun: Word, verb: Word) -> bool:
    """Whether a noun behind a preposition is the phrase of neither the preposition nor anything else."""
    if word.upos in VERBS and any(one != noun and one.upos != "PUNCT" for one in tree.children(word.index)):
        return False  # a clause: "while avoiding the hall"
    if word.deprel in _SEEN:
        return word.head == noun.index and noun.head == verb.index and noun.deprel in _OBJECT
    return noun.head in (verb.index, word.index) and noun.deprel in _MISREAD


class Masked(NamedTuple):
    """Scores that leave only some trees.

    Attributes:
        logs: row i, column j: the logarithm of the probability that word j governs word i
        relations: of the words that have only one governor left, by position
        tags: universal and Penn tags of named words, by position
    """

    logs: "Floats"
    relations: Dict[int, str]
    tags: Dict[int, Tuple[str, str]]


def masked(logs: "Floats", words: Iterable[NamedWord]) -> Masked:
    """Rule out each tree in which some words are something else than units say.

    Args:
        logs: row i, column j: the logarithm of the probability that word j governs word i
        words: that units name
    """
    found = Masked(logs.copy(), {}, {})
    for one in words:
        found.tags[one.word] = ("ADP", "RP" if one.is_particle else "IN")
        arcs = [(one.word, one.verb, "compound:prt")] if one.is_particle else [(one.word, one.noun, "case")]
        arcs += [(one.word + number, one.word, "fixed") for number in range(1, one.length)]
        arcs += [(one.noun, one.verb, "obj" if one.is_particle else "obl")] if one.noun else []
        for word, head, relation in arcs:
            found.relations[word] = relation
            found.logs[word] = np.where(np.arange(len(logs)) == head, logs[word], -np.inf)
        # What the network hung on the word, behind it, hangs elsewhere.
        found.logs[one.word + one.length :, one.word] = -np.inf
    return found
