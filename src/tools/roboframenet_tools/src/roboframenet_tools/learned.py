"""``rfn export-learned``: writes what persons taught the robot as files of a domain, and what is listed of it.

It works on the file, as ``rfn import-learned`` does. A running semantic_framer sees before the next command that it
has changed.
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
  rfn export-learned --out my_domain/lexical_units/learned.yaml --frames my_domain/frames

The file is a lexical unit file as programmers write them: another robot knows it
when it is among its domains. A sequence of deeds also needs its frame: without
--frames it is left out. Kinds and names of places are no lexical units; 'rfn
import-learned' takes them over from the file itself.

exit status: 0 written, 2 wrong usage, or there is nothing to write
"""


class NothingLearned(RuntimeError):
    """There is no file, or nothing of that name in it; the message says so."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn export-learned``."""
    parser.epilog = EXAMPLES
    add_file_argument(parser)
    parser.add_argument("--out", metavar="FILE", help="write this file (default: print)")
    parser.add_argument("--frames", metavar="FOLDER", help="write the frames of sequences into this folder")


def add_file_argument(parser: argparse.ArgumentParser) -> None:
    """Declare ``--file``: where it is kept."""
    parser.add_argument(
        "--file", metavar="FILE", help="where it is kept (default: learned.sqlite in the ROS home folder)"
    )


def run(arguments: argparse.Namespace) -> int:
    """Write the file; return the exit status."""
    try:
        units = learned_units(arguments.file)
        text = exported(units, has_frames=bool(arguments.frames))
        if arguments.frames:
            _write_frames(units, arguments.frames)
        if arguments.out:
            with open(arguments.out, "w", encoding="utf-8") as file:
                file.write(text)
        else:
            print(text, end="")
    except (NothingLearned, StoreError, OSError) as error:
        print(f"rfn export-learned: {error}", file=sys.stderr)
        return 2
    return 0


def _write_frames(units: List[LearnedUnit], folder: str) -> None:
    os.makedirs(folder, exist_ok=True)
    for unit in units:
        if unit.frame_text:
            with open(os.path.join(folder, f"{unit.frame_name}.yaml"), "w", encoding="utf-8") as file:
                file.write(unit.frame_text)


def exported(units: List[LearnedUnit], *, has_frames: bool = False) -> str:
    """Return a lexical unit file with all units, and a remark on what it leaves out.

    Args:
        units: what is learned
        has_frames: whether sequences are among them, because their frames are written, too
    Raises:
        NothingLearned: there are none
    """
    if not units:
        raise NothingLearned("nothing is learned")
    written = [bool(unit.unit_text) and (has_frames or not unit.frame_text) for unit in units]
    if not any(written):
        raise NothingLearned("nothing that is learned is a lexical unit without a frame of its own; see --help")
    return "".join(
        f"# {_described(unit)}\n{unit.unit_text.rstrip()}\n" if is_written else f"# Left out:\n# {_described(unit)}\n"
        for unit, is_written in zip(units, written)
    )


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
    frame = f" ({unit.frame_name})" if unit.unit_text else ""
    return f'{unit.meaning}{frame}; taught{who} on {when} in "{said}"'


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
