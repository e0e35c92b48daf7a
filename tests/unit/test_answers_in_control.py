"""Questions about times and orders of deeds, and their answers."""

from itertools import count

import pytest
from test_control_sentences import drawn

from semantic_framer.framer import Understood, read
from semantic_framer.values.clause_plan import plan_of
from semantic_framer.values.dialogue import Context

ANSWERS = {
    ("Tomorrow go to the kitchen.", "At nine."): "AT(tomorrow at nine, navigating_to_location(goal=the kitchen))",
    ("Go to the office on Monday.", "at 10 am"): "AT(on monday at 10 am, navigating_to_location(goal=the office))",
    ("Say hello every day.", "At noon."): "AT(every day at noon, saying(message=hello))",
    ("Tomorrow at three open the door.", "in the afternoon"): (
        "AT(tomorrow at three in the afternoon, opening(container_portal=the door))"
    ),
    # Another command is no answer.
    ("Tomorrow go to the kitchen.", "Turn left twice."): (
        "REPEAT(2-2, turning(direction=left, angle=90, angle_unit=degrees))"
    ),
    ("Visit the kitchen before the office.", "Yes."): "SEQUENCE(arriving(goal=the kitchen), arriving(goal=the office))",
    ("Visit the kitchen before the office.", "No."): "DECLINED",
    # What is missing behind a link.
    ("Wait until.", "noon"): "WAIT(condition_of_time(time=noon))",
    ("Wait until.", "until the door is open"): "WAIT(condition_of_state(theme=the door, state=open))",
    ("Follow me until.", "I say enough"): (
        "UNTIL(condition_of_speech(speaker=I, message=enough), REPEAT(following(cotheme=me)))"
    ),
    ("Turn left when.", "Anna comes in"): (
        "SEQUENCE(WAIT(condition_of_arriving(theme=Anna)), turning(direction=left, angle=90, angle_unit=degrees))"
    ),
    ("Wait until.", "Turn left twice."): "REPEAT(2-2, turning(direction=left, angle=90, angle_unit=degrees))",
    ("If it is open, close it.", "the fridge"): (
        "IF(condition_of_state(state=open, theme=the fridge), closing(container_portal=the fridge))"
    ),
    ("When it rings, go to the door.", "the bell"): (
        "SEQUENCE(WAIT(condition_of_sound(theme=the bell)), navigating_to_location(goal=the door))"
    ),
    # What holds in the case that a question asked about.
    ("Is the door open?", "If so, close it."): (
        "IF(condition_of_state(theme=the door, state=open), closing(container_portal=the door))"
    ),
    ("Is there a mug on the table?", "If not, go to the kitchen."): (
        "IF(not condition_of_place(theme=a mug, location=the table), navigating_to_location(goal=the kitchen))"
    ),
    ("Check whether the door is open.", "In that case, close it."): (
        "IF(condition_of_state(theme=the door, state=open), closing(container_portal=the door))"
    ),
    ("Is the door open?", "If it is, close it."): (
        "IF(condition_of_state(theme=the door, state=open), closing(container_portal=the door))"
    ),
    ("Do you see a mug?", "If you do, bring it to me."): (
        "IF(condition_of_perceiving(perceiver=you, phenomenon=a mug), bringing(theme=a mug, beneficiary=me))"
    ),
    ("Is the door open?", "If it is closed, open it."): (
        "IF(condition_of_state(theme=the door, state=closed), opening(container_portal=the door))"
    ),
    ("Is the door open?", "Turn left.", "If so, close it."): "CONDITION",
    ("Where is the mug?", "If so, bring it to me."): "CONDITION",
    # A place instead of another one.
    ("Go to the kitchen.", "Not the kitchen, the office."): "navigating_to_location(goal=the office)",
    ("Go to the kitchen.", "Go to the office instead."): "navigating_to_location(goal=the office)",
    ("Turn left.", "Not left, right."): "turning(direction=right, angle=90, angle_unit=degrees)",
}
QUESTIONS = {
    "Wait until.": "Until when?",
    "Turn left when.": "When what?",
    "If it is open, close it.": "If what is open?",
    "When it rings, go to the door.": "When what rings?",
}


@pytest.mark.parametrize("said", ANSWERS)
def test_answer_completes_the_command(pipeline, said):
    context = Context()
    for text in said:
        outcome, context = read(
            pipeline.parse(text), pipeline.knowledge.lexicon, pipeline.knowledge.frames, context=context
        )
    if not isinstance(outcome, Understood):
        assert outcome.code == ANSWERS[said]
        return
    plan = outcome.plan or plan_of(outcome.clauses, said[-1])
    meant = str(outcome.clauses[0][0]) if plan is None else drawn(plan, outcome.clauses, count())
    assert meant == ANSWERS[said]


@pytest.mark.parametrize("text", QUESTIONS)
def test_question_repeats_what_was_said(pipeline, text):
    outcome, _ = read(pipeline.parse(text), pipeline.knowledge.lexicon, pipeline.knowledge.frames)
    assert outcome.sentence == QUESTIONS[text]
