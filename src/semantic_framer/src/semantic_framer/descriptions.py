"""What a sentence says of things on the way: "the tv that is on the table" is located, though nobody asks for that."""

from typing import List, Mapping, Sequence, Tuple

from semantic_frames.frame import SemanticFrame

from semantic_framer.clauses import Clause, clause_of
from semantic_framer.lexicon import Lexicon
from semantic_framer.matching import Reading, read_clause
from semantic_framer.ranking import rank
from semantic_framer.sentence import Sentence

#: They only join a relative clause to its noun: "the bathroom where the door is on the right".
_RELATIVE_ADVERBS = frozenset(["where", "when", "why"])


def relative_clauses(sentence: Sentence, clauses: Sequence[Clause]) -> Tuple[Clause, ...]:
    """Find the relative clauses inside of what is asked for.

    Args:
        sentence: the sentence
        clauses: what it asks for
    """
    asked = {clause.verb for clause in clauses}
    inside = frozenset().union(*(clause.positions for clause in clauses))
    found: List[Clause] = []
    for word in sentence.tree.words:
        if word.deprel != "acl:relcl" or word.index not in inside:
            continue
        copula = next((child for child in sentence.children(word.index) if child.deprel == "cop"), None)
        verb = copula or word
        if verb.upos in ("VERB", "AUX") and verb.index not in asked:
            positions = frozenset(
                index
                for index in sentence.subtree(word.index)
                if sentence.word(index).form.lower() not in _RELATIVE_ADVERBS
            )
            found.append(clause_of(sentence, verb.index, positions, False))
    return tuple(clause for clause in found if clause.subject)


def descriptions(
    sentence: Sentence, clauses: Sequence[Clause], lexicon: Lexicon, frames: Mapping[str, SemanticFrame]
) -> Tuple[Reading, ...]:
    """Return the frames that relative clauses evoke; they are no steps of what is asked for.

    Only a unit that asks for the subject is about what is, and no command: "the mug that stands on the table".
    """
    found: List[Reading] = []
    for clause in relative_clauses(sentence, clauses):
        readings = [
            reading
            for reading in read_clause(sentence, clause, lexicon, frames)
            if not reading.missing
            and not reading.left_over
            and any(clause.subject in value.positions for value in reading.values)
        ]
        found += sorted(readings, key=rank)[:1]
    return tuple(found)
