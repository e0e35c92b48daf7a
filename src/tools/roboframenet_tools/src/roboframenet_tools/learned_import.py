"""``rfn import-learned``: takes over what persons taught another robot, from its file."""

import argparse
import os
import sys
from typing import Tuple

from nearest_meaning.learned_file import LearnedFile, default_learned_file
from roboframenet_ros.sqlite_file import StoreError
from roboframenet_tools.learned import NothingLearned, add_file_argument, learned_units

EXAMPLES = """examples:
  rfn import-learned /from/another/robot/learned.sqlite

Words that this robot has been taught itself keep their meaning. A running
semantic_framer sees before the next command what is new.

exit status: 0 imported, 2 wrong usage, or it was not imported
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn import-learned``."""
    parser.epilog = EXAMPLES
    parser.add_argument("source", metavar="SOURCE", help="the file of the other robot")
    add_file_argument(parser)


def run(arguments: argparse.Namespace) -> int:
    """Import; return the exit status."""
    try:
        new, kept = imported(arguments.source, os.path.expanduser(arguments.file or default_learned_file()))
    except (NothingLearned, StoreError) as error:
        print(f"rfn import-learned: {error}", file=sys.stderr)
        return 2
    print(f"{new} imported, {kept} not: their words have a meaning already")
    return 0


def imported(source: str, path: str) -> Tuple[int, int]:
    """Copy what one file has into another; return how much is new, and how much was left as it was.

    Args:
        source: the file of the other robot
        path: the own file, which is made if there is none
    Raises:
        NothingLearned: there is no file of the other robot
        StoreError: one of the files cannot be read or written
    """
    units = learned_units(source)
    file = LearnedFile(path)
    try:
        own = {unit.said for unit in file.units()}
        new = [unit for unit in units if unit.said not in own]
        for unit in new:
            file.add(unit)
    finally:
        file.close()
    return len(new), len(units) - len(new)
