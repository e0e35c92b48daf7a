"""Questions about deeds, from the sentence to the answer, beside a log of deeds."""

from dataclasses import replace
from datetime import datetime, timedelta
from typing import Optional

import pytest

from offline_pipeline.knowledge import load_knowledge, pretend_servers, shipped_domains
from offline_pipeline.pipeline import Pipeline
from question_answering.answers import answer
from question_answering.deed_log import DeedLog, PlanKinds, PlannedNode, TriedOnce
from question_answering.robot_knowledge import RobotKnowledge, served_frames
from typed_arguments import FilledFrame
from world_model.world import World, snapshot
from world_model.world_file import load_world_file

NOW = datetime(2012, 5, 14, 20, 0)
DO, SEQUENCE, CONDITION, PARALLEL, REPEAT, WAIT = range(6)
KINDS = PlanKinds(DO, CONDITION, PARALLEL, REPEAT, WAIT)
HOME = """
places:
  kitchen:
  hall:
doors:
  kitchen_door: {to: kitchen, states: [open]}
  hall_door: {to: hall, states: [open]}
things:
  table_1: {in: kitchen}
  mug_1: {on: table_1}
devices:
  lamp_1: {in: hall}
  lamp_2: {in: kitchen}
robots:
  robot: {x: 1, y: 1}
"""


class Robot:
    """A robot that obeys at once, and remembers."""

    def __init__(self) -> None:
        knowledge = load_knowledge([shipped_domains()])
        pretend_servers(knowledge.graph)
        self.pipeline = Pipeline(knowledge)
        self.frames = dict(knowledge.graph.frames)
        self.world: World = snapshot("1", {one.id: one for one in load_world_file(HOME, "home.yaml")})
        self.log = DeedLog(KINDS)
        self.known = RobotKnowledge(world=self.world, now=NOW)
        self.count = 0

    def filled(self, text: str) -> FilledFrame:
        (reading,) = self.pipeline.understand(text).readings
        return FilledFrame(reading.unit.frame_name, reading.arguments, "server")

    def did(self, text: str, *, reason: str = "", before: timedelta = timedelta(hours=1)) -> None:
        self.count += 1
        once = TriedOnce(self.filled(text), not reason, reason, NOW - before, 12.0)
        self.log.add_tried(f"c{self.count}", text, 0, once)

    def does(self, *texts: str) -> None:
        nodes = [PlannedNode(SEQUENCE, tuple(range(1, len(texts) + 1)))]
        nodes += [PlannedNode(DO, (), number, text, (self.filled(text),)) for number, text in enumerate(texts, 1)]
        self.log.add_plan("now", nodes)
        self.known = replace(self.known, doing=" and ".join(texts))

    def hears(self, text: str) -> Optional[str]:
        readings = self.pipeline.understand(text).readings
        if len(readings) != 1:
            return None
        running, planned = self.log.running_and_planned()
        served = served_frames(self.frames, frozenset(["closing", "bringing", "switching_device"]))
        known = replace(
            self.known,
            tried=self.log.clauses,
            running=running,
            planned=planned,
            frames=self.frames,
            served=served,
        )
        return answer(readings[0].unit.frame_name, readings[0].arguments, known)


@pytest.fixture
def robot() -> Robot:
    return Robot()


def test_what_was_done_is_known_with_its_time_and_its_elements(robot: Robot) -> None:
    robot.did("Close the kitchen door.", before=timedelta(hours=2))
    robot.did("Switch on the lamp in the hall.")
    assert robot.hears("Did you close the kitchen door?") == (
        'Yes: I carried out "Close the kitchen door." today at 18:00.'
    )
    assert robot.hears("When did you close the kitchen door?") == "Today at 18:00."
    assert robot.hears("Who closed the kitchen door?") == "I did, today at 18:00."
    assert robot.hears("Why did you close the kitchen door?") == 'Because you asked me to: "Close the kitchen door.".'
    assert robot.hears("Which lamps did you switch on?") == "The lamp in the hall."
    assert robot.hears("What did you switch on?") == "The lamp in the hall."
    assert robot.hears("How long did you close the kitchen door?") == "It took me 12 seconds, today at 18:00."
    assert robot.hears("Did you close a door?") == 'Yes: I carried out "Close the kitchen door." today at 18:00.'


def test_what_was_not_done_is_not_invented(robot: Robot) -> None:
    robot.did("Close the kitchen door.")
    assert robot.hears("Did you close the hall door?") == "No, as far as I remember."
    assert robot.hears("Did you open the kitchen door?") == "No, as far as I remember."
    assert robot.hears("Which lamps did you switch on?") == "I did not do that, as far as I remember."
    assert robot.hears("How often have you closed the hall door?") == "Never, as far as I remember."
    assert robot.hears("Why did you not close the hall door?") == "Nobody has asked me to, as far as I remember."
    assert robot.hears("Who switched on the lamp in the hall?") == "I did not do that, and do not know who did."
    assert robot.hears("Did Anna close the kitchen door?") == "I do not know: I only remember what I did myself."


def test_what_failed_is_told_with_its_reason(robot: Robot) -> None:
    robot.did("Close the kitchen door.", reason="the door is stuck")
    told = 'No. I tried "Close the kitchen door." today at 19:00: the door is stuck.'
    assert robot.hears("Did you close the kitchen door?") == told
    assert robot.hears("Why did you not close the kitchen door?") == told


def test_how_often_counts_within_the_time_that_is_named(robot: Robot) -> None:
    robot.did("Close the kitchen door.", before=timedelta(days=1))
    robot.did("Close the kitchen door.")
    assert robot.hears("How often have you closed the kitchen door?") == "Twice."
    assert robot.hears("How often have you closed the kitchen door today?") == "Once."
    assert robot.hears("Have you ever closed the kitchen door?") == (
        'Yes: I carried out "Close the kitchen door." today at 19:00.'
    )


def test_what_runs_and_what_comes_later_are_kept_apart(robot: Robot) -> None:
    robot.does("Close the kitchen door", "Switch on the lamp in the hall")
    assert robot.hears("Are you closing the kitchen door?") == (
        'Yes, I am carrying out "Close the kitchen door and Switch on the lamp in the hall".'
    )
    assert robot.hears("Are you switching on the lamp in the hall?") == (
        'No, I am carrying out "Close the kitchen door and Switch on the lamp in the hall".'
    )
    assert robot.hears("Are you going to switch on the lamp in the hall?") == (
        'Yes, as a part of "Close the kitchen door and Switch on the lamp in the hall".'
    )
    robot.log.end("now")
    robot.known = replace(robot.known, doing="")
    assert robot.hears("Are you closing the kitchen door?") == "No, I am doing nothing at the moment."


def test_what_can_be_done_is_what_is_registered(robot: Robot) -> None:
    assert robot.hears("Are you able to close doors?") == "Yes, I can close doors."
    assert robot.hears("Are you able to vacuum?") == "No: nothing that runs here can do that."
    assert robot.hears("What can you carry?") == (
        "Yes, I can carry things, but I cannot tell which are too heavy or too large."
    )


def test_a_sequence_is_the_frame_that_it_stands_for(robot: Robot) -> None:
    """Bringing is done by grasping, going and handing over, where no server brings."""
    parts = next(parts for parts in robot.frames["bringing"].children if len(parts) > 1)
    given = robot.filled("Bring the mug to the hall.")
    for number, part in enumerate(parts):
        once = TriedOnce(FilledFrame(part.name, given.arguments, "server"), True, "", NOW, 1.0)
        robot.log.add_tried("c", "Bring the mug to the hall.", 0, once)
        is_done = robot.hears("Did you bring the mug to the hall?")
        assert is_done is not None and is_done.startswith("Yes") == (number == len(parts) - 1)


def test_a_wait_keeps_what_comes_behind_it_from_running() -> None:
    nodes = [
        PlannedNode(SEQUENCE, (1, 2, 3)),
        PlannedNode(DO, (), 1, "go"),
        PlannedNode(WAIT, (), 2),
        PlannedNode(DO, (), 3, "say hello"),
    ]
    log = DeedLog(KINDS)
    log.add_plan("c", nodes)
    assert [[node.label for node in part] for part in log.running_and_planned()] == [["go"], ["say hello"]]
    log.add_tried("c", "", 1, TriedOnce(FilledFrame("going"), True, "", NOW, 1.0))
    assert [[node.label for node in part] for part in log.running_and_planned()] == [[], ["say hello"]]


def test_what_runs_beside_each_other_runs() -> None:
    nodes = [PlannedNode(PARALLEL, (1, 2)), PlannedNode(DO, (), 1, "go"), PlannedNode(DO, (), 2, "sing")]
    log = DeedLog(KINDS, most=1)
    log.add_plan("c", nodes)
    assert [node.label for node in log.running_and_planned()[0]] == ["go", "sing"]
    for number in (0, 1):
        log.add_tried("other", "", number, TriedOnce(FilledFrame("going"), True, "", NOW, 1.0))
    assert [clause.number for clause in log.clauses] == [1]


def test_the_past_is_asked_about_in_other_words(robot: Robot) -> None:
    robot.did("Go to the hall.", before=timedelta(days=1))
    robot.did("Go to the hall.", before=timedelta(hours=3))
    robot.did("Close the kitchen door.", before=timedelta(hours=2))
    assert robot.hears("How many times have you been to the hall?") == "Twice."
    assert robot.hears("Have you been to the kitchen?") == "No, as far as I remember."
    assert robot.hears("Which rooms have you been to?") == "To the hall."
    assert robot.hears("Did you go to the hall yesterday?") == (
        'Yes: I carried out "Go to the hall." yesterday at 20:00.'
    )
    assert robot.hears("Did you close the kitchen door yesterday?") == "No, as far as I remember."
    assert robot.hears("When was the kitchen door closed?") == "Today at 18:00."
    assert robot.hears("Was the kitchen door closed by you?") == (
        'Yes: I carried out "Close the kitchen door." today at 18:00.'
    )
    told = "It took me 12 seconds, today at 18:00."
    assert robot.hears("How long did it take you to close the kitchen door?") == told
    assert robot.hears("How long did you need to close the kitchen door?") == told


def test_knowing_how_is_an_ability(robot: Robot) -> None:
    assert robot.hears("Do you know how to close doors?") == "Yes, I can close doors."
    assert robot.hears("Do you know how to vacuum?") == "No: nothing that runs here can do that."
