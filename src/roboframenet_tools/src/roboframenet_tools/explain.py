"""``rfn explain``: how a sentence is understood, step by step."""

import argparse
import json
import sys
from typing import List

from frame_registrar.search import Candidate
from roboframenet_tools.drawing import draw_arcs, svg_arcs
from roboframenet_tools.understanding import (
    Knowledge,
    Pipeline,
    Understanding,
    load_knowledge,
    pretend_servers,
    shipped_domains,
    to_json,
)
from stanford_parser_ros.model import ModelError

EXAMPLES = """examples:
  rfn explain "Bring me the mug from the kitchen."
  rfn explain --svg parse.svg "Turn left 120 degrees."
  rfn explain --live "Go to the office."
  rfn explain --batch sentences.txt --json > understood.jsonl

exit status: 0 it would be done (a batch: every line has its object), 1 it would not, 2 wrong usage
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn explain``."""
    parser.epilog = EXAMPLES
    parser.add_argument("text", nargs="*", help="the sentence")
    parser.add_argument(
        "--domains", action="append", metavar="FOLDER", help="folder of frames and units (default: those shipped)"
    )
    parser.add_argument(
        "--live", action="store_true", help="frames, units and servers of the running graph; needs a ROS master"
    )
    parser.add_argument("--svg", metavar="FILE", help="also draw the parse into this file")
    parser.add_argument("--batch", metavar="FILE", help="one sentence a line; '-' reads standard input")
    parser.add_argument("--json", action="store_true", help="one JSON object a sentence")


def run(arguments: argparse.Namespace) -> int:
    """Explain one sentence or many; return the exit status."""
    if bool(arguments.text) == bool(arguments.batch):
        print("rfn explain: give a sentence or --batch FILE", file=sys.stderr)
        return 2
    try:
        lines = _lines(arguments.batch) if arguments.batch else [" ".join(arguments.text)]
        pipeline = Pipeline(_knowledge(arguments))
    except (OSError, ModelError, LookupError) as error:
        print(f"rfn explain: {error}", file=sys.stderr)
        return 2
    for problem in pipeline.knowledge.problems:
        print(problem, file=sys.stderr)
    for line in lines:
        understanding = pipeline.understand_safely(line)
        print(
            json.dumps(to_json(understanding), ensure_ascii=False) if arguments.json else describe(understanding),
            flush=True,
        )
    if arguments.batch:
        return 0
    if arguments.svg and understanding.tree is not None:
        with open(arguments.svg, "w", encoding="utf-8") as file:
            file.write(svg_arcs(understanding.tree))
    return 0 if understanding.reply.code == "DONE" else 1


def _lines(path: str) -> List[str]:
    """Lines of a batch; bytes that are no UTF-8 become replacement characters, since every line gets its object."""
    if path == "-":
        content = sys.stdin.buffer.read()
    else:
        with open(path, "rb") as file:
            content = file.read()
    lines = content.decode("utf-8", errors="replace").split("\n")
    return [line.rstrip("\r") for line in (lines[:-1] if not lines[-1] else lines)]


def _knowledge(arguments: argparse.Namespace) -> Knowledge:
    if arguments.live:
        from roboframenet_tools.ros_graph import live_knowledge

        return live_knowledge(timeout_s=10.0)
    knowledge = load_knowledge(arguments.domains or [shipped_domains()])
    pretend_servers(knowledge.graph)
    return knowledge


def _steps(candidate: Candidate) -> str:
    return ", then ".join(
        f"{frame.name}({', '.join(f'{name}={text}' for name, text in frame.arguments)}) on {frame.server}"
        for frame in candidate.frames
    )


def describe(understanding: Understanding) -> str:
    """Return the explanation for a person."""
    lines = [understanding.text.strip(), ""]
    if understanding.tree is not None:
        lines += [draw_arcs(understanding.tree), ""]
    for number, attempts in enumerate(understanding.attempts, start=1):
        lines.append(f"clause {number}: {len(attempts)} lexical units tried")
        for attempt in attempts:
            place = f"{attempt.unit.path.rsplit('/', 1)[-1]}:{attempt.unit.line}"
            elements = (
                ", ".join(f"{value.name}={value.argument}" for value in attempt.reading.values)
                if attempt.reading
                else ""
            )
            verdict = "no" if attempt.reading is None else "incomplete" if attempt.wanted else "fits"
            lines.append(f"  {verdict:<10} {attempt.verb} -> {attempt.unit.frame_name}({elements})  [{place}]")
            lines += [f"             no {relations} for {element}" for element, relations in attempt.wanted]
            if attempt.reading is not None and attempt.reading.left_over and understanding.tree is not None:
                words = understanding.tree.words
                left = [words[index - 1].form for index in attempt.reading.left_over if index <= len(words)]
                lines.append(f"             left over: {' '.join(left)}")
    if understanding.readings:
        lines.append("frames reached: " + ", then ".join(reading.unit.frame_name for reading in understanding.readings))
    for reading in understanding.descriptions:
        elements = ", ".join(f"{value.name}={value.argument}" for value in reading.values)
        lines.append(f"said on the way: {reading.unit.frame_name}({elements})")
    for number, (reading, candidates) in enumerate(zip(understanding.readings, understanding.candidates), start=1):
        if len(understanding.candidates) > 1:
            lines.append(f'clause {number}, "{reading.words}"')
        lines += [
            f"{'otherwise' if is_behind else 'would run'}: {_steps(candidate)}"
            for is_behind, candidate in enumerate(candidates)
        ]
    reply = understanding.reply
    lines.append(f"reply: {reply.outcome.lower().replace('_', ' ')} [{reply.code}] {reply.sentence}")
    return "\n".join(lines)
