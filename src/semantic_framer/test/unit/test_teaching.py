"""What a person teaches in words: it is asked about before it is kept, and done like any other command."""

from dataclasses import replace
from typing import Any, Tuple

import pytest

from frame_registrar.graph import FrameGraph
from frame_registrar.sequence_finder import SequenceFinder
from semantic_framer.framer import Heard, Policy, Question, Refusal, Understood, hear
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.units.learned_units import learned_units
from semantic_framer.units.lexicon import Lexicon
from semantic_framer.units.taught_names import TaughtNames
from semantic_framer.values.dialogue import Context, Lesson
from semantic_framer.values.outcome import Noted, reply_outcome
from semantic_frames import load_frame
from typed_arguments import FilledFrame
from world_model import Relation, Sort, World, WorldObject
from world_model.world_object import ROBOT_ID

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
        unit_text, _, frame_text = lesson.text.partition("\n---\n")
        wiser.replace_file(path, unit_text, learned_units(unit_text, path))
        if frame_text:
            frame = load_frame(frame_text, path)
            known = replace(known, frames={**known.frames, frame.name: frame})
    meanings = {f"learned/{place}.yaml": lesson.verb for place, lesson in enumerate(lessons)}
    return replace(known, lexicon=wiser, taught=TaughtNames(meanings=meanings))


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


TIDYING = "To tidy up means to put the books on the shelf and the cups in the kitchen."


@pytest.mark.parametrize(
    ("lesson", "told"),
    [
        (TIDYING, "put the books on the shelf, then put the cups in the kitchen"),
        ("To freshen up means to open the window, then go to the hall.", "open the window, then go to the hall"),
        ("When I say bedtime, close the door and go to the charger.", "close the door, then go to the charger"),
    ],
)
def test_a_sequence_is_told_back_deed_by_deed(known: Any, parser: Any, lesson: str, told: str) -> None:
    asked = said(lesson, known, parser).outcome
    assert isinstance(asked, Question) and asked.sentence.endswith(f'do you always mean "{told}"?')


def test_a_sequence_is_one_in_the_frame_graph(known: Any, parser: Any) -> None:
    (lesson,) = taught(TIDYING, known, parser)
    frame = load_frame(lesson.text.partition("\n---\n")[2], "learned.yaml")
    assert frame.name == lesson.frame_name == "taught_tidy_up"
    assert [[child.name for child in sequence] for sequence in frame.children] == [["placing", "placing"]]
    graph = FrameGraph()
    for one in (*known.frames.values(), frame):
        graph.add(one)
    graph.register("placing", "placer")
    heard = said("Tidy up.", with_lessons(known, lesson), parser)
    assert isinstance(heard.outcome, Understood)
    filled = FilledFrame(frame.name, heard.outcome.clauses[0][0].arguments)
    (found,) = SequenceFinder(graph).find([filled])
    assert [(one.name, one.text("theme"), one.text("goal")) for one in found] == [
        ("placing", "the books", "the shelf"),
        ("placing", "the cups", "the kitchen"),
    ]
    goals = [one.find("goal") for one in found]
    assert [goal.relation for goal in goals if goal is not None] == ["on", "in"]


def test_a_limit_of_a_child_holds_in_a_sequence(known: Any, parser: Any) -> None:
    (lesson,) = taught("To patrol far means to go to the hall and to turn left 90 degrees.", known, parser)
    frame = load_frame(lesson.text.partition("\n---\n")[2], "learned.yaml")
    limited = known.frames["turning"]
    elements = tuple(replace(e, maximum=1.0) if e.name == "angle" else e for e in limited.frame_elements)
    graph = FrameGraph()
    for one in (*known.frames.values(), replace(limited, frame_elements=elements), frame):
        graph.add(one)
    graph.register("navigating_to_location", "goer")
    graph.register("turning", "turner")
    heard = said("Patrol far.", with_lessons(known, lesson), parser)
    assert isinstance(heard.outcome, Understood)
    finder = SequenceFinder(graph)
    filled = FilledFrame(frame.name, heard.outcome.clauses[0][0].arguments)
    assert list(finder.find([filled])) == [] and "LIMIT" in [one.code for one in finder.why_not([filled])]


def test_a_sequence_wants_a_yes_where_one_of_its_deeds_wants_it(known: Any, parser: Any) -> None:
    confirmed = replace(known, frames={**known.frames})
    confirmed.frames["placing"] = replace(known.frames["placing"], is_confirmed=True)
    wiser = with_lessons(confirmed, *taught(TIDYING, confirmed, parser))
    assert isinstance(said("Tidy up.", wiser, parser).outcome, Question)


def test_what_two_persons_taught_is_asked_about_with_both(known: Any, parser: Any) -> None:
    lessons = [
        *taught("When I say dismissed, go to the charger.", known, parser),
        *taught("When I say dismissed, turn left.", known, parser),
    ]
    wiser = with_lessons(known, *lessons)
    asked = said("Dismissed!", wiser, parser)
    assert asked.outcome == Question(
        "AMBIGUOUS",
        'I was taught different meanings of "Dismissed". Which do you mean: "turn left" or "go to the charger"?',
    )
    done = said("Go to the charger.", wiser, parser, asked.context)
    assert reading_of(done) == "navigating_to_location(goal=the charger)"
    assert reading_of(said("The first one.", wiser, parser, asked.context)).startswith("turning(direction=left")
    same = with_lessons(known, lessons[0], lessons[0])
    assert reading_of(said("Dismissed!", same, parser)) == "navigating_to_location(goal=the charger)"


@pytest.mark.parametrize(
    ("text", "told", "noun", "kind"),
    [
        ("A mug is a cup.", "a mug is a cup", "mug", "cup"),
        ("A frobnicator is a kind of tool.", "a frobnicator is a tool", "frobnicator", "tool"),
        ("Mugs are cups.", "a mug is a cup", "mug", "cup"),
    ],
)
def test_a_kind_is_told_back_before_it_is_kept(
    known: Any, parser: Any, text: str, told: str, noun: str, kind: str
) -> None:
    assert said(text, known, parser).outcome == Question("CONFIRM", f"Shall I remember that {told}? Say yes or no.")
    (lesson,) = taught(text, known, parser)
    assert (lesson.said, lesson.verb, lesson.frame_name) == (noun, kind, "(kind)")


@pytest.mark.parametrize(
    "text",
    [
        "A dog is an animal.",
        "The mug is a cup.",
        "A man is a robot.",
        "Love is a battlefield.",
        "Is a mug a cup?",
        "This room is the den.",
        "This room is a mess.",
    ],
)
def test_what_is_known_or_names_no_thing_teaches_no_kind(known: Any, parser: Any, text: str) -> None:
    assert said(text, known, parser).outcome == said(text, known, parser, without=frozenset(["teaching"])).outcome


HOME = World(
    "1",
    (
        WorldObject("living_room", Sort.PLACE, "living room", category="living room", size_m=(4.0, 4.0, 2.0)),
        WorldObject("kitchen", Sort.PLACE, "kitchen", category="kitchen"),
        WorldObject(ROBOT_ID, Sort.ROBOT, relations=(Relation("in", "living_room"),)),
        WorldObject("mug_1", category="mug", relations=(Relation("in", "kitchen"),)),
    ),
)


def test_a_name_of_the_place_where_the_robot_is_is_told_back(known: Any, parser: Any) -> None:
    at_home = replace(known, world=HOME)
    asked = said("This room is the den.", at_home, parser).outcome
    assert asked == Question("CONFIRM", 'By "the den", do you always mean this place, the living room?')
    (lesson,) = taught("This room is the den.", at_home, parser)
    assert (lesson.said, lesson.verb, lesson.frame_name) == ("den", "living_room", "(place)")
    names = TaughtNames(places={lesson.said: lesson.verb})
    wiser = replace(at_home, world=names.world_with(HOME), types=names.types_with(known.types), taught=names)
    heard = said("Go to the den.", wiser, parser)
    assert isinstance(heard.outcome, Understood)
    goal = heard.outcome.clauses[0][0].argument("goal")
    assert goal is not None and goal.referents == ("living_room",)
    assert isinstance(said("This room is the kitchen.", at_home, parser).outcome, Refusal)
    forgotten = said("Forget what I taught you about the den.", wiser, parser)
    assert [(one.said, one.is_forgotten) for one in forgotten.lessons] == [("den", True)]


def test_a_thing_of_a_taught_kind_is_found(known: Any, parser: Any) -> None:
    names = TaughtNames(kinds={"mug": "frobnicator", "gizmo": "mug"})
    wiser = replace(known, world=names.world_with(HOME), types=names.types_with(known.types), taught=names)
    for text in ("Take the frobnicator.", "Take the gizmo."):
        heard = said(text, wiser, parser)
        assert isinstance(heard.outcome, Understood), heard.outcome
        theme = heard.outcome.clauses[0][0].argument("theme")
        assert theme is not None and theme.referents == ("mug_1",)
    heard = said("Take the gizmo.", known, parser)
    theme = heard.outcome.clauses[0][0].argument("theme") if isinstance(heard.outcome, Understood) else None
    assert theme is None or theme.referents == ()


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
        'By "dismissed", do you always mean "turn left"? So far it means "go to the charger".',
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


def test_who_is_not_to_forget_forgets_nothing(known: Any, parser: Any) -> None:
    wiser = with_lessons(known, *taught("When I say dismissed, go to the charger.", known, parser))
    assert said("Do not forget what I taught you about dismissed.", wiser, parser).lessons == ()
    named = said('Forget what I taught you about "dismissed".', wiser, parser)
    assert [(one.said, one.is_forgotten) for one in named.lessons] == [("dismissed", True)]


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
