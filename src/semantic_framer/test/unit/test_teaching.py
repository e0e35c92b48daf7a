"""What a person teaches in words: it is asked about before it is kept, and done like any other command."""

from dataclasses import replace
from typing import Any, Tuple

import pytest

from semantic_framer.framer import Heard, Policy, Question, Refusal, Understood, hear
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.units.learned_units import learned_units
from semantic_framer.units.lexicon import Lexicon
from semantic_framer.values.dialogue import Context, Lesson
from semantic_framer.values.outcome import Noted, reply_outcome

DISMISSED = 'By "dismissed", do you always mean "go to the charger"?'


@pytest.fixture
def known(lexicon: Lexicon, frames: Any) -> FramedLexicon:
    return FramedLexicon(lexicon, frames)


def said(text: str, known: FramedLexicon, parser: Any, context: Context = Context(), **more: Any) -> Heard:
    return hear(parser.parse(text, known.lexicon.verbs), known, context=context, policy=Policy(), **more)


def with_lessons(known: FramedLexicon, *lessons: Lesson) -> FramedLexicon:
    wiser = Lexicon()
    for path, text in known.lexicon.files.items():
        wiser.add_file(text, path)
    for place, lesson in enumerate(lessons):
        path = f"learned/{place}.yaml"
        wiser.replace_file(path, lesson.text, learned_units(lesson.text, path))
    return replace(known, lexicon=wiser)


def taught(text: str, known: FramedLexicon, parser: Any) -> Tuple[Lesson, ...]:
    asked = said(text, known, parser)
    assert isinstance(asked.outcome, Question) and asked.lessons == (), asked.outcome
    yes = said("Yes.", known, parser, asked.context)
    assert isinstance(yes.outcome, Noted) and reply_outcome(yes.outcome) == "DONE" and yes.context.pending is None
    return yes.lessons


def reading_of(heard: Heard) -> str:
    assert isinstance(heard.outcome, Understood), heard.outcome
    return "; ".join(str(clause[0]) for clause in heard.outcome.clauses)


def test_it_is_told_back_before_it_is_kept_and_nothing_is_done(known: Any, parser: Any) -> None:
    asked = said("When I say dismissed, go to the charger.", known, parser)
    assert asked.outcome == Question("CONFIRM", DISMISSED)
    yes = said("Yes.", known, parser, asked.context)
    assert yes.outcome == Noted("DONE", 'All right: "dismissed" means "go to the charger".')
    assert [(one.said, one.verb, one.is_agreed) for one in yes.lessons] == [("dismissed", "go to the charger", True)]


@pytest.mark.parametrize(
    ("lesson", "text", "expected"),
    [
        ("When I say dismissed, go to the charger.", "Dismissed!", "navigating_to_location(goal=the charger)"),
        ("When I say home time, go to the charger.", "Home time.", "navigating_to_location(goal=the charger)"),
        ("To freshen up means to open the window.", "Freshen up.", "opening(container_portal=the window)"),
        ("To freshen up means to turn left 90 degrees.", "Please freshen up.", "turning(direction=left, angle=90"),
        ("Freshening up means opening the window.", "Freshen up.", "opening(container_portal=the window)"),
        ("When I say done, put the cup on the shelf.", "Done.", "placing(theme=the cup, goal=the shelf"),
    ],
)
def test_what_was_taught_is_done(known: Any, parser: Any, lesson: str, text: str, expected: str) -> None:
    assert not isinstance(said(text, known, parser).outcome, Understood)
    wiser = with_lessons(known, *taught(lesson, known, parser))
    assert reading_of(said(text, wiser, parser)).startswith(expected)


def test_another_robot_knows_it_from_a_file_of_units(known: Any, parser: Any) -> None:
    (lesson,) = taught("When I say dismissed, go to the charger.", known, parser)
    other = Lexicon()
    for path, text in {**known.lexicon.files, "imported.yaml": lesson.text}.items():
        other.add_file(text, path)
    heard = said("Dismissed.", replace(known, lexicon=other), parser)
    assert reading_of(heard) == "navigating_to_location(goal=the charger)"


def test_a_place_is_where_it_was_taught(known: Any, parser: Any) -> None:
    wiser = with_lessons(known, *taught("When I say done, put the cup on the shelf.", known, parser))
    heard = said("Done.", wiser, parser)
    assert isinstance(heard.outcome, Understood)
    goal = heard.outcome.clauses[0][0].argument("goal")
    assert goal is not None and (goal.relation, goal.text) == ("on", "the shelf")


def test_a_deed_that_wants_a_yes_wants_it_each_time(known: Any, parser: Any) -> None:
    confirmed = replace(known, frames={**known.frames})
    name = "navigating_to_location"
    confirmed.frames[name] = replace(known.frames[name], is_confirmed=True)
    wiser = with_lessons(confirmed, *taught("When I say dismissed, go to the charger.", confirmed, parser))
    assert isinstance(said("Dismissed!", wiser, parser).outcome, Question)


def test_a_no_keeps_nothing(known: Any, parser: Any) -> None:
    asked = said("When I say dismissed, go to the charger.", known, parser)
    no = said("No.", known, parser, asked.context)
    assert isinstance(no.outcome, Refusal) and not any(one.is_agreed for one in no.lessons)


def test_another_command_ends_the_question(known: Any, parser: Any) -> None:
    asked = said("When I say dismissed, go to the charger.", known, parser)
    other = said("Turn left.", known, parser, asked.context)
    assert isinstance(other.outcome, Understood) and other.lessons == () and other.context.pending is None


def test_words_that_are_understood_get_no_other_meaning(known: Any, parser: Any) -> None:
    refused = said("To nod means to go to the charger.", known, parser)
    assert refused.outcome == Refusal("NOT_LEARNED", 'I know "nod" already, so I learn no other meaning of it.')


@pytest.mark.parametrize(
    "text",
    [
        "To freshen up means to fly to the moon.",
        "To freshen up means to bring it to me.",
        "To freshen up means to turn left twice.",
    ],
)
def test_what_is_not_understood_as_one_thing_is_not_learned(known: Any, parser: Any, text: str) -> None:
    outcome = said(text, known, parser).outcome
    assert isinstance(outcome, Refusal) and outcome.code == "NOT_LEARNED" and "freshen up" in outcome.sentence


@pytest.mark.parametrize(
    "text",
    ["Turn left when I say so.", "Whenever I say banana, turn left.", "When Anna says hello, go to the charger."],
)
def test_conditions_and_orders_are_as_they_were(known: Any, parser: Any, text: str) -> None:
    assert said(text, known, parser).outcome == said(text, known, parser, without=frozenset(["teaching"])).outcome


def test_who_teaches_another_meaning_is_told_the_one_before(known: Any, parser: Any) -> None:
    wiser = with_lessons(known, *taught("When I say dismissed, go to the charger.", known, parser))
    asked = said("When I say dismissed, turn left.", wiser, parser).outcome
    assert asked == Question(
        "CONFIRM",
        'By "dismissed", do you always mean "turn left"? So far it means navigating to location (the charger).',
    )


def test_what_was_taught_is_forgotten_by_its_words(known: Any, parser: Any) -> None:
    way = Lesson("make your way", "go", "", "", text="frame_name: navigating_to_location\nverb: make your way\n")
    wiser = with_lessons(known, *taught("When I say dismissed, go to the charger.", known, parser), way)
    for text, words in (
        ("Forget what I taught you about dismissed.", "dismissed"),
        ("Forget what I taught you about making my way.", "make your way"),
        ("Forget what I taught you about making my way home.", "make your way"),
    ):
        heard = said(text, wiser, parser)
        assert heard.outcome == Noted("DONE", f'I have forgotten "{words}".')
        assert [(one.said, one.is_forgotten) for one in heard.lessons] == [(words, True)]
        refused = said(text, known, parser)
        assert isinstance(refused.outcome, Refusal) and refused.outcome.code == "NOT_LEARNED" and not refused.lessons


def test_an_agent_teaches_and_forgets_nothing(known: Any, parser: Any) -> None:
    wiser = with_lessons(known, *taught("When I say dismissed, go to the charger.", known, parser))
    for text in ("To freshen up means to open the window.", "Forget what I taught you about dismissed."):
        refused = said(text, wiser, parser, may_teach=False)
        assert isinstance(refused.outcome, Refusal) and refused.outcome.code == "NOT_LEARNED" and not refused.lessons
    # It is asked what is meant, and a yes of the person at the client does it and teaches nothing.
    asked = said("Acquire the ball.", known, parser, may_teach=False)
    yes = said("Yes.", known, parser, asked.context, may_teach=False)
    assert isinstance(yes.outcome, Understood) and yes.lessons == ()


def test_the_rule_can_be_switched_off(known: Any, parser: Any) -> None:
    outcome = said("To freshen up means to open the window.", known, parser, without=frozenset(["teaching"])).outcome
    assert isinstance(outcome, Refusal) and outcome.code == "REPORT"
