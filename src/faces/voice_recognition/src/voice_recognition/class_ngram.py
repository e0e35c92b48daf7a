"""Writes a language as a small class trigram that is not forced into it, in ARPA format.

The probability of the words after two others is mixed from trigrams, bigrams, and single words; talk that is not for
the robot has a share of the single words.
"""

import math
from collections import defaultdict
from typing import DefaultDict, Dict, FrozenSet, Iterable, List, Optional

from voice_recognition.spoken_language import SpokenLanguage, Words, sentences

#: Shares that the shorter history gets.
FROM_BIGRAM = 0.1
FROM_UNIGRAM = 0.1
#: Share of the words of talk among single words.
OTHER_SHARE = 0.2
BEGIN, END = "<s>", "</s>"

Counts = Dict[Words, float]


def write_ngram(
    language: Optional[SpokenLanguage],
    other_words: Iterable[str],
    *,
    phrases: Iterable[Words] = (),
    without: FrozenSet[str] = frozenset(),
    other_share: float = OTHER_SHARE,
) -> str:
    """Return the model.

    Args:
        language: what can be said to the robot; each template weighs the same, however many fillers it has; None for
            the phrases alone
        other_words: words of talk
        phrases: what can be said besides, such as "stop"
        without: words that nobody can pronounce
        other_share: share of the words of talk among single words
    """
    counts: List[DefaultDict[Words, float]] = [defaultdict(float) for _ in range(3)]
    by_template: DefaultDict[int, List[Words]] = defaultdict(list)
    for template, _, words in sentences(language) if language is not None else ():
        if not without & set(words):
            by_template[id(template)].append(words)
    for ways in [*by_template.values(), *([phrase] for phrase in phrases)]:
        for words in ways:
            marked = (BEGIN, *words, END)
            for order in range(3):
                for at in range(len(marked) - order):
                    counts[order][marked[at : at + order + 1]] += 1.0 / len(ways)
    return _arpa([dict(one) for one in counts], sorted(set(other_words) - without), other_share)


def _arpa(counts: List[Counts], others: List[str], other_share: float) -> str:
    unigrams = _unigrams(counts[0], others, other_share)
    bigrams = _mixed(counts[1], unigrams, FROM_UNIGRAM)
    trigrams = _mixed(counts[2], bigrams, FROM_BIGRAM)
    begins = {gram[:-1] for gram in bigrams}
    pairs = {gram[:-1] for gram in trigrams}
    lines = ["\\data\\", f"ngram 1={len(unigrams) + 1}", f"ngram 2={len(bigrams)}", f"ngram 3={len(trigrams)}", ""]
    lines += ["\\1-grams:", f"-99 {BEGIN} {math.log10(FROM_UNIGRAM):.4f}"]
    for gram in sorted(unigrams):
        lines.append(_line(unigrams[gram], gram, FROM_UNIGRAM if gram in begins else 1.0))
    lines += ["", "\\2-grams:"]
    for gram in sorted(bigrams):
        lines.append(_line(bigrams[gram], gram, FROM_BIGRAM if gram in pairs else 1.0))
    lines += ["", "\\3-grams:"]
    lines += [f"{math.log10(trigrams[gram]):.4f} {' '.join(gram)}" for gram in sorted(trigrams)]
    return "\n".join([*lines, "", "\\end\\", ""])


def _line(probability: float, gram: Words, backoff: float) -> str:
    return f"{math.log10(probability):.4f} {' '.join(gram)} {math.log10(backoff):.4f}"


def _unigrams(counts: Counts, others: List[str], other_share: float) -> Counts:
    total = sum(count for gram, count in counts.items() if gram != (BEGIN,))
    found = {gram: (1 - other_share) * count / total for gram, count in counts.items() if gram != (BEGIN,)}
    for word in [*others, END]:
        found[word,] = found.get((word,), 0.0) + other_share / (len(others) + 1)
    return found


def _mixed(counts: Counts, lower: Counts, share: float) -> Counts:
    """Return probabilities of the last words after the others, mixed with those after a shorter history."""
    totals: DefaultDict[Words, float] = defaultdict(float)
    for gram, count in counts.items():
        totals[gram[:-1]] += count
    return {
        gram: (1 - share) * count / totals[gram[:-1]] + share * _lower(lower, gram[1:])
        for gram, count in counts.items()
    }


def _lower(lower: Counts, gram: Words) -> float:
    return lower.get(gram, 0.0)
