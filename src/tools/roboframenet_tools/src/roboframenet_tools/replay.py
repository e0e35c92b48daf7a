"""``rfn replay``: reads recorded sentences with this version, and shows where it differs."""

import argparse
import sys

from offline_pipeline.knowledge import load_knowledge, pretend_servers, shipped_domains
from offline_pipeline.pipeline import BEHAVIOURS, Pipeline, to_json
from roboframenet_tools.folders import folders_of
from roboframenet_tools.recording import RecordingError, is_same, read_records, record_of
from semantic_framer.values.dialogue import Context
from stanford_parser_ros.inference import ModelError

EXAMPLES = """examples:
  rfn record said.jsonl              in the old version, while people talk to the robot
  rfn replay said.jsonl              in the new version
  rfn explain --batch sentences.txt --json > said.jsonl    the same without a robot

The sentences are read in their order, so that answers to questions are understood. Nothing is carried out.
Exit status: 0 no difference, 1 a difference, 2 wrong usage
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn replay``."""
    parser.epilog = EXAMPLES
    parser.add_argument("file", help="from 'rfn record', or from 'rfn explain --json'")
    parser.add_argument(
        "--with",
        dest="others",
        action="append",
        default=[],
        metavar="FOLDER[,FOLDER]",
        help="folders of frames and units beside those shipped",
    )
    parser.add_argument("--behaviour", choices=sorted(BEHAVIOURS), default="now", help="as for rfn explain")


def run(arguments: argparse.Namespace) -> int:
    """Replay; return the exit status."""
    try:
        with open(arguments.file, encoding="utf-8") as file:
            records = read_records(file, arguments.file)
        knowledge = load_knowledge([shipped_domains(), *folders_of(arguments.others)])
        pretend_servers(knowledge.graph)
        pipeline = Pipeline(knowledge, parameters=BEHAVIOURS[arguments.behaviour])
    except (OSError, UnicodeDecodeError, RecordingError, ModelError) as error:
        print(f"rfn replay: {error}", file=sys.stderr)
        return 2
    context = Context()
    differing = 0
    for before in records:
        understanding = pipeline.understand_safely(before.text, context)
        context = understanding.context
        after = record_of(to_json(understanding))
        if not is_same(before, after):
            differing += 1
            print(f'"{before.text}"\n  - {before}\n  + {after}', flush=True)
    print(f"{len(records)} sentences, {differing} differ")
    return 1 if differing else 0
