"""Condenses the training file of the lemmatizer: each form occurs a few times instead of once per occurrence."""

import math
from collections import Counter
from pathlib import Path
from typing import Counter as Count
from typing import Iterable, List, Tuple

from .conllu import Sentence, Word, read, write

WORDS_PER_SENTENCE = 20


def condense(sources: Iterable[Path], target: Path) -> int:
    """Write each (form, tag, lemma) of the sources 1 + log2(count) times; return the number of words.

    The lemmatizer trains on occurrences and would learn "the" ten thousand times. The output consists of lists of
    words, not of real sentences: every word depends on the first, because the lemmatizer reads no heads.
    """
    counts: Count[Tuple[str, str, str, str]] = Counter()
    for source in sources:
        for sentence in read(source):
            for word in sentence.words:
                if "Typo=Yes" not in word.feats and word.lemma != "_":
                    counts[(word.form, word.upos, word.xpos, word.lemma)] += 1
    repeated: List[Tuple[str, str, str, str]] = []
    for key, count in sorted(counts.items()):
        repeated += [key] * (1 + int(math.log2(count)))
    sentences = []
    for start in range(0, len(repeated), WORDS_PER_SENTENCE):
        words = tuple(
            Word(form, lemma, upos, xpos, "_", 0 if at == 0 else 1, "root" if at == 0 else "dep")
            for at, (form, upos, xpos, lemma) in enumerate(repeated[start : start + WORDS_PER_SENTENCE])
        )
        sentences.append(Sentence(words))
    write(target, sentences)
    return len(repeated)
