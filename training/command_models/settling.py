"""Trains a tagger or a parser for its last steps, at a low learning rate, with a moving average of its weights.

Single steps vary by two points; their average does not.

Stanza's tagger has no option to continue from a trained model, and its parser none to average; this module does both
with Stanza's classes. It runs in a separate process: ``settling tagger|parser SOURCE TARGET VECTORS DEV STEPS SEED
TRAIN...``.
"""

import io
import shutil
import sys
from abc import ABC, abstractmethod
from pathlib import Path
from typing import TYPE_CHECKING, Any, Dict, Iterator, List, Sequence, Type

if TYPE_CHECKING:
    import torch

EVERY = 100  # steps between two evaluations on the development set


class Settled(ABC):
    """A trained model with its training and development sentences."""

    rate: float
    decay: float  # of the average per step; lower at the start
    trainer: Any  # a Stanza object, which has no types

    @abstractmethod
    def __init__(self, source: Path, vectors: Path, dev: Path, train: Sequence[Path]) -> None:
        """Load a model and the sentences."""

    @abstractmethod
    def batches(self) -> Iterator[object]:
        """Return training sentences without end, shuffled."""

    @abstractmethod
    def update(self, batch: object) -> float:
        """Make one step, and return its loss."""

    @abstractmethod
    def score(self) -> float:
        """Return the share of development words that are right."""


class SettledTagger(Settled):
    """Right is a word whose tags and features are all right."""

    rate = 0.0004
    decay = 0.985
    _BATCH = 64

    def __init__(self, source: Path, vectors: Path, dev: Path, train: Sequence[Path]) -> None:
        from stanza.models.common.doc import Document
        from stanza.models.common.pretrain import Pretrain
        from stanza.models.pos.data import Dataset, ShuffledDataset
        from stanza.models.pos.trainer import Trainer
        from stanza.utils.conll import CoNLL

        pretrain = Pretrain(str(vectors))
        self.trainer = Trainer(model_file=str(source), pretrain=pretrain, args={"lr": self.rate}, device="cpu")
        arguments = (self.trainer.args, pretrain)
        options = {"vocab": self.trainer.vocab, "tag_columns": self.trainer.args["tag_columns"]}
        documents = [Document(CoNLL.conll2dict(input_file=str(path))[0]) for path in train]
        parts = [Dataset(document, *arguments, evaluation=False, **options) for document in documents]
        self._train = ShuffledDataset(parts, self._BATCH)
        self._gold = dev
        document = CoNLL.conll2doc(input_file=str(dev))
        self._dev = Dataset(document, *arguments, evaluation=True, sort_during_eval=True, **options)

    def batches(self) -> Iterator[object]:
        while True:
            yield from self._train

    def update(self, batch: object) -> float:
        return float(self.trainer.update(batch, eval=False))

    def score(self) -> float:
        from stanza.models import tagger
        from stanza.models.common import utils
        from stanza.models.pos import scorer

        predictions: List[object] = []
        indices: List[int] = []
        for batch in self._dev.to_loader(batch_size=self._BATCH):
            found, _ = self.trainer.predict(batch, extra_columns=True)
            predictions += found
            indices.extend(batch.idx)
        tagger.set_predictions(self._dev.doc, self.trainer, utils.unsort(predictions, indices), None)
        text = io.StringIO(format(self._dev.doc, "C") + "\n\n")
        return float(scorer.score(text, str(self._gold), eval_type="AllTags")[2])


class SettledParser(Settled):
    """Right is a word with the right head and relation, by the tags of the treebank."""

    rate = 0.0005
    decay = 0.995
    _WORDS = 1000  # of a batch

    def __init__(self, source: Path, vectors: Path, dev: Path, train: Sequence[Path]) -> None:
        from stanza.models.common.doc import Document
        from stanza.models.common.pretrain import Pretrain
        from stanza.models.depparse.data import DataLoader, InfiniteBatch
        from stanza.models.depparse.trainer import Trainer
        from stanza.utils.conll import CoNLL

        pretrain = Pretrain(str(vectors))
        settings = {"lr": self.rate}
        self.trainer = Trainer.load(str(source), pretrain, args=settings, device="cpu", reset_history=True)
        options = {"args": self.trainer.args, "pretrain": pretrain, "vocab": self.trainer.vocab}
        sentences = [sentence for path in train for sentence in CoNLL.conll2dict(input_file=str(path))[0]]
        self._train = InfiniteBatch(DataLoader(Document(sentences), self._WORDS, evaluation=False, **options))
        self._gold = dev
        document = CoNLL.conll2doc(input_file=str(dev))
        self._dev = DataLoader(document, self._WORDS, evaluation=True, sort_during_eval=True, **options)

    def batches(self) -> Iterator[object]:
        while True:
            yield self._train.next_batch()

    def update(self, batch: object) -> float:
        loss, _ = self.trainer.update(batch, eval=False)
        return float(loss)

    def score(self) -> float:
        from stanza.models.common.doc import DEPREL, HEAD
        from stanza.models.depparse import scorer
        from stanza.models.depparse.utils import predict_dataset

        found = predict_dataset(self.trainer, self._dev)
        self._dev.doc.set([HEAD, DEPREL], [word for sentence in found for word in sentence])
        text = io.StringIO(format(self._dev.doc, "C") + "\n\n")
        return float(scorer.score(text, str(self._gold))[2])


KINDS: Dict[str, Type[Settled]] = {"tagger": SettledTagger, "parser": SettledParser}


def settle(
    kind: str, source: Path, target: Path, vectors: Path, dev: Path, steps: int, seed: int, train: Sequence[Path]
) -> None:
    """Train on from ``source`` over the files of ``train``; the best state on ``dev``, be it the source, goes to
    ``target``.
    """
    from stanza.models.common import utils

    utils.set_random_seed(seed)
    settled = KINDS[kind](source, vectors, dev, train)
    best = settled.score()
    print(f"before: dev_score = {best:.4f}", flush=True)
    # The first steps lose what the optimizer had learned; if later steps do not make up for it, the source stays best.
    shutil.copyfile(str(source), str(target))
    weights = {name: weight for name, weight in settled.trainer.model.named_parameters() if weight.requires_grad}
    average = {name: weight.detach().clone() for name, weight in weights.items()}
    for step, batch in enumerate(settled.batches(), 1):
        loss = settled.update(batch)
        decay = min(settled.decay, (1.0 + step) / (10.0 + step))
        for name, weight in weights.items():
            average[name].mul_(decay).add_(weight.detach(), alpha=1.0 - decay)
        if step % 20 == 0:
            print(f"Finished STEP {step}/{steps}, loss = {loss:.4f}", flush=True)
        if step % EVERY == 0 or step == steps:
            current = _exchanged(weights, average)
            found = settled.score()
            print(f"step {step}: dev_score = {found:.4f}", flush=True)
            if found >= best:
                best = found
                settled.trainer.save(str(target))
            _exchanged(weights, current)
        if step >= steps:
            return


def _exchanged(weights: Dict[str, "torch.nn.Parameter"], new: Dict[str, "torch.Tensor"]) -> Dict[str, "torch.Tensor"]:
    """Set the weights to other values and return the old ones."""
    kept = {name: weight.detach().clone() for name, weight in weights.items()}
    for name, weight in weights.items():
        weight.data.copy_(new[name])
    return kept


def main(arguments: Sequence[str]) -> int:
    """Run the step."""
    kind, source, target, vectors, dev, steps, seed = arguments[:7]
    train = [Path(path) for path in arguments[7:]]
    settle(kind, Path(source), Path(target), Path(vectors), Path(dev), int(steps), int(seed), train)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
