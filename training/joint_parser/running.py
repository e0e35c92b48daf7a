"""One training from a prepared folder to weights, and the figures of its network."""

import json
from dataclasses import asdict, fields
from pathlib import Path
from typing import Any, Dict, List

import torch
from safetensors.torch import load_file, save_file

from command_models.errors import TrainingError
from joint_parser import scoring
from joint_parser.data import Batches, Example, Labels, read_examples
from joint_parser.folder import read_encoder, read_folder
from joint_parser.learning import Learner, Settings, Teachers
from joint_parser.network import JointParser, Shape
from stanford_parser_ros.joint.pieces import PieceVocabulary

WEIGHTS = "weights.safetensors"


def shape_of(labels: Labels, vocabulary: PieceVocabulary) -> Shape:
    """Return the sizes of a network."""
    return Shape(len(vocabulary), len(labels.upos), len(labels.xpos), len(labels.feats), len(labels.deprel))


def load(folder: Path, labels: Labels, vocabulary: PieceVocabulary, device: str = "cpu") -> JointParser:
    """Load a trained network.

    Raises:
        TrainingError: there is none
    """
    path = folder / WEIGHTS
    if not path.is_file():
        raise TrainingError(f"{path}: no such file; train it first")
    settings = json.loads((folder / "settings.json").read_text(encoding="utf-8"))
    model = JointParser(shape_of(labels, vocabulary), pooling=settings["pooling"])
    state = {name: value.float() for name, value in load_file(path).items()}
    model.load_state_dict(state)
    model.to(device)
    return model


def train(options: Any) -> None:
    """Train one network, and write its averaged weights."""
    settings = Settings(**{field.name: getattr(options, field.name) for field in fields(Settings)})
    labels, vocabulary = read_folder(options.data)
    sets = {
        name: read_examples(options.data / f"{name}.xz") for name in ("ewt-train", "childes", "generated", "ewt-dev")
    }
    if options.few:
        sets = {name: examples[: options.few] for name, examples in sets.items()}
    torch.manual_seed(settings.seed)
    model = JointParser(
        shape_of(labels, vocabulary),
        dropout=settings.dropout,
        head_dropout=settings.head_dropout,
        pooling=settings.pooling,
    )
    initial = {name: torch.from_numpy(values) for name, values in read_encoder(options.data / "encoder.npz").items()}
    missing = model.load_state_dict(initial, strict=False)
    if missing.unexpected_keys:
        raise TrainingError(f"{options.data}: an encoder of another form: {missing.unexpected_keys}")
    if "arcs.weight" in initial and missing.missing_keys:
        raise TrainingError(f"{options.data}: the model to start from lacks weights: {missing.missing_keys}")
    model.to(options.device)
    batches = Batches(vocabulary, labels, pooling=settings.pooling, device=options.device)
    teachers = None
    if options.teachers:
        teachers = Teachers([load(folder, labels, vocabulary, options.device) for folder in options.teachers])
    pieces = (options.data / "pieces.txt").read_text(encoding="utf-8").splitlines()
    learner = Learner(
        model,
        batches,
        labels,
        settings,
        options.out,
        device=options.device,
        teachers=teachers,
        mask_piece=pieces.index("[MASK]"),
    )
    history = learner.train([*sets["ewt-train"], *sets["childes"]], sets["generated"], sets["ewt-dev"], options.seconds)
    save_file(
        {name: value.detach().half().cpu().contiguous() for name, value in learner.average.items()},
        options.out / WEIGHTS,
    )
    (options.out / "settings.json").write_text(json.dumps(asdict(settings), indent=1) + "\n", encoding="utf-8")
    (options.out / "history.json").write_text(json.dumps(history, indent=1) + "\n", encoding="utf-8")


def score(options: Any) -> Dict[str, Any]:
    """Return the figures of a trained network."""
    labels, vocabulary = read_folder(options.data)
    model = load(options.model, labels, vocabulary, options.device)
    settings = json.loads((options.model / "settings.json").read_text(encoding="utf-8"))
    batches = Batches(vocabulary, labels, pooling=settings["pooling"], device=options.device)

    def parse(examples: List[Example]) -> List[scoring.Parsed]:
        return scoring.parse_all(model, batches, examples, labels)

    return all_figures(options.data, parse, options.few)


def all_figures(data: Path, parse: Any, few: int = 0) -> Dict[str, Any]:
    """Return the figures of a parser on all that is kept apart, by gold words."""
    found: Dict[str, Any] = {}
    for name in ("ewt-dev", "ewt-test", "scored", "scored-taught"):
        examples = read_examples(data / f"{name}.xz")[: few or None]
        parsed = parse(examples)
        found[name] = scoring.figures(examples, parsed)
        if name.startswith("scored"):
            found[f"{name} by construction"] = scoring.by_construction(examples, parsed)
    return found
