"""Generates annotated command sentences: builds trees from the frames and writes them in several styles."""

import random
from dataclasses import dataclass, replace
from typing import FrozenSet, Iterator, List, Set, Type

from .clauses import Clauses
from .conllu import Sentence, problems
from .conventions import settled, unclear
from .elaborate import Elaborate
from .errors import TrainingError
from .lexicon import EVALUATION, TRAINING, Lexicon, evaluation_words
from .mining import Mined
from .nouns import Nouns
from .sentences import Sentences
from .trees import Node, flatten
from .verbs import Verbs

LONGEST = 32  # words; longer sentences are drawn again
_QUESTIONS = ("modal", "mind", "question")


@dataclass(frozen=True)
class Style:
    """How an utterance is written: capital first letter, final punctuation, names in lower case."""

    capital: bool
    final: bool
    lower_names: bool


CANONICAL = Style(True, True, False)
SPOKEN = Style(False, False, True)


def draw_style(chooser: random.Random) -> Style:
    """Draw a style: 35 % written, 10 % without full stop, 10 % in lower case with it, 45 % as from a recogniser."""
    draw = chooser.random()
    if draw < 0.35:
        return CANONICAL
    if draw < 0.45:
        return Style(True, False, False)
    if draw < 0.55:
        return Style(False, True, chooser.random() < 0.6)
    return Style(False, False, chooser.random() < 0.8)


def write_out(root: Node, style: Style, mark: str, comments: List[str]) -> Sentence:
    """Write a tree as a sentence in a style; ``mark`` is its final punctuation if the style has any.

    Without final punctuation there are no commas either: recognisers write none, and people who leave out one leave out
    the other.
    """
    if not style.final:
        root = _without_commas(root)
    else:
        root = root.post("punct", Node(mark, mark, "PUNCT", ".", tight=True))
    sentence = flatten(root)
    words = list(sentence.words)
    if style.lower_names:
        words = [replace(word, form=word.form.lower()) for word in words]
    if style.capital:
        words[0] = replace(words[0], form=words[0].form[:1].upper() + words[0].form[1:])
    spans = tuple(
        replace(span, form="".join(word.form for word in words[span.first - 1 : span.last])) for span in sentence.spans
    )
    return Sentence(tuple(words), spans, tuple(comments))


def _without_commas(node: Node) -> Node:
    return replace(
        node,
        left=tuple(_without_commas(child) for child in node.left if child.form != ","),
        right=tuple(_without_commas(child) for child in node.right if child.form != ","),
    )


def _asks(root: Node) -> bool:
    """Whether an utterance is a question: an interrogative at its root, or a verb before its subject."""
    words = [part for part in root.left if part.rel not in ("vocative", "discourse", "punct")]
    if root.xpos in ("WRB", "WP") or any(part.xpos == "WP" for part in words[:1]):
        return True
    if any(part.rel == "expl" for part in root.right):
        return True
    return bool(words) and words[0].upos == "AUX" and any(part.rel.startswith("nsubj") for part in words)


def builder(
    chooser: random.Random, lexicon: Lexicon, mined: Mined, wide: float, kind: Type[Sentences] = Sentences
) -> Sentences:
    """A sentence builder over a lexicon; ``wide`` is the share of mined and made-up words (0 to 1)."""
    nouns = Nouns(chooser, lexicon, mined, wide)
    clauses = Clauses(chooser, nouns)
    return kind(chooser, nouns, clauses, Verbs(chooser, nouns, clauses))


def generate(
    count: int,
    seed: int,
    lexicon: Lexicon,
    mined: Mined,
    wide: float,
    prefix: str,
    banned: FrozenSet[str] = frozenset(),
    kind: Type[Sentences] = Sentences,
) -> Iterator[Sentence]:
    """Return ``count`` different sentences without ``banned`` words, each as one paragraph.

    Raises TrainingError if a frame builds something that is not a tree, which is a mistake in the frame.
    """
    chooser = random.Random(seed)
    build = builder(chooser, lexicon, mined, wide, kind)
    seen: Set[str] = set()
    made = 0
    tries = 0
    while made < count:
        tries += 1
        if tries > 60 * count + 1000:
            raise TrainingError(f"the frames yield only {made} different sentences; asked for {count}")
        root = settled(build.utterance())
        if len(root.parts()) > LONGEST or unclear(root):
            continue
        style = draw_style(chooser)
        mark = "?" if _asks(root) else "!" if chooser.random() < 0.08 else "."
        sentence = write_out(root, style, mark, [])
        if any(word.form.lower() in banned or word.lemma.lower() in banned for word in sentence.words):
            continue  # a made-up word may happen to be a real one
        text = sentence.text()
        if text in seen:
            # Short utterances recur; a few repetitions are wanted, because people say them most.
            if len(sentence.words) > 2 or chooser.random() > 0.3:
                continue
        seen.add(text)
        wrong = problems(sentence)
        if wrong:
            raise TrainingError("generated sentence is no tree: {}: {}".format(text, "; ".join(wrong)))
        made += 1
        yield replace(sentence, comments=("newpar", f"sent_id = {prefix}-{made:06d}", "text = " + text))


def training(count: int, seed: int, mined: Mined, wide: float = 0.32) -> Iterator[Sentence]:
    """Sentences to train on."""
    return generate(count, seed, TRAINING, mined, wide, "command", evaluation_words())


def elaborate(count: int, seed: int, mined: Mined, wide: float = 0.32) -> Iterator[Sentence]:
    """Sentences to train on in the last steps."""
    return generate(count, seed, TRAINING, mined, wide, "elaborate", evaluation_words(), Elaborate)


def evaluation(count: int, seed: int) -> Iterator[Sentence]:
    """Sentences to score on: the same frames over the evaluation lexicon, no other open-class words."""
    return generate(count, seed + 7919, EVALUATION, Mined(), 0.0, "held-out")
