"""A network of few weights that knows nothing, for tests of what reads such a folder."""

import json
from pathlib import Path

import torch

from joint_parser.data import Labels
from joint_parser.export import write_network
from joint_parser.network import JointParser, Shape
from stanford_parser_ros.joint import model_folder

PIECES = "[PAD] [UNK] [CLS] [SEP] [MASK] go to the kitchen bring mug ##s ##x a b c . , and put it on table".split()
LABELS = Labels(
    ("DET", "NOUN", "PUNCT", "VERB"),
    (".", "DT", "NN", "VB"),
    ("Number=Sing", "_"),
    ("det", "nsubj", "obj", "obl", "punct", "root"),
)


def write_tiny(out: Path, seed: int = 3) -> None:
    """Write a model folder; the same weights for the same seed."""
    torch.manual_seed(seed)
    out.mkdir(parents=True, exist_ok=True)
    shape = Shape(
        len(PIECES), 4, 4, 2, 6, width=8, layers=1, attention=2, inner=16, positions=256, arc=8, relation=4, tag=8
    )
    model = JointParser(shape)
    for name, parameter in model.named_parameters():
        if "norm" not in name and parameter.dim() > 1:
            torch.nn.init.normal_(parameter, std=0.6)
    model.eval()
    write_network(model, out, quantized=False)
    (out / model_folder.LABELS).write_text(json.dumps(LABELS.as_json()) + "\n", encoding="utf-8")
    (out / model_folder.PIECES).write_text("\n".join(PIECES) + "\n", encoding="utf-8")
    model_folder.write_manifest(out)
