"""``rfn export-learned``: writes what persons taught the robot as a lexical unit file, and what is listed of it.

It works on the file. A running semantic_framer sees before the next command that it has changed.
"""

import argparse
import os
import sys
from datetime import datetime, timezone
from typing import Iterator, List

from nearest_meaning.learned import LearnedUnit
from nearest_meaning.learned_file import LearnedFile, default_learned_file
from roboframenet_ros.sqlite_file import StoreError

EXAMPLES = """examples:
  rfn export-learned
  rfn export-learned --out my_domain/lexical_units/learned.yaml

The file is a lexical unit file as programmers write them: another robot knows it
when it is among its domains.

exit status: 0 written, 2 wrong usage, or there is nothing to write
"""


class NothingLearned(RuntimeError):
    """There is no file, or nothing of that name in it; the message says so."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn export-learned``."""
    parser.epilog = EXAMPLES
    parser.add_argument(
        "--file", metavar="FILE", help="where it is kept (default: learned.sqlite in the ROS home folder)"
    )
    parser.add_argument("--out", metavar="FILE", help="write this file (default: print)")


def run(arguments: argparse.Namespace) -> int:
    """Write the file; return the exit status."""
    try:
        text = exported(learned_units(arguments.file))
        if arguments.out:
            with open(arguments.out, "w", encoding="utf-8") as file:
                file.write(text)
        else:
            print(text, end="")
    except (NothingLearned, StoreError, OSError) as error:
        print(f"rfn export-learned: {error}", file=sys.stderr)
        return 2
    return 0


def exported(units: List[LearnedUnit]) -> str:
    """Return a lexical unit file with all units.

    Raises:
        NothingLearned: there are none
    """
    if not units:
        raise NothingLearned("nothing is learned")
    return "".join(f"# {_described(unit)}\n{unit.text}" for unit in units)


def listed(units: List[LearnedUnit]) -> str:
    """Return a line for each unit."""
    lines = [f"{len(units)} learned"]
    width = max((len(unit.name) for unit in units), default=0)
    lines += [f"{unit.name:<{width}}  {_described(unit)}" for unit in units]
    return "\n".join(lines)


def _described(unit: LearnedUnit) -> str:
    when = datetime.fromtimestamp(unit.when_s, timezone.utc).strftime("%Y-%m-%d %H:%M UTC")
    who = f" by {unit.who}" if unit.who else ""
    said = " ".join(unit.sentence.split())
    return f'"{unit.said}" means "{unit.verb}" ({unit.frame_name}); taught{who} on {when} in "{said}"'


def learned_units(path: str = "") -> List[LearnedUnit]:
    """Return what a file holds; what cannot be read of it is named on standard error.

    Args:
        path: of the file; empty for the default one
    Raises:
        NothingLearned: there is no file
        StoreError: it cannot be read
    """
    return [unit for file in _opened(path) for unit in file.units()]


def forget(name: str, path: str = "") -> str:
    """Forget one unit, and return what to tell.

    Args:
        name: as ``rfn list --learned`` shows it
        path: of the file; empty for the default one
    Raises:
        NothingLearned: there is no file, or no such unit in it
        StoreError: it cannot be written
    """
    for file in _opened(path):
        if file.forget(name):
            return f"{name} is forgotten. It was kept in {file.path}."
    raise NothingLearned(f"nothing learned is named {name}; 'rfn list --learned' shows the names")


def _opened(path: str) -> Iterator[LearnedFile]:
    path = os.path.expanduser(path or default_learned_file())
    if not os.path.isfile(path):
        raise NothingLearned(f"nothing is learned: there is no file {path}; --file names another one")
    file = LearnedFile(path)
    try:
        yield file
        for problem in file.problems:
            print(problem, file=sys.stderr)
    finally:
        file.close()
