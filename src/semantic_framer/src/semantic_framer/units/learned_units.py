"""Lexical units that a person has taught: those of a known verb, with the words that were said in its place, and those
of words that mean a deed, or a sequence of deeds in the frame graph."""

import re
from dataclasses import replace
from typing import Any, Dict, List, Mapping, NamedTuple, Sequence, Tuple

import yaml

from checked_files.marked_yaml import line_of
from nearest_meaning.learned import name_in_words, text_with_frame
from semantic_framer.units.lexicon import Lexicon
from semantic_framer.values.dialogue import Lesson
from semantic_frames import FileRefused, Problem, load_lexical_units
from semantic_frames.frame import SemanticFrame, UnknownPolicy
from semantic_frames.lexical_unit import LexicalUnit

#: So much of words is in the name of a frame, which may be longer.
_LONGEST_NAME = 60
_ESCAPED = re.compile(r"\\(.)")
#: Keys of the unit of the known verb that say nothing of other words.
_OF_ITS_VERB = frozenset(["verb", "verb_class", "question", "remark", "asks", "holds", "event", "subject", "examples"])


def text_of_lesson(lesson: Lesson, lexicon: Lexicon) -> str:
    """Return the text of a lexical unit file that teaches what a person agreed to.

    Its units are those of the known verb: so the words are understood with other arguments, and in other moods.

    Raises:
        LookupError: the lexicon has no unit of the verb and the frame, with its file
    """
    found: List[Dict[str, Any]] = []
    files = lexicon.files
    units = [unit for unit in lexicon.units_of(lesson.verb) if unit.frame_name == lesson.frame_name]
    # The known verb may itself have been taught.
    written = [unit for unit in units if not unit.is_learned] or units
    for unit in written:
        if unit.path in files:
            entry = _entry(files[unit.path], unit.line)
            kept = {key: value for key, value in entry.items() if key not in _OF_ITS_VERB}
            found.append({"frame_name": unit.frame_name, "verb": lesson.said, **kept})
    if not found:
        raise LookupError(f"no file has a unit of {lesson.verb!r} for the frame {lesson.frame_name}")
    found[0]["examples"] = [{"text": lesson.sentence}]
    text: str = yaml.safe_dump(found, sort_keys=False, allow_unicode=True, width=120)
    return text


def text_of_idiom(said: str, frame_name: str, values: Mapping[str, str]) -> str:
    """Return the text of a lexical unit file for words that mean one deed, with all of its arguments.

    Args:
        said: the words, in lower case
        frame_name: of the deed
        values: what fills its elements
    """
    entry = {"frame_name": frame_name, "remark": re.escape(said), "values": dict(values)}
    text: str = yaml.safe_dump([entry], sort_keys=False, allow_unicode=True, width=120)
    return text


class Step(NamedTuple):
    """One deed of a sequence.

    Attributes:
        frame: of the deed
        values: what fills its elements, in the words of a lexical unit
    """

    frame: SemanticFrame
    values: Mapping[str, str]


def frame_of_sequence(said: str, who: str) -> str:
    """Return the name of the frame for words that mean a sequence of deeds; each person's own, where one is known."""
    by = f"_by_{name_in_words(who)[:_LONGEST_NAME]}" if who else ""
    return f"taught_{name_in_words(said)[:_LONGEST_NAME]}{by}"


def text_of_sequence(said: str, name: str, steps: Sequence[Step]) -> str:
    """Return the texts of a lexical unit file and of a frame file for words that mean several deeds in their order.

    The frame is their sequence in the frame graph: each of its elements goes to one child. It wants a yes, and knows
    the things spoken of, where one of its children does.

    Args:
        said: the words, in lower case
        name: of the frame
        steps: the deeds
    """
    values: Dict[str, str] = {}
    elements: List[Dict[str, Any]] = []
    children: List[Dict[str, Any]] = []
    for place, step in enumerate(steps, 1):
        relations = []
        for child_name, value in step.values.items():
            parent_name = f"{child_name}_{place}"
            values[parent_name] = value
            relations.append({"parent_name": parent_name, "child_name": child_name})
            elements.append(_element_for(parent_name, child_name, step.frame))
        children.append({"name": step.frame.name, "frame_element_relations": relations})
    policies = [step.frame.on_unknown for step in steps]
    strictest = next(one for one in (UnknownPolicy.REFUSE, UnknownPolicy.ASK, UnknownPolicy.ACT) if one in policies)
    frame: Dict[str, Any] = {
        "name": name,
        "description": f'A person taught the robot what "{said}" means.',
        "on_unknown": strictest.value,
        "confirm": any(step.frame.is_confirmed for step in steps),
        "frame_elements": elements,
        "children": [children],
    }
    frame_text: str = yaml.safe_dump(frame, sort_keys=False, allow_unicode=True, width=120)
    return text_with_frame(text_of_idiom(said, name, values), frame_text)


def _element_for(name: str, child_name: str, child: SemanticFrame) -> Dict[str, Any]:
    """Return the element of a sequence that fills an element of a child."""
    of_child = child.element(child_name)
    if of_child is None:
        return {"name": name}
    taken_over = {
        "framenet": of_child.framenet,
        "semantic_type": list(of_child.semantic_types),
        "confirm": list(of_child.confirmed_values),
    }
    return {"name": name, **{key: value for key, value in taken_over.items() if value}}


def words_of(unit: LexicalUnit) -> Tuple[str, ...]:
    """Return the words that a learned unit explains."""
    return (*unit.verbs, *(_ESCAPED.sub(r"\1", remark.text) for remark in unit.remarks))


def _entry(text: str, line: int) -> Dict[str, Any]:
    root = yaml.compose(text, Loader=yaml.SafeLoader)
    content = yaml.safe_load(text)
    if isinstance(root, yaml.SequenceNode):
        entries = [one for node, one in zip(root.value, content) if line_of(node) == line]
        return dict(entries[0]) if entries else {}
    return dict(content)


def learned_units(text: str, path: str) -> Tuple[LexicalUnit, ...]:
    """Read a lexical unit file that a person has taught.

    Raises:
        FileRefused: it has mistakes
    """
    units = load_lexical_units(text, path)
    if any(not unit.verbs and not unit.remarks for unit in units):
        raise FileRefused([Problem("EMPTY", path, 1, "verb", "no verb", "what is learned has a verb or a remark")])
    return tuple(replace(unit, is_learned=True) for unit in units)
