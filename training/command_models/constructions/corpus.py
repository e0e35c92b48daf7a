"""Draws sentences of the constructions, and checks every one."""

import random
from dataclasses import replace
from typing import FrozenSet, Iterator, List, Sequence, Set, Tuple

from command_models.conllu import Sentence
from command_models.conventions import settled, unclear
from command_models.errors import TrainingError
from command_models.generate import draw_style, write_out
from command_models.lexicon import EVALUATION, TRAINING, Lexicon, evaluation_words
from command_models.mining import Mined
from command_models.trees import Node

from . import commands, embedded, phrasal, questions, scored_only, subordinate  # noqa: F401  (they enter themselves)
from .phrases import Phrases
from .registry import ENTERED, STRANDED, Construction
from .units import Unit
from .validity import violations

LONGEST = 34
#: Sentences of each construction that is for scoring.
SCORED_EACH = 60


def constructions(*, scored: bool) -> List[Construction]:
    """Return the constructions that are taught, or those for scoring alone, by name."""
    return [one for _, one in sorted(ENTERED.items()) if one.scored == scored]


def sentence_of(one: Construction, root: Node, chooser: random.Random) -> Sentence:
    """Write a tree as a sentence, in a style that is drawn."""
    mark = "!" if one.mark == "." and chooser.random() < 0.06 else one.mark
    sentence = write_out(root, draw_style(chooser), mark, [])
    return _hung(sentence)


def _hung(sentence: Sentence) -> Sentence:
    """Hang a preposition at the end on the question word in front, as its case."""
    words = list(sentence.words)
    for place, word in enumerate(words):
        if word.deprel == STRANDED:
            front = next(n for n, other in enumerate(words, 1) if other.head == word.head and other.deprel == "obl")
            words[place] = replace(word, head=front, deprel="case")
    return replace(sentence, words=tuple(words))


def draw(
    phrases: Phrases, one: Construction, chooser: random.Random, banned: FrozenSet[str], *, clear: bool = False
) -> Tuple[Sentence, str]:
    """Draw one sentence of a construction without banned words, and its text.

    Args:
        phrases: pieces
        one: the construction
        chooser: draws
        banned: words that it must not have
        clear: leave out what may be read in two ways

    Raises:
        TrainingError: it is no valid tree, which is a mistake in the construction
    """
    for _ in range(200):
        root = settled(one.build(phrases))
        if len(root.parts()) > LONGEST or (clear and unclear(root)):
            continue
        sentence = sentence_of(one, root, chooser)
        if any(word.form.lower() in banned or word.lemma.lower() in banned for word in sentence.words):
            continue
        wrong = violations(sentence, projective=one.projective)
        text = sentence.text()
        if wrong:
            raise TrainingError(f"construction {one.name}: {text}: {'; '.join(wrong)}")
        return sentence, text
    raise TrainingError(f"construction {one.name}: no sentence of at most {LONGEST} words without banned words")


def _drawn(
    table: Sequence[Construction],
    counts: Sequence[int],
    phrases: Phrases,
    chooser: random.Random,
    banned: FrozenSet[str],
    prefix: str,
    clear: bool,
) -> Iterator[Sentence]:
    seen: Set[str] = set()
    number = 0
    for one, count in zip(table, counts):
        made = 0
        for _ in range(20 * count + 100):
            if made == count:
                break
            sentence, text = draw(phrases, one, chooser, banned, clear=clear)
            if text.lower() in seen:
                continue
            seen.add(text.lower())
            made += 1
            number += 1
            comments = ("newpar", f"sent_id = {prefix}-{number:06d}", f"construction = {one.name}", f"text = {text}")
            yield replace(sentence, comments=comments)


def taught(count: int, seed: int, mined: Mined, units: Sequence[Unit], wide: float = 0.3) -> List[Sentence]:
    """Sentences to train on, about as many as asked for, without words of the evaluation lexicon."""
    chooser = random.Random(seed)
    table = constructions(scored=False)
    phrases = Phrases(chooser, TRAINING, mined, wide, units)
    whole = sum(one.weight for one in table)
    counts = [round(count * one.weight / whole) for one in table]
    sentences = list(_drawn(table, counts, phrases, chooser, evaluation_words(), "taught", True))
    chooser.shuffle(sentences)
    return sentences


def scored(seed: int, units: Sequence[Unit], each: int = SCORED_EACH, *, taught_too: bool = False) -> List[Sentence]:
    """Sentences to score on, over the evaluation lexicon: of the constructions that no training sentence has.

    Args:
        seed: of the draws
        units: the verbs
        each: sentences of each construction
        taught_too: of the constructions that are taught instead, over words that are not
    """
    chooser = random.Random(seed)
    lexicon: Lexicon = EVALUATION
    table = constructions(scored=not taught_too)
    phrases = Phrases(chooser, lexicon, Mined(), 0.0, units)
    return list(_drawn(table, [each] * len(table), phrases, chooser, frozenset(), "scored", False))
