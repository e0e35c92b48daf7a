"""The network: an encoder of six layers, mixes of them, and scorers of tags, heads and relations."""

from dataclasses import dataclass
from typing import Dict, List, Tuple

import torch
from torch import Tensor, nn
from torch.nn import functional


@dataclass(frozen=True)
class Shape:
    """Sizes of the network.

    Attributes:
        pieces: of the vocabulary
        upos, xpos, feats, relations: numbers of labels
        width, layers, attention, inner, positions: of the encoder
        arc, relation, tag: of the scorers
    """

    pieces: int
    upos: int
    xpos: int
    feats: int
    relations: int
    width: int = 384
    layers: int = 6
    attention: int = 12
    inner: int = 1536
    positions: int = 256
    shapes: int = 6
    arc: int = 384
    relation: int = 128
    tag: int = 256


class Layer(nn.Module):  # type: ignore[misc]  # torch is not read
    """One layer of the encoder, as in BERT."""

    def __init__(self, shape: Shape, dropout: float) -> None:
        super().__init__()
        self.heads = shape.attention
        self.query = nn.Linear(shape.width, shape.width)
        self.key = nn.Linear(shape.width, shape.width)
        self.value = nn.Linear(shape.width, shape.width)
        self.out = nn.Linear(shape.width, shape.width)
        self.norm_attention = nn.LayerNorm(shape.width, eps=1e-12)
        self.up = nn.Linear(shape.width, shape.inner)
        self.down = nn.Linear(shape.inner, shape.width)
        self.norm_out = nn.LayerNorm(shape.width, eps=1e-12)
        self.dropout = nn.Dropout(dropout)

    def forward(self, states: Tensor, bias: Tensor) -> Tensor:
        """Return the next states; ``bias`` is added to the scores of attention."""
        batch, length, width = states.shape

        def split(values: Tensor) -> Tensor:
            return values.view(batch, length, self.heads, width // self.heads).transpose(1, 2)

        query, key, value = split(self.query(states)), split(self.key(states)), split(self.value(states))
        scores = query @ key.transpose(-1, -2) * (width // self.heads) ** -0.5 + bias
        attended = self.dropout(scores.softmax(-1)) @ value
        attended = attended.transpose(1, 2).reshape(batch, length, width)
        states = self.norm_attention(states + self.dropout(self.out(attended)))
        inner = self.down(functional.gelu(self.up(states)))
        mixed: Tensor = self.norm_out(states + self.dropout(inner))
        return mixed


class Mix(nn.Module):  # type: ignore[misc]  # torch is not read
    """A weighted mean of the layers."""

    def __init__(self, layers: int) -> None:
        super().__init__()
        self.weights = nn.Parameter(torch.zeros(layers))

    def forward(self, layers: List[Tensor]) -> Tensor:
        """Return the mean."""
        shares = self.weights.float().softmax(0)
        mixed = layers[0] * shares[0]
        for share, layer in zip(shares[1:], layers[1:]):
            mixed = mixed + layer * share
        return mixed


class JointParser(nn.Module):  # type: ignore[misc]  # torch is not read
    """Encoder and scorers."""

    def __init__(
        self, shape: Shape, *, dropout: float = 0.1, head_dropout: float = 0.33, pooling: str = "mean"
    ) -> None:
        """
        Args:
            shape: sizes
            dropout: in the encoder
            head_dropout: in the scorers
            pooling: "first" piece of a word, or "mean" of its pieces
        """
        super().__init__()
        self.shape, self.pooling = shape, pooling
        self.pieces = nn.Embedding(shape.pieces, shape.width)
        self.places = nn.Embedding(shape.positions, shape.width)
        self.shapes = nn.Embedding(shape.shapes, shape.width)
        nn.init.zeros_(self.shapes.weight)
        self.norm = nn.LayerNorm(shape.width, eps=1e-12)
        self.layers = nn.ModuleList(Layer(shape, dropout) for _ in range(shape.layers))
        self.mix_tags, self.mix_arcs = Mix(shape.layers + 1), Mix(shape.layers + 1)
        self.to_tag = nn.Linear(shape.width, shape.tag)
        self.upos = nn.Linear(shape.tag, shape.upos)
        self.xpos = nn.Linear(shape.tag, shape.xpos)
        self.feats = nn.Linear(shape.tag, shape.feats)
        self.arc_word, self.arc_head = nn.Linear(shape.width, shape.arc), nn.Linear(shape.width, shape.arc)
        self.relation_word = nn.Linear(shape.width, shape.relation)
        self.relation_head = nn.Linear(shape.width, shape.relation)
        self.arcs = nn.Linear(shape.arc, shape.arc)
        self.arc_bias = nn.Linear(shape.arc, 1, bias=False)
        nn.init.normal_(self.arcs.weight, std=0.02)
        self.relations = nn.Linear(shape.relation, shape.relation * shape.relations, bias=False)
        nn.init.normal_(self.relations.weight, std=0.02)
        self.relation_bias_word = nn.Linear(shape.relation, shape.relations)
        self.relation_bias_head = nn.Linear(shape.relation, shape.relations, bias=False)
        self.dropout, self.head_dropout = nn.Dropout(dropout), nn.Dropout(head_dropout)

    def encode(self, numbers: Tensor, shapes: Tensor, bias: Tensor) -> List[Tensor]:
        """Return the states of all layers."""
        places = torch.arange(numbers.shape[1], device=numbers.device)
        states = self.pieces(numbers) + self.places(places)[None] + self.shapes(shapes)
        found = [self.dropout(self.norm(states))]
        for layer in self.layers:
            found.append(layer(found[-1], bias))
        return found

    def words(self, mixed: Tensor, pool: Tensor) -> Tensor:
        """Return the states of the root (the first piece) and of the words.

        Args:
            mixed: states of pieces
            pool: share of each piece in each word, the root among them
        """
        return torch.bmm(pool.to(mixed.dtype), mixed)

    def forward(self, numbers: Tensor, shapes: Tensor, pool: Tensor, bias: Tensor) -> Dict[str, Tensor]:
        """Return scores: of tags of each word, of each head (0 is the root), of each relation to each head."""
        layers = self.encode(numbers, shapes, bias)
        tagged = self.words(self.mix_tags(layers), pool)[:, 1:]
        hidden = self.head_dropout(functional.gelu(self.to_tag(self.head_dropout(tagged))))
        words = self.head_dropout(self.words(self.mix_arcs(layers), pool))
        arc_word = self.head_dropout(functional.gelu(self.arc_word(words[:, 1:])))
        arc_head = self.head_dropout(functional.gelu(self.arc_head(words)))
        arcs = self.arcs(arc_word) @ arc_head.transpose(1, 2) + self.arc_bias(arc_head).transpose(1, 2)
        return {
            "upos": self.upos(hidden),
            "xpos": self.xpos(hidden),
            "feats": self.feats(hidden),
            "arcs": arcs,
            "relations": self.relation_scores(words),
        }

    def relation_scores(self, words: Tensor) -> Tensor:
        """Return the scores of the relations of each word to each head."""
        word = self.head_dropout(functional.gelu(self.relation_word(words[:, 1:])))
        head = self.head_dropout(functional.gelu(self.relation_head(words)))
        batch, count, size = word.shape
        # word, relation, size
        matrices = self.relations(word).view(batch, count, self.shape.relations, size)
        scores = torch.einsum("bnrs,bms->bnmr", matrices, head)
        return scores + self.relation_bias_word(word)[:, :, None] + self.relation_bias_head(head)[:, None]


def parameter_groups(model: JointParser, encoder: float, scorers: float, decay: float) -> List[Dict[str, object]]:
    """Return the parameters with their learning rates: smaller for the lower layers of the encoder."""
    groups: Dict[Tuple[float, float], List[nn.Parameter]] = {}
    for name, parameter in model.named_parameters():
        if name.startswith("layers."):
            rate = encoder * decay ** (model.shape.layers - 1 - int(name.split(".")[1]))
        elif name.startswith(("pieces", "places", "norm.")):
            rate = encoder * decay**model.shape.layers
        else:
            rate = scorers
        shrink = 0.01 if parameter.dim() > 1 else 0.0
        groups.setdefault((rate, shrink), []).append(parameter)
    return [{"params": found, "lr": rate, "weight_decay": shrink} for (rate, shrink), found in groups.items()]
