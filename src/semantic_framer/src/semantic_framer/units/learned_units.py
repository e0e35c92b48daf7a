"""Lexical units that a person has taught: those of a known verb, with the words that were said in its place."""

import re
from dataclasses import replace
from typing import Any, Dict, List, Mapping, Tuple

import yaml

from checked_files.marked_yaml import line_of
from semantic_framer.units.lexicon import Lexicon
from semantic_framer.values.dialogue import Lesson
from semantic_frames import FileRefused, Problem, load_lexical_units
from semantic_frames.lexical_unit import LexicalUnit

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
