"""The pipeline without ROS: from a sentence to what would run, with everything that was tried on the way."""

import os
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Callable, Dict, FrozenSet, Iterable, List, Mapping, Optional, Tuple, Union

from frame_registrar import search as registrar
from frame_registrar.graph import FrameGraph
from semantic_frames import FileRefused, Problem, load_frame
from semantic_frames.frame import SemanticFrame
from semantic_frames.lexical_unit import LexicalUnit
from semantic_frames.source_files import FRAMES_FOLDER, LEXICAL_UNITS_FOLDER, read_text, yaml_files
from semantic_framer.clauses import Clause, find_clauses
from semantic_framer.descriptions import descriptions
from semantic_framer.framer import Question, Understood, prepared, read
from semantic_framer.lexicon import Lexicon
from semantic_framer.matching import Reading, read_clause
from semantic_framer.readings import readings_of
from semantic_framer.sentence import Sentence
from semantic_framer.verb_matching import match_verbs
from stanford_parser_ros.model import Parser, UnparsableText, shipped_model_dir
from stanford_parser_ros.tree import DependencyTree

#: Refusals after which no frame is reported: the person said not to do it, or not at once, or asked for nothing.
_NOTHING_MEANT = frozenset(["NEGATED", "CONDITION", "QUESTION", "REPORT", "WISH", "TALK"])


@dataclass(frozen=True)
class Reply:
    """What the person would hear; ``outcome`` and ``code`` as in ``roboframenet_msgs/Reply``."""

    outcome: str
    code: str
    sentence: str


@dataclass(frozen=True)
class Attempt:
    """A lexical unit that was tried on a clause.

    Attributes:
        unit: the unit
        verb: of the unit
        reading: what it made of the clause; None when a relation that it requires is not there
        wanted: element and relations that were looked for in vain
    """

    unit: LexicalUnit
    verb: str
    reading: Optional[Reading]
    wanted: Tuple[Tuple[str, str], ...]


@dataclass(frozen=True)
class Understanding:
    """All that came of a sentence.

    Attributes:
        text: as it was said
        tree: its parse; None where there are no words
        attempts: units tried, by clause
        readings: the best reading of each clause that has one
        descriptions: what is said of things on the way, and is no step
        candidates: sequences of frames that would be tried, the first first
        reply: what the person would hear
    """

    text: str
    tree: Optional[DependencyTree]
    attempts: Tuple[Tuple[Attempt, ...], ...]
    readings: Tuple[Reading, ...]
    candidates: Tuple[registrar.Candidate, ...]
    reply: Reply
    descriptions: Tuple[Reading, ...] = ()


@dataclass(frozen=True)
class Knowledge:
    """Frames and lexical units of some folders, and what is wrong with their files.

    ``read_names`` are the frames of files that could be read, also of those that the graph refused.
    """

    graph: FrameGraph
    lexicon: Lexicon
    problems: Tuple[Problem, ...]
    read_names: FrozenSet[str]

    @property
    def frames(self) -> Mapping[str, SemanticFrame]:
        """Frames by name."""
        return self.graph.frames


def shipped_domains() -> str:
    """Return the folder of the domains: of the ROS package, or of the source tree that this module lies in."""
    beside = Path(os.path.realpath(__file__)).parents[3] / "roboframenet_domains" / "domains"
    if beside.is_dir():
        return str(beside)
    import rospkg  # only an installed space needs it

    return os.path.join(rospkg.RosPack().get_path("roboframenet_domains"), "domains")


def load_knowledge(paths: Iterable[str]) -> Knowledge:
    """Read frames and units below some folders."""
    folders = list(paths)
    return load_files(list(yaml_files(folders, FRAMES_FOLDER)), list(yaml_files(folders, LEXICAL_UNITS_FOLDER)))


def load_files(frame_files: Iterable[str], unit_files: Iterable[str]) -> Knowledge:
    """Read frames and units from files; a file that is wrong becomes problems."""
    return load_texts(_texts(frame_files), _texts(unit_files))


def _texts(paths: Iterable[str]) -> List[Tuple[str, Callable[[], str]]]:
    return [(path, lambda path=path: read_text(path)) for path in paths]


def load_texts(
    frame_files: Iterable[Tuple[str, Callable[[], str]]], unit_files: Iterable[Tuple[str, Callable[[], str]]]
) -> Knowledge:
    """Read frames and units from paths with a function that gives the text of each."""
    graph, lexicon = FrameGraph(), Lexicon()
    problems: List[Problem] = []
    owners: Dict[str, SemanticFrame] = {}
    for path, text in frame_files:
        try:
            frame = load_frame(text(), path)
            if frame.name in owners:
                problems.append(
                    Problem(
                        "DUPLICATE_FRAME",
                        path,
                        frame.line,
                        "name",
                        f"'{frame.name}'",
                        "a name of its own",
                        f"also in {owners[frame.name].path}:{owners[frame.name].line}",
                    )
                )
                continue
            owners[frame.name] = frame
            graph.add(frame)
        except FileRefused as error:
            problems += error.problems
    for path, text in unit_files:
        try:
            lexicon.add_file(text(), path)
        except FileRefused as error:
            problems += error.problems
    return Knowledge(graph, lexicon, tuple(problems), frozenset(owners))


def pretend_servers(graph: FrameGraph) -> None:
    """Pretend that a server of the same name is there for every frame: offline nothing says what a robot can do."""
    for name in graph.frames:
        graph.register(name, name)


class Pipeline:
    """Understands sentences; the parser is loaded once."""

    def __init__(self, knowledge: Knowledge, parser: Optional[Parser] = None, *, max_candidates: int = 64) -> None:
        """
        Args:
            knowledge: frames (with their servers) and units
            parser: None for the models that are shipped
            max_candidates: so many sequences are looked for
        Raises:
            ModelError: the models cannot be loaded
        """
        self.knowledge = knowledge
        self._parser = parser if parser is not None else Parser(model_dir=shipped_model_dir())
        self._max_candidates = max_candidates
        self._verbs = frozenset(verb.split()[0] for verb in knowledge.lexicon.verbs)

    @property
    def parser(self) -> Parser:
        """The parser, for another pipeline with other units."""
        return self._parser

    def parse(self, text: str) -> DependencyTree:
        """Parse a sentence with the verbs of the lexicon in mind.

        Raises:
            UnparsableText: no words
        """
        return self._parser.parse(text, self._verbs)

    def understand(self, text: str) -> Understanding:
        """Understand one sentence; every sentence gives a reply."""
        if not text.strip():
            return _nothing(text, Reply("REFUSED", "EMPTY_TEXT", "I heard nothing."))
        try:
            tree = self.parse(text)
        except UnparsableText as error:
            return _nothing(text, Reply("REFUSED", "EMPTY_TEXT", f"I heard no words: {error}."))
        lexicon, frames = self.knowledge.lexicon, self.knowledge.frames
        meant = prepared(tree, lexicon, frames)
        sentence = meant if isinstance(meant, Sentence) else Sentence(tree)
        clauses = find_clauses(sentence, lexicon)
        attempts = tuple(self._attempts(sentence, clause) for clause in clauses)
        outcome, _ = read(tree, lexicon, frames)
        if not isinstance(outcome, Understood) and outcome.code in _NOTHING_MEANT:
            return Understanding(text, tree, attempts, (), (), Reply("REFUSED", outcome.code, outcome.sentence))
        said = descriptions(sentence, clauses, lexicon, frames)
        if not isinstance(outcome, Understood):
            kind = "NEEDS_INFORMATION" if isinstance(outcome, Question) else "REFUSED"
            reply = Reply(kind, outcome.code, outcome.sentence)
            return Understanding(text, tree, attempts, self._best(sentence), (), reply, said)
        readings = tuple(readings[0] for readings in outcome.clauses)
        found = self._search(outcome.clauses)
        if isinstance(found, registrar.Refusal):
            kind = "NEEDS_INFORMATION" if found.code == "MISSING_ELEMENT" else "REFUSED"
            return Understanding(text, tree, attempts, readings, (), Reply(kind, found.code, found.sentence), said)
        first = ", then ".join(f"{frame.name} on {frame.server}" for frame in found[0].frames)
        return Understanding(text, tree, attempts, readings, found, Reply("DONE", "DONE", f"I would do {first}."), said)

    def understand_safely(self, text: str) -> Understanding:
        """Understand one sentence of many: an error of ours becomes a reply, and the others still get theirs."""
        try:
            return self.understand(text)
        except Exception as error:  # boundary: a batch goes on behind a sentence that breaks something
            return _nothing(text, Reply("FAILED", "STAGE_ERROR", f"{type(error).__name__}: {error}"))

    def _best(self, sentence: Sentence) -> Tuple[Reading, ...]:
        found = [
            readings_of(sentence, clause, self.knowledge.lexicon, self.knowledge.frames)
            for clause in find_clauses(sentence, self.knowledge.lexicon)
            if not clause.is_negated
        ]
        return tuple(readings[0] for readings in found if readings)

    def _attempts(self, sentence: Sentence, clause: Clause) -> Tuple[Attempt, ...]:
        lexicon, frames = self.knowledge.lexicon, self.knowledge.frames
        attempts = []
        for match in match_verbs(sentence, clause, lexicon):
            for unit in lexicon.units_of(match.verb):
                alone = Lexicon.of_units([replace(unit, verbs=(match.verb,))])
                found = read_clause(sentence, clause, alone, frames)
                reading = found[0] if found else None
                filled = {value.name for value in reading.values} if reading else set()
                needed = {element.name for element in reading.missing} if reading else set()
                wanted = tuple(
                    (
                        relation.name,
                        " or ".join(map(str, relation.relations))
                        + (f" ({', '.join(relation.words)})" if relation.words else ""),
                    )
                    for relation in unit.relations
                    if (reading is None and relation.is_required)
                    or (relation.name in needed and relation.name not in filled)
                )
                attempts.append(Attempt(unit, match.verb, reading, wanted))
        return tuple(attempts)

    def _search(
        self, clauses: Tuple[Tuple[Reading, ...], ...]
    ) -> Union[Tuple[registrar.Candidate, ...], registrar.Refusal]:
        return registrar.search(
            self.knowledge.graph,
            [[_registrar_reading(reading) for reading in readings] for readings in clauses],
            max_candidates=self._max_candidates,
        )


def _registrar_reading(reading: Reading) -> registrar.Reading:
    return registrar.Reading(
        frame_name=reading.unit.frame_name,
        coverage=reading.coverage,
        arguments=tuple(
            registrar.Argument(name=value.name, text=value.argument, items=value.items, conjunction=value.conjunction)
            for value in reading.values
        ),
    )


def _nothing(text: str, reply: Reply) -> Understanding:
    return Understanding(text, None, (), (), (), reply)


def to_json(understanding: Understanding) -> Dict[str, object]:
    """Return what ``rfn explain --batch --json`` writes of a sentence."""
    words = understanding.tree.words if understanding.tree else ()
    left = sorted({index for reading in understanding.readings for index in reading.left_over if index <= len(words)})
    return {
        "text": understanding.text,
        "tokens": [word.form for word in words],
        "frames": [_frame_to_json(reading, is_description=False) for reading in understanding.readings]
        + [_frame_to_json(reading, is_description=True) for reading in understanding.descriptions],
        "left_over": [words[index - 1].form for index in left],
        "reply": {
            "outcome": understanding.reply.outcome,
            "code": understanding.reply.code,
            "sentence": understanding.reply.sentence,
        },
    }


def _frame_to_json(reading: Reading, *, is_description: bool) -> Dict[str, object]:
    return {
        "name": reading.unit.frame_name,
        "verb_token": reading.verb_positions[0],
        "frame_elements": [
            {
                "name": value.name,
                "argument": value.argument,
                "tokens": list(value.positions),
                "head_token": value.head_position,
            }
            for value in reading.values
        ],
        "is_description": is_description,
    }
