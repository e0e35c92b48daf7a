"""Sentences with conditions, times and other words that join deeds, and the tree that each means.

``control_sentences.tsv`` has a sentence and its tree in each line, ``control_refusals.tsv`` a sentence and the code of
its refusal or question. A third of each, marked ``held``, was written with the others and read only when no rule was
changed any more.
"""

import os
from itertools import count
from pathlib import Path
from typing import Iterator, List, Sequence, Tuple

import pytest
from roboframenet_msgs.msg import CommandLexicalUnits

from arbitrator.ros_messages import plan_from_message
from frame_registrar.ros_messages import conditions_in, to_clauses, to_plan
from frame_registrar.search import Refusal, search
from offline_pipeline.pipeline import Pipeline
from semantic_framer import ros_messages as framer_messages
from semantic_framer.framer import Understood, read
from semantic_framer.values.clause_plan import LEAVES, PlanPart, plan_of
from semantic_framer.values.reading import Reading

FOLDER = Path(os.path.realpath(__file__)).parent
#: Orders for later; a firing of one is a command, and has a machine of its own.
STANDING_ORDERS = ("AT(", "WHENEVER(")


def lines_of(name: str) -> List[Tuple[str, str]]:
    rows = (FOLDER / name).read_text(encoding="utf-8").splitlines()
    return [(text, meant) for text, meant, *_ in (row.split("\t") for row in rows)]


def drawn(part: PlanPart, clauses: Sequence[Tuple[Reading, ...]], places: Iterator[int]) -> str:
    """A tree in one line, with the frames of its leaves."""
    if part.kind in LEAVES:
        reading = clauses[next(places)][0]
        arguments = ", ".join(f"{argument.name}={argument.text}" for argument in reading.arguments)
        said = f"{reading.unit.frame_name}({arguments})"
    else:
        fields = [f"{part.count}-{part.most}"] if part.count or part.most else []
        fields += [f"{part.duration_s:g} s"] if part.duration_s else []
        fields += [f"every {part.period_s:g} s"] if part.period_s else []
        fields += [f"at most {part.limit_s:g} s"] if part.limit_s else []
        fields += [part.when.words] if part.when is not None else []
        said = f"{part.kind}({', '.join(fields + [drawn(child, clauses, places) for child in part.children])})"
    return ("not " if part.is_negated else "") + said + (" anew" if part.trigger == "BEGINS" else "")


def tree_of(pipeline: Pipeline, text: str) -> str:
    """The tree of a sentence after all stages up to the arbitrator; the code of its refusal or question."""
    tree = pipeline.parse(text)
    outcome, _ = read(tree, pipeline.knowledge.lexicon, pipeline.knowledge.frames)
    if not isinstance(outcome, Understood):
        return outcome.code
    message = CommandLexicalUnits(
        clauses=framer_messages.to_clauses(outcome.clauses, tree), plan=framer_messages.to_plan(outcome, text)
    )
    found = search(
        pipeline.knowledge.graph,
        to_clauses(message.clauses),
        max_candidates=64,
        conditions=conditions_in(message.plan, message.clauses),
    )
    assert not isinstance(found, Refusal), found
    plan = to_plan(message.clauses, text, found, message.plan)
    drawable = outcome.plan or plan_of(outcome.clauses, text)
    assert drawable is not None, outcome
    said = drawn(drawable, outcome.clauses, count())
    if not said.startswith(STANDING_ORDERS):
        plan_from_message(plan)  # raises if the arbitrator cannot make a machine of it
    return said


@pytest.mark.parametrize(("text", "meant"), lines_of("control_sentences.tsv"))
def test_tree_of_a_sentence(pipeline, text, meant):
    assert tree_of(pipeline, text) == meant


@pytest.mark.parametrize(("text", "code"), lines_of("control_refusals.tsv"))
def test_sentence_that_is_asked_about_or_refused(pipeline, text, code):
    assert tree_of(pipeline, text) == code


@pytest.mark.parametrize(
    ("text", "condition"),
    [
        ("When the kettle boils, turn off the stove.", "When the kettle boils"),
        ("Switch the kettle on and, when it boils, pour me a tea.", "when it boils"),
    ],
)
def test_only_the_condition_that_is_not_understood_is_quoted(pipeline, text, condition):
    outcome, _ = read(pipeline.parse(text), pipeline.knowledge.lexicon, pipeline.knowledge.frames)
    assert f'"{condition}"' in outcome.sentence, outcome


def test_tables_are_large_enough():
    assert len(lines_of("control_sentences.tsv")) >= 250
    assert len(lines_of("control_refusals.tsv")) >= 100
