"""``rfn unknown``: what was refused and asked in a recording, by the lexical unit that is nearest: what to add next."""

import argparse
import sys
from collections import Counter
from dataclasses import dataclass, replace
from typing import Counter as CounterOf
from typing import Dict, List, Optional, Sequence, Tuple

from checked_files import FileRefused
from nearest_meaning.likeness import Likeness
from offline_pipeline.pipeline import Pipeline, Understanding, to_json
from roboframenet_tools.offline import add_knowledge_arguments, offline_pipeline, told_problems
from roboframenet_tools.recording import Frame, Record, RecordingError, read_records, record_of
from roboframenet_tools.sentence_file import ExpectedReading, sentence_in_file
from semantic_framer.values.dialogue import Context
from stanford_parser_ros.inference import ModelError

EXAMPLES = """examples:
  rfn record said.jsonl                        while people talk to the robot
  rfn unknown said.jsonl
  rfn unknown said.jsonl --out sentences.yaml
  rfn test sentences.yaml --with my_robot      after a unit was added

Each group is a lexical unit: what was said is nearest to it. What this version understands is only counted.
The file of --out has the reading that is nearest, or the code of the refusal: correct it to what is meant.

exit status: 0 listed, 2 wrong usage
"""
#: Replies to a sentence of which a lexical unit, a frame or a server is lacking.
_LACKING = frozenset(
    [
        "NO_VERB",
        "UNKNOWN_VERB",
        "NO_READING",
        "LEFT_OVER_WORDS",
        "UNKNOWN_FRAME",
        "CONDITION",
        "QUESTION",
        "VALUE_NOT_ALLOWED",
        "NO_SERVER",
    ]
)
#: The question whether a sentence means another one has these words.
_GUESS = "do you mean"
#: An example that is less like a sentence has nothing to do with it.
_LEAST_LIKENESS = 0.4
_HEADER = """# Sentences that a robot did not understand, each with the reading that is nearest to it.
# Correct what is meant, add lexical units, and run 'rfn test' with this file.
"""


@dataclass(frozen=True)
class Nearest:
    """What is nearest to a sentence.

    Attributes:
        unit: frame and verb; empty when nothing is near
        meaning: the sentence that was offered, or an example of the unit
        frames: the reading of the sentence that was offered; empty when none was
    """

    unit: str = ""
    meaning: str = ""
    frames: Tuple[Frame, ...] = ()


@dataclass(frozen=True)
class Unknown:
    """A sentence that was not understood.

    Attributes:
        record: of the last time
        count: how often it was said
        nearest: to it
    """

    record: Record
    count: int
    nearest: Nearest


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn unknown``."""
    parser.epilog = EXAMPLES
    parser.add_argument("file", nargs="+", help="from 'rfn record', or from 'rfn explain --json'")
    parser.add_argument("--out", metavar="FILE", help="also write a file for 'rfn test'")
    add_knowledge_arguments(parser)


def run(arguments: argparse.Namespace) -> int:
    """List; return the exit status."""
    try:
        records: List[Record] = []
        for path in arguments.file:
            with open(path, encoding="utf-8") as file:
                records += read_records(file, path)
        pipeline = told_problems(offline_pipeline(arguments))
        found, now_known = unknown_sentences(records, pipeline, Likeness())
        if arguments.out:
            with open(arguments.out, "w", encoding="utf-8") as file:
                file.write(exported(found))
    except (OSError, UnicodeDecodeError, RecordingError, FileRefused, ModelError) as error:
        print(f"rfn unknown: {error}", file=sys.stderr)
        return 2
    print(listed(found))
    print(f"\n{len(records)} sentences, {sum(one.count for one in found)} not understood, {now_known} understood now")
    return 0


def is_lacking(record: Record) -> bool:
    """Whether a reply says that the robot lacks something for a sentence, or was a guess what it means."""
    return record.code in _LACKING or (record.code == "CONFIRM" and _GUESS in record.sentence)


def unknown_sentences(
    records: Sequence[Record], pipeline: Pipeline, likeness: Likeness
) -> Tuple[Tuple[Unknown, ...], int]:
    """Return what was not understood, the most frequent first, and how many are understood by now.

    Args:
        records: in the order in which they were said
        pipeline: understands them
        likeness: compares sentences with the examples of the units
    """
    context, now_known = Context(), 0
    counts: CounterOf[str] = Counter()
    found: Dict[str, Unknown] = {}
    for record in records:
        # What was not understood was no answer to the question before.
        before = replace(context, pending=None) if is_lacking(record) else context
        understanding = pipeline.understand_safely(record.text, before)
        context = understanding.context
        if not is_lacking(record):
            continue
        nearest = _without_server(record) or _nearest(record.text, understanding, pipeline, likeness)
        if nearest is None:
            now_known += 1
            continue
        key = " ".join(record.text.lower().strip(" .!?").split())
        counts[key] += 1
        found[key] = Unknown(record, counts[key], nearest)
    return tuple(sorted(found.values(), key=lambda one: -one.count)), now_known


def _without_server(record: Record) -> Optional[Nearest]:
    """Return what a sentence means that only lacked a server."""
    if record.code != "NO_SERVER" or not record.frames:
        return None
    return Nearest(f"no server for {record.frames[0][0]}", "", record.frames)


def _nearest(text: str, understanding: Understanding, pipeline: Pipeline, likeness: Likeness) -> Optional[Nearest]:
    """Return what is nearest to a sentence that is read like this; None if it is understood."""
    if not is_lacking(record_of(to_json(understanding))):
        return None
    pending = understanding.context.pending
    if pending is not None and pending.readings:
        offered = pending.readings[0].text
        understanding = pipeline.understand_safely(offered)
        frames = record_of(to_json(understanding)).frames
        unit = _unit_of(understanding.readings[0].unit.frame_name, understanding.readings[0].verb)
        return Nearest(unit, offered, frames)
    if understanding.readings:
        reading = understanding.readings[0]
        return Nearest(_unit_of(reading.unit.frame_name, reading.unit.stands_for(reading.verb) or reading.verb))
    knowledge = pipeline.knowledge
    deeds = knowledge.lexicon.deeds(knowledge.frames)
    alike = likeness.of(text.strip(" .!?"), deeds.texts)
    best = max(range(len(alike)), key=lambda place: alike[place], default=None)
    if best is None or alike[best] < _LEAST_LIKENESS:
        return Nearest()
    example = deeds.examples[best]
    return Nearest(_unit_of(example.unit.frame_name, example.unit.verbs[0]), example.text)


def _unit_of(frame_name: str, verb: str) -> str:
    return f"{frame_name} ({verb})"


def listed(found: Sequence[Unknown]) -> str:
    """Return the sentences in groups, the largest first, for a terminal."""
    groups: Dict[str, List[Unknown]] = {}
    for one in found:
        groups.setdefault(one.nearest.unit, []).append(one)
    lines: List[str] = []
    for unit, group in sorted(groups.items(), key=lambda item: -sum(one.count for one in item[1])):
        lines += [""] * bool(lines) + [f"{sum(one.count for one in group):>5}  {unit or 'nothing near'}"]
        for one in group:
            near = f' -> "{one.nearest.meaning}"' if one.nearest.meaning else ""
            lines.append(f'{one.count:>9}  "{one.record.text}"{near}')
            lines.append(f"           {_reply(one.record)}")
    return "\n".join(lines)


def _reply(record: Record) -> str:
    return f"{record.outcome.lower().replace('_', ' ')} [{record.code}] {record.sentence}"


def exported(found: Sequence[Unknown]) -> str:
    """Return a file for ``rfn test``; empty lists make a file that it refuses as empty."""
    entries: List[str] = []
    for one in found:
        frames = one.nearest.frames
        code = "" if frames else one.record.code
        near = f' Nearest: {one.nearest.unit}, "{one.nearest.meaning}".' if one.nearest.meaning else ""
        often = "once" if one.count == 1 else f"{one.count} times"
        remark = f"Said {often}: {_reply(one.record)}{near}"
        entries.append(sentence_in_file(ExpectedReading(one.record.text, frames, code), remark))
    return _HEADER + "".join(entries)
