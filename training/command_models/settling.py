"""Trains the tagger for its last steps, at a low learning rate, with a moving average of its weights.

Single steps vary by two points; their average does not.

Unlike Stanza's parser, its tagger has no option to continue from a trained model; this module does so with Stanza's
classes. It runs in a separate process: ``settling SOURCE TARGET VECTORS DEV STEPS SEED TRAIN...``.
"""

import io
import shutil
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any, Dict, Iterator, List, Sequence

if TYPE_CHECKING:
    import torch

RATE = 0.0004
DECAY = 0.985  # decay of the average per step; lower at the start
EVERY = 100  # steps between two evaluations on the development set
BATCH = 64


def _score(trainer: Any, data: Any, gold: Path) -> float:  # a Stanza object, which has no types
    """Return the share of development words whose tags and features are all right."""
    from stanza.models import tagger
    from stanza.models.common import utils
    from stanza.models.pos import scorer

    predictions: List[object] = []
    indices: List[int] = []
    for batch in data.to_loader(batch_size=BATCH):
        found, _ = trainer.predict(batch, extra_columns=True)
        predictions += found
        indices.extend(batch.idx)
    predictions = utils.unsort(predictions, indices)
    tagger.set_predictions(data.doc, trainer, predictions, None)
    text = io.StringIO(format(data.doc, "C") + "\n\n")
    return float(scorer.score(text, str(gold), eval_type="AllTags")[2])


def settle(source: Path, target: Path, vectors: Path, dev: Path, steps: int, seed: int, train: Sequence[Path]) -> None:
    """Train on from ``source`` over the files of ``train``; the best state on ``dev``, be it the source, goes to
    ``target``.
    """
    from stanza.models.common import utils
    from stanza.models.common.doc import Document
    from stanza.models.common.pretrain import Pretrain
    from stanza.models.pos.data import Dataset, ShuffledDataset
    from stanza.models.pos.trainer import Trainer
    from stanza.utils.conll import CoNLL

    utils.set_random_seed(seed)
    pretrain = Pretrain(str(vectors))
    trainer = Trainer(model_file=str(source), pretrain=pretrain, args={"lr": RATE}, device="cpu")
    options = {"vocab": trainer.vocab, "tag_columns": trainer.args["tag_columns"]}
    parts = [
        Dataset(
            Document(CoNLL.conll2dict(input_file=str(path))[0]), trainer.args, pretrain, evaluation=False, **options
        )
        for path in train
    ]
    checked = Dataset(
        CoNLL.conll2doc(input_file=str(dev)), trainer.args, pretrain, evaluation=True, sort_during_eval=True, **options
    )
    shuffled = ShuffledDataset(parts, BATCH)

    def batches() -> Iterator[object]:
        while True:
            yield from shuffled

    best = _score(trainer, checked, dev)
    print(f"before: dev_score = {best:.4f}", flush=True)
    # The first steps lose what the optimizer had learned; if later steps do not make up for it, the source stays best.
    shutil.copyfile(str(source), str(target))
    weights = {name: weight for name, weight in trainer.model.named_parameters() if weight.requires_grad}
    average = {name: weight.detach().clone() for name, weight in weights.items()}
    for step, batch in enumerate(batches(), 1):
        loss = trainer.update(batch, eval=False)
        decay = min(DECAY, (1.0 + step) / (10.0 + step))
        for name, weight in weights.items():
            average[name].mul_(decay).add_(weight.detach(), alpha=1.0 - decay)
        if step % 20 == 0:
            print(f"Finished STEP {step}/{steps}, loss = {loss:.4f}", flush=True)
        if step % EVERY == 0 or step == steps:
            current = _exchanged(weights, average)
            found = _score(trainer, checked, dev)
            print(f"step {step}: dev_score = {found:.4f}", flush=True)
            if found >= best:
                best = found
                trainer.save(str(target))
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
    source, target, vectors, dev, steps, seed = arguments[:6]
    settle(
        Path(source),
        Path(target),
        Path(vectors),
        Path(dev),
        int(steps),
        int(seed),
        [Path(path) for path in arguments[6:]],
    )
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
