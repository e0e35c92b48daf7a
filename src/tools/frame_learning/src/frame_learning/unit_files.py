"""Writes learned units as files that a person can read and edit."""

import textwrap
from typing import Callable, List, Mapping, Sequence, Tuple

from frame_learning.evidence import Lesson
from frame_learning.unit_induction import LearnedUnit, core_elements
from semantic_frames.frame import SemanticFrame

#: Number of examples in a file; more make it hard to read.
MOST_EXAMPLES = 6


def to_yaml(units: Sequence[LearnedUnit], is_understood: Callable[[Lesson], bool]) -> str:
    """Write the units of one frame as a lexical unit file.

    Args:
        units: of one frame
        is_understood: whether a sentence may be an example
    """
    lines: List[str] = []
    for unit in units:
        lines += [f"- frame_name: {unit.frame_name}", *_verbs(unit)]
        if unit.open_relations or unit.closed_relations:
            lines.append("  frame_element_grammatical_relations:")
        for name, relations in list(unit.closed_relations.items()) + list(unit.open_relations.items()):
            is_closed = unit.closed_relations.get(name) is relations
            lines += [f"    - name: {name}", f"      relation: [{', '.join(relations)}]", "      argument: phrase"]
            lines += [f"      words: [{', '.join(map(_quoted, unit.words[name]))}]"] if is_closed else []
            typed = is_closed and name in unit.types
            lines += [f"      semantic_type: [{', '.join(unit.types[name])}]"] if typed else []
            lines += ["      required: True"] if name in unit.required else []
            lines += [f"      after_place: [{_quoted(unit.after_place[name])}]"] if name in unit.after_place else []
        examples = [lesson for lesson in unit.lessons if is_understood(lesson)][:MOST_EXAMPLES]
        if examples:
            lines.append("  examples:")
        for lesson in examples:
            filled = ", ".join(f"{name}: {_quoted(words)}" for name, words in lesson.arguments.items())
            lines.append(f"    - text: {_quoted(lesson.sentence.text)}")
            lines += [f"      frame_elements: {{{filled}}}"] if filled else []
    return "\n".join(lines) + "\n"


def frame_yaml(name: str, lessons: Sequence[Lesson]) -> str:
    """Write the file of a frame that no file describes yet; elements that every sentence fills are core."""
    names = list(dict.fromkeys(element for lesson in lessons for element in lesson.sentence.elements))
    core = core_elements(name, lessons, None)
    verbs = sorted({lesson.verb for lesson in lessons})
    lines = [
        "# Learned. Name the frame of FrameNet in `framenet`, or say in a comment why it has none.",
        f"name: {name}",
        f"description: The robot does what {' or '.join(_quoted(verb) for verb in verbs)} means.",
    ]
    lines += ["frame_elements:"] if names else []
    for element in names:
        lines += [f"  - name: {element}", f"    is_core: {element in core}"]
    return "\n".join(lines) + "\n"


def names_of_new_frames(frames: Mapping[str, SemanticFrame], units: Sequence[LearnedUnit]) -> Tuple[str, ...]:
    """Return the names of frames that units evoke but no file describes."""
    return tuple(sorted({unit.frame_name for unit in units} - set(frames)))


def _verbs(unit: LearnedUnit) -> List[str]:
    if not unit.verbs_alike:
        return [f"  verb: [{', '.join(unit.verbs)}]"]
    alike = textwrap.wrap(", ".join(unit.verbs_alike), width=100, break_on_hyphens=False)
    return ["  verb:", f"    [{', '.join(unit.verbs)},", "     # Like them, by WordNet.", *_indented(alike, "]")]


def _indented(lines: Sequence[str], end: str) -> List[str]:
    return [f"     {line}" for line in lines[:-1]] + [f"     {lines[-1]}{end}"]


def _quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'
