"""``rfn check``: finds problems in frame and lexical unit files."""

import argparse
import os
import sys

from offline_pipeline.file_checks import Examples, example_problems, find_problems, load_paths
from roboframenet_tools.written_out import written_out
from stanford_parser_ros.inference import ModelError

EXAMPLES = """examples:
  rfn check my_domain
  rfn check --examples my_domain
  rfn check my_domain/frames/winking.yaml --with my_domain
  rfn check --expanded my_domain/lexical_units/docking.yaml --with my_domain

exit status: 0 no problems, 1 problems, 2 wrong usage
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn check``."""
    parser.epilog = EXAMPLES
    parser.add_argument(
        "paths", nargs="+", help="files, and folders that contain folders named frames and lexical_units"
    )
    parser.add_argument(
        "--with",
        dest="others",
        action="append",
        default=[],
        metavar="FOLDER",
        help="frames and units that the files may refer to; they are not checked",
    )
    parser.add_argument(
        "--examples", action="store_true", help="run the examples of each unit through the parser and the framer"
    )
    parser.add_argument(
        "--expanded", action="store_true", help="print each unit with the relations that it inherits from roles"
    )


def run(arguments: argparse.Namespace) -> int:
    """Check the files; return the exit status."""
    missing = [path for path in arguments.paths + arguments.others if not os.path.exists(path)]
    if missing:
        print(f"rfn check: there is no {', '.join(missing)}", file=sys.stderr)
        return 2
    knowledge, checked = load_paths(arguments.paths, arguments.others)
    if not checked:
        print("rfn check: found no YAML files in folders named frames and lexical_units", file=sys.stderr)
        return 2
    problems = find_problems(knowledge, checked)
    if arguments.expanded:
        for unit in knowledge.lexicon.whole_units(knowledge.frames):
            if unit.path in checked and unit.verbs:
                print(written_out(unit))
    if arguments.examples:
        try:
            problems += example_problems(Examples(knowledge), checked)
        except ModelError as error:
            print(f"rfn check: {error}", file=sys.stderr)
            return 2
    for problem in problems:
        print(problem)
    print(f"{_count(len(checked), 'file')}, {_count(len(problems), 'problem')}")
    return 1 if problems else 0


def _count(number: int, what: str) -> str:
    return f"{number} {what}" if number == 1 else f"{number} {what}s"
