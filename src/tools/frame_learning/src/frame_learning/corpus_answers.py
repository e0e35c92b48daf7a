"""Sends commands of a corpus through the pipeline, and converts the answers to the names and positions of the
corpus."""

import time
from typing import Dict, FrozenSet, Iterable, List, Tuple

from frame_learning.annotated_commands import AnnotatedCommand, AnnotatedElement, AnnotatedFrame, positions_at
from frame_learning.argument_answers import arguments_of
from frame_learning.behaviour_2012 import understand_2012
from frame_learning.corpus_mapping import CorpusMapping
from frame_learning.metrics import Answer
from offline_pipeline.pipeline import Pipeline
from semantic_frames.frame import SemanticFrame
from stanford_parser_ros.model import UnparsableText
from utterance_passes.trees.tree import DependencyTree

#: Name of an element, positions of its words in our parse, position of its head there.
_Filling = Tuple[str, Iterable[int], int]


def answer(pipeline: Pipeline, mapping: CorpusMapping, command: AnnotatedCommand) -> Answer:
    """Understand a command as ``rfn explain --batch --json`` does; an error of the system becomes an answer."""
    started = time.monotonic()
    understanding = pipeline.understand_safely(command.text)
    milliseconds = 1000.0 * (time.monotonic() - started)
    tree = understanding.tree
    frames: List[AnnotatedFrame] = []
    if tree is not None:
        readings = understanding.readings + (understanding.descriptions if mapping.has_descriptions else ())
        for reading in readings:
            if not reading.verb_positions:
                continue  # A question, or a condition, has a pattern and no verb; no corpus annotates those.
            elements = [(value.name, value.positions, value.head_position) for value in reading.arguments]
            known = pipeline.knowledge.frames[reading.unit.frame_name]
            frames.append(_annotated(tree, command, mapping, known, reading.verb_positions[0], elements))
    arguments = None
    if mapping.arguments is not None:
        arguments = arguments_of(understanding, command, mapping, pipeline.knowledge)
    return Answer(tuple(frames), understanding.reply.code == "DONE", milliseconds, arguments)


def answer_2012(pipeline: Pipeline, mapping: CorpusMapping, command: AnnotatedCommand) -> Answer:
    """Understand a command as in 2012: a command is answered when a frame is filled."""
    started = time.monotonic()
    try:
        tree = pipeline.parse(command.text)
    except UnparsableText:
        return Answer((), False, 1000.0 * (time.monotonic() - started))
    filled = understand_2012(tree, pipeline.knowledge.lexicon, pipeline.knowledge.frames, mapping)
    milliseconds = 1000.0 * (time.monotonic() - started)
    frames = tuple(
        _annotated(tree, command, mapping, frame, verb, [(name, [head], head) for name, head in values])
        for frame, verb, values in filled
    )
    return Answer(frames, bool(frames), milliseconds)


def _annotated(
    tree: DependencyTree,
    command: AnnotatedCommand,
    mapping: CorpusMapping,
    frame: SemanticFrame,
    verb: int,
    fillings: Iterable[_Filling],
) -> AnnotatedFrame:
    """Return a frame in the names and positions of the corpus; elements with one name there become one element."""
    found: Dict[str, Tuple[FrozenSet[int], int]] = {}
    for name, words, head_word in fillings:
        corpus_name = mapping.element_name(frame, name)
        tokens = positions_at(command, _characters(tree, words))
        head_characters = _characters(tree, [_semantic_head(tree, mapping, head_word)])
        head = min(positions_at(command, head_characters), default=0)
        if corpus_name is None or not tokens:
            continue
        before, first_head = found.get(corpus_name, (frozenset(), head))
        found[corpus_name] = (before | tokens, first_head)
    return AnnotatedFrame(
        name=mapping.frame_name(frame),
        lexical_unit=tuple(sorted(positions_at(command, _characters(tree, [verb])))),
        elements=tuple(
            AnnotatedElement(name, _span(command, mapping, tokens, head), head)
            for name, (tokens, head) in found.items()
        ),
    )


def _semantic_head(tree: DependencyTree, mapping: CorpusMapping, head: int) -> int:
    while head > 0 and tree.word(head).said in mapping.transparent_nouns:
        inner = next(
            (
                child.index
                for child in tree.children(head)
                if child.deprel.startswith("nmod") and any(word.said == "of" for word in tree.prepositions(child.index))
            ),
            0,
        )
        if not inner:
            break
        head = inner
    return head


def _span(command: AnnotatedCommand, mapping: CorpusMapping, tokens: FrozenSet[int], head: int) -> FrozenSet[int]:
    """Return a span in the convention of the corpus."""
    kept = sorted(position for position in tokens if not mapping.is_head_span or position <= head)
    while len(kept) > 1 and command.tokens[kept[0] - 1].lower() in mapping.words_left_out:
        kept.pop(0)
    return frozenset(kept)


def _characters(tree: DependencyTree, words: Iterable[int]) -> List[Tuple[int, int]]:
    return [
        (tree.word(position).start_character, tree.word(position).end_character) for position in words if position > 0
    ]
