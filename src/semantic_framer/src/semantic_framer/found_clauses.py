"""The clauses of a sentence, also of one in which the parser found no verb."""

from typing import Tuple

from semantic_framer.sentence import Sentence
from semantic_framer.settling import Now
from utterance_passes.clauses import Clause, find_clauses, whole_sentence
from utterance_passes.verb_matching import match_verbs


def found_clauses(sentence: Sentence, now: Now) -> Tuple[Clause, ...]:
    """Return the clauses of the sentence; if the parser found no verb, a verb of the lexicon at the front ("High
    five!") makes a clause.

    Args:
        sentence: the sentence
        now: the lexicon, and the trace
    """
    tree, known = sentence.tree, now.known
    clauses = find_clauses(tree, known)
    if clauses and any(match_verbs(tree, clause, known) for clause in clauses):
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
            now.write("verb_at_the_front", tree.word(front.verb).form, "a verb, though the parser saw none")
            return (front,)
    return clauses
