"""``rfn test``: reads the sentences of a file, and shows those whose reading is another than the file says."""

import argparse
import sys
from typing import List

from checked_files import FileRefused
from checked_files.source_files import read_text
from offline_pipeline.pipeline import to_json
from roboframenet_tools.offline import add_knowledge_arguments, offline_pipeline, told_problems
from roboframenet_tools.recording import record_of
from roboframenet_tools.sentence_file import ExpectedReading, load_sentences
from stanford_parser_ros.inference import ModelError

EXAMPLES = """examples:
  rfn test sentences.yaml
  rfn test sentences.yaml --with my_robot
  rfn unknown said.jsonl --out sentences.yaml

The file is a list. Each sentence has the frames that it must evoke, with all of their arguments, the code of the
reply that it must get, or another sentence that means the same:

  - text: Go to the hall.
    frames:
    - navigating_to_location: {goal: the hall}
  - text: Thank you.
    code: TALK
  - text: Off to the hall with you.
    means: Go to the hall.

Each sentence is read for itself. Nothing is carried out.
exit status: 0 each is read so, 1 one is read in another way, 2 wrong usage
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn test``."""
    parser.epilog = EXAMPLES
    parser.add_argument("file", nargs="+", help="a file of sentences")
    add_knowledge_arguments(parser)


def run(arguments: argparse.Namespace) -> int:
    """Read the sentences; return the exit status."""
    try:
        files = [(path, load_sentences(read_text(path), path)) for path in arguments.file]
        pipeline = told_problems(offline_pipeline(arguments))
    except (OSError, FileRefused, ModelError) as error:
        print(f"rfn test: {error}", file=sys.stderr)
        return 2
    differing: List[ExpectedReading] = []
    for path, sentences in files:
        for expected in sentences:
            record = record_of(to_json(pipeline.understand_safely(expected.text)))
            if expected.means:
                expected = expected.as_meant(record_of(to_json(pipeline.understand_safely(expected.means))))
            if not expected.agrees(record):
                differing.append(expected)
                print(f'{path}:{expected.line}: "{expected.text}"\n  - {expected}\n  + {record}', flush=True)
    print(f"{sum(len(sentences) for _, sentences in files)} sentences, {len(differing)} differ")
    return 1 if differing else 0
