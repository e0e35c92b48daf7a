"""Scores a packaged model: EWT test with the CoNLL 2018 evaluation, held-out commands, latency."""

import statistics
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Dict, Iterable, List, Sequence, Tuple

from .conllu import Sentence, read, write
from .pipeline import Parser, processors_of

METRICS = ("Tokens", "Sentences", "Words", "UPOS", "XPOS", "UFeats", "Lemmas", "UAS", "LAS", "CLAS", "MLAS")


def conll(gold: Path, system: Path) -> Dict[str, float]:
    """F1 in percent of every metric of the CoNLL 2018 shared task's evaluation."""
    from udtools.udeval import evaluate, load_conllu_file

    found = evaluate(load_conllu_file(str(gold)), load_conllu_file(str(system)))
    return {metric: 100.0 * found[metric].f1 for metric in METRICS}


def on_gold_words(model: Path, gold: Path) -> Dict[str, float]:
    """Return the scores on a treebank with its words given and everything else predicted."""
    sentences = [Sentence(sentence.words) for sentence in read(gold)]
    parsed = Parser(model, pretokenized=True).words([[word.form for word in one.words] for one in sentences])
    with tempfile.TemporaryDirectory() as folder:
        wanted, got = Path(folder) / "gold.conllu", Path(folder) / "system.conllu"
        write(wanted, sentences)
        write(got, parsed)
        return conll(wanted, got)


def on_raw_text(model: Path, gold: Path) -> Dict[str, float]:
    """Return the scores on a treebank from its running text, as published figures are measured."""
    import stanza
    import torch

    torch.set_num_threads(1)
    run = stanza.Pipeline(
        "en",
        dir=str(model),
        package=None,
        processors=processors_of(model),
        download_method=None,
        use_gpu=False,
        logging_level="ERROR",
    )
    paragraphs: List[str] = []
    for sentence in read(gold):
        starts = any(line.startswith(("newpar", "newdoc")) for line in sentence.comments)
        if starts or not paragraphs:
            paragraphs.append(sentence.comment("text"))
        else:
            paragraphs[-1] += " " + sentence.comment("text")
    document = run("\n\n".join(paragraphs))
    for one in document.sentences:
        for token in one.tokens:
            if "<UNK>" in token.text:
                # the tokenizer cuts over-long strings, but the evaluation needs the same characters
                token.text = document.text[token.start_char : token.end_char].replace(" ", "")
                if len(token.words) == 1:
                    token.words[0].text = token.text
    with tempfile.TemporaryDirectory() as folder:
        got = Path(folder) / "system.conllu"
        got.write_text(format(document, "C") + "\n\n", encoding="utf-8")
        return conll(gold, got)


@dataclass(frozen=True)
class Commands:
    """Numbers of right commands, words and trees."""

    sentences: int
    words: int
    trees: int
    roots: int
    tags: int
    heads: int
    labelled: int
    failures: Tuple[str, ...]

    def percent(self) -> Dict[str, float]:
        """Figures for the model card."""
        part = 100.0 / max(1, self.sentences)
        word = 100.0 / max(1, self.words)
        return {
            "whole tree right": part * self.trees,
            "root right": part * self.roots,
            "UPOS": word * self.tags,
            "UAS": word * self.heads,
            "LAS": word * self.labelled,
        }


def on_commands(model: Path, gold: Iterable[Sentence]) -> Commands:
    """Return the scores on commands whose words are given; punctuation does not count."""
    wanted = list(gold)
    parsed = Parser(model, pretokenized=True).words([[word.form for word in one.words] for one in wanted])
    words = trees = roots = tags = heads = labelled = 0
    failures: List[str] = []
    for one, two in zip(wanted, parsed):
        wrong: List[str] = []
        for left, right in zip(one.words, two.words):
            if left.upos == "PUNCT":
                continue
            words += 1
            tags += left.upos == right.upos
            heads += left.head == right.head
            labelled += (left.head, left.deprel) == (right.head, right.deprel)
            if (left.head, left.deprel) != (right.head, right.deprel):
                wrong.append(
                    "{} {}->{} (gold {}->{})".format(
                        left.form,
                        right.deprel,
                        two.words[right.head - 1].form if right.head else "ROOT",
                        left.deprel,
                        one.words[left.head - 1].form if left.head else "ROOT",
                    )
                )
            if left.head == 0:
                roots += right.head == 0
        trees += not wrong
        if wrong:
            failures.append("{} | {}".format(one.text(), "; ".join(wrong)))
    return Commands(len(wanted), words, trees, roots, tags, heads, labelled, tuple(failures))


def latency(model: Path, texts: Sequence[str]) -> Tuple[float, float]:
    """Return the milliseconds per command after warm-up: median and 95th percentile, one thread."""
    parser = Parser(model)
    for text in texts[:5]:
        parser.text(text)
    spent: List[float] = []
    for text in texts:
        started = time.perf_counter()
        parser.text(text)
        spent.append(1000.0 * (time.perf_counter() - started))
    spent.sort()
    return statistics.median(spent), spent[int(0.95 * (len(spent) - 1))]
