"""Words mined from treebanks, and made-up words, so that the models do not rely on a short lexicon.

An unknown word at the start of a command is a verb, and one after "the" a noun. Models learn this only from sentences
with many different words, some of them invented.
"""

import random
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from typing import Counter as Count
from typing import Dict, FrozenSet, Iterable, Tuple

from .conllu import read

_ONSETS = (
    "b bl br c ch cl cr d dr f fl fr g gl gr h j k kl l m n p pl pr qu r s sc sh sk sl sn sp st t tr v w z".split()
)
_NUCLEI = "a e i o u ai ea ee oa oo ou ie".split()
_CODAS = "b ck d ff g l ll m mp n nd ng nk p r rb rk rt sh sk sp ss st t tch x zz ble dle nt lt".split()
_TAILS = {
    "NOUN": ("", "", "er", "let", "on", "ix"),
    "VERB": ("", "", "", "ify", "ate"),
    "ADJ": ("y", "ish", "ic", ""),
    "PROPN": ("o", "a", "i", "us", ""),
}
# Verbs that need more than an object, or that are never commands.
_NOT_COMMANDS = frozenset("be have do let seem become think know believe hope wonder guess suppose want need".split())


@dataclass(frozen=True)
class Mined:
    """Lemmas found in treebanks at least twice, by class, the most frequent first."""

    transitive: Tuple[str, ...] = ()
    intransitive: Tuple[str, ...] = ()
    nouns: Tuple[str, ...] = ()
    names: Tuple[str, ...] = ()
    adjectives: Tuple[str, ...] = ()


def _kept(counts: Count[str], least: int, banned: FrozenSet[str]) -> Tuple[str, ...]:
    return tuple(
        lemma
        for lemma, count in sorted(counts.items(), key=lambda pair: (-pair[1], pair[0]))
        if count >= least and lemma.lower() not in banned and lemma.isalpha() and lemma.isascii() and len(lemma) > 2
    )


def mine(paths: Iterable[Path], banned: FrozenSet[str]) -> Mined:
    """Collect verbs, nouns, names and adjectives, without the ``banned`` words."""
    counts: Dict[str, Count[str]] = {kind: Counter() for kind in ("t", "i", "n", "p", "a")}
    for path in paths:
        for sentence in read(path):
            objects = {word.head for word in sentence.words if word.deprel == "obj"}
            barred = {word.head for word in sentence.words if word.deprel in ("xcomp", "ccomp", "compound:prt")}
            for place, word in enumerate(sentence.words, 1):
                if "Typo" in word.feats or word.lemma.lower() in _NOT_COMMANDS:
                    continue
                if word.upos == "VERB" and word.lemma.islower() and place not in barred:
                    counts["t" if place in objects else "i"][word.lemma] += 1
                elif (
                    word.upos == "NOUN" and word.xpos in ("NN", "NNS") and word.lemma.islower() and word.form.islower()
                ):
                    counts["n"][word.lemma] += 1
                elif word.upos == "PROPN" and word.xpos == "NNP" and word.form.istitle():
                    counts["p"][word.form] += 1
                elif word.upos == "ADJ" and word.xpos == "JJ" and word.form.islower() and word.form == word.lemma:
                    counts["a"][word.lemma] += 1
    return Mined(
        _kept(counts["t"], 3, banned),
        _kept(counts["i"], 3, banned),
        _kept(counts["n"], 3, banned),
        _kept(counts["p"], 2, banned),
        _kept(counts["a"], 3, banned),
    )


def nonce(chooser: random.Random, kind: str) -> str:
    """A made-up word of one or two syllables that looks like its class (``NOUN``, ``VERB``, ``ADJ``, ``PROPN``)."""
    made = ""
    for _ in range(chooser.choice((1, 1, 2))):
        made += chooser.choice(_ONSETS) + chooser.choice(_NUCLEI)
    made += chooser.choice(_CODAS) + chooser.choice(_TAILS[kind])
    return made.capitalize() if kind == "PROPN" else made
