"""Learning: batches, losses, the moving average of the weights, and checkpoints that a run goes on from."""

import json
import random
import time
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Dict, List, Optional, Sequence

import torch
from safetensors.torch import load_file, save_file
from torch import Tensor
from torch.nn import functional

from joint_parser import scoring
from joint_parser.data import IGNORED, Batches, Example, Labels, as_spoken
from joint_parser.network import JointParser, parameter_groups

KINDS = ("upos", "xpos", "feats")
_NEVER = -1e4


@dataclass(frozen=True)
class Settings:
    """How a network learns.

    Attributes:
        seed: of all draws
        epochs: over the treebanks
        pieces: of one batch
        encoder_rate, scorer_rate, decay: learning rates, and their decay from layer to layer
        dropout, head_dropout, masked: in the encoder, in the scorers, and the share of pieces that are hidden
        spoken: share of treebank sentences that are read as they are heard
        treebank: treebank sentences in each epoch; 0 is all of them
        generated: generated sentences in each epoch
        averaged: decay of the moving average of the weights
        soft: share of what the teachers say, where there are any
        pooling: of the pieces of a word
        saved, judged: epochs between two checkpoints, and between two scores
        floats: bits; 16 where the processor computes with bfloat16, else 32 is faster
    """

    seed: int = 1
    epochs: int = 12
    pieces: int = 1536
    encoder_rate: float = 2e-4
    scorer_rate: float = 1.5e-3
    decay: float = 0.9
    dropout: float = 0.1
    head_dropout: float = 0.25
    masked: float = 0.03
    spoken: float = 0.15
    treebank: int = 0
    generated: int = 7000
    averaged: float = 0.998
    soft: float = 0.7
    pooling: str = "mean"
    saved: int = 5
    judged: int = 5
    floats: int = 16


def _soft_loss(scores: Tensor, wanted: Tensor, valid: Tensor) -> Tensor:
    """Cross entropy with probabilities, over the rows that are valid."""
    losses = -(wanted * scores.log_softmax(-1)).sum(-1)
    return (losses * valid).sum() / valid.sum().clamp(min=1)


def loss_of(scores: Dict[str, Tensor], batch: Dict[str, Tensor]) -> Tensor:
    """Return the loss by the labels: tags, heads, and relations to the right heads."""
    total = sum(_loss(scores[kind], batch[kind]) for kind in KINDS)
    total = total + _loss(scores["arcs"].float().masked_fill(batch["no_head"], _NEVER), batch["head"])
    chosen = at_heads(scores["relations"].float(), batch["head"].clamp(min=0))
    return total + _loss(chosen, batch["deprel"])


def _loss(scores: Tensor, labels: Tensor) -> Tensor:
    """Cross entropy with labels; 0 if there are none."""
    summed = functional.cross_entropy(
        scores.float().flatten(0, 1), labels.flatten(), ignore_index=IGNORED, reduction="sum"
    )
    return summed / (labels != IGNORED).sum().clamp(min=1)


def at_heads(relations: Tensor, heads: Tensor) -> Tensor:
    """Return the scores of the relations of each word to one head."""
    index = heads[:, :, None, None].expand(-1, -1, 1, relations.shape[-1])
    return relations.gather(2, index)[:, :, 0]


class Teachers:
    """Networks whose mean a smaller or single network learns."""

    def __init__(self, models: Sequence[JointParser]) -> None:
        self._models = list(models)
        for model in self._models:
            model.eval()

    def loss(self, scores: Dict[str, Tensor], batch: Dict[str, Tensor]) -> Tensor:
        """Return the loss by what the teachers say."""
        with torch.no_grad():
            said = [model(batch["numbers"], batch["shapes"], batch["pool"], batch["bias"]) for model in self._models]
            arcs = torch.stack(
                [one["arcs"].float().masked_fill(batch["no_head"], _NEVER).softmax(-1) for one in said]
            ).mean(0)
            heads = arcs.argmax(-1)
            relations = torch.stack([at_heads(one["relations"].float(), heads).softmax(-1) for one in said]).mean(0)
            tags = {kind: torch.stack([one[kind].float().softmax(-1) for one in said]).mean(0) for kind in KINDS}
        valid = (batch["head"] != IGNORED).float()
        total = _soft_loss(scores["arcs"].float().masked_fill(batch["no_head"], _NEVER), arcs, valid)
        total = total + _soft_loss(at_heads(scores["relations"].float(), heads), relations, valid)
        for kind in KINDS:
            total = total + _soft_loss(scores[kind].float(), tags[kind], valid)
        return total


class Learner:
    """One training, which goes on from its last checkpoint."""

    def __init__(
        self,
        model: JointParser,
        batches: Batches,
        labels: Labels,
        settings: Settings,
        folder: Path,
        *,
        device: str,
        teachers: Optional[Teachers] = None,
        mask_piece: int = 0,
    ) -> None:
        self.model, self._batches, self._labels, self._settings = model, batches, labels, settings
        self._folder, self._device, self._teachers, self._mask_piece = folder, device, teachers, mask_piece
        folder.mkdir(parents=True, exist_ok=True)
        groups = parameter_groups(model, settings.encoder_rate, settings.scorer_rate, settings.decay)
        self._optimizer = torch.optim.AdamW(groups, betas=(0.9, 0.98), eps=1e-8)
        self._rates = [group["lr"] for group in self._optimizer.param_groups]
        self.average = {name: value.detach().clone() for name, value in model.state_dict().items()}
        self._step = 0
        self._ends_s, self._seconds = time.monotonic(), 1.0

    def train(
        self, treebanks: Sequence[Example], generated: Sequence[Example], dev: Sequence[Example], seconds: float = 1e9
    ) -> List[Dict[str, float]]:
        """Learn for all epochs, or until the seconds are over; return the figures of each epoch."""
        began_s = time.monotonic()
        self._ends_s, self._seconds = began_s + seconds, seconds
        first = self._resume()
        history: List[Dict[str, float]] = []
        spoken = {one: as_spoken(one) for one in treebanks}
        batch_count = self._count(treebanks, generated)
        total = batch_count * self._settings.epochs
        for epoch in range(first, self._settings.epochs):
            chooser = random.Random(self._settings.seed * 1000 + epoch)
            torch.manual_seed(self._settings.seed * 1000 + epoch)
            own = chooser.sample(list(treebanks), self._from_treebanks(treebanks))
            drawn = [spoken[one] if chooser.random() < self._settings.spoken else one for one in own]
            count = min(len(generated), self._settings.generated)
            drawn += chooser.sample(list(generated), count)
            self.model.train()
            losses = torch.zeros((), device=self._device)
            number = 0
            for part in self._batches.epoch(drawn, self._settings.pieces, chooser):
                losses += self._learn(self._batches.batch(part), total)
                number += 1
                if time.monotonic() > self._ends_s:
                    break
                if number % 50 == 0:
                    print(f"  {number} of {batch_count}, loss {float(losses) / number:.2f}", flush=True)
            last = epoch == self._settings.epochs - 1
            late = time.monotonic() - began_s > seconds
            if last or late or (epoch + 1) % self._settings.saved == 0:
                self._save(epoch + 1)
            line = {"epoch": epoch + 1, "loss": float(losses) / max(1, number), "s": time.monotonic() - began_s}
            if last or late or (epoch + 1) % self._settings.judged == 0:
                line.update(self.score(dev))
            history.append(line)
            print(json.dumps({key: round(value, 3) for key, value in line.items()}), self._folder.name, flush=True)
            if late:
                break
        return history

    def _from_treebanks(self, treebanks: Sequence[Example]) -> int:
        return min(self._settings.treebank or len(treebanks), len(treebanks))

    def _count(self, treebanks: Sequence[Example], generated: Sequence[Example]) -> int:
        """Return about how many batches an epoch has."""
        own = list(treebanks)[:: max(1, len(treebanks) // max(1, self._from_treebanks(treebanks)))]
        drawn = [*own, *list(generated)[: self._settings.generated]]
        return sum(1 for _ in self._batches.epoch(drawn, self._settings.pieces, random.Random(0)))

    def _learn(self, batch: Dict[str, Tensor], total: int) -> Tensor:
        settings = self._settings
        # With a limit of time, the rate is down at its end, however far the epochs are.
        left = (self._ends_s - time.monotonic()) / self._seconds
        share = max(self._step / max(1, total), 1 - max(0.0, left))
        factor = min(1.0, share / 0.08) if share < 0.08 else max(0.0, (1 - share) / 0.92)
        for group, rate in zip(self._optimizer.param_groups, self._rates):
            group["lr"] = rate * max(factor, 1e-4)
        numbers = batch["numbers"]
        hidden = torch.rand(numbers.shape, device=numbers.device) < settings.masked
        hidden[:, 0] = False
        masked = numbers.masked_fill(hidden & (batch["bias"][:, 0, 0] == 0), self._mask_piece)
        with torch.autocast(self._device, dtype=torch.bfloat16, enabled=settings.floats == 16):
            scores = self.model(masked, batch["shapes"], batch["pool"], batch["bias"])
            loss = loss_of(scores, batch)
            if self._teachers is not None:
                loss = (1 - settings.soft) * loss + settings.soft * self._teachers.loss(scores, batch)
        self._optimizer.zero_grad(set_to_none=True)
        loss.backward()
        torch.nn.utils.clip_grad_norm_(self.model.parameters(), 1.0)
        self._optimizer.step()
        self._step += 1
        decay = min(settings.averaged, (1 + self._step) / (10 + self._step))
        with torch.no_grad():
            state = self.model.state_dict()
            torch._foreach_mul_(list(self.average.values()), decay)
            torch._foreach_add_(list(self.average.values()), list(state.values()), alpha=1 - decay)
        return loss.detach()

    def averaged(self) -> JointParser:
        """Return a network with the averaged weights."""
        model: JointParser = JointParser(self.model.shape, pooling=self._settings.pooling)
        model.to(self._device)
        model.load_state_dict(self.average)
        return model

    def score(self, examples: Sequence[Example]) -> Dict[str, float]:
        """Return the figures of the averaged weights."""
        parsed = scoring.parse_all(self.averaged(), self._batches, examples, self._labels)
        return scoring.figures(examples, parsed)

    # -- checkpoints --------------------------------------------------------------------------------

    def _save(self, epochs: int) -> None:
        tensors: Dict[str, Tensor] = {f"model.{name}": value for name, value in self.model.state_dict().items()}
        tensors.update({f"average.{name}": value for name, value in self.average.items()})
        for number, group in enumerate(self._optimizer.param_groups):
            for place, parameter in enumerate(group["params"]):
                for name, value in self._optimizer.state[parameter].items():
                    if name != "step":
                        tensors[f"{name}.{number}.{place}"] = value
        meta = {"epochs": str(epochs), "step": str(self._step), "settings": json.dumps(asdict(self._settings))}
        path = self._folder / "checkpoint.safetensors"
        new = path.with_suffix(".new")
        save_file({name: value.detach().cpu().contiguous() for name, value in tensors.items()}, new, metadata=meta)
        new.replace(path)

    def _resume(self) -> int:
        """Load the last checkpoint; return the number of epochs that are done."""
        path = self._folder / "checkpoint.safetensors"
        if not path.is_file():
            return 0
        from safetensors import safe_open

        with safe_open(path, framework="pt") as stream:
            meta = stream.metadata()
        if json.loads(meta["settings"]) != asdict(self._settings):
            return 0
        tensors = load_file(path, device=self._device)
        self.model.load_state_dict({name[6:]: value for name, value in tensors.items() if name.startswith("model.")})
        # In the order of the network: the two are added up pair by pair.
        self.average = {name: tensors[f"average.{name}"] for name in self.average}
        self._step = int(meta["step"])
        for number, group in enumerate(self._optimizer.param_groups):
            for place, parameter in enumerate(group["params"]):
                state: Dict[str, Any] = {"step": torch.tensor(float(self._step))}
                for name in ("exp_avg", "exp_avg_sq"):
                    if f"{name}.{number}.{place}" in tensors:
                        state[name] = tensors[f"{name}.{number}.{place}"]
                if len(state) > 1:
                    self._optimizer.state[parameter] = state
        return int(meta["epochs"])
