"""Writes the network for ONNX Runtime: rows of pieces and large matrices with 8 bits, the rest with 32."""

import shutil
from pathlib import Path
from typing import Any, Tuple

import torch
from torch import Tensor, nn
from torch.nn import functional

from joint_parser.folder import read_folder
from joint_parser.network import JointParser
from joint_parser.running import load
from stanford_parser_ros.joint import model_folder


class OneSentence(nn.Module):  # type: ignore[misc]  # torch is not read
    """The network for one sentence, without what is needed for learning alone."""

    numbers: Tensor
    scales: Tensor

    def __init__(self, model: JointParser) -> None:
        super().__init__()
        self._model = model
        weight = model.pieces.weight.detach()
        scales = weight.abs().amax(1, keepdim=True) / 127.0 + 1e-12
        self.register_buffer("numbers", torch.round(weight / scales).to(torch.int8))
        self.register_buffer("scales", scales)

    def forward(self, numbers: Tensor, shapes: Tensor, pool: Tensor) -> Tuple[Tensor, Tensor, Tensor, Tensor, Tensor]:
        """Return the scores of tags, heads (word, head) and relations (word, head, relation)."""
        model = self._model
        pieces = self.numbers[numbers].float() * self.scales[numbers]
        states = pieces + model.places.weight[: numbers.shape[0]] + model.shapes.weight[shapes]
        states = model.norm(states)[None]
        layers = [states]
        for layer in model.layers:
            layers.append(self._layer(layer, layers[-1]))
        tagged = (pool @ model.mix_tags(layers)[0])[1:][None]
        hidden = functional.gelu(model.to_tag(tagged))
        words = (pool @ model.mix_arcs(layers)[0])[None]
        arc_word, arc_head = functional.gelu(model.arc_word(words[:, 1:])), functional.gelu(model.arc_head(words))
        arcs = model.arcs(arc_word) @ arc_head.transpose(1, 2) + model.arc_bias(arc_head).transpose(1, 2)
        word = functional.gelu(model.relation_word(words[:, 1:]))
        head = functional.gelu(model.relation_head(words))
        relations, size = model.shape.relations, model.shape.relation
        matrices = model.relations(word).reshape(-1, size)
        scores = (matrices @ head[0].T).reshape(-1, relations, head.shape[1]).transpose(1, 2)
        scores = scores + model.relation_bias_word(word)[0][:, None] + model.relation_bias_head(head)
        return model.upos(hidden)[0], model.xpos(hidden)[0], model.feats(hidden)[0], arcs[0], scores

    @staticmethod
    def _layer(layer: Any, states: Tensor) -> Tensor:
        heads, size = layer.heads, states.shape[2] // layer.heads

        def split(values: Tensor) -> Tensor:
            return values.reshape(1, -1, heads, size).transpose(1, 2)

        query, key, value = split(layer.query(states)), split(layer.key(states)), split(layer.value(states))
        attended = (query @ key.transpose(-1, -2) * size**-0.5).softmax(-1) @ value
        attended = attended.transpose(1, 2).reshape(1, -1, heads * size)
        states = layer.norm_attention(states + layer.out(attended))
        found: Tensor = layer.norm_out(states + layer.down(functional.gelu(layer.up(states))))
        return found


def export(data: Path, trained: Path, out: Path, *, quantized: bool = True) -> None:
    """Write the model folder that ``~runtime: joint`` loads.

    Args:
        data: prepared folder
        trained: folder of a training
        out: is made
        quantized: with 8 bits; else with 32, for a comparison
    Raises:
        TrainingError: nothing is trained there
    """
    labels, vocabulary = read_folder(data)
    model = load(trained, labels, vocabulary)
    model.eval()
    out.mkdir(parents=True, exist_ok=True)
    write_network(model, out, quantized=quantized)
    shutil.copyfile(data / "labels.json", out / model_folder.LABELS)
    shutil.copyfile(data / "pieces.txt", out / model_folder.PIECES)
    model_folder.write_manifest(out)


def write_network(model: JointParser, out: Path, *, quantized: bool) -> None:
    """Write a network for ONNX Runtime into a folder."""
    whole, path = out / "whole.onnx", out / model_folder.NETWORK
    example = (torch.tensor([1, 5, 6, 2]), torch.tensor([5, 0, 0, 5]), torch.eye(4)[:3])
    with torch.inference_mode():
        torch.onnx.export(
            OneSentence(model),
            example,
            str(whole),
            input_names=["numbers", "shapes", "pool"],
            output_names=["upos", "xpos", "feats", "arcs", "relations"],
            dynamic_axes={
                "numbers": {0: "pieces"},
                "shapes": {0: "pieces"},
                "pool": {0: "words", 1: "pieces"},
            },
            opset_version=17,
            dynamo=False,
        )
    if quantized:
        from onnxruntime.quantization import QuantType, quantize_dynamic

        quantize_dynamic(
            whole,
            path,
            op_types_to_quantize=["MatMul"],
            weight_type=QuantType.QInt8,
            per_channel=True,
            reduce_range=True,
        )
        whole.unlink()
    else:
        whole.replace(path)
