"""``rfn new``: writes the files that a new frame needs, ready to be filled in."""

import argparse
import os
import re
import sys
from typing import Dict

EXAMPLES = """examples:
  rfn new waving --verb wave
  rfn new waving --verb wave --folder my_robot
  rfn check --examples my_robot

It refuses to overwrite a file. Exit status: 0 written, 1 a file exists already, 2 wrong usage
"""
_FRAME = """# Name the frame of FrameNet here, or say in a comment why it has none.
name: {name}
description: The robot does what "{verb}" means.
framenet: ""
frame_elements:
  - name: theme
    is_core: True
    question: What should I {verb}?
    answer: the box
"""
_UNIT = """frame_name: {name}
verb: [{verb}]
frame_element_grammatical_relations:
  - name: theme
    relation: dobj
    argument: phrase
examples:
  - text: {capital} the box.
    frame_elements: {{theme: the box}}
  - text: please {verb} the ball
    frame_elements: {{theme: the ball}}
  - text: Could you {verb} the red mug?
    frame_elements: {{theme: the red mug}}
"""
_SERVER = '''#!/usr/bin/env python3
"""RFNServer of the frame {name}."""
import os

import rospy
from rfnserver import RFNServer
from rfnserver.arguments import argument

FOLDER = os.path.join(os.path.dirname(os.path.realpath(__file__)), "..")


def {name}(frame):
    """Do it; a goal that is not ended here succeeds, an exception aborts it with its text."""
    rospy.loginfo("{verb}: %s", argument(frame, "theme"))


if __name__ == "__main__":
    rospy.init_node("{name}")
    server = RFNServer("{name}", {name})
    server.add_semantic_frame(os.path.join(FOLDER, "frames", "{name}.yaml"))
    server.add_lexical_unit(os.path.join(FOLDER, "lexical_units", "{name}.yaml"))
    server.register_with_frame("{name}")
    server.start()
    rospy.spin()
'''
_TEST = '''"""The files of the frame {name} are right, and its examples are understood."""
from pathlib import Path

from offline_pipeline.file_checks import Examples, example_problems, find_problems, load_paths


def test_files_and_examples():
    knowledge, checked = load_paths([str(Path(__file__).resolve().parents[1])])
    assert "{name}" in knowledge.frames
    assert find_problems(knowledge, checked) == []
    assert example_problems(Examples(knowledge), checked) == []
'''


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn new``."""
    parser.epilog = EXAMPLES
    parser.add_argument("name", help="name of the frame, such as waving")
    parser.add_argument("--verb", help="verb that evokes it, base form (default: the name)")
    parser.add_argument("--folder", default=".", help="folder for the files (default: this one)")


def run(arguments: argparse.Namespace) -> int:
    """Write the files; return the exit status."""
    try:
        files = scaffold(arguments.name, arguments.verb or arguments.name)
    except ValueError as error:
        print(f"rfn new: {error}", file=sys.stderr)
        return 2
    paths = {os.path.join(arguments.folder, path): text for path, text in files.items()}
    there = [path for path in paths if os.path.lexists(path)]
    if there:
        print(f"rfn new: these files exist already: {', '.join(there)}; nothing was written", file=sys.stderr)
        return 1
    for path, text in paths.items():
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "x", encoding="utf-8") as file:
            file.write(text)
        if path.endswith("_server"):
            os.chmod(path, 0o755)
        print(path)
    return 0


def scaffold(name: str, verb: str) -> Dict[str, str]:
    """Return the text of each file by its path in the folder.

    Args:
        name: of the frame: lower case letters, digits and underscores
        verb: that evokes it, with a particle if it has one
    Raises:
        ValueError: the name or the verb has another form
    """
    if not re.fullmatch(r"[a-z][a-z0-9_]*", name):
        raise ValueError(
            f"'{name}' is not the name of a frame: use lower case letters, digits and underscores, such as waving"
        )
    if not re.fullmatch(r"[a-z]+( [a-z]+)*", verb):
        raise ValueError(f"'{verb}' is not a verb: use lower case words, such as 'pick up' (give it with --verb)")
    words = {"name": name, "verb": verb, "capital": verb.capitalize()}
    templates = {
        f"frames/{name}.yaml": _FRAME,
        f"lexical_units/{name}.yaml": _UNIT,
        f"nodes/{name}_server": _SERVER,
        f"test/test_{name}.py": _TEST,
    }
    return {path: template.format(**words) for path, template in templates.items()}
