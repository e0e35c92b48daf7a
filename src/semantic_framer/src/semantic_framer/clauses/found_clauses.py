"""The clauses of a sentence, also of one in which the parser found no verb."""

from typing import Optional, Tuple

from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.sentence import Sentence
from utterance_passes.engine.trace import Trace
from utterance_passes.phrases.clauses import Clause, whole_sentence
from utterance_passes.phrases.verb_matching import match_verbs


def found_clauses(
    sentence: Sentence, clauses: Tuple[Clause, ...], known: FramedLexicon, trace: Optional[Trace]
) -> Tuple[Clause, ...]:
    """Return the clauses of the sentence; if the parser found no verb, a verb of the lexicon at the front ("High
    five!") makes a clause.

    Args:
        sentence: the sentence
        clauses: what ``find_clauses`` finds in it
        known: lexical units and frames
        trace: receives a line if a verb at the front makes a clause; None for no trace
    """
    tree = sentence.tree
    is_off = "verb_at_the_front" in known.without
    if is_off or (clauses and any(match_verbs(tree, clause, known) for clause in clauses)):
        return clauses
    words = [
        word
        for word in tree.words
        if word.upos != "PUNCT" and (word.upos != "INTJ" or len(tree.words) < 3)
        if word.index not in sentence.abandoned
    ]
    if words:
        front = whole_sentence(tree, words[0].index)
        if match_verbs(tree, front, known):
            if trace is not None:
                verb = tree.word(front.verb).form
                trace.add("verb_at_the_front", verb, after="a verb, though the parser saw none")
            return (front,)
    return clauses
