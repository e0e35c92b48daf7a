"""``rfn explain``: shows how a sentence is understood, step by step."""

import argparse
import json
import sys
from typing import List

from checked_files import FileRefused
from frame_registrar.search import Candidate
from nearest_meaning.likeness import Likeness
from offline_pipeline.named_rules import unknown_rules
from offline_pipeline.pipeline import BEHAVIOURS, Pipeline, Understanding, to_json
from roboframenet_tools.drawing import draw_arcs, svg_arcs
from roboframenet_tools.offline import add_knowledge_arguments, offline_pipeline, told_problems
from semantic_framer.values.dialogue import Context
from stanford_parser_ros.inference import ModelError
from stanford_parser_ros.joint.inference import described
from stanford_parser_ros.stanford_dependencies import collapsed
from utterance_passes.engine.trace import TraceLine
from utterance_passes.trees.tree import DependencyTree

EXAMPLES = """examples:
  rfn explain "Bring me the mug from the kitchen."
  rfn explain --svg parse.svg "Turn left 120 degrees."
  rfn explain --without quotations "Tell her lunch is ready."
  rfn explain --with my_robot "Wave at Alice."
  rfn explain --world home.yaml "Take the box near the lamp on the table."
  rfn explain --behaviour 2012 "Go to Roger's office."
  rfn explain --after "Move forward." "Ten feet."
  rfn explain --live "Go to the office."
  rfn explain --live
  rfn explain --batch sentences.txt --json > understood.jsonl

With --live a sentence is explained with the knowledge of the running graph, and is not carried out. Without a sentence,
the nodes of the graph explain each command that they hear, until Ctrl-C.

exit status: 0 it would be done (a batch: every line has its object), 1 it would not, 2 wrong usage
"""
#: Under an explanation without --live.
PRETENCE = "(As if every frame had a server: 'rfn explain --live' and 'rfn list' know which have one.)"
#: Width of the column of rule names.
_RULE_WIDTH = 22


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn explain``."""
    parser.epilog = EXAMPLES
    parser.add_argument("text", nargs="*", help="the sentence")
    add_knowledge_arguments(parser)
    parser.add_argument(
        "--live",
        action="store_true",
        help="use what the running graph knows and its parameters; without a sentence, explain what the graph hears",
    )
    parser.add_argument(
        "--after",
        action="append",
        default=[],
        metavar="SENTENCE",
        help="a sentence that was said before; a fragment such as 'again' changes or repeats its command",
    )
    parser.add_argument(
        "--without",
        action="append",
        default=[],
        metavar="RULE",
        help="switch a rule off ('rfn passes --all' lists them)",
    )
    parser.add_argument(
        "--behaviour",
        choices=sorted(BEHAVIOURS),
        help="parameters of the nodes as the launch argument 'behaviour' sets them (default: now)",
    )
    parser.add_argument("--svg", metavar="FILE", help="also draw the parse into this file")
    parser.add_argument(
        "--batch", metavar="FILE", help="a file with one sentence in each line; '-' reads standard input"
    )
    parser.add_argument("--json", action="store_true", help="write one JSON object for each sentence")


def run(arguments: argparse.Namespace) -> int:
    """Explain one sentence or many; return the exit status."""
    is_following = arguments.live and not arguments.text and not arguments.batch
    unknown = unknown_rules(arguments.without)
    wrong = ""
    if unknown:
        wrong = f"no rule is named {', '.join(unknown)}"
    elif bool(arguments.text) == bool(arguments.batch) and not is_following:
        wrong = "give a sentence or --batch FILE"
    elif arguments.live and arguments.behaviour:
        wrong = "--live uses the parameters of the running graph: omit --behaviour"
    elif arguments.live and (arguments.names or arguments.world):
        wrong = "--live uses what the running graph knows: omit --names and --world"
    if wrong:
        print(f"rfn explain: {wrong}", file=sys.stderr)
        return 2
    try:
        if is_following:
            return _follow()
        lines = _lines(arguments.batch) if arguments.batch else [" ".join(arguments.text)]
        pipeline = told_problems(_pipeline(arguments))
    except (OSError, ModelError, LookupError, FileRefused) as error:
        print(f"rfn explain: {error}", file=sys.stderr)
        return 2
    context = Context()
    for said in arguments.after:
        context = pipeline.understand_safely(said, context).context
    for line in lines:
        understanding = pipeline.understand_safely(line, context)
        print(
            json.dumps(to_json(understanding), ensure_ascii=False) if arguments.json else describe(understanding),
            flush=True,
        )
    if not arguments.live and not arguments.json:
        print(PRETENCE)
    if arguments.batch:
        return 0
    if arguments.svg and understanding.tree is not None:
        with open(arguments.svg, "w", encoding="utf-8") as file:
            file.write(svg_arcs(understanding.tree_read or understanding.tree))
    return 0 if understanding.reply.code == "DONE" else 1


def _lines(path: str) -> List[str]:
    """Return the lines of a batch. Bytes that are not UTF-8 become replacement characters, because every line gets an
    object."""
    if path == "-":
        content = sys.stdin.buffer.read()
    else:
        with open(path, "rb") as file:
            content = file.read()
    lines = content.decode("utf-8", errors="replace").split("\n")
    return [line.rstrip("\r") for line in (lines[:-1] if not lines[-1] else lines)]


def _pipeline(arguments: argparse.Namespace) -> Pipeline:
    without = frozenset(arguments.without)
    if arguments.live:
        from roboframenet_tools.ros_graph import live_knowledge, live_parameters, live_world

        knowledge = live_knowledge(timeout_s=10.0)
        world, parameters = live_world(timeout_s=5.0), live_parameters()
        return Pipeline(
            knowledge,
            parameters=parameters,
            without=without,
            is_traced=not arguments.json,
            world=world,
            likeness=Likeness(),
        )
    parameters = BEHAVIOURS[arguments.behaviour or "now"]
    return offline_pipeline(arguments, parameters=parameters, without=without, is_traced=not arguments.json)


def _follow() -> int:
    """Print the events of the running graph about each command, until Ctrl-C."""
    from roboframenet_tools.ros_graph import live_traces

    for text in live_traces():
        print(text, flush=True)
    return 0


def _steps(candidate: Candidate) -> str:
    return ", then ".join(
        f"{frame.name}({', '.join(f'{name}={text}' for name, text in frame.texts)}) on {frame.server}"
        for frame in candidate.frames
    )


def _relations(tree: DependencyTree) -> str:
    """Return the relations under the names that lexical units use: "prep_at(Wave, Alice)" for obl with "at"."""
    return " ".join(
        f"{one.relation}({tree.word(one.governor).form}, {tree.word(one.dependent).form})"
        for one in collapsed(tree)
        if one.governor and one.relation != "punct"
    )


def describe(understanding: Understanding) -> str:
    """Return the explanation for a person: the tree that was read, and what each rule did in the run that decided."""
    lines = [understanding.text.strip(), ""]
    tree = understanding.tree_read or understanding.tree
    if tree is not None:
        lines += [draw_arcs(tree), "", f"  {'for lexical units':<{_RULE_WIDTH}} {_relations(tree)}"]
        lines += [f"  {'may hang elsewhere':<{_RULE_WIDTH}} {line}" for line in described(tree)]
        lines.append("")
    lines += [describe_line(line) for line in understanding.trace]
    if understanding.readings:
        lines.append("frames reached: " + ", then ".join(reading.unit.frame_name for reading in understanding.readings))
    lines += [f"description: {reading}" for reading in understanding.descriptions]
    for number, (reading, candidates) in enumerate(zip(understanding.readings, understanding.candidates), start=1):
        if len(understanding.candidates) > 1:
            lines.append(f'clause {number}, "{reading.clause_text}"')
        lines += [
            f"{'otherwise' if is_behind else 'would run'}: {_steps(candidate)}"
            for is_behind, candidate in enumerate(candidates)
        ]
    reply = understanding.reply
    lines.append(f"reply: {reply.outcome.lower().replace('_', ' ')} [{reply.code}] {reply.sentence}")
    if understanding.behind is not None:
        lines += ["", "when the robot has stopped:", describe(understanding.behind)]
    return "\n".join(lines)


def describe_line(line: TraceLine) -> str:
    """Return a line of the trace, with the name of the rule in a column of its own."""
    return f"  {line.rule:<{_RULE_WIDTH}} {line.what}"
