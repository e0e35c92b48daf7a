"""``rfn experience``: lists, explains, resets, exports and imports what the robot experienced."""

import argparse
import json
import os
import sys
from typing import Callable, Dict, List, Sequence

from experience.known import Aspect, Record, Subject
from experience.memory import Memory
from experience.rules import Rule
from experience.store import Store, row_of, rule_from_text, rule_to_text, trial_from_row
from experience.trial import Trial
from roboframenet_ros.home_folder import file_in_ros_home
from roboframenet_ros.sqlite_file import StoreError

EXAMPLES = """examples:
  rfn experience list
  rfn experience explain left_arm
  rfn experience export experience.jsonl
  rfn experience import experience.jsonl
  rfn experience reset

It works on the file, and tells a running node to read it again. 'reset' deletes everything, rules too.

exit status: 0 done, 2 wrong usage or a file that cannot be read or written
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn experience``."""
    parser.epilog = EXAMPLES
    parser.add_argument("--file", metavar="FILE", help="where it is kept (default: that of the node)")
    verbs = parser.add_subparsers(dest="verb", metavar="VERB", required=True)
    verbs.add_parser("list", help="show what is known of each server, and the rules")
    explain = verbs.add_parser("explain", help="show what is known of servers in each place and for each kind of thing")
    explain.add_argument("server", help="the name of a server, or a part of it")
    verbs.add_parser("reset", help="delete everything")
    for verb, line in (("export", "write everything as lines of JSON"), ("import", "add what was exported")):
        verbs.add_parser(verb, help=line).add_argument("path", help="of the exported file; - for the standard one")


def run(arguments: argparse.Namespace) -> int:
    """Do what is asked; return the exit status."""
    path = os.path.expanduser(arguments.file) if arguments.file else _file_of_the_node()
    try:
        # Only adding and deleting changes a file; nothing that is imported is pruned here.
        store = Store(path, most_trials=sys.maxsize)
        try:
            for problem in store.problems:
                print(f"rfn experience: {problem}", file=sys.stderr)
            text = _VERBS[arguments.verb](store, arguments)
        finally:
            store.close()
    except (StoreError, OSError, ValueError) as error:
        print(f"rfn experience: {error}", file=sys.stderr)
        return 2
    print(text)
    if arguments.verb in ("reset", "import"):
        problem = _reload()
        if problem:
            print(f"rfn experience: the running node has not read it: {problem}", file=sys.stderr)
            return 2
    return 0


def _list(store: Store, _: argparse.Namespace) -> str:
    trials, rules = store.trials(), store.rules()
    records = Memory(trials).experience.records
    lines = [f"{len(trials)} trials, {len(rules)} rules"]
    if records:
        lines += ["", f"{'frame':<28} {'server':<32} {'last trials':>12} {'takes':>8}"]
    for subject, record in sorted(records.items(), key=lambda item: (item[0].frame, item[0].server)):
        lines.append(f"{subject.frame:<28} {subject.server:<32} {_count(record):>12} {record.took_s:>6.1f} s")
    return "\n".join(lines + [""] * bool(rules) + [rule.sentence for rule in rules])


def _count(record: Record) -> str:
    cell = record.cells.get((Aspect.NOTHING, ""))
    return f"{cell.recent.count(True)} of {len(cell.recent)}" if cell is not None else "-"


def _explain(store: Store, arguments: argparse.Namespace) -> str:
    trials = store.trials()
    found: List[str] = []
    for subject, record in Memory(trials).experience.records.items():
        if arguments.server in subject.server:
            found += _explained(subject, record, [one for one in trials if one.server == subject.server])
    return "\n".join(found) or f'No server with "{arguments.server}" in its name was tried.'


def _explained(subject: Subject, record: Record, trials: Sequence[Trial]) -> List[str]:
    lines = [f"{subject.server} for {subject.frame}: {_count(record)} of the last trials, about {record.took_s:.1f} s"]
    for (aspect, value), cell in sorted(record.cells.items()):
        if aspect != Aspect.NOTHING:
            where = Aspect(aspect).name.lower().replace("_", " ")
            lines.append(f"  {where + ' ' + value:<40} {cell.recent.count(True)} of {len(cell.recent)}")
    failed = [one for one in trials if one.frame == subject.frame and one.reason]
    lines += [f"  it {one.reason}" for one in failed[-3:]]
    return lines


def _reset(store: Store, _: argparse.Namespace) -> str:
    count = len(store.trials())
    store.delete_everything()
    return f"{count} trials and all rules are deleted."


def _export(store: Store, arguments: argparse.Namespace) -> str:
    lines = [json.dumps({"trial": row_of(trial)}) for trial in store.trials()]
    lines += [json.dumps({"rule": rule_to_text(rule)}) for rule in store.rules()]
    if arguments.path == "-":
        return "\n".join(lines)
    with open(arguments.path, "w", encoding="utf-8") as file:
        file.writelines(f"{line}\n" for line in lines)
    return f"{len(lines)} lines are written."


def _import(store: Store, arguments: argparse.Namespace) -> str:
    if arguments.path == "-":
        lines = sys.stdin.read().splitlines()
    else:
        with open(arguments.path, encoding="utf-8") as file:
            lines = file.read().splitlines()
    trials: List[Trial] = []
    rules: List[Rule] = []
    for number, line in enumerate(lines, start=1):
        try:
            ((kind, content),) = json.loads(line).items()
            if kind == "trial":
                trials.append(trial_from_row(content))
            elif kind == "rule":
                rules.append(rule_from_text(content))
            else:
                raise ValueError(f"'{kind}' is neither a trial nor a rule")
        except (ValueError, TypeError, KeyError, AttributeError) as error:
            raise ValueError(f"{arguments.path}:{number}: {error}") from error
    known = set(store.trials())
    new = [trial for trial in trials if trial not in known]
    store.add(new)
    store.write_rules(rules)
    return f"{len(new)} trials and {len(rules)} rules are added; {len(trials) - len(new)} trials were there already."


_VERBS: Dict[str, Callable[[Store, argparse.Namespace], str]] = {
    "list": _list,
    "explain": _explain,
    "reset": _reset,
    "export": _export,
    "import": _import,
}


def _file_of_the_node() -> str:
    """Return where the running node keeps it; without one, where it would."""
    from experience.ros_running_node import file_of_the_node

    named = file_of_the_node()
    return os.path.expanduser(named or file_in_ros_home("experience.sqlite"))


def _reload() -> str:
    """Tell a running node to read the file again; returns why it did not."""
    from experience.ros_running_node import reload_experience

    return reload_experience()
