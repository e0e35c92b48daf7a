"""Checks frame and lexical unit files: their form, their references, and the meaning of their examples."""

import os
from typing import Iterable, List, Optional, Tuple

from checked_files.source_files import FRAMES_FOLDER, LEXICAL_UNITS_FOLDER, yaml_files
from offline_pipeline.knowledge import Knowledge, load_files, pretend_servers, with_names
from offline_pipeline.pipeline import Pipeline
from semantic_framer.framer import Understood, read
from semantic_frames import Problem, check_lexical_unit
from semantic_frames.lexical_unit import Example, LexicalUnit


def load_paths(paths: Iterable[str], others: Iterable[str] = ()) -> Tuple[Knowledge, Tuple[str, ...]]:
    """Read files and folders.

    Args:
        paths: files and folders to check; a file with a key ``frame_name`` is a lexical unit file, one with a key
            ``names`` is a file of names
        others: folders that the checked files may refer to
    Returns:
        all knowledge that was read, and the paths of the files to check
    """
    frames: List[str] = []
    units: List[str] = []
    names: List[str] = []
    for path in paths:
        if os.path.isdir(path):
            frames += yaml_files([path], FRAMES_FOLDER)
            units += yaml_files([path], LEXICAL_UNITS_FOLDER)
        else:
            files = units if _is_unit_file(path) else names if _has_key(path, "names") else frames
            files.append(os.path.abspath(path))
    checked = tuple(dict.fromkeys(frames + units + names))
    frames += yaml_files(others, FRAMES_FOLDER)
    units += yaml_files(others, LEXICAL_UNITS_FOLDER)
    return with_names(load_files(dict.fromkeys(frames), dict.fromkeys(units)), names), checked


def _is_unit_file(path: str) -> bool:
    if os.path.basename(os.path.dirname(os.path.abspath(path))) == LEXICAL_UNITS_FOLDER:
        return True
    return _has_key(path, "frame_name")


def _has_key(path: str, key: str) -> bool:
    with open(path, encoding="utf-8", errors="replace") as file:
        return any(line.lstrip("- ").startswith(f"{key}:") for line in file)


def find_problems(knowledge: Knowledge, checked: Tuple[str, ...]) -> List[Problem]:
    """Return the problems of the checked files: their form, cycles, unknown frames, children and elements."""
    problems = list(knowledge.problems) + list(knowledge.graph.unknown_children())
    for unit in knowledge.lexicon.units:
        problems += check_lexical_unit(unit, knowledge.frames)
    # A refused frame has a problem of its own; a reference to it is not a second problem.
    refused = {f"'{name}'" for name in knowledge.read_names - set(knowledge.frames)}
    return sorted(
        (
            problem
            for problem in problems
            if problem.path in checked and not (problem.code == "UNKNOWN_FRAME" and problem.found in refused)
        ),
        key=lambda problem: (problem.path, problem.line),
    )


class Examples:
    """Runs examples of lexical units; the parser is loaded once."""

    def __init__(self, knowledge: Knowledge, pipeline: Optional[Pipeline] = None) -> None:
        """
        Raises:
            ModelError: the models cannot be loaded
        """
        pretend_servers(knowledge.graph)
        self.knowledge = knowledge
        self._pipeline = pipeline or Pipeline(knowledge)

    def problem(self, unit: LexicalUnit, example: Example) -> Optional[Problem]:
        """Return why the pipeline does not understand an example as its unit says; None if it does.

        It is understood when it is one clause whose first reading has the frame of the unit and the expected arguments.
        """
        outcome, _ = read(self._pipeline.parse(example.text), self.knowledge.lexicon, self.knowledge.frames)
        if not isinstance(outcome, Understood):
            found = f"{outcome.code}: {outcome.sentence}"
        else:
            reading = outcome.clauses[0][0]
            arguments = {value.name: value.text for value in reading.arguments}
            is_meant = reading.unit.frame_name == unit.frame_name and all(
                arguments.get(name) == text for name, text in example.frame_elements.items()
            )
            if is_meant and len(outcome.clauses) == 1:
                return None
            found = "; ".join(
                f"{readings[0].unit.frame_name}("
                + ", ".join(f"{value.name}={value.text}" for value in readings[0].arguments)
                + ")"
                for readings in outcome.clauses
            )
        expected = ", ".join(f"{name}={text}" for name, text in example.frame_elements.items())
        return Problem(
            "EXAMPLE_NOT_UNDERSTOOD",
            unit.path,
            example.line,
            f'"{example.text}"',
            found,
            f"{unit.frame_name}({expected})",
            "'rfn explain' shows why",
        )


def example_problems(examples: Examples, checked: Tuple[str, ...]) -> List[Problem]:
    """Run the examples of every checked unit."""
    found = [
        examples.problem(unit, example)
        for unit in examples.knowledge.lexicon.units
        if unit.path in checked
        for example in unit.examples
    ]
    return [problem for problem in found if problem is not None]
