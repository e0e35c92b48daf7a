"""Questions about a small home and about the robot, from the sentence to the answer."""

from dataclasses import replace
from datetime import datetime
from typing import Optional, Tuple

import pytest

from offline_pipeline.knowledge import load_knowledge, pretend_servers, shipped_domains
from offline_pipeline.pipeline import Pipeline
from question_answering.answers import ANSWERS, BEING_NAMED, answer, person_named
from question_answering.robot_knowledge import (
    Deed,
    Outcome,
    RobotKnowledge,
    examples_of,
    served_frames,
    steps_behind,
)
from question_answering.wording import day_and_time
from typed_arguments import Source, TypedArgument
from world_model import Relation, Sort, WorldObject
from world_model.knowledge import Change, Knowledge, Update
from world_model.world import World, snapshot
from world_model.world_file import load_world_file

HOME = """
places:
  kitchen: {x: 0, y: 0, size: [6, 6]}
  hall:
  office:
doors:
  kitchen_door: {to: kitchen, states: [closed]}
things:
  table_1: {in: kitchen}
  shelf_1: {in: hall, size: [1, 0.4, 2]}
  mug_1: {on: table_1, attributes: [red], of: anna}
  bottle_1: {on: table_1, states: [empty]}
  bottle_2: {on: shelf_1, states: [empty]}
  chair_1: {in: hall}
  chair_2: {in: hall}
  key_1: {}
devices:
  lamp_1: {in: hall}
persons:
  anna: {in: kitchen}
  ben: {in: hall}
robots:
  robot: {x: 1, y: 1}
"""


@pytest.fixture(scope="module")
def pipeline() -> Pipeline:
    knowledge = load_knowledge([shipped_domains()])
    pretend_servers(knowledge.graph)
    return Pipeline(knowledge)


@pytest.fixture(scope="module")
def home() -> World:
    return snapshot("1", {one.id: one for one in load_world_file(HOME, "home.yaml")})


def answered(text: str, pipeline: Pipeline, known: RobotKnowledge) -> Optional[str]:
    """Return the answer to a question; None when it is not understood as one."""
    readings = pipeline.understand(text).readings
    if len(readings) != 1 or readings[0].unit.frame_name not in ANSWERS:
        return None
    return answer(readings[0].unit.frame_name, readings[0].arguments, known)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Where is the mug?", "The mug is on the table in the kitchen."),
        ("Where is Anna?", "Anna is in the kitchen."),
        ("Where are you?", "I am in the kitchen."),
        ("Where is the key?", "I do not know where the key is."),
        ("Where is the unicorn?", "I know of no unicorn."),
        ("Where is Clara?", "I do not know Clara."),
        ("Have you seen the red mug?", "The red mug is on the table in the kitchen."),
        (
            "Where are the bottles?",
            "I know of 2 bottles: one is on the table in the kitchen and one is on the shelf in the hall.",
        ),
        ("Which things are on the table?", "On the table there are a bottle and a red mug."),
        ("What is on the shelf?", "On the shelf there is a bottle."),
        ("What is in the office?", "I know of nothing in the office."),
        ("What is on the piano?", 'I do not know of any place "the piano".'),
        ("How many chairs are in the hall?", "As far as I know, there are 2 chairs in the hall."),
        ("How many chairs are in the kitchen?", "I know of no chairs in the kitchen."),
        ("How many people are in the kitchen?", "As far as I know, there is 1 person in the kitchen."),
        ("How many mugs are there?", "As far as I know, there is 1 mug."),
        ("Is the door open?", "No, the door is closed."),
        ("Is the door closed?", "Yes, the door is closed."),
        ("Are the bottles empty?", "Yes, the bottles are empty."),
        ("Which door is open?", "I know of no door that is open."),
        ("Which doors are closed?", "The kitchen door is closed."),
        ("What bottles on the shelf are empty?", "The bottle on the shelf is empty."),
        ("How many bottles are empty?", "As far as I know, there are 2 bottles that are empty."),
        ("Which rooms do you know?", "I know of the hall, the kitchen and the office."),
        ("What is Anna holding?", "I do not know that Anna holds anything."),
        ("What do you have in your hand?", "I hold nothing."),
        ("What does Anna have?", "A red mug belongs to Anna."),
        ("What is in your hand?", "I hold nothing."),
        ("Does Anna have the mug?", "Yes. A red mug belongs to Anna."),
        ("Who is holding the mug?", "The mug is on the table in the kitchen."),
        ("Who is asleep?", "I know of nobody who is asleep."),
        ("Is Anna in the kitchen or in the hall?", "Anna is in the kitchen."),
        ("Who is in the hall or in the kitchen?", "Anna and Ben are in the hall or in the kitchen."),
        ("What is the biggest thing you know of in the hall?", "It is the shelf in the hall."),
        ("What is the biggest thing here?", "I do not know which thing is the biggest."),
        ("Is Anna here?", "Yes, Anna is here."),
        ("Are all the doors closed?", "Yes, all the doors are closed."),
        ("Are any bottles full?", "No, the bottles are empty."),
        ("Whose mug is that?", "The mug belongs to Anna."),
        ("Is the lamp on?", "I do not know whether the lamp is on."),
        ("Who is in the kitchen?", "Anna is in the kitchen."),
        ("Who is in the office?", "I know of nobody in the office."),
        ("Is Anna in the kitchen?", "Yes, Anna is in the kitchen."),
        ("Is Anna in the hall?", "No, Anna is in the kitchen."),
        ("Is there a mug on the table?", "Yes, a red mug is on the table."),
        ("Do you know Anna?", "Yes. Anna is a person and is in the kitchen."),
        ("Do you know Clara?", "No, I do not know Clara."),
        ("What is the biggest thing in the hall?", "It is the shelf in the hall."),
        ("Which chair is the biggest?", "I do not know which chair is the biggest."),
        ("What is the biggest mug?", "I do not know which mug is the biggest."),
        ("What is the biggest boat?", "I know of no boat."),
        ("Who owns the red mug?", "The red mug belongs to Anna."),
        ("Whose is the lamp?", "I do not know whom the lamp belongs to."),
        ("What colour is the mug?", "The mug is red."),
        ("What color is the lamp?", "I do not know the colour of the lamp."),
        ("Is the door open or closed?", "The door is closed."),
        ("Is the door closed right now?", "Yes, the door is closed."),
        ("Is the door open at the moment?", "No, the door is closed."),
        ("Where has Anna gone?", "Anna is in the kitchen."),
        ("Where did the mug go?", "The mug is on the table in the kitchen."),
        ("Is there a bottle in the office or not?", "No, I know of no bottle in the office."),
        ("I want to know where the mug is.", "The mug is on the table in the kitchen."),
        ("I wonder if the door is open.", "No, the door is closed."),
        ("Do you know how many chairs there are in the hall?", "As far as I know, there are 2 chairs in the hall."),
        ("Let me know who is in the kitchen.", "Anna is in the kitchen."),
        ("I'd like to know which things are on the table.", "On the table there are a bottle and a red mug."),
        ("Is there a bottle in the office?", "No, I know of no bottle in the office."),
        ("Do you think the door is open?", "No, the door is closed."),
        ("Can you see Anna in the hall?", "No, Anna is in the kitchen."),
        ("What is the mug's colour?", "The mug is red."),
        ("How many chairs have we got in the hall?", "As far as I know, there are 2 chairs in the hall."),
        ("Do you know how many chairs the hall has?", "As far as I know, there are 2 chairs in the hall."),
        ("The color of the mug?", "The mug is red."),
        ("Which color is the mug?", "The mug is red."),
        ("Where is my mug?", "I do not know who you are. The mug of Anna is on the table in the kitchen."),
        ("Where is my lamp?", "The lamp is in the hall."),
        ("Who am I?", "I do not know who you are."),
    ],
)
def test_question_about_the_home(text: str, expected: str, pipeline: Pipeline, home: World) -> None:
    assert answered(text, pipeline, RobotKnowledge(home)) == expected


def test_the_speaker_is_known(pipeline: Pipeline, home: World) -> None:
    known = RobotKnowledge(home, speaker="anna")
    assert answered("Where is my mug?", pipeline, known) == "Your mug is on the table in the kitchen."
    assert answered("Who am I?", pipeline, known) == "You are Anna."
    assert answered("Where is my mug?", pipeline, replace(known, speaker="ben")) == "I know of no mug."


WENT = Deed("Go to the kitchen.", Outcome.DONE, "Done.")
STOPPED = Deed("Follow me.", Outcome.SUPERSEDED, "A stop ended it.")
CRY = Deed("Stop!", Outcome.DONE, "I stand still.", is_stop=True)
NOT_SAID = 'I did not do "say hello", because "it is noon" did not hold.'
IN_PART = Deed("If it is noon, say hello.", Outcome.DONE, f"Done. {NOT_SAID}")
BEGAN = 'I was carrying out "Follow me.", and then you said "Stop!".'
FAILED = Deed("Bring me the mug.", Outcome.FAILED, "I have not seen a mug.")


@pytest.mark.parametrize(
    ("text", "deeds", "doing", "expected"),
    [
        ("Why did you stop?", (STOPPED, CRY), "", 'I was carrying out "Follow me.", and then you said "Stop!".'),
        ("Why did you stop?", (FAILED,), "", '"Bring me the mug." did not work: I have not seen a mug.'),
        ("Why did you stop?", (WENT,), "", 'Nobody stopped me: I carried out "Go to the kitchen." to its end.'),
        (
            "Why did you stop?",
            (STOPPED, CRY, FAILED, WENT),
            "",
            f'{BEGAN} Since then, I have carried out "Go to the kitchen.".',
        ),
        # The replies to a stop, and to what it ends, come in any order.
        ("Why did you stop?", (WENT, CRY, STOPPED), "", 'I was carrying out "Follow me.", and then you said "Stop!".'),
        ("Why did you stop?", (WENT, CRY), "", 'You said "Stop!".'),
        ("What went wrong?", (IN_PART,), "", f'I carried out "{IN_PART.text}", because you asked me to. {NOT_SAID}'),
        ("What did you do?", (IN_PART,), "", f'I carried out "{IN_PART.text}". {NOT_SAID}'),
        ("Why did you stop?", (), "", "I have not done anything yet."),
        ("Why did you stop?", (WENT,), "Follow me.", 'I have not stopped: I am carrying out "Follow me.".'),
        ("Why did you not do it?", (WENT, FAILED), "", '"Bring me the mug." did not work: I have not seen a mug.'),
        (
            "Why didn't you bring me the mug?",
            (FAILED, WENT),
            "",
            '"Bring me the mug." did not work: I have not seen a mug.',
        ),
        ("Why did you go to the kitchen?", (WENT, FAILED), "", 'You asked me to: "Go to the kitchen.".'),
        ("Why did you go to the garden?", (WENT, FAILED), "", "I do not remember anything like that."),
        ("What went wrong?", (WENT, FAILED), "", '"Bring me the mug." did not work: I have not seen a mug.'),
        ("What did you do?", (FAILED, WENT), "", 'I carried out "Go to the kitchen.".'),
        ("What have you done so far?", (STOPPED, CRY), "", 'I began "Follow me.", and did not finish it.'),
        ("What did you do?", (FAILED,), "", 'I did not do it: "Bring me the mug.". I have not seen a mug.'),
        ("What did you do?", (), "", "I have not done anything yet."),
        ("What comes next?", (), "", "Nothing: I am doing nothing at the moment."),
        ("What comes next?", (), "Follow me.", 'Nothing after "Follow me.", as far as I know.'),
    ],
)
def test_what_was_done_and_why(
    text: str, deeds: Tuple[Deed, ...], doing: str, expected: str, pipeline: Pipeline
) -> None:
    assert answered(text, pipeline, RobotKnowledge(deeds=deeds, doing=doing)) == expected


def test_what_comes_next_is_behind_the_active_step(pipeline: Pipeline) -> None:
    steps = ("1 go to the kitchen", "2 take the mug", "3 come back", "succeeded")
    assert steps_behind(steps, ["1 go to the kitchen"]) == ("take the mug", "come back")
    assert steps_behind(steps, ["3 come back"]) == steps_behind(steps, []) == ()
    known = RobotKnowledge(doing="Go to the kitchen.", next_steps=steps_behind(steps, ["1 go to the kitchen"]))
    assert answered("What comes next?", pipeline, known) == "Next: take the mug, then come back."


KNOWN = RobotKnowledge(
    abilities=("Turn left.", "Say hello."),
    ability_count=2,
    doing="Go to the kitchen.",
    last_words="Turn left.",
    last_reply="Which mug?",
    now=datetime(2026, 11, 22, 14, 5),
)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("What can you do?", 'You can say, for example: "Turn left." and "Say hello.".'),
        ("Hey robot, what can you do?", 'You can say, for example: "Turn left." and "Say hello.".'),
        ("Who are you?", "I am Robo, a robot that understands English. Ask me what I can do."),
        ("What are you doing?", 'I am carrying out "Go to the kitchen.".'),
        ("What did I say?", 'You said "Turn left.".'),
        ("What did you say?", 'I said: "Which mug?"'),
        ("Sorry, what?", 'I said: "Which mug?"'),
        ("I didn't understand that.", 'I said: "Which mug?"'),
        ("What time is it?", "It is 14:05."),
        ("What's the time?", "It is 14:05."),
        ("What day is it?", "It is Sunday, 22 November 2026."),
        ("What day is tomorrow?", "Tomorrow is Monday, 23 November 2026."),
        ("Where are you?", "I do not know where I am."),
        ("Where is the mug?", "I know of no mug."),
        ("Who is in the kitchen?", 'I do not know of any place "the kitchen".'),
    ],
)
def test_question_about_the_robot_that_knows_of_nothing(text: str, expected: str, pipeline: Pipeline) -> None:
    assert answered(text, pipeline, KNOWN) == expected


def test_robot_that_can_and_does_nothing_says_so(pipeline: Pipeline) -> None:
    assert "cannot do anything" in answered("What can you do?", pipeline, RobotKnowledge())
    assert answered("What are you doing?", pipeline, RobotKnowledge()) == "I am doing nothing at the moment."


@pytest.mark.parametrize(
    "text",
    [
        "Is it safe to go to the kitchen?",
        "Should I open the door?",
        "Where is it?",
    ],
)
def test_other_questions_do_nothing(text: str, pipeline: Pipeline) -> None:
    found = pipeline.understand(text)
    assert found.reply.outcome != "DONE" or found.readings[0].unit.questions


@pytest.mark.parametrize(
    "text", ["Turn left and what time is it?", "Could you go to the kitchen?", "Can you say hello?"]
)
def test_commands_stay_commands(text: str, pipeline: Pipeline) -> None:
    assert not any(reading.unit.questions for reading in pipeline.understand(text).readings)


def test_examples_are_those_of_frames_that_can_be_carried_out(pipeline: Pipeline) -> None:
    knowledge = pipeline.knowledge
    served = served_frames(knowledge.frames, frozenset(["turning", "saying", "question_of_time"]))
    found = examples_of(knowledge.frames, knowledge.lexicon.units, served)
    assert len(found) == len(served - {"question_of_time"})
    frames = {pipeline.understand(text).readings[0].unit.frame_name for text in found}
    assert frames == served - {"question_of_time"}


def test_every_question_of_the_domain_has_an_answer(pipeline: Pipeline, home: World) -> None:
    # Others are answered by servers of their own, such as those about standing orders.
    assert set(ANSWERS) <= {frame.name for frame in pipeline.knowledge.frames.values() if frame.is_question}
    for unit in pipeline.knowledge.lexicon.units:
        for example in unit.examples if unit.frame_name in ANSWERS else ():
            assert answered(example.text, pipeline, replace(KNOWN, world=home)), example.text


@pytest.mark.parametrize(
    "text, said, ident",
    [
        ("I am Anna.", "Hello, Anna.", "anna"),
        ("my name is Ben", "Hello, Ben.", "ben"),
        ("Hello, I'm Eva Braun.", "Hello, Eva Braun.", "person_eva_braun"),
        ("I am Mrs. Miller.", "Hello, Mrs. Miller.", "person_mrs__miller"),
    ],
)
def test_whoever_says_who_they_are_is_met(text: str, said: str, ident: str, pipeline: Pipeline, home: World) -> None:
    assert answered(text, pipeline, RobotKnowledge(home)) == said
    (reading,) = pipeline.understand(text).readings
    assert person_named(reading.arguments[0].text, home).id == ident


@pytest.mark.parametrize(
    "text", ["I am hungry.", "I am a doctor.", "Her name is Anna.", "I am not Anna.", "Is Anna here?"]
)
def test_not_everybody_who_is_spoken_of_speaks(text: str, pipeline: Pipeline) -> None:
    assert BEING_NAMED not in [reading.unit.frame_name for reading in pipeline.understand(text).readings]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Where is the box?", "I know of no box but the toolbox, which is in the hall."),
        ("Where is the toolbox?", "The toolbox is in the hall."),
    ],
)
def test_thing_of_a_kind_may_not_be_the_one_that_is_meant(text: str, expected: str, pipeline: Pipeline) -> None:
    world = "places:\n  hall:\nthings:\n  toolbox_1: {name: toolbox, category: box, in: hall}\n"
    known = RobotKnowledge(snapshot("1", {one.id: one for one in load_world_file(world, "home.yaml")}))
    (reading,) = pipeline.in_world(known.world).understand(text).readings
    assert answer(reading.unit.frame_name, reading.arguments, known) == expected


#: The robot was last told of the home on Saturday at 14:05; in this run it has seen the key alone.
TWO_RUNS = """
places:
  kitchen:
  hall:
things:
  table_1: {in: kitchen}
  key_1: {on: table_1}
  mug_1: {}
  bottle_1: {}
devices:
  lamp_1: {in: hall}
persons:
  bob:
  anna:
robots:
  robot: {in: hall}
"""
SATURDAY = datetime(2026, 11, 21, 14, 5)


@pytest.fixture(scope="module")
def later() -> World:
    of_file = load_world_file(TWO_RUNS, "home.yaml")
    told = (
        WorldObject("mug_1", relations=(Relation("on", "table_1"),)),
        WorldObject("bottle_1", relations=(Relation("held_by", "robot"),)),
        WorldObject("lamp_1", Sort.DEVICE, states=("on",)),
        WorldObject("anna", Sort.PERSON, relations=(Relation("in", "kitchen"),)),
    )
    change = Knowledge(of_file).plan(Update(told), 10.0, SATURDAY.timestamp())
    assert isinstance(change, Change)
    return snapshot("2", Knowledge(of_file, change.learned).objects)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Where is the mug?", "I last saw the mug yesterday at 14:05, on the table in the kitchen."),
        ("Where is Anna?", "I last saw Anna yesterday at 14:05, in the kitchen."),
        ("Where is Bob?", "I have not seen Bob yet."),
        ("Where is the key?", "The key is on the table in the kitchen."),
        ("Is the lamp on?", "When I last knew, yesterday at 14:05, the lamp was on."),
        (
            "What is on the table?",
            "On the table there is a key. As of yesterday at 14:05: On the table there are a key and a mug.",
        ),
        (
            "Who is in the kitchen?",
            "I know of nobody in the kitchen. As of yesterday at 14:05: Anna is in the kitchen.",
        ),
        ("What do you have in your hand?", "I hold nothing. As of yesterday at 14:05: I hold a bottle."),
    ],
)
def test_what_an_earlier_run_knew_is_told_with_when(text: str, expected: str, pipeline: Pipeline, later: World) -> None:
    assert answered(text, pipeline, RobotKnowledge(later, now=datetime(2026, 11, 22, 9, 30))) == expected


@pytest.mark.parametrize(
    ("now", "expected"),
    [
        (datetime(2026, 11, 21, 23, 59), "today at 14:05"),
        (datetime(2026, 11, 22, 0, 1), "yesterday at 14:05"),
        (datetime(2026, 11, 25, 9, 0), "on Saturday at 14:05"),
        (datetime(2026, 12, 24, 9, 0), "on 21 November at 14:05"),
        (datetime(2027, 1, 1, 9, 0), "on 21 November 2026 at 14:05"),
    ],
)
def test_a_time_is_told_as_people_tell_it(now: datetime, expected: str) -> None:
    assert day_and_time(SATURDAY, now) == expected


def test_what_was_given_away_is_known_to_be_gone(pipeline: Pipeline, home: World) -> None:
    gone = replace(home.by_id["bottle_1"], relations=(Relation("held_by", "anna"),))
    world = snapshot("2", {**home.by_id, "bottle_1": gone})
    words = "the bottle on the table"
    there = TypedArgument("theme", words, Source.INFERRED, head="it", lemma="it", referents=("bottle_1",))
    known = RobotKnowledge(world)
    assert answer("question_of_being_there", [there], known) == (
        "No, as far as I know: the bottle is held by Anna in the kitchen."
    )
    assert answer("question_of_place", [there], known) == "The bottle is held by Anna in the kitchen."
