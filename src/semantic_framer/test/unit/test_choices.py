"""A question that offers readings is answered by one of them, by a part that only one has, or by its place."""

from typing import Any, Dict, List, Tuple

import pytest

from semantic_framer.framer import LeftOverWords, Policy, Question, Refusal, Understood


def meant(outcome: Any) -> List[Tuple[str, Dict[str, str]]]:
    assert isinstance(outcome, Understood), outcome
    return [
        (readings[0].unit.frame_name, {value.name: value.text for value in readings[0].arguments if value.positions})
        for readings in outcome.clauses
    ]


TO_THE_OFFICE = [("bringing", {"theme": "the mug", "goal": "the office"})]
MUG_OR_OFFICE = "bring the mug to the kitchen no the office"
KITCHEN_OR_LEFT = "go to the kitchen and follow Bob no turn left"
GO_AND_TURN = [("navigating_to_location", {"goal": "the kitchen"}), ("turning", {"direction": "left"})]
GO = [("navigating_to_location", {"goal": "the kitchen"})]
LEFT = [("turning", {"direction": "left"})]


@pytest.mark.parametrize(
    "said, answer, done",
    [
        (MUG_OR_OFFICE, "bring the mug to the office", TO_THE_OFFICE),
        (MUG_OR_OFFICE, "to the office", TO_THE_OFFICE),
        (MUG_OR_OFFICE, "the second one please", TO_THE_OFFICE),
        ("bring the mug on the table no the plate", "on the plate", [("bringing", {"theme": "the mug on the plate"})]),
        (KITCHEN_OR_LEFT, "turn left", LEFT),
        (KITCHEN_OR_LEFT, "the first", GO_AND_TURN),
        (KITCHEN_OR_LEFT, "go to the kitchen and turn left", GO_AND_TURN),
        ("turn left tomorrow, no, go to the kitchen", "the latter", GO),
        ("turn left or go to the kitchen", "the kitchen", GO),
        ("turn left or go to the kitchen", "turn left", LEFT),
        (
            "move forward two metres no three",
            "yes",
            [("moving", {"direction": "forward", "distance": "3", "distance_unit": "metres"})],
        ),
        (
            "move forward two metres no twenty five",
            "yes please",
            [("moving", {"direction": "forward", "distance": "25", "distance_unit": "metres"})],
        ),
        # A command of its own is no answer.
        (MUG_OR_OFFICE, "turn left", LEFT),
        # "It" is asked for too.
        ("take it", "the mug", [("taking", {"theme": "the mug"})]),
    ],
)
def test_answer_picks_a_reading(understand: Any, said: str, answer: str, done: List[Any]) -> None:
    question, context = understand(said)
    assert isinstance(question, Question) and question.code == "AMBIGUOUS"
    outcome, after = understand(answer, context)
    assert meant(outcome) == done
    assert after.pending is None


@pytest.mark.parametrize(
    "said, answer, code, is_open",
    [
        (MUG_OR_OFFICE, "no", "DECLINED", False),
        (MUG_OR_OFFICE, "the office", "NO_VERB", True),
        (MUG_OR_OFFICE, "the third one", "NO_VERB", True),
        (MUG_OR_OFFICE, "yes", "TALK", True),
        (MUG_OR_OFFICE, "not to the office", "CORRECTION", False),
    ],
)
def test_answer_that_picks_nothing_does_nothing(
    understand: Any, said: str, answer: str, code: str, is_open: bool
) -> None:
    question, context = understand(said)
    outcome, after = understand(answer, context)
    assert isinstance(outcome, Refusal) and outcome.code == code
    # What is no answer does not drop the question in silence.
    assert (after.pending is not None) == outcome.sentence.endswith(f"I still ask: {question.sentence}") == is_open


def test_choice_expires(understand: Any) -> None:
    _, context = understand(MUG_OR_OFFICE, now_s=0.0)
    assert isinstance(understand("the second one", context, now_s=31.0)[0], Refusal)


def test_reading_that_was_picked_may_ask_in_turn(understand: Any) -> None:
    _, context = understand("go to the kitchen or move forward")
    question, context = understand("the second", context)
    assert isinstance(question, Question) and question.code == "MISSING_ELEMENT"
    assert meant(understand("two metres", context)[0])[0][0] == "moving"


def test_words_of_the_answer_are_not_those_that_were_left_over(understand: Any) -> None:
    policy = Policy(left_over_words=LeftOverWords.WARN)
    _, context = understand("go to the kitchen sideways or turn left", policy=policy)
    outcome, _ = understand("the first", context, policy=policy)
    assert meant(outcome) == GO and "sideways" in outcome.warning
    assert outcome.clauses[0][0].left_over == ()
