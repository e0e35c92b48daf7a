"""Finds the verbs of the lexicon that a clause uses, particles included."""

from dataclasses import dataclass
from typing import List, Optional, Sequence, Tuple

from utterance_passes.phrases.clauses import Clause
from utterance_passes.trees.tree import DependencyTree
from utterance_passes.trees.vocabulary import Speech, Vocabulary

#: Relations of the other words of a verb: "turn the light *on*", "turn left *to* *face* the door".
_PARTICLES = frozenset(["compound:prt", "advmod", "advcl", "case", "mark", "obl", "obj", "xcomp", "amod"])


@dataclass(frozen=True)
class VerbMatch:
    """A verb of the lexicon in a clause, and the positions of its words."""

    verb: str
    positions: Tuple[int, ...]


def match_verbs(tree: DependencyTree, clause: Clause, vocabulary: Vocabulary) -> Tuple[VerbMatch, ...]:
    """Find the verbs of the lexicon that a clause uses, verbs of more words first."""
    word = tree.word(clause.verb)
    found: List[VerbMatch] = []
    for base in dict.fromkeys((word.lemma.lower(), word.said)):
        for verb in vocabulary.verbs_beginning_with(base):
            positions = _verb_positions(tree, clause, verb.split()[1:])
            if positions is not None and all(verb != match.verb for match in found):
                found.append(VerbMatch(verb, (clause.verb,) + positions))
    return tuple(sorted(found, key=lambda match: -len(match.verb.split())))


def _verb_positions(tree: DependencyTree, clause: Clause, particles: Sequence[str]) -> Optional[Tuple[int, ...]]:
    """Find the particles of a verb: beside it, after its object ("pick it up"), or as a preposition ("look for").

    Of several, the one right before the next particle is meant: "turn to the right *to face* the sink".
    """
    found: List[int] = []
    after = clause.verb
    for particle, following in zip(particles, [*particles[1:], ""]):
        possible = [
            index
            for index in sorted(clause.positions)
            if index > after
            and _form(tree, index) == particle
            and (index == after + 1 or tree.word(index).deprel in _PARTICLES)
            and (index == after + 1 or _is_near(tree, clause, index))
        ]
        if not possible:
            return None
        together = (one for one in possible if one + 1 in clause.positions and _form(tree, one + 1) == following)
        after = next(together, possible[0])
        found.append(after)
    return tuple(found)


def _form(tree: DependencyTree, index: int) -> str:
    return tree.word(index).said


def _is_near(tree: DependencyTree, clause: Clause, index: int) -> bool:
    """Whether the head of a word is the verb or a phrase of the verb: "check whether it is on" has no "check on", nor
    has "check whether I left it on"."""
    head = tree.governor(tree.word(index)) if tree.word(index).head else None
    if head is None or head.index == clause.verb:
        return head is not None
    is_particle = tree.word(index).deprel in ("case", "compound:prt")
    is_of_a_clause = is_particle and head.deprel in ("ccomp", "xcomp", "advcl")
    return head.head == clause.verb and not is_of_a_clause


@dataclass(frozen=True)
class Saying:
    """A verb of saying: its clause, its last word, and how it names its addressee."""

    clause: Clause
    last: int
    speech: Speech


def has_verb_of_saying(tree: DependencyTree, vocabulary: Vocabulary) -> bool:
    """Whether any word may be a verb of saying; most commands have none, and then their clauses are not needed."""
    return any(
        vocabulary.speech_of(verb) is not None
        for word in tree.words
        for spelling in {word.said, word.lemma.lower()}
        for verb in vocabulary.verbs_beginning_with(spelling)
    )


def saying_of(tree: DependencyTree, clause: Clause, vocabulary: Vocabulary) -> Optional[Saying]:
    """Return the verb of saying of a clause; None if it has none."""
    for match in match_verbs(tree, clause, vocabulary):
        speech = vocabulary.speech_of(match.verb)
        if speech is not None:
            return Saying(clause, max(match.positions), speech)
    return None


def stray_clause(tree: DependencyTree, saying: Saying) -> int:
    """Return the verb of a clause right after the verb of saying that the parser attached elsewhere: "find Bob and tell
    her *lunch is ready*"; 0 if there is none.
    """
    behind = (word for word in tree.words if word.index > saying.last and word.head < saying.last)
    strays = (
        word.index
        for word in behind
        if word.deprel in ("parataxis", "conj", "ccomp")
        and word.head not in (0, saying.clause.verb)
        and tree.phrase_start(word.index) == saying.last + 1
    )
    return next(strays, 0)
