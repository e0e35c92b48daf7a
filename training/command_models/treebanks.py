"""Selects and cleans the treebanks for training."""

import random
from dataclasses import dataclass, replace
from pathlib import Path
from typing import FrozenSet, Iterable, Iterator, List

from .conllu import Sentence, read
from .errors import TrainingError

_ADULTS = frozenset("Mother Father Investigator Grandmother Grandfather".split())
# EWT's present names of relations that have older names in other treebanks
_RENAMED = {
    "obl:tmod": "obl:unmarked",
    "obl:npmod": "obl:unmarked",
    "nmod:tmod": "nmod:unmarked",
    "nmod:npmod": "nmod:unmarked",
}
_UNWANTED_RELATIONS = frozenset(("dep", "reparandum"))
OTHERS = 6000  # spoken sentences that are not imperatives


@dataclass(frozen=True)
class Written:
    """The three parts of UD_English-EWT."""

    train: Path
    dev: Path
    test: Path


def written(folder: Path) -> Written:
    """Return the EWT files of a folder; raises TrainingError with the name of a missing one."""
    paths = [folder / (f"en_ewt-{part}.conllu") for part in ("train", "dev", "test")]
    for path in paths:
        if not path.is_file():
            raise TrainingError(f"{path}: no such file; expected the folder of UD_English-EWT")
    return Written(*paths)


def without(sentences: Iterable[Sentence], banned: FrozenSet[str]) -> Iterator[Sentence]:
    """Return the sentences without banned words, as form or as lemma."""
    for sentence in sentences:
        if not any(word.lemma.lower() in banned or word.form.lower() in banned for word in sentence.words):
            yield sentence


def _usable(sentence: Sentence) -> bool:
    role = sentence.comment("speaker_role")
    if role and role not in _ADULTS:
        return False
    if len(sentence.words) < 3 or any(word.deprel in _UNWANTED_RELATIONS for word in sentence.words):
        return False
    return not any("+" in word.form or "_" in word.form or word.form.lower() == "xxx" for word in sentence.words)


def _imperative(sentence: Sentence) -> bool:
    return sentence.words[0].xpos == "VB" and sentence.words[0].deprel == "root"


def spoken(folder: Path, banned: FrozenSet[str], seed: int) -> List[Sentence]:
    """Adult speech of UD_English-CHILDES (every ``*.conllu`` below the folder).

    All imperatives and up to OTHERS other sentences, relations renamed to EWT's.  A selection made before
    passes through unchanged. Raises TrainingError when nothing is found.
    """
    paths = sorted(folder.glob("**/*.conllu"))
    kept = [sentence for path in paths for sentence in without(read(path), banned) if _usable(sentence)]
    if not kept:
        raise TrainingError(f"{folder}: no usable sentence in *.conllu below; expected UD_English-CHILDES")
    imperatives = [sentence for sentence in kept if _imperative(sentence)]
    others = [sentence for sentence in kept if not _imperative(sentence)]
    random.Random(seed).shuffle(others)
    return [renamed(sentence) for sentence in imperatives + others[:OTHERS]]


def renamed(sentence: Sentence) -> Sentence:
    """Return the sentence with EWT's present names of relations."""
    words = tuple(replace(word, deprel=_RENAMED.get(word.deprel, word.deprel)) for word in sentence.words)
    return replace(sentence, words=words)


_SUBORDINATING_ADVERBS = frozenset("when where whenever wherever why how".split())


def as_written(sentence: Sentence) -> Sentence:
    """Return a sentence of UD_English-CHILDES with EWT's conventions.

    A second verb behind "go" and "come" is no compound but what they are for; question words stay adverbs where they
    introduce a clause; final marks have one tag; a particle is an adposition, and "back" an adverb.
    """
    words = list(sentence.words)
    for place, word in enumerate(words):
        governor = words[word.head - 1] if word.head else None
        if word.deprel == "compound" and word.upos == "VERB" and governor is not None and word.head <= place:
            word = replace(word, deprel="xcomp")
        if word.xpos == "WRB" and word.form.lower() in _SUBORDINATING_ADVERBS:
            word = replace(word, upos="ADV", deprel="advmod" if word.deprel == "mark" else word.deprel)
        if word.upos == "PUNCT" and word.xpos in ("?", "!"):
            word = replace(word, xpos=".")
        if word.deprel == "compound:prt" and word.xpos in ("RP", "IN"):
            word = replace(word, upos="ADP", xpos="RP")
        elif word.upos == "ADV" and word.xpos in ("RP", "IN"):
            word = replace(word, xpos="RB")
        if word.upos == "AUX" and word.xpos == "POS":
            word = replace(word, xpos="VBZ")
        words[place] = word
    return replace(sentence, words=tuple(words))
