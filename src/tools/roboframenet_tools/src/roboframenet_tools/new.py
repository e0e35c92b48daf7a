"""``rfn new``: writes the files that a new ability needs, ready to be filled in."""

import argparse
import os
import sys
from typing import Dict, FrozenSet, Optional, Tuple

from offline_pipeline.knowledge import Knowledge, load_knowledge, shipped_domains
from roboframenet_tools.scaffold import Ability, ability_files, is_program, node_line, package_files
from roboframenet_tools.verb_forms import verb_of

EXAMPLES = """examples:
  rfn new winking                             the verb is "wink"
  rfn new winking --verb blink --folder my_robot
  rfn new winking --package src/my_robot      a catkin package, with launch file and rostest
  rfn new computing --verb compute --from-action actionlib_tutorials/Fibonacci.action
  rfn check --examples my_robot

It refuses to overwrite a file, and the name of a shipped frame; an existing package gets the files of one more ability.
Exit status: 0 written, 1 a file or a frame of that name exists already, 2 wrong usage
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn new``."""
    parser.epilog = EXAMPLES
    parser.add_argument("name", help="name of the frame, such as winking")
    parser.add_argument("--verb", help="verb that evokes it, base form (default: from the name, 'wink' for winking)")
    where = parser.add_mutually_exclusive_group()
    where.add_argument("--folder", default=".", help="folder for the files (default: this one)")
    where.add_argument(
        "--package", metavar="FOLDER", help="the same, as a catkin package of that name, with launch file and rostest"
    )
    parser.add_argument(
        "--from-action",
        metavar="PACKAGE/NAME.action",
        help="the frame gets an element for each field of the goal, and the server takes these goals",
    )


def run(arguments: argparse.Namespace) -> int:
    """Write the files; return the exit status."""
    known = load_knowledge([shipped_domains()])
    try:
        ability = _ability(arguments, known)
    except ValueError as error:
        print(f"rfn new: {error}", file=sys.stderr)
        return 2
    folder = arguments.package or arguments.folder
    files = ability_files(ability)
    is_new_package = bool(arguments.package) and not os.path.exists(os.path.join(folder, "package.xml"))
    if is_new_package:
        files = {**package_files(ability), **files}
    there = [path for path in (os.path.join(folder, path) for path in files) if os.path.lexists(path)]
    if there:
        print(f"rfn new: these files exist already: {', '.join(there)}; nothing was written", file=sys.stderr)
        return 1
    if ability.name in known.frames:
        print(
            f"rfn new: the frame '{ability.name}' exists already ({known.frames[ability.name].path}): a server can "
            "register for it without new files. Or take another name; nothing was written",
            file=sys.stderr,
        )
        return 1
    others = sorted({unit.frame_name for unit in known.lexicon.units if ability.verb in unit.verbs})
    if others:
        print(
            f"rfn new: warning: '{ability.verb}' evokes {', '.join(others)} already; the relations that fit decide "
            "between them",
            file=sys.stderr,
        )
    _write(files, folder)
    print("\n".join(next_steps(ability, folder, is_new_package=is_new_package)))
    return 0


def _ability(arguments: argparse.Namespace, known: Knowledge) -> Ability:
    """
    Raises:
        ValueError: a name or the verb has another form, or the action type does not exist
    """
    verbs: FrozenSet[str] = frozenset(verb for unit in known.lexicon.units for verb in unit.verbs)
    verb: Optional[str] = arguments.verb or verb_of(arguments.name, verbs.__contains__)
    package = os.path.basename(os.path.abspath(arguments.package)) if arguments.package else ""
    if verb is None:
        raise ValueError(f"which verb evokes '{arguments.name}'? Give it with --verb")
    if not arguments.from_action:
        return Ability(arguments.name, verb, package=package)
    from roboframenet_tools.ros_action_types import action_class, elements_of

    action, kind = action_class(arguments.from_action)
    return Ability(arguments.name, verb, elements=elements_of(kind), action=action, package=package)


def _write(files: Dict[str, str], folder: str) -> None:
    for name, text in files.items():
        path = os.path.join(folder, name)
        os.makedirs(os.path.dirname(path) or ".", exist_ok=True)
        with open(path, "x", encoding="utf-8") as file:
            file.write(text)
        if is_program(name):
            os.chmod(path, 0o755)
        print(path)


def next_steps(ability: Ability, folder: str, *, is_new_package: bool) -> Tuple[str, ...]:
    """Return what a person does next, a command in each line."""
    name, package = ability.name, ability.package
    lines = ["", f'The verb is "{ability.verb}". Next:']
    steps = [
        (f"rfn check --examples {folder}", "the example sentences are understood"),
        (f"edit {os.path.join(folder, 'nodes', name + '_server')}", "what the robot does"),
    ]
    if package and not is_new_package:
        steps.append(
            (f"edit {os.path.join(folder, 'launch', package + '.launch')}", f"add {node_line(ability).strip()}")
        )
    if package:
        steps += [
            ("catkin_make && source devel/setup.bash", "in the workspace of the package"),
            (f"rostest {package} {name}.test", "with a pipeline of its own"),
            (f"roslaunch {package} {package}.launch", "while a pipeline runs"),
        ]
    else:
        steps.append((os.path.join(folder, "nodes", name + "_server"), "while a pipeline runs"))
    width = max(len(command) for command, _ in steps)
    return (*lines, *(f"  {command:<{width}}   # {meaning}" for command, meaning in steps))
