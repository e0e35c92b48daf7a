"""Extra-thematic phrases: the robot asks whether to go on without them, and refuses other words."""

from typing import Any

import pytest

from checked_files.problem import FileRefused
from semantic_framer.framer import LeftOverWords, Policy, Question, Refusal, Understood
from semantic_frames.extra_thematic import extra_thematic_elements, load_extra_thematic


@pytest.mark.parametrize(
    "text, name, words",
    [
        ("Close the door for ten seconds.", "Duration", "for ten seconds"),
        ("Say hello from the kitchen.", "Source", "from the kitchen"),
        ("Say hello in the kitchen.", "Place", "in the kitchen"),
        ("Follow me silently.", "Manner", "silently"),
        ("Turn around at the door.", "Place", "at the door"),
        ("Bring me a cloth to clean the table.", "Purpose", "to clean the table"),
    ],
)
def test_phrase_is_asked_about_and_left_out_after_a_yes(understand: Any, text: str, name: str, words: str) -> None:
    asked, context = understand(text)
    assert asked == Question("LEFT_OVER_WORDS", f'I cannot do the "{words}" part. Shall I do the rest?')
    outcome, _ = understand("Yes.", context)
    assert isinstance(outcome, Understood)
    assert name in {element.name for element in extra_thematic_elements()}
    assert words not in {argument.words for argument in outcome.clauses[0][0].arguments}


def test_no_ends_it_and_a_new_command_is_no_answer(understand: Any) -> None:
    _, context = understand("Close the door for ten seconds.")
    declined, after = understand("No.", context)
    assert isinstance(declined, Refusal) and declined.code == "DECLINED"
    assert after.pending is None
    turned, _ = understand("Turn left.", context)
    assert isinstance(turned, Understood) and turned.clauses[0][0].unit.frame_name == "turning"


def test_the_question_expires(understand: Any) -> None:
    policy = Policy(question_timeout_s=30.0)
    _, context = understand("Close the door for ten seconds.", policy=policy, now_s=100.0)
    late, _ = understand("Yes.", context, policy=policy, now_s=131.0)
    assert isinstance(late, Refusal)


@pytest.mark.parametrize(
    "text",
    [
        "Move forward two three metres.",
        "Take the mug without the plate.",
        "Take the mug the plate.",
        "Turn left three metres.",
    ],
)
def test_other_words_are_refused(understand: Any, text: str) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Refusal), outcome


def test_strict_refuses_as_before(understand: Any) -> None:
    outcome, _ = understand("Follow me silently.", policy=Policy(left_over_words=LeftOverWords.STRICT))
    assert isinstance(outcome, Refusal) and outcome.left_over == ("silently",)


def test_a_wrong_file_says_where() -> None:
    with pytest.raises(FileRefused) as refused:
        load_extra_thematic("- {name: Manner, adverb: [-ly]}", "x.yaml")
    assert "adverb" in str(refused.value.problems[0])
