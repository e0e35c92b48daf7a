"""``rfn score``: measures how well the commands of a public corpus are understood."""

import argparse
import json
import sys
from pathlib import Path
from typing import Callable, Dict, List, Mapping, Sequence, Tuple

from checked_files import FileRefused
from checked_files.source_files import LEXICAL_UNITS_FOLDER
from frame_learning.annotated_commands import AnnotatedCommand, CorpusError
from frame_learning.annotated_sentences import sentences_of
from frame_learning.corpora import CORPORA, PublishedFigures
from frame_learning.corpus_answers import answer, answer_2012
from frame_learning.corpus_mapping import CorpusMapping
from frame_learning.gpsr_command import NAME as GPSR
from frame_learning.gpsr_command import TITLE as GPSR_TITLE
from frame_learning.gpsr_command import add_gpsr_arguments, run_gpsr
from frame_learning.huric_maps import read_huric_maps
from frame_learning.learn_command import learned_knowledge, lexicon_files
from frame_learning.map_score import attachments, compared
from frame_learning.metrics import Answer, Count, Score, is_exact, score
from frame_learning.outcome_score import add_outcome_arguments, score_outcomes
from frame_learning.tables import aligned
from frame_learning.talk_score import NAME as TALK
from frame_learning.talk_score import TITLE as TALK_TITLE
from frame_learning.talk_score import run_talk
from mood_matrix.mood_command import NAME as MOOD
from mood_matrix.mood_command import TITLE as MOOD_TITLE
from mood_matrix.mood_command import add_mood_arguments, run_mood
from offline_pipeline.knowledge import load_knowledge, pretend_servers, shipped_domains
from offline_pipeline.named_rules import unknown_rules
from offline_pipeline.pipeline import Parameters, Pipeline
from semantic_framer.values.outcome import MEANING_ONLY
from stanford_parser_ros.inference import ModelError
from world_model import World

EXAMPLES = """examples:
  rfn score huric huric-2.1/english
  rfn score huric huric-2.1/english --folds 5
  rfn score huric huric-2.1/english --maps
  rfn score tage tagE/data --json > tage.json
  rfn score scout scout/transcripts
  rfn score scout scout/transcripts --sample 200 --seed 7
  rfn score gpsr grammars --count 5000 --seed 7 --failures
  rfn score talk treebanks --count 1000 --failures
  rfn score mood
  rfn score mood --row 8 --row 22 --domain devices --failures

exit status: 0 scored, 2 wrong usage
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn score``."""
    parser.epilog = EXAMPLES
    titles = "; ".join(f"{name}: {corpus.title}" for name, corpus in CORPORA.items())
    others = {GPSR: GPSR_TITLE, TALK: TALK_TITLE, MOOD: MOOD_TITLE}
    told = "; ".join([titles, *(f"{name}: {title}" for name, title in others.items())])
    parser.add_argument("corpus", choices=(*CORPORA, *others), help=told)
    parser.add_argument("folder", nargs="?", default="", metavar="DIR", help=f"its folder; none for {MOOD}")
    parser.add_argument("--domains", action="append", metavar="FOLDER", help="frames and units (default: shipped)")
    parser.add_argument(
        "--folds",
        type=int,
        default=0,
        metavar="N",
        help="score each Nth of the commands with units learned only from the others",
    )
    parser.add_argument("--json", action="store_true", help="one JSON object")
    parser.add_argument(
        "--behaviour",
        choices=("now", "2012"),
        default="now",
        help="2012: single words, every other word ignored; the table always shows its figures",
    )
    parser.add_argument(
        "--without",
        action="append",
        default=[],
        metavar="RULE",
        help="switch a rule off ('rfn passes --all' lists them)",
    )
    parser.add_argument("--wrong", metavar="FILE", help="write the commands that are not completely right to this file")
    parser.add_argument(
        "--maps", action="store_true", help="of huric: score with the map of each command too, and list what changes"
    )
    add_gpsr_arguments(parser)
    add_outcome_arguments(parser)
    add_mood_arguments(parser)


def run(arguments: argparse.Namespace) -> int:
    """Score a corpus; return the exit status."""
    corpus = CORPORA.get(arguments.corpus)
    is_annotated = corpus is not None and corpus.is_annotated
    if not is_annotated and (arguments.folds or arguments.behaviour == "2012"):
        print(
            f"rfn score: {arguments.corpus} has no annotated frames to learn from or to compare with", file=sys.stderr
        )
        return 2
    if unknown := unknown_rules(arguments.without):
        print(f"rfn score: no rule is named {', '.join(unknown)}", file=sys.stderr)
        return 2
    if (arguments.corpus == MOOD) is bool(arguments.folder):
        needs = "is made of the domains and has no folder" if arguments.folder else "needs its folder"
        print(f"rfn score: {arguments.corpus} {needs}", file=sys.stderr)
        return 2
    if arguments.maps and arguments.corpus != "huric":
        print(f"rfn score: {arguments.corpus} has no maps", file=sys.stderr)
        return 2
    try:
        knowledge = load_knowledge(arguments.domains or [shipped_domains()])
        pretend_servers(knowledge.graph)
        pipeline = Pipeline(knowledge, parameters=Parameters(policy=MEANING_ONLY), without=frozenset(arguments.without))
        if arguments.corpus == MOOD:
            return run_mood(arguments, pipeline, Path((arguments.domains or [shipped_domains()])[0]))
        if arguments.corpus == TALK:
            return run_talk(arguments, pipeline)
        if corpus is None:
            return run_gpsr(arguments, pipeline)
        commands = corpus.read(arguments.folder)
        mapping = corpus.mapping() if is_annotated else None
        maps = read_huric_maps(arguments.folder) if arguments.maps else {}
    except (CorpusError, FileRefused, ModelError, LookupError) as error:
        print(f"rfn score: {error}", file=sys.stderr)
        return 2
    for problem in knowledge.problems:
        print(problem, file=sys.stderr)
    if mapping is None:
        return score_outcomes(arguments, pipeline, commands)
    if maps and (arguments.folds or arguments.behaviour == "2012"):
        print("rfn score: --maps goes with the shipped units as they work now", file=sys.stderr)
        return 2
    return _score_frames(arguments, pipeline, mapping, commands, corpus.published, maps)


def _score_frames(
    arguments: argparse.Namespace,
    pipeline: Pipeline,
    mapping: CorpusMapping,
    commands: Sequence[AnnotatedCommand],
    published: Sequence[PublishedFigures],
    maps: Mapping[str, World],
) -> int:
    is_old = arguments.behaviour == "2012"
    understand = answer_2012 if is_old else answer
    if arguments.folds:
        pairs = _in_folds(pipeline, mapping, commands, arguments.folds, understand)
    else:
        pairs = [(command, understand(pipeline, mapping, command)) for command in commands]
    found = score(pairs)
    in_maps = [(one, understand(pipeline.in_world(maps[one.name]), mapping, one)) for one in commands] if maps else []
    if arguments.wrong:
        with open(arguments.wrong, "w", encoding="utf-8") as file:
            wrong = [one for one in in_maps or pairs if not is_exact(*one)]
            file.writelines(compared(command, given) for command, given in wrong)
    attached = attachments(pairs, in_maps)
    if arguments.json:
        with_maps = {"maps": {**to_json(score(in_maps)), "attachments": attached.to_json()}} if maps else {}
        print(json.dumps({**to_json(found), **with_maps}))
        return 0
    name = "2012" if is_old else "now"
    rows = [(f"{name}, learned, {arguments.folds}-fold" if arguments.folds else name, found)]
    if arguments.folds:
        rows.append((name, score((command, understand(pipeline, mapping, command)) for command in commands)))
    if maps:
        rows.append((f"{name}, with maps", score(in_maps)))
    if not is_old:
        old = [answer_2012(pipeline, mapping, command) for command in commands]
        rows.append(("2012", score(zip(commands, old))))
    print(table(rows, published))
    if maps:
        print(f"\n{attached}")
    return 0


def _in_folds(
    pipeline: Pipeline,
    mapping: CorpusMapping,
    commands: Sequence[AnnotatedCommand],
    folds: int,
    understand: Callable[[Pipeline, CorpusMapping, AnnotatedCommand], Answer],
) -> List[Tuple[AnnotatedCommand, Answer]]:
    """Score each fold with units learned from the others, without the shipped units; the frames stay."""
    known = pipeline.knowledge
    found: List[Tuple[AnnotatedCommand, Answer]] = []
    for fold in range(folds):
        others = [command for number, command in enumerate(commands) if number % folds != fold]
        sentences, _ = sentences_of(others, mapping, known.frames, known.lexicon.units)
        files, _ = lexicon_files(sentences, pipeline.parser, known)
        units = {path: text for path, text in files.items() if path.startswith(LEXICAL_UNITS_FOLDER)}
        learned = learned_knowledge(known.frames, {}, units)
        pretend_servers(learned.graph)
        taught = Pipeline(learned, pipeline.parser, parameters=Parameters(policy=MEANING_ONLY))
        found += [
            (command, understand(taught, mapping, command))
            for number, command in enumerate(commands)
            if number % folds == fold
        ]
    return found


def to_json(found: Score) -> Dict[str, object]:
    """Return the object that ``rfn score --json`` writes."""
    return {
        "commands": found.commands,
        "fp": round(found.fp, 2),
        "aic_exact": round(found.aic_exact, 2),
        "aic_head": round(found.aic_head, 2),
        "em": round(found.em, 2),
        "coverage": round(found.coverage, 2),
        "precision_answered": round(found.precision_answered, 2),
        "ms_per_command": round(found.ms_per_command, 2),
        **({"arguments": arguments_to_json(found.arguments)} if found.arguments is not None else {}),
        "per_frame": {
            name: {
                "annotated": row.frame.annotated,
                "predicted": row.frame.predicted,
                "right": row.frame.right,
                "fp": round(row.frame.f1, 2),
                "aic_exact": round(row.exact.f1, 2),
                "aic_head": round(row.head.f1, 2),
                "taken_for": dict(row.taken_for),
            }
            for name, row in found.per_frame.items()
        },
    }


def arguments_to_json(count: Count) -> Dict[str, float]:
    """Return the figures of arguments in the convention of the corpus."""
    return {
        "micro_f1": round(count.f1, 2),
        "right": count.right,
        "predicted": count.predicted,
        "annotated": count.annotated,
    }


def table(rows: Sequence[Tuple[str, Score]], published: Sequence[PublishedFigures] = ()) -> str:
    """Return the figures for a person: ours and the published ones in one table, then each frame of the first row."""
    lines: List[Tuple[str, ...]] = [
        ("", "FP", "AIC-exact", "AIC-head", "EM", "coverage", "precision", "right", "right heads", "ms/command")
    ]
    for name, found in rows:
        figures = [found.fp, found.aic_exact, found.aic_head, found.em, found.coverage]
        figures += [found.precision_answered, found.right_answered, found.right_answered_heads, found.ms_per_command]
        lines.append((name,) + tuple(f"{figure:.1f}" for figure in figures))
    for others in published:
        shown = tuple(f"{figure:.1f}" for figure in (others.fp, others.aic_exact, others.aic_head))
        lines.append((others.name,) + shown + ("-",) * 6)
    frames = [("frame", "annotated", "FP", "AIC-exact", "AIC-head", "taken for")]
    for name, row in rows[0][1].per_frame.items():
        taken = ", ".join(f"{other} {count}" for other, count in sorted(row.taken_for.items()) if other != name)
        frames.append(
            (name, str(row.frame.annotated), f"{row.frame.f1:.1f}", f"{row.exact.f1:.1f}", f"{row.head.f1:.1f}", taken)
        )
    arguments = [
        f"{name}: arguments in the convention of the corpus: micro-F1 {count.f1:.1f}, {count.right} right, "
        f"{count.predicted} found, {count.annotated} annotated"
        for name, count in ((name, found.arguments) for name, found in rows)
        if count is not None
    ]
    head = "\n".join([f"{rows[0][1].commands} commands", *arguments])
    return f"{head}\n\n{aligned(lines)}\n\n{aligned(frames)}"
