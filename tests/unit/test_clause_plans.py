"""Sentences that say how often or for how long, and the tree that each means."""

from dataclasses import replace

import pytest
from roboframenet_msgs.msg import CommandLexicalUnits, Plan

from arbitrator.plan import Do, InSequence, Repeat, Until
from arbitrator.ros_messages import plan_from_message
from frame_registrar.ros_messages import to_clauses, to_plan
from frame_registrar.search import Refusal, search
from semantic_framer import ros_messages as framer_messages
from semantic_framer.framer import Understood, read


def drawn(plan):
    """A plan in one line: 3*(turn left), for 2 s: 0*(move forward)."""
    if isinstance(plan, Do):
        return plan.label
    if isinstance(plan, InSequence):
        return "; ".join(map(drawn, plan.children))
    if isinstance(plan, Repeat):
        return f"{plan.times or ''}*({drawn(plan.child)})"
    assert isinstance(plan, Until)
    return f"{plan.duration_s:g} s: {drawn(plan.child)}"


def plan_of(pipeline, text):
    """The plan of a sentence, as the stages pass it on; the code of the outcome if there is none."""
    tree = pipeline.parse(text)
    outcome, _ = read(tree, pipeline.knowledge.lexicon, pipeline.knowledge.frames)
    if not isinstance(outcome, Understood):
        return outcome.code
    message = CommandLexicalUnits(
        clauses=framer_messages.to_clauses(outcome.clauses, tree), plan=framer_messages.to_plan(outcome, text)
    )
    found = search(pipeline.knowledge.graph, to_clauses(message.clauses), max_candidates=64)
    assert not isinstance(found, Refusal), found
    return drawn(plan_from_message(to_plan(message.clauses, text, found, message.plan)))


TREES = {
    "Turn left.": "Turn left",
    "Turn left once.": "Turn left",
    "Turn left twice.": "2*(Turn left)",
    "Turn left thrice.": "3*(Turn left)",
    "Turn left two times.": "2*(Turn left)",
    "Turn left three times.": "3*(Turn left)",
    "Turn left 4 times.": "4*(Turn left)",
    "Turn left exactly two times.": "2*(Turn left)",
    "Turn left 90 degrees twice.": "2*(Turn left 90 degrees)",
    "Turn around three times.": "3*(Turn around)",
    "Please turn around three times.": "3*(turn around)",
    "Could you turn around twice?": "2*(turn around)",
    "Nod twice.": "2*(Nod)",
    "Nod five times.": "5*(Nod)",
    "Say hello three times.": "3*(Say hello)",
    "Say hello to Anna twice.": "2*(Say hello to Anna)",
    "Go to the kitchen three times.": "3*(Go to the kitchen)",
    "Say hello twice and go to the kitchen.": "2*(Say hello); go to the kitchen",
    "Go to the kitchen and say hello twice.": "Go to the kitchen; 2*(say hello)",
    "Go to the kitchen, then say hello two times.": "Go to the kitchen; 2*(say hello)",
    "Turn around three times and say hello.": "3*(Turn around); say hello",
    "Follow me for ten minutes.": "600 s: *(Follow me)",
    "Follow me for half an hour.": "1800 s: *(Follow me)",
    "Follow Anna for thirty seconds.": "30 s: *(Follow Anna)",
    "Please follow me for two minutes.": "120 s: *(follow me)",
    "Move forward for two seconds.": "2 s: *(Move forward)",
    "Drive forward for 5 seconds.": "5 s: *(Drive forward)",
    "Move backward for one second.": "1 s: *(Move backward)",
    "Turn left for ten seconds.": "10 s: *(Turn left)",
    "Patrol the hall for an hour.": "3600 s: *(Patrol the hall)",
    "Go back and forth between the kitchen and the office twice.": "Go the kitchen; 2*(Go the office; Go the kitchen)",
    "Go from the kitchen to the office and back.": "Go the kitchen; Go the office; Go the kitchen",
    "Go to the kitchen, then to the office, and so on.": "*(Go to the kitchen; Go to the office)",
    "Go to the kitchen, but first go to the office.": "go to the office; Go to the kitchen",
    "Turn left twice, then move forward for two seconds.": "2*(Turn left); 2 s: *(move forward)",
    "Follow me for ten minutes and go to the kitchen.": "600 s: *(Follow me); go to the kitchen",
    "Wait for five seconds.": "Wait for five seconds",
    "Wait for five seconds, then turn left twice.": "Wait for five seconds; 2*(turn left)",
    # These are asked about, or refused: half of a sentence is not what was said.
    "Turn left a few times.": "LEFT_OVER_WORDS",
    "Turn left 200 times.": "LEFT_OVER_WORDS",
    "Turn left many times.": "LEFT_OVER_WORDS",
    "Turn left two or three times.": "LEFT_OVER_WORDS",
    "Turn left one more time.": "LEFT_OVER_WORDS",
    "Go to the kitchen for ten minutes.": "LEFT_OVER_WORDS",
    "Open the door for two minutes.": "LEFT_OVER_WORDS",
    "Move forward two metres for five seconds.": "LEFT_OVER_WORDS",
    "Turn left 90 degrees for two seconds.": "LEFT_OVER_WORDS",
    "Follow me for two or three minutes.": "LEFT_OVER_WORDS",
    "Don't turn left twice.": "NEGATED",
}


@pytest.mark.parametrize("text", TREES)
def test_tree_of_a_sentence(pipeline, text):
    assert plan_of(pipeline, text) == TREES[text]


def test_plan_with_another_number_of_clauses_is_refused(pipeline):
    tree = pipeline.parse("Turn left twice.")
    outcome, _ = read(tree, pipeline.knowledge.lexicon, pipeline.knowledge.frames)
    clauses = framer_messages.to_clauses(outcome.clauses, tree)
    joined = framer_messages.to_plan(replace(outcome, clauses=outcome.clauses * 2), "x")
    found = search(pipeline.knowledge.graph, to_clauses(clauses), max_candidates=64)
    with pytest.raises(ValueError, match="the plan joins 2 clauses, and the command has 1"):
        to_plan(clauses, "x", found, joined)


def test_clauses_in_sequence_need_no_plan(pipeline):
    tree = pipeline.parse("Turn left.")
    outcome, _ = read(tree, pipeline.knowledge.lexicon, pipeline.knowledge.frames)
    assert framer_messages.to_plan(outcome, "Turn left.") == Plan()
