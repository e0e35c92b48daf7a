"""Frames of relative clauses: "the tv that is on the table" says where the tv is, although nobody asks for that."""

from typing import List, Sequence, Tuple

from semantic_framer.filling.matching import match_units
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.reading import Reading, rank
from semantic_framer.values.sentence import Sentence
from utterance_passes.phrases.clauses import Clause, clause_of
from utterance_passes.phrases.verb_matching import match_verbs
from utterance_passes.trees.tree import VERBS
from word_classes import word_class

_RELATIVE_ADVERBS = word_class("relative_adverbs")


def relative_clauses(sentence: Sentence, clauses: Sequence[Clause]) -> Tuple[Clause, ...]:
    """Find the relative clauses inside the clauses of a request.

    Args:
        sentence: the sentence
        clauses: the clauses that ask for something
    """
    asked = {clause.verb for clause in clauses}
    inside = frozenset().union(*(clause.positions for clause in clauses))
    found: List[Clause] = []
    for word in sentence.tree.words:
        if word.deprel != "acl:relcl" or word.index not in inside:
            continue
        copula = next((child for child in sentence.children(word.index) if child.deprel == "cop"), None)
        verb = copula or word
        if verb.upos in VERBS and verb.index not in asked:
            positions = frozenset(
                index for index in sentence.subtree(word.index) if sentence.word(index).said not in _RELATIVE_ADVERBS
            )
            found.append(clause_of(sentence.tree, verb.index, positions, False))
    return tuple(clause for clause in found if clause.subject)


def descriptions(sentence: Sentence, clauses: Sequence[Clause], known: FramedLexicon) -> Tuple[Reading, ...]:
    """Return the frames that relative clauses evoke; they are not steps of the request.

    Only a unit that asks for the subject describes a state instead of a command: "the mug that stands on the table".
    """
    found: List[Reading] = []
    for clause in relative_clauses(sentence, clauses):
        readings = [
            reading
            for reading in match_units(sentence, clause, match_verbs(sentence.tree, clause, known), known)
            if not reading.missing
            and not reading.left_over
            and any(clause.subject in value.positions for value in reading.arguments)
        ]
        found += sorted(readings, key=rank)[:1]
    return tuple(found)
