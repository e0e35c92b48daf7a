"""Sentences that say when they begin, while something runs, and how each begins."""

import pytest
from roboframenet_msgs.msg import Plan

from frame_registrar.ros_messages import to_clauses, to_plan
from frame_registrar.search import Refusal, search
from semantic_framer import ros_messages as framer_messages
from semantic_framer.framer import Question, Understood, read

BEGINNINGS = {
    "Then go to the kitchen.": "FOLLOW",
    "And then go to the kitchen.": "FOLLOW",
    "After that go to the kitchen.": "FOLLOW",
    "Next go to the kitchen.": "FOLLOW",
    "When you are done go to the kitchen.": "FOLLOW",
    "When you're done, go to the kitchen.": "FOLLOW",
    "Go to the kitchen when you are done.": "FOLLOW",
    "Go to the kitchen after that.": "FOLLOW",
    "Afterwards go to the kitchen.": "FOLLOW",
    "Meanwhile say hello.": "BESIDE",
    "In the meantime tell me a joke.": "BESIDE",
    "Say hello meanwhile.": "BESIDE",
    "While you do that say hello.": "BESIDE",
    "Go to the kitchen.": "REPLACE",
    "Go to Anna's.": "REPLACE",  # "'s" ends like "afterwards"
    "Go to the kitchen, then say hello.": "REPLACE",
}


def read_in(pipeline, text, context=None):
    known = {} if context is None else {"context": context}
    tree = pipeline.parse(text)
    return tree, read(tree, pipeline.knowledge.lexicon, pipeline.knowledge.frames, **known)


@pytest.mark.parametrize(("text", "beginning"), BEGINNINGS.items())
def test_when_a_command_begins(pipeline, text, beginning):
    tree, (outcome, _) = read_in(pipeline, text)
    assert isinstance(outcome, Understood), outcome
    assert outcome.beginning == beginning
    clauses = framer_messages.to_clauses(outcome.clauses, tree)
    found = search(pipeline.knowledge.graph, to_clauses(clauses), max_candidates=64)
    assert not isinstance(found, Refusal), found
    joined = framer_messages.with_beginning(Plan(), outcome.beginning)
    assert to_plan(clauses, text, found, joined).beginning == getattr(Plan, beginning)


def test_answer_to_a_question_does_not_forget_when_the_command_begins(pipeline):
    _, (asked, context) = read_in(pipeline, "Then go.")
    assert isinstance(asked, Question), asked
    _, (outcome, _) = read_in(pipeline, "the kitchen", context)
    assert isinstance(outcome, Understood), outcome
    assert outcome.beginning == "FOLLOW"
