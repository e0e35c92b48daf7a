"""Fragments and repeats change or repeat the last command while it is fresh."""

from dataclasses import replace
from typing import Dict, List, Tuple

import pytest

from semantic_framer.clauses.fragments import shipped_fragments
from semantic_framer.framer import Policy, Question, Refusal, Understood, hear
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.units.lexicon import Lexicon
from semantic_framer.values.dialogue import Context, LastCommand
from semantic_frames.frame import SemanticFrame
from stanford_parser_ros.model import Parser
from typed_arguments import Source
from utterance_passes.engine.trace import Trace
from utterance_passes.trees.formula_file import Formula

PATTERNS = [(kind, formula) for kind, formulas in shipped_fragments().items() for formula in formulas]


class Talk:
    """One person and one framer; each utterance has a stamp."""

    def __init__(self, parser: Parser, known: FramedLexicon) -> None:
        self._parser = parser
        self._known = known
        self._verbs = frozenset(verb.split()[0] for verb in known.lexicon.verbs)
        self.context = Context()
        self.trace = ""

    def say(self, text: str, said_s: float = 100.0, policy: Policy = Policy()) -> object:
        trace = Trace()
        tree = self._parser.parse(text, self._verbs)
        heard = hear(tree, self._known, context=self.context, policy=policy, said_s=said_s, trace=trace)
        self.context, self.trace = heard.context, str(trace)
        return heard.outcome

    def frames(self, text: str, said_s: float = 100.0, policy: Policy = Policy()) -> Tuple[str, ...]:
        outcome = self.say(text, said_s, policy)
        assert isinstance(outcome, Understood), outcome
        return tuple(str(readings[0]) for readings in outcome.clauses)


@pytest.fixture
def talk(parser: Parser, lexicon: Lexicon, frames: Dict[str, SemanticFrame]) -> Talk:
    return Talk(parser, FramedLexicon(lexicon, frames))


@pytest.mark.parametrize("kind, formula", PATTERNS, ids=lambda value: getattr(value, "example", value))
def test_the_example_of_a_pattern_is_its_own(kind: str, formula: Formula) -> None:
    of_kind = [other for of, other in PATTERNS if of == kind]
    assert [other for other in of_kind if other.pattern.fullmatch(formula.example)] == [formula]


def test_a_measure_replaces_the_amount(talk: Talk) -> None:
    talk.say("Move forward two metres.")
    outcome = talk.say("ten feet")
    assert isinstance(outcome, Understood)
    reading = outcome.clauses[0][0]
    assert str(reading) == "moving(direction=forward, distance=10, distance_unit=feet)"
    direction, distance = reading.argument("direction"), reading.argument("distance")
    assert direction is not None and distance is not None
    assert direction.source is Source.INFERRED and not direction.positions
    assert distance.source is Source.SAID and distance.positions == (1, 2)
    assert distance.si == pytest.approx(3.048)
    assert "fragment: ten feet: changes elements" in talk.trace


def test_a_repeat_says_nothing_new(talk: Talk) -> None:
    first = talk.frames("Go to the kitchen and turn left.")
    outcome = talk.say("again")
    assert isinstance(outcome, Understood)
    assert tuple(str(readings[0]) for readings in outcome.clauses) == first
    values = [value for readings in outcome.clauses for value in readings[0].arguments]
    assert {value.source for value in values} == {Source.INFERRED, Source.DEFAULT}
    assert not any(value.positions or value.head_position for value in values)


def test_a_fragment_can_be_changed_again(talk: Talk) -> None:
    talk.say("Turn left 30 degrees.")
    assert talk.frames("to the right") == ("turning(direction=right, angle=30, angle_unit=degrees)",)
    assert talk.frames("ten more") == ("turning(direction=right, angle=10, angle_unit=degrees)",)
    assert talk.frames("again") == ("turning(direction=right, angle=10, angle_unit=degrees)",)


@pytest.mark.parametrize(
    ("before", "said", "frame"),
    [
        ("Move forward two metres.", "a bit more", "moving(direction=forward, distance=20, distance_unit=centimetres)"),
        ("Turn left 30 degrees.", "a bit more", "turning(direction=left, angle=15, angle_unit=degrees)"),
        ("Turn left.", "a bit more to the right", "turning(direction=right, angle=15, angle_unit=degrees)"),
        ("Turn left.", "a bit to the right", "turning(direction=right, angle=15, angle_unit=degrees)"),
    ],
)
def test_a_bit_is_a_stated_amount(talk: Talk, before: str, said: str, frame: str) -> None:
    talk.say(before)
    outcome = talk.say(said)
    assert isinstance(outcome, Understood)
    reading = outcome.clauses[0][0]
    assert str(reading) == frame
    amounts = [one.measure for one in reading.arguments if one.measure is not None]
    assert amounts and all(measure.is_assumed for measure in amounts)
    assert reading.clause_text.endswith("(20 centimetres)" if "metres" in frame else "(15 degrees)")


@pytest.mark.parametrize(
    ("before", "said", "frame"),
    [
        ("Follow me.", ["faster"], "following(cotheme=me, manner=faster)"),
        ("Follow me.", ["a bit slower please"], "following(cotheme=me, manner=slower)"),
        ("Follow me.", ["hurry up", "slow down a little"], "following(cotheme=me)"),
        ("Go to the kitchen.", ["go a bit faster"], "navigating_to_location(goal=the kitchen, speed=faster)"),
    ],
)
def test_a_deed_goes_on_faster_or_slower(talk: Talk, before: str, said: List[str], frame: str) -> None:
    talk.say(before)
    found = [talk.frames(text) for text in said]
    assert found[-1] == (frame,)


def test_what_is_done_fast_cannot_be_done_faster(talk: Talk) -> None:
    talk.say("Follow me.")
    talk.say("faster")
    outcome = talk.say("even faster")
    assert isinstance(outcome, Refusal) and outcome.sentence == "I cannot do that faster."


def test_an_amount_is_not_done_again_faster_without_a_yes(talk: Talk) -> None:
    talk.say("Turn left.")
    outcome = talk.say("faster")
    assert isinstance(outcome, Question) and outcome.code == "CONFIRM"


def test_faster_alone_means_nothing(talk: Talk) -> None:
    outcome = talk.say("faster")
    assert isinstance(outcome, Question) and outcome.code == "AMBIGUOUS"


def test_how_to_do_an_amount_again_wants_a_yes(talk: Talk) -> None:
    talk.say("Turn left 30 degrees.")
    outcome = talk.say("slowly")
    assert isinstance(outcome, Question) and outcome.code == "CONFIRM"
    assert talk.frames("yes") == ("turning(direction=left, angle=30, angle_unit=degrees, speed=slowly)",)


@pytest.mark.parametrize("said_s, is_fresh", [(160.0, True), (161.0, False), (99.0, False)])
def test_a_command_is_fresh_for_a_while(talk: Talk, said_s: float, is_fresh: bool) -> None:
    talk.say("Turn left.")
    outcome = talk.say("again", said_s=said_s)
    assert isinstance(outcome, Understood if is_fresh else Question)


def test_the_time_is_a_parameter(talk: Talk) -> None:
    never = Policy(fragment_timeout_s=0.0)
    talk.say("Turn left.", policy=never)
    outcome = talk.say("again", policy=never)
    assert isinstance(outcome, Refusal) and outcome.code == "NO_VERB"


def test_without_a_command_the_robot_asks(talk: Talk) -> None:
    outcome = talk.say("again")
    assert outcome == Question("AMBIGUOUS", 'What do you mean by "again"? Say it in a whole sentence.')


def test_a_stop_forgets_the_command(talk: Talk) -> None:
    talk.say("Turn left.")
    talk.context = talk.context.stopped()
    assert isinstance(talk.say("again"), Question)


@pytest.mark.parametrize(
    "between, is_kept",
    [
        ("hello", True),
        ("Wash the zyx.", True),
    ],
)
def test_a_refused_command_leaves_nothing_to_repeat(talk: Talk, between: str, is_kept: bool) -> None:
    talk.say("Turn left.")
    talk.say(between)
    assert isinstance(talk.say("again"), Understood if is_kept else Question)


def test_a_frame_that_is_gone_is_not_repeated(talk: Talk) -> None:
    talk.say("Turn left.")
    last = talk.context.last
    assert isinstance(last, LastCommand)
    unit = replace(last.clauses[0][0].unit, frame_name="gone")
    talk.context = replace(talk.context, last=replace(last, clauses=((replace(last.clauses[0][0], unit=unit),),)))
    outcome = talk.say("again")
    assert isinstance(outcome, Refusal) and outcome.code == "NO_VERB"


def test_two_clauses_with_such_an_element_lead_to_a_question(talk: Talk) -> None:
    talk.say("Take the cup and clean the plate.")
    outcome = talk.say("and the mug too")
    assert isinstance(outcome, Question)
    assert outcome.sentence == 'Which do you mean: "clean the mug" or "take the mug"? Say it in a whole sentence.'


@pytest.mark.parametrize(
    ("text", "way"),
    [("Louder.", "louder"), ("Say that again louder.", "louder"), ("Quieter.", "quieter")],
)
def test_a_robot_with_one_voice_does_not_say_louder_as_words(talk: Talk, text: str, way: str) -> None:
    talk.say("Say hello.")
    outcome = talk.say(text)
    assert isinstance(outcome, Refusal) and outcome.sentence == f"I cannot do that {way}."


def test_another_way_is_the_other_way(talk: Talk) -> None:
    talk.say("Turn left ninety degrees.")
    assert talk.frames("Other way.") == ("turning(direction=right, angle=90, angle_unit=degrees)",)


def test_next_to_is_a_place_and_no_beginning(talk: Talk) -> None:
    talk.say("Put the mug on the table.")
    outcome = talk.say("Next to the plate.")
    assert isinstance(outcome, Understood) and outcome.beginning == "REPLACE"
    goal = outcome.clauses[0][0].argument("goal")
    assert goal is not None and (goal.text, goal.relation) == ("the plate", "next_to")


@pytest.mark.parametrize(
    ("first", "said", "count"),
    [
        ("Turn around.", "Repeat that four times.", 4),
        ("Turn around.", "three more times", 3),
        ("Turn around.", "Do it twice more.", 2),
        ("Turn around twice.", "do that again three times", 6),
    ],
)
def test_a_command_is_repeated_so_many_times(talk: Talk, first: str, said: str, count: int) -> None:
    talk.say(first)
    outcome = talk.say(said)
    assert isinstance(outcome, Understood), outcome
    assert [readings[0].control.count for readings in outcome.clauses] == [count]


def test_several_clauses_are_not_repeated_so_many_times(talk: Talk) -> None:
    talk.say("Turn around and move forward two metres.")
    assert isinstance(talk.say("Repeat that four times."), Refusal)


def test_a_question_that_is_asked_again_keeps_the_beginning(talk: Talk) -> None:
    talk.say("Turn left ninety degrees.")
    first = talk.say("Then put the mug down.")
    again = talk.say("Where?")
    outcome = talk.say("On the table.")
    assert again == first
    assert isinstance(outcome, Understood) and outcome.beginning == "FOLLOW"
