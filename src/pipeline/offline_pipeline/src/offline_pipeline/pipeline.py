"""Runs the stages from text to candidates, one after the other, and records their decisions."""

from copy import copy
from dataclasses import dataclass, replace
from typing import Dict, FrozenSet, Mapping, Optional, Tuple, Union

from command_server.cries import Cry
from command_server.open_commands import refusal_of_text
from command_server.orders_back import said_behind
from command_server.settings import Settings as CommandServerSettings
from command_server.stop_words import find_cry
from frame_registrar import search as registrar
from nearest_meaning.likeness import Likeness
from offline_pipeline.knowledge import Knowledge
from referring_expressions.deeds import DeedsDone
from semantic_framer.behaviour_2012 import Arguments, Questions, with_habits
from semantic_framer.filling.descriptions import descriptions
from semantic_framer.framer import Heard, hear
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.units.heeding import heeded_elements
from semantic_framer.values.clause_plan import CONDITION, PlanPart, leaves_of
from semantic_framer.values.dialogue import Context, Lesson
from semantic_framer.values.outcome import (
    CORRECTION,
    DECLINED,
    PROHIBITION,
    LeftOverWords,
    Policy,
    Understood,
    reply_outcome,
)
from semantic_framer.values.reading import Reading
from semantic_types import WordTypes
from stanford_parser_ros.joint.lexicon_hints import hints_of
from stanford_parser_ros.model import KnownWords, Parser, UnparsableText, shipped_parser
from typed_arguments import FilledFrame
from typed_arguments.goal_text import to_plain
from utterance_passes.engine.trace import Trace, TraceLine
from utterance_passes.trees.tree import DependencyTree
from utterance_passes.wording.typos import spellings_of
from world_model import World
from world_model.names import known_names

#: Refusals after which the pipeline reports no frame: the person said not to do it, or not now.
_NOTHING_MEANT = frozenset([PROHIBITION, CORRECTION, DECLINED, "CONDITION"])


@dataclass(frozen=True)
class Reply:
    """The reply that the person would get; ``outcome`` and ``code`` as in ``roboframenet_msgs/Reply``."""

    outcome: str
    code: str
    sentence: str


@dataclass(frozen=True)
class Parameters:
    """Parameters of the nodes, with their defaults.

    Attributes:
        max_text_length: of command_server, characters
        policy: of semantic_framer
        max_candidates: of frame_registrar
        arguments: of semantic_framer
        questions: of semantic_framer
    """

    max_text_length: int = CommandServerSettings.max_text_length
    policy: Policy = Policy()
    max_candidates: int = 64
    arguments: Arguments = Arguments.PHRASES
    questions: Questions = Questions.ASK


#: Parameters that roboframenet_bringup sets, by the name of the behaviour.
BEHAVIOURS: Mapping[str, Parameters] = {
    "now": Parameters(),
    "2012": Parameters(
        policy=Policy(left_over_words=LeftOverWords.IGNORE, fragment_timeout_s=0.0, confirms=False),
        arguments=Arguments.SINGLE_WORDS,
        questions=Questions.REFUSE,
    ),
}


@dataclass(frozen=True)
class Understanding:
    """The result of understanding a sentence.

    Attributes:
        text: as it was said
        reply: the reply that the person would get
        tree: its parse; None if it was not parsed
        tree_read: the parse after the passes; None if it was not read
        readings: the best reading of each clause that has one
        descriptions: frames that describe things, and are not steps
        candidates: of each clause, the sequences of frames in the order in which they would be tried
        plan: how the clauses are joined; None if they are done one after the other, or nothing is done
        trace: the effect of each rule, in the run that decided
        context: what is remembered for the next sentence
        lessons: what an answer teaches; nothing keeps it here
        behind: the result of the command after a stop ("stop and come back"), which begins when the robot has stopped;
            None if there is none
    """

    text: str
    reply: Reply
    tree: Optional[DependencyTree] = None
    tree_read: Optional[DependencyTree] = None
    readings: Tuple[Reading, ...] = ()
    descriptions: Tuple[Reading, ...] = ()
    candidates: Tuple[Tuple[registrar.Candidate, ...], ...] = ()
    plan: Optional[PlanPart] = None
    trace: Tuple[TraceLine, ...] = ()
    context: Context = Context()
    lessons: Tuple[Lesson, ...] = ()
    behind: Optional["Understanding"] = None


class Pipeline:
    """Understands sentences; the parser is loaded once."""

    def __init__(
        self,
        knowledge: Knowledge,
        parser: Optional[Parser] = None,
        *,
        parameters: Parameters = Parameters(),
        without: FrozenSet[str] = frozenset(),
        is_traced: bool = False,
        world: Optional[World] = None,
        likeness: Optional[Likeness] = None,
    ) -> None:
        """
        Args:
            knowledge: frames (with their servers) and units
            parser: None for the shipped models
            parameters: of the nodes
            without: names of passes that are switched off
            is_traced: whether to record the effect of each rule
            world: what the robot knows of things, persons and places; None for nothing; its names are heard too
            likeness: compares sentences with examples; None if nothing does
        Raises:
            ModelError: the models cannot be loaded
        """
        self.knowledge = knowledge
        self._parser = parser if parser is not None else shipped_parser()
        self._parameters = parameters
        self._without = without
        self._is_traced = is_traced
        graph = knowledge.graph
        served = {
            frame: [graph.profile(frame, server) for server in graph.servers(frame)]
            for frame, _ in graph.registrations()
        }
        heeded = heeded_elements(knowledge.frames, served)
        world = world or World()
        types = _types_with(knowledge, world)
        self._known = FramedLexicon(knowledge.lexicon, knowledge.frames, types, heeded, world, likeness=likeness)
        units = knowledge.lexicon.whole_units(knowledge.frames)
        self._words = KnownWords(
            frozenset(verb.split()[0] for verb in knowledge.lexicon.verbs),
            spellings_of(units),
            frozenset(word for name in types.names for word in name.lower().split()),
            hints_of(units),
        )

    @property
    def parser(self) -> Parser:
        """The parser, for another pipeline with other units."""
        return self._parser

    def in_world(self, world: World) -> "Pipeline":
        """Return a pipeline that differs in what the robot knows of things, persons and places."""
        other = copy(self)
        other._known = replace(self._known, types=_types_with(self.knowledge, world), world=world)
        return other

    def having_done(self, *deeds: FilledFrame) -> "Pipeline":
        """Return a pipeline that differs in what the robot has done: the frames, each of another command."""
        other = copy(self)
        done = DeedsDone(tuple((deed,) for deed in deeds), self.knowledge.frames)
        other._known = replace(self._known, deeds=done)
        return other

    def parse(self, text: str) -> DependencyTree:
        """Parse a sentence, given the verbs of the lexicon.

        Raises:
            UnparsableText: no words
        """
        return self._parser.traced(text, self._words).tree

    def understand(self, text: str, context: Context = Context()) -> Understanding:
        """Understand one sentence; every sentence gets a reply.

        Args:
            text: as it was said
            context: what is remembered of the sentences before
        """
        cry = find_cry(text)
        if cry is not None:
            return self._stopped(text, cry, context)
        refusal = refusal_of_text(text, max_length=self._parameters.max_text_length)
        if refusal is not None:
            return Understanding(text, Reply("REFUSED", *refusal), context=context)
        try:
            parse = self._parser.traced(text, self._words, without=self._without)
        except UnparsableText as reason:
            return Understanding(text, Reply("REFUSED", *reason.refusal), context=context)
        trace = Trace(parse.trace) if self._is_traced else None
        heard = hear(
            parse.tree,
            self._known,
            context=context,
            policy=self._parameters.policy,
            without=self._without,
            trace=trace,
        )
        return self._understanding(text, parse.tree, heard, trace)

    def _stopped(self, text: str, cry: Cry, context: Context) -> Understanding:
        """Understand a stop, and the command after it.

        Args:
            text: the whole text
            cry: the stop in it
            context: the context before the stop; after a stop, no reply answers an open question
        """
        # If the text is too long, the rest is not a command.
        command = said_behind(cry) if len(text) <= self._parameters.max_text_length else ""
        context = context.stopped()
        behind = self.understand(command, context) if command else None
        what = "stops at once, and goes no further" if not command else f'stops at once; then a command: "{command}"'
        return Understanding(
            text,
            Reply("DONE", "DONE", "Stopped."),
            trace=(TraceLine("stop_words", (), "", "", what),) if self._is_traced else (),
            context=behind.context if behind is not None else context,
            behind=behind,
        )

    def understand_safely(self, text: str, context: Context = Context()) -> Understanding:
        """Understand one sentence of many: an internal error becomes its reply, and the other sentences are still
        read. See :meth:`understand`."""
        try:
            return self.understand(text, context)
        except Exception as error:  # boundary: a batch continues after a sentence that causes an error
            reply = Reply("FAILED", "STAGE_ERROR", f"{type(error).__name__}: {error}")
            return Understanding(text, reply, context=context)

    def _understanding(self, text: str, tree: DependencyTree, heard: Heard, trace: Optional[Trace]) -> Understanding:
        parameters = self._parameters
        outcome, context = with_habits(
            heard.outcome, heard.context, arguments=parameters.arguments, questions=parameters.questions, trace=trace
        )
        found: Union[Tuple[registrar.Found, ...], registrar.Refusal] = ()
        if isinstance(outcome, Understood):
            readings = tuple(readings[0] for readings in outcome.clauses)
            found = self._search(outcome)
            if isinstance(found, registrar.Refusal):
                reply = Reply(registrar.reply_outcome(found), found.code, found.sentence)
            else:
                first = ", then ".join(
                    _described(registrar.candidates_of(ways)[0])
                    + (f" ({reading.control.phrase})" if reading.control.is_said else "")
                    for reading, ways in zip(readings, found)
                )
                how = f" ({outcome.plan})" if outcome.plan is not None else ""
                reply = Reply("DONE", "DONE", f"I would do {first}{how}.")
            if trace is not None:
                trace.add("registrar", after=reply.sentence)
        else:
            reply = Reply(reply_outcome(outcome), outcome.code, outcome.sentence)
            is_meant = outcome.code not in _NOTHING_MEANT
            readings = tuple(read.plausible[0] for read in heard.clauses if read.plausible and is_meant)
        said: Tuple[Reading, ...] = ()
        if heard.sentence is not None and reply.code not in _NOTHING_MEANT:
            said = descriptions(heard.sentence, [read.clause for read in heard.clauses], self._known)
        return Understanding(
            text=text,
            reply=reply,
            tree=tree,
            tree_read=heard.sentence.tree if heard.sentence is not None else None,
            readings=readings,
            descriptions=said,
            candidates=() if isinstance(found, registrar.Refusal) else tuple(map(registrar.candidates_of, found)),
            plan=outcome.plan if isinstance(outcome, Understood) else None,
            trace=trace.lines if trace is not None else (),
            context=context,
            lessons=heard.lessons,
        )

    def _search(self, understood: Understood) -> Union[Tuple[registrar.Found, ...], registrar.Refusal]:
        return registrar.search(
            self.knowledge.graph,
            [
                [_registrar_reading(reading, preference) for preference, reading in enumerate(readings)]
                for readings in understood.clauses
            ],
            conditions={
                place: leaf.label
                for place, leaf in enumerate(leaves_of(understood.plan) if understood.plan is not None else ())
                if leaf.kind == CONDITION
            },
            max_candidates=self._parameters.max_candidates,
        )


def _types_with(knowledge: Knowledge, world: World) -> WordTypes:
    """Return the types of words with the names of a world, as the framer hears them from the world model."""
    types = knowledge.types
    return WordTypes(types.nouns, {**dict(known_names(world)), **types.names}) if world.objects else types


def _described(candidate: registrar.Candidate) -> str:
    return ", then ".join(f"{frame.name} on {frame.server}" for frame in candidate.frames)


def _registrar_reading(reading: Reading, preference: int) -> registrar.Reading:
    return registrar.Reading(
        frame_name=reading.unit.frame_name,
        coverage=reading.coverage,
        preference=preference,
        arguments=reading.arguments,
    )


def to_json(understanding: Understanding) -> Dict[str, object]:
    """Return what ``rfn explain --batch --json`` writes for a sentence; the command after a stop is in ``behind``."""
    words = understanding.tree.words if understanding.tree else ()
    left = sorted({index for reading in understanding.readings for index in reading.left_over if index <= len(words)})
    behind = {"behind": to_json(understanding.behind)} if understanding.behind is not None else {}
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
        **behind,
    }


def _frame_to_json(reading: Reading, *, is_description: bool) -> Dict[str, object]:
    return {
        "name": reading.unit.frame_name,
        "verb_token": reading.verb_positions[0] if reading.verb_positions else 0,
        "frame_elements": [
            {
                "name": value.name,
                "argument": value.text,
                "tokens": list(value.positions),
                "head_token": value.head_position,
                "typed": to_plain(value),
            }
            for value in reading.arguments
        ],
        "is_description": is_description,
    }
