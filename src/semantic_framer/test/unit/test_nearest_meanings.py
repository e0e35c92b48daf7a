"""A sentence that cannot be done as it stands: the nearest thing is asked about, and a yes teaches it."""

from dataclasses import replace
from typing import Any, Tuple

import pytest

from nearest_meaning.likeness import Likeness
from semantic_framer.framer import Heard, Policy, Question, Refusal, Understood, hear
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.units.heeding import EVERYTHING
from semantic_framer.units.learned_units import learned_units, text_of_lesson
from semantic_framer.units.lexicon import Lexicon
from semantic_framer.values.dialogue import Context, Lesson
from utterance_passes.engine.trace import Trace

ACQUIRE = 'By "Acquire the ball", do you mean "get the ball"?'


class Alike(Likeness):
    """Finds one text alike, and no other."""

    def __init__(self, *texts: str) -> None:
        super().__init__()
        self._texts = texts

    def of(self, text: str, others: Tuple[str, ...]) -> Tuple[float, ...]:
        return tuple(0.8 if other in self._texts else 0.1 for other in others)


@pytest.fixture
def known(lexicon: Lexicon, frames: Any) -> FramedLexicon:
    return FramedLexicon(lexicon, frames)


def said(text: str, known: FramedLexicon, parser: Any, context: Context = Context(), **more: Any) -> Heard:
    return hear(parser.parse(text, known.lexicon.verbs), known, context=context, policy=Policy(), **more)


def frames_of(heard: Heard) -> Any:
    assert isinstance(heard.outcome, Understood), heard.outcome
    return [clause[0].unit.frame_name for clause in heard.outcome.clauses]


def test_a_verb_of_the_class_of_a_known_one_is_asked_about(known: Any, parser: Any) -> None:
    asked = said("Acquire the ball.", known, parser)
    assert asked.outcome == Question("CONFIRM", ACQUIRE) and asked.lessons == ()
    yes = said("Yes.", known, parser, asked.context)
    assert frames_of(yes) == ["taking"]
    (lesson,) = yes.lessons
    assert (lesson.said, lesson.verb, lesson.is_agreed, lesson.sentence) == (
        "acquire",
        "get",
        True,
        "Acquire the ball.",
    )


def test_a_no_does_nothing_and_is_not_asked_again(known: Any, parser: Any) -> None:
    asked = said("Acquire the ball.", known, parser)
    no = said("No.", known, parser, asked.context)
    assert isinstance(no.outcome, Refusal) and no.context.pending is None
    assert [(one.said, one.frame_name, one.is_agreed) for one in no.lessons] == [("acquire", "taking", False)]
    wiser = replace(known, declined=frozenset([("acquire", "taking")]))
    again = said("Acquire the cup.", wiser, parser).outcome
    assert "get the cup" not in again.sentence


def test_an_idiom_is_asked_about_by_the_verb_of_the_examples_that_are_like_it(known: Any, parser: Any) -> None:
    examples = known.lexicon.deeds(known.frames).examples
    of_going = [one.text for one in examples if one.unit.frame_name == "navigating_to_location"]
    like = replace(known, likeness=Alike("go", *of_going))
    asked = said("Make your way to the hall.", like, parser)
    assert asked.outcome == Question("CONFIRM", 'By "Make your way to the hall", do you mean "go to the hall"?')
    yes = said("yes", like, parser, asked.context)
    assert frames_of(yes) == ["navigating_to_location"] and yes.lessons[0].said == "make your way"


def test_what_nothing_is_like_is_refused_as_before(known: Any, parser: Any) -> None:
    refused = said("Make your way to the hall.", replace(known, likeness=Alike()), parser).outcome
    assert refused == Refusal("NO_READING", 'I know "make", but not used like this.')


def test_a_refusal_says_what_can_be_done_that_is_near(known: Any, parser: Any) -> None:
    texts = {one.unit.frame_name: one.text for one in known.lexicon.deeds(known.frames).examples}
    like = replace(known, likeness=Alike(texts["navigating_to_location"], texts["perceiving"]))
    refused = said("Betake yourself to the kitchen.", like, parser).outcome
    assert refused == Refusal("UNKNOWN_VERB", 'I do not know how to "betake". I can go and look.')
    only = replace(like, heeded={"navigating_to_location": {"goal": EVERYTHING}})
    assert said("Betake yourself to the kitchen.", only, parser).outcome.sentence.endswith("I can go.")


def test_without_an_encoder_only_the_class_counts_and_the_trace_says_why(
    known: Any, parser: Any, tmp_path: Any
) -> None:
    trace = Trace()
    heard = said("Acquire the ball.", replace(known, likeness=Likeness(tmp_path)), parser, trace=trace)
    assert heard.outcome == Question("CONFIRM", ACQUIRE)
    lines = [line.after for line in trace.lines if line.rule == "nearest_meaning"]
    assert any("not compared" in line and str(tmp_path) in line for line in lines)
    assert any("To acquire is the same as to get." in line for line in lines)


def test_a_sentence_with_words_that_nothing_reads_is_asked_about_without_them(known: Any, parser: Any) -> None:
    asked = said("Go deep into the cave.", known, parser)
    assert asked.outcome == Question("CONFIRM", 'By "Go deep into the cave", do you mean "go into the cave"?')
    yes = said("Yes.", known, parser, asked.context)
    assert frames_of(yes) == ["navigating_to_location"] and [one.verb for one in yes.lessons] == [""]
    wiser = replace(known, declined=frozenset([("go deep into the cave", "navigating_to_location")]))
    assert isinstance(said("Go deep into the cave.", wiser, parser).outcome, Refusal)


@pytest.mark.parametrize(
    "text",
    [
        "Do not acquire the ball.",
        "Never acquire the ball.",
        "Acquire the ball without the lid.",
        "Acquire the ball unless it is full.",
        "I acquire the ball.",
        "Did you acquire the ball?",
        "Move to the left three feet.",
        "Turn left two feet.",
        "stop going north now",
        "Thank you.",
    ],
)
def test_what_is_forbidden_limited_told_or_asked_is_not_asked_about(known: Any, parser: Any, text: str) -> None:
    outcome = said(text, known, parser).outcome
    assert not (isinstance(outcome, Question) and outcome.sentence.startswith("By "))


def test_what_is_understood_and_reaches_no_server_is_refused(lexicon: Any, frames: Any, parser: Any) -> None:
    known = FramedLexicon(lexicon, frames, heeded={"pushing": {"theme": EVERYTHING}})
    assert isinstance(said("Push the chair onto the table.", known, parser).outcome, Refusal)


def test_the_rule_can_be_switched_off(known: Any, parser: Any) -> None:
    outcome = said("Acquire the ball.", known, parser, without=frozenset(["nearest_meaning"])).outcome
    assert isinstance(outcome, Refusal) and outcome.code == "UNKNOWN_VERB"


def test_who_asks_nothing_back_does_not_ask_this(known: Any, parser: Any) -> None:
    tree = parser.parse("Acquire the ball.", known.lexicon.verbs)
    assert isinstance(hear(tree, known, policy=Policy(confirms=False)).outcome, Refusal)


def test_a_stop_ends_the_question(known: Any, parser: Any) -> None:
    asked = said("Acquire the ball.", known, parser)
    yes = said("Yes.", known, parser, asked.context.stopped())
    assert isinstance(yes.outcome, Refusal) and yes.lessons == ()


def test_a_question_that_has_expired_teaches_nothing(known: Any, parser: Any) -> None:
    asked = said("Acquire the ball.", known, parser)
    yes = said("Yes.", known, parser, asked.context, now_s=Policy().question_timeout_s + 1.0)
    assert isinstance(yes.outcome, Refusal) and yes.lessons == ()


# --- what is learned


def taught(known: FramedLexicon, lesson: Lesson) -> FramedLexicon:
    wiser = Lexicon()
    for path, text in known.lexicon.files.items():
        wiser.add_file(text, path)
    text = text_of_lesson(lesson, known.lexicon)
    wiser.replace_file("learned/x.yaml", text, learned_units(text, "learned/x.yaml"))
    return replace(known, lexicon=wiser)


@pytest.mark.parametrize(
    ("lesson", "text", "expected"),
    [
        (
            Lesson("make your way", "go", "navigating_to_location", "Make your way to the hall."),
            "Make your way to the office.",
            "navigating_to_location(goal=the office)",
        ),
        (
            Lesson("acquire", "get", "taking", "Acquire the ball."),
            "Could you acquire the cup?",
            "taking(theme=the cup)",
        ),
        (
            Lesson("freshen up", "tidy up", "tidying", "Freshen up the room."),
            "freshen up the kitchen",
            "tidying(object=the kitchen)",
        ),
    ],
)
def test_what_was_taught_is_done_with_other_arguments(
    known: Any, parser: Any, lesson: Lesson, text: str, expected: str
) -> None:
    heard = said(text, taught(known, lesson), parser)
    assert isinstance(heard.outcome, Understood), heard.outcome
    assert str(heard.outcome.clauses[0][0]).startswith(expected[:-1])


def test_a_unit_that_a_programmer_wrote_goes_before_one_that_was_taught(known: Any, parser: Any) -> None:
    wiser = taught(known, Lesson("lift", "drop", "ungrasping", "Lift it."))
    assert frames_of(said("Lift the box.", wiser, parser)) == frames_of(said("Lift the box.", known, parser))


def test_a_verb_without_a_file_teaches_nothing(known: Any) -> None:
    with pytest.raises(LookupError):
        text_of_lesson(Lesson("zoom", "no such verb", "moving", "Zoom."), known.lexicon)
