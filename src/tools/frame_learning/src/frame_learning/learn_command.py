"""``rfn learn``: learns lexical units from annotated sentences."""

import argparse
import os
import sys
from functools import lru_cache, partial
from typing import Callable, Dict, List, Mapping, Optional, Sequence, Set, Tuple

from checked_files import FileRefused
from checked_files.source_files import FRAMES_FOLDER, LEXICAL_UNITS_FOLDER, read_text
from frame_learning.annotated_commands import CorpusError
from frame_learning.annotated_sentences import AnnotatedSentence, read_sentences, sentences_of
from frame_learning.corpora import CORPORA
from frame_learning.evidence import Lesson
from frame_learning.similar_verbs import add_similar_verbs
from frame_learning.unit_files import frame_yaml, names_of_new_frames, to_yaml
from frame_learning.unit_induction import LearnedUnit, learn
from offline_pipeline.knowledge import Knowledge, load_knowledge, load_texts, shipped_domains
from semantic_framer.framer import Understood, read
from semantic_framer.units.lexicon import Lexicon
from semantic_framer.values.outcome import MEANING_ONLY
from semantic_frames.frame import SemanticFrame
from stanford_parser_ros.inference import ModelError
from stanford_parser_ros.model import Parser, UnparsableText, shipped_parser
from utterance_passes.trees.tree import DependencyTree
from word_classes import word_class

#: A path and the function that reads its text.
TextFile = Tuple[str, Callable[[], str]]
EXAMPLES = """examples:
  rfn learn garden_sentences.yaml --out gardening
  rfn learn huric huric-2.1/english --out learned
  rfn check --examples gardening

a file holds a list of sentences:
  - text: Water the roses in the front garden.
    frame_name: watering
    verb: Water
    frame_elements: {plant: the roses, place: in the front garden}

exit status: 0 written, 1 nothing was learned or a file exists already, 2 wrong usage
"""
#: In "can find" the parser must not take "can" for the verb of a command.
_MODALS = word_class("modals") | {"there"}


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn learn``."""
    parser.epilog = EXAMPLES
    corpora = ", ".join(f"{name} DIR" for name, corpus in CORPORA.items() if corpus.is_annotated)
    parser.add_argument("files", nargs="+", help=f"files of annotated sentences, or a corpus: {corpora}")
    parser.add_argument(
        "--out", required=True, metavar="FOLDER", help="folder in which frames and lexical_units are written"
    )
    parser.add_argument("--domains", action="append", metavar="FOLDER", help="known frames (default: shipped)")


def run(arguments: argparse.Namespace) -> int:
    """Learn and write; return the exit status."""
    try:
        known = load_knowledge(arguments.domains or [shipped_domains()])
        unexplained: Tuple[str, ...] = ()
        corpus = CORPORA.get(arguments.files[0]) if len(arguments.files) == 2 else None
        if corpus is not None and corpus.is_annotated:
            commands = corpus.read(arguments.files[1])
            sentences, unexplained = sentences_of(commands, corpus.mapping(), known.frames, known.lexicon.units)
        else:
            sentences = tuple(sentence for path in arguments.files for sentence in read_sentences(path))
        parser = shipped_parser(cache_size=10000)
    except (CorpusError, FileRefused, ModelError, LookupError) as error:
        print(f"rfn learn: {error}", file=sys.stderr)
        return 2
    files, report = lexicon_files(sentences, parser, known)
    paths = {os.path.join(arguments.out, path): text for path, text in files.items()}
    there = [path for path in paths if os.path.lexists(path)]
    if there:
        print(f"rfn learn: these files exist already: {', '.join(there)}; nothing was written", file=sys.stderr)
        return 1
    for path, text in paths.items():
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "x", encoding="utf-8") as file:
            file.write(text)
        print(path)
    for line in unexplained + report:
        print(f"not explained: {line}")
    print(f"{len(sentences)} frames in sentences, {len(files)} files, {len(unexplained + report)} not explained")
    return 0 if files else 1


def lexicon_files(
    sentences: Sequence[AnnotatedSentence], parser: Parser, known: Knowledge
) -> Tuple[Dict[str, str], Tuple[str, ...]]:
    """Learn a domain.

    Args:
        sentences: annotated sentences
        parser: its models
        known: frames that need no file; its units are not used
    Returns:
        text by path in the folder of the domain, and one line for each sentence that is not explained
    """
    first_words = {sentence.text[sentence.verb[0][0] : sentence.verb[0][1]].lower() for sentence in sentences}
    verbs = frozenset(first_words - _MODALS)
    parse: Callable[[str], DependencyTree] = lru_cache(maxsize=None)(lambda text: parser.parse(text, verbs))
    readable, unexplained = _parsable(sentences, parse)
    units, report = learn(readable, parse, known.frames)
    lessons = [lesson for unit in units for lesson in unit.lessons]
    units = _useful(units, parse, known)
    add_similar_verbs(units)
    new = _new_frames(units, known)
    by_frame = _by_frame(units)
    learned = _draft(units, known)
    examples: Set[int] = set()
    wrong: List[str] = []
    for lesson in lessons:
        found = _understood(lesson, parse, learned.lexicon, learned.frames)
        if found is None:
            wrong.append(
                f'{lesson.sentence.place}: {lesson.sentence.frame_name} is not found in "{lesson.sentence.text}"'
            )
        elif found == 1:
            examples.add(id(lesson))
    files = {f"{FRAMES_FOLDER}/{name}.yaml": text for name, text in new.items()}
    for name, members in by_frame.items():
        files[f"{LEXICAL_UNITS_FOLDER}/{name}.yaml"] = to_yaml(members, lambda lesson: id(lesson) in examples)
    return files, unexplained + report + tuple(wrong)


def _new_frames(units: Sequence[LearnedUnit], known: Knowledge) -> Dict[str, str]:
    return {
        name: frame_yaml(name, [lesson for unit in units if unit.frame_name == name for lesson in unit.lessons])
        for name in names_of_new_frames(known.frames, units)
    }


def _by_frame(units: Sequence[LearnedUnit]) -> Dict[str, List[LearnedUnit]]:
    found: Dict[str, List[LearnedUnit]] = {}
    for unit in units:
        found.setdefault(unit.frame_name, []).append(unit)
    return found


def _draft(units: Sequence[LearnedUnit], known: Knowledge) -> Knowledge:
    """Return the units without their examples."""
    drafts = {name: to_yaml(members, lambda lesson: False) for name, members in _by_frame(units).items()}
    return learned_knowledge(known.frames, _new_frames(units, known), drafts)


def _useful(
    units: Sequence[LearnedUnit], parse: Callable[[str], DependencyTree], known: Knowledge
) -> Tuple[LearnedUnit, ...]:
    """Leave out units that break more sentences than they explain: a rare pattern may break frequent ones.

    A unit may be left out only if its verbs evoke its frame through another unit as well.
    """
    frames = _draft(units, known).frames

    def explained(some: Sequence[LearnedUnit], lessons: Sequence[Lesson]) -> int:
        lexicon = Lexicon()
        for name, members in _by_frame(some).items():
            lexicon.add_file(to_yaml(members, lambda lesson: False), name)
        return sum(_understood(lesson, parse, lexicon, frames, offered=1) is not None for lesson in lessons)

    kept = list(units)
    for unit in units:
        others = [other for other in kept if other is not unit]
        verbs = {verb for other in others if other.frame_name == unit.frame_name for verb in other.verbs}
        if unit.required and set(unit.verbs) <= verbs:
            lessons = [lesson for other in units for lesson in other.lessons if lesson.verb in unit.verbs]
            if explained(others, lessons) > explained(kept, lessons):
                kept = others
    return tuple(kept)


def learned_knowledge(
    frames: Mapping[str, SemanticFrame], new_frames: Mapping[str, str], units: Mapping[str, str]
) -> Knowledge:
    """Return the known frames, together with learned frames and units.

    Args:
        frames: frames that have files
        new_frames: text of learned frame files by name
        units: text of learned lexical unit files by name
    """
    paths = {frame.path: frame.path for frame in frames.values()}
    frame_files: List[TextFile] = [(path, partial(read_text, path)) for path in paths]
    return load_texts(frame_files + _learned_files(new_frames), _learned_files(units))


def _learned_files(texts: Mapping[str, str]) -> List[TextFile]:
    return [(f"{name} (learned)", partial(str, text)) for name, text in texts.items()]


def _parsable(
    sentences: Sequence[AnnotatedSentence], parse: Callable[[str], DependencyTree]
) -> Tuple[Tuple[AnnotatedSentence, ...], Tuple[str, ...]]:
    good: List[AnnotatedSentence] = []
    bad: List[str] = []
    for sentence in sentences:
        try:
            parse(sentence.text)
            good.append(sentence)
        except UnparsableText as error:
            bad.append(f"{sentence.place}: {error}")
    return tuple(good), tuple(bad)


def _understood(
    lesson: Lesson,
    parse: Callable[[str], DependencyTree],
    lexicon: Lexicon,
    frames: Mapping[str, SemanticFrame],
    offered: Optional[int] = None,
) -> Optional[int]:
    """Return the number of clauses of a sentence if one of them is as annotated; None if none is.

    This many readings of a clause count, the best first.
    """
    outcome, _ = read(parse(lesson.sentence.text), lexicon, frames, policy=MEANING_ONLY)
    if not isinstance(outcome, Understood):
        return None
    for readings in outcome.clauses:
        for reading in readings[:offered]:
            arguments = {value.name: value.text for value in reading.arguments}
            if reading.unit.frame_name == lesson.sentence.frame_name and all(
                arguments.get(name) == text for name, text in lesson.arguments.items()
            ):
                return len(outcome.clauses)
    return None
