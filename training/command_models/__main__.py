"""Command line: build, pack, score, card, compare, huric, generate.  ``python -m command_models build --help``."""

import argparse
import json
import sys
from pathlib import Path
from typing import Dict, List, Optional

from . import building, card, generate, huric, lexicon, mining, scoring, trainers
from .conllu import write
from .errors import TrainingError
from .pipeline import Parser


def _arguments() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="command_models", description=__doc__)
    commands = parser.add_subparsers(dest="action", required=True)
    build = commands.add_parser("build", help="treebank folders to packaged model; goes on where it was broken off")
    build.add_argument("--ewt", type=Path, required=True, help="folder of UD_English-EWT")
    build.add_argument("--childes", type=Path, required=True, help="folder of UD_English-CHILDES")
    build.add_argument("--wordnet", type=Path, required=True, help="folder of the WordNet 3.0 database (data.noun ...)")
    build.add_argument("--work", type=Path, required=True, help="folder for data, models, logs; kept for resuming")
    build.add_argument("--out", type=Path, required=True, help="folder of the packaged model")
    build.add_argument("--commands", type=int, default=10000, help="generated sentences")
    build.add_argument("--vectors", type=int, default=22000, help="word vectors kept")
    build.add_argument("--seed", type=int, default=20261)
    build.add_argument("--jobs", type=int, default=2, help="trainings at once")
    default = trainers.Effort()
    for name, value in vars(default).items():
        option = "--" + name.replace("_", "-") + "-steps"
        build.add_argument(option, type=int, default=value, help=f"default {value}")
    pack = commands.add_parser("pack", help="package the models that a working folder holds by now")
    pack.add_argument("--work", type=Path, required=True)
    pack.add_argument("--out", type=Path, required=True)
    score = commands.add_parser("score", help="EWT test and held-out commands")
    score.add_argument("--model", type=Path, required=True)
    score.add_argument("--ewt", type=Path, help="folder of UD_English-EWT")
    score.add_argument("--held-out", type=int, default=1000, help="held-out command sentences, 0 for none")
    score.add_argument("--seed", type=int, default=20261)
    score.add_argument("--show", type=int, default=0, help="failures to print")
    score.add_argument("--huric", type=Path, help="folder of HuRIC 2.1 with *.hrc below")
    score.add_argument("--rules", type=Path, help="folder with stanford_parser_ros: map relations by its rules")
    score.add_argument("--json", type=Path, help="write the figures there")
    against = commands.add_parser("huric", help="HuRIC's gold trees")
    against.add_argument("--model", type=Path, required=True)
    against.add_argument("--data", type=Path, required=True, help="folder of HuRIC 2.1 with *.hrc below")
    against.add_argument("--show", type=int, default=0, help="failures to print")
    against.add_argument("--rules", type=Path, help="folder with stanford_parser_ros: map relations by its rules")
    carded = commands.add_parser("card", help="put the figures of 'score --json' into a model card")
    carded.add_argument("--figures", type=Path, required=True)
    carded.add_argument("--model", type=Path, required=True, help="folder with manifest.json and MODEL_CARD.md")
    compared = commands.add_parser("compare", help="whether figures of 'score --json' are those of a model card")
    compared.add_argument("--figures", type=Path, required=True)
    compared.add_argument("--card", type=Path, required=True, help="MODEL_CARD.md")
    compared.add_argument("--within", type=float, default=0.2, help="points that they may differ; default 0.2")
    made = commands.add_parser("generate", help="write generated sentences as CoNLL-U")
    made.add_argument("--count", type=int, default=1000)
    made.add_argument("--seed", type=int, default=20261)
    made.add_argument("--evaluation", action="store_true", help="over the evaluation words")
    made.add_argument("--treebank", type=Path, action="append", default=[], help="CoNLL-U file to mine words from")
    made.add_argument("--out", type=Path, required=True)
    return parser


def _build(options: argparse.Namespace) -> None:
    effort = trainers.Effort(**{name: getattr(options, name + "_steps") for name in vars(trainers.Effort())})
    building.build(
        building.Plan(
            options.ewt,
            options.childes,
            options.wordnet,
            options.work.resolve(),
            options.out,
            options.seed,
            options.commands,
            1000,
            options.vectors,
            options.jobs,
            effort,
        )
    )


def _score(options: argparse.Namespace) -> None:
    figures: Dict[str, Dict[str, float]] = {}
    if options.ewt:
        test = options.ewt / "en_ewt-test.conllu"
        figures[card.GOLD] = scoring.on_gold_words(options.model, test)
        figures[card.RAW] = scoring.on_raw_text(options.model, test)
    if options.held_out:
        sentences = list(generate.evaluation(options.held_out, options.seed))
        commands = scoring.on_commands(options.model, sentences)
        figures[f"generated commands over held-out words ({options.held_out}), percent"] = commands.percent()
        for failure in commands.failures[: options.show]:
            print("  " + failure)
        median, high = scoring.latency(options.model, [sentence.text() for sentence in sentences[:200]])
        figures["milliseconds per command, one thread"] = {"median": median, "95th percentile": high}
    if options.huric:
        figures["HuRIC commands with their gold words, percent"] = _on_huric(
            options.model, options.huric, options.rules
        ).percent()
    for title, found in figures.items():
        print(title + ": " + ", ".join("{} {:.2f}".format(*pair) for pair in found.items()))
    if options.json:
        options.json.write_text(json.dumps(figures, indent=1) + "\n", encoding="utf-8")


def _on_huric(model: Path, data: Path, rules: Optional[Path]) -> huric.Score:
    commands = huric.read_folder(data)
    parsed = Parser(model, pretokenized=True).words([command.tokens for command in commands])
    return huric.score(commands, parsed, huric.runtime_arguments(rules) if rules else huric.our_arguments)


def _huric(options: argparse.Namespace) -> None:
    found = _on_huric(options.model, options.data, options.rules)
    for line in found.lines() + ["  " + failure for failure in found.failures[: options.show]]:
        print(line)


def _generate(options: argparse.Namespace) -> None:
    if options.evaluation:
        sentences = generate.evaluation(options.count, options.seed)
    else:
        mined = mining.mine(options.treebank, lexicon.evaluation_words())
        sentences = generate.training(options.count, options.seed, mined)
    print(f"{write(options.out, sentences)} sentences in {options.out}")


def main(arguments: Optional[List[str]] = None) -> int:
    """Run the tool; return 0 on success, otherwise 1: an error, or differences that ``compare`` found."""
    options = _arguments().parse_args(arguments)
    try:
        if options.action == "build":
            _build(options)
        elif options.action == "pack":
            building.pack_plan(options.work, options.out)
        elif options.action == "score":
            _score(options)
        elif options.action == "card":
            card.update(options.model / "MODEL_CARD.md", options.figures, options.model / "manifest.json")
        elif options.action == "compare":
            different = card.differences(options.card, options.figures, options.within)
            for line in different:
                print(line)
            return 1 if different else 0
        elif options.action == "huric":
            _huric(options)
        else:
            _generate(options)
    except TrainingError as error:
        sys.stderr.write(f"command_models: {error}\n")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
