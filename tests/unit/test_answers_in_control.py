"""Questions about times and orders of deeds, and their answers."""

from itertools import count

import pytest
from test_control_sentences import drawn, pipeline  # noqa: F401 - a fixture

from semantic_framer.clause_plan import plan_of
from semantic_framer.dialogue import Context
from semantic_framer.framer import Understood, read

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
}


@pytest.mark.parametrize("said", ANSWERS)
def test_answer_completes_the_command(pipeline, said):  # noqa: F811 - the fixture
    context = Context()
    for text in said:
        outcome, context = read(
            pipeline.parse(text), pipeline.knowledge.lexicon, pipeline.knowledge.frames, context=context
        )
    if not isinstance(outcome, Understood):
        assert outcome.code == ANSWERS[said]
        return
    plan = outcome.plan or plan_of(outcome.clauses, said[-1])
    assert plan is not None
    assert drawn(plan, outcome.clauses, count()) == ANSWERS[said]
