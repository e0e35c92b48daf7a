"""``rfn score gpsr``: draws commands from generator grammars, and scores whether they are understood rightly."""

import argparse
import json
import sys
from dataclasses import replace
from typing import Counter, Dict, List, Sequence, Tuple

from frame_learning.gpsr_commands import DrawnCommand, draw_commands
from frame_learning.gpsr_logical_forms import agrees, find_logical_form, read_logical_forms
from frame_learning.gpsr_meaning import GpsrMapping, load_gpsr_mapping
from frame_learning.gpsr_score import Judged, Verdict, by_category, causes, judge
from frame_learning.tables import aligned
from offline_pipeline.pipeline import Parameters, Pipeline
from semantic_framer.values.outcome import MEANING_ONLY
from semantic_frames.semantic_type import with_parents
from semantic_types import WordTypes

#: Kinds of slots whose words a robot is told.
_NAME, _OBJECT = "name", "object"
#: Name of the corpus on the command line.
NAME = "gpsr"
TITLE = "grammars of the command generators of RoboCup@Home (GPSR, EGPSR), a folder in any depth"


def add_gpsr_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments that only this corpus has."""
    parser.add_argument("--count", type=int, default=1000, metavar="N", help=f"{NAME}, talk: how many (1000)")
    parser.add_argument("--seed", type=int, default=0, metavar="N", help=f"{NAME}: of the commands; of --sample (0)")
    parser.add_argument("--failures", action="store_true", help=f"{NAME}, mood, talk: list the failures")


def run_gpsr(arguments: argparse.Namespace, pipeline: Pipeline) -> int:
    """Draw and score commands; return the exit status.

    Raises:
        CorpusError: the grammars cannot be read
        FileRefused: the mapping is wrong
    """
    mapping = load_gpsr_mapping()
    commands = draw_commands(arguments.folder, arguments.count, arguments.seed, mapping.slot_rules)
    pipeline = with_names(pipeline, mapping, commands)
    judged = [judge(pipeline, mapping, command) for command in commands]
    forms = _forms(arguments.folder, mapping, judged)
    if arguments.wrong:
        with open(arguments.wrong, "w", encoding="utf-8") as file:
            file.writelines(
                f"{item.verdict.value}\t{item.command.grammar}\t{item.command.text}\t{item.cause}\n"
                for item in judged
                if item.verdict is not Verdict.RIGHT
            )
    if arguments.json:
        print(json.dumps(_to_json(judged, forms)))
        return 0
    print(_table(judged))
    print(f"\nlogical forms: {forms['agree']} of {forms['published']} agree with the mapping")
    if arguments.failures:
        failing = [verdict for verdict in Verdict if verdict is not Verdict.RIGHT]
        rows = [
            (str(number), verdict.value, cause, example) for number, verdict, cause, example in causes(judged, failing)
        ]
        print("\n" + aligned([("", "", "cause", "example"), *rows]))
    return 0


def with_names(pipeline: Pipeline, mapping: GpsrMapping, commands: Sequence[DrawnCommand]) -> Pipeline:
    """Return a pipeline of a robot that knows the persons and the objects of the grammars: a team gets these names
    before the competition.
    """
    types = pipeline.knowledge.types
    names: Dict[str, Tuple[str, ...]] = {}
    for piece in (piece for command in commands for piece in command.pieces if piece.kind in (_NAME, _OBJECT)):
        text, wanted = piece.text.lower(), mapping.types.get(piece.kind, ())
        if text not in names and wanted:
            found = types.of_noun([text]).names if piece.kind == _OBJECT else ()
            names[text] = tuple(one for one in found if with_parents(one) & frozenset(wanted)) or wanted[:1]
    return Pipeline(
        replace(pipeline.knowledge, types=WordTypes(types.nouns, names)),
        pipeline.parser,
        parameters=Parameters(policy=MEANING_ONLY),
    )


def _forms(folder: str, mapping: GpsrMapping, judged: Sequence[Judged]) -> Dict[str, int]:
    """Count the commands with a published logical form, and those whose meaning agrees with it."""
    forms = read_logical_forms(folder)
    found: Counter[str] = Counter()
    for item in judged:
        form = find_logical_form(forms, item.command, mapping)
        meanings = mapping.meanings(item.command)
        if form is not None and meanings:
            found["published"] += 1
            is_same = agrees(form, meanings[0], mapping)
            found["agree"] += is_same
            if not is_same:
                print(f"{item.command.text}: its logical form is {form.form}", file=sys.stderr)
    return {"published": found["published"], "agree": found["agree"]}


def _to_json(judged: Sequence[Judged], forms: Dict[str, int]) -> Dict[str, object]:
    counts = Counter(item.verdict.value for item in judged)
    return {
        "commands": len(judged),
        **{verdict.value: counts[verdict.value] for verdict in Verdict},
        "logical_forms": forms,
        "categories": {
            name: {verdict.value: number for verdict, number in found.items()}
            for name, found in by_category(judged).items()
        },
    }


def _table(judged: Sequence[Judged]) -> str:
    rows: List[Sequence[str]] = [("", "commands", *(verdict.value for verdict in Verdict), "right %")]
    whole = Counter(item.verdict for item in judged)
    for name, found in (*by_category(judged).items(), ("all", whole)):
        total = sum(found.values())
        share = f"{100.0 * found[Verdict.RIGHT] / total:.1f}" if total else "-"
        rows.append((name, str(total), *(str(found[verdict]) for verdict in Verdict), share))
    return aligned(rows)
