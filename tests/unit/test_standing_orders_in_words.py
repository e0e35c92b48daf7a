"""Sentences that give a standing order, or say when they begin, and the plan that each means."""

import pytest
from roboframenet_msgs.msg import CommandLexicalUnits, Plan

from arbitrator.ros_messages import any_from_message
from arbitrator.standing import STANDING
from frame_registrar.ros_messages import to_clauses, to_plan
from frame_registrar.search import Refusal, search
from semantic_framer import ros_messages as framer_messages
from semantic_framer.framer import Question, Understood, read


def outcome_of(pipeline, text):
    tree = pipeline.parse(text)
    return tree, read(tree, pipeline.knowledge.lexicon, pipeline.knowledge.frames)[0]


ORDERS = {
    "Turn off the oven at eight.": "AT(at eight, Turn off the oven)",
    "At eight turn off the oven.": "AT(at eight, turn off the oven)",
    "At 8:30 pm go to the kitchen.": "AT(at 8:30 pm, go to the kitchen)",
    "Go to the kitchen at noon.": "AT(at noon, Go to the kitchen)",
    "Turn off the oven at eight in the evening.": "AT(at eight in the evening, Turn off the oven)",
    "Tomorrow at nine go to the door.": "AT(tomorrow at nine, go to the door)",
    "Bring me the mug at half past eight tonight.": "AT(at half past eight tonight, Bring me the mug)",
    "On Monday at nine open the door.": "AT(on monday at nine, open the door)",
    "Every day at seven say good morning.": "AT(every day at seven, say good morning)",
    "Every morning at nine, go to the kitchen and say hello.": (
        "AT(every morning at nine, SEQUENCE(go to the kitchen, say hello))"
    ),
    "In five minutes turn off the oven.": "AT(In five minutes, turn off the oven)",
    "Turn off the lamp in ten minutes.": "AT(in ten minutes, Turn off the lamp)",
    "Every ten minutes go to the door.": "AT(Every ten minutes, go to the door)",
    "Whenever the bell rings, go to the door.": "WHENEVER(the bell rings, go to the door)",
    "Go to the door whenever the bell rings.": "WHENEVER(the bell rings, Go to the door)",
    "Every time you see Anna, greet her.": "WHENEVER(you see Anna, greet her)",
}
PLANS = {
    "Go to the hall and in five minutes go back to the kitchen.": (
        "SEQUENCE(Go to the hall, WAIT(300 s), go back to the kitchen)"
    ),
}
ASKED = {
    "Tomorrow at three go to the hall.": "At 3:00 or at 15:00?",
    "Go to the kitchen tomorrow.": "At what time tomorrow?",
    "Every morning go to the kitchen.": "At what time every morning?",
    "Go to the kitchen and turn off the oven at eight.": 'Which deed do you mean by "at eight"?',
    "Whenever the bell rings.": "What should I do whenever the bell rings?",
    "At eight.": "What should I do at eight?",
}
BEGINNINGS = {
    "Then go to the kitchen.": "FOLLOW",
    "After that go to the kitchen.": "FOLLOW",
    "Next go to the kitchen.": "FOLLOW",
    "When you're done, go to the kitchen.": "FOLLOW",
    "Go to the kitchen when you are done.": "FOLLOW",
    "Go to the kitchen after that.": "FOLLOW",
    "Meanwhile say hello.": "BESIDE",
    "Say hello meanwhile.": "BESIDE",
    "While you do that say hello.": "BESIDE",
    "Go to the kitchen.": "REPLACE",
    "Go to the kitchen, then say hello.": "REPLACE",
}


@pytest.mark.parametrize(("text", "tree"), [*ORDERS.items(), *PLANS.items()])
def test_plan_of_a_sentence(pipeline, text, tree):
    parse, outcome = outcome_of(pipeline, text)
    assert isinstance(outcome, Understood), outcome
    assert str(outcome.plan) == tree
    message = CommandLexicalUnits(
        clauses=framer_messages.to_clauses(outcome.clauses, parse), plan=framer_messages.to_plan(outcome, text)
    )
    if text in ORDERS and tree.startswith("AT"):
        found = search(pipeline.knowledge.graph, to_clauses(message.clauses), max_candidates=64)
        assert not isinstance(found, Refusal), found
        assert isinstance(any_from_message(to_plan(message.clauses, text, found, message.plan)), STANDING)


@pytest.mark.parametrize(("text", "question"), ASKED.items())
def test_order_that_is_open_is_asked_about(pipeline, text, question):
    outcome = outcome_of(pipeline, text)[1]
    assert isinstance(outcome, Question)
    assert outcome.sentence.startswith(question)


@pytest.mark.parametrize(("text", "beginning"), BEGINNINGS.items())
def test_when_a_command_begins(pipeline, text, beginning):
    outcome = outcome_of(pipeline, text)[1]
    assert isinstance(outcome, Understood), outcome
    assert outcome.beginning == beginning
    assert framer_messages.to_plan(outcome, text).beginning == getattr(Plan, beginning)
