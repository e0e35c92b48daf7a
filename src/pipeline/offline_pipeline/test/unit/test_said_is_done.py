"""What was said is what is done: times, amounts, slips and answers, from the text to the reply."""

import pytest

from offline_pipeline.pipeline import Pipeline, Understanding


def outcome(said: Understanding) -> str:
    """Return the plan or the frames of what would be done, with all their elements; else what the reply does."""
    if said.reply.outcome != "DONE":
        return {"NEEDS_INFORMATION": "asked", "REFUSED": "refused"}[said.reply.outcome]
    frames = [
        f"{one.unit.frame_name}({', '.join(f'{value.name}={value.text}' for value in one.arguments)})"
        for one in said.readings
    ]
    at = "AT " if "(AT(" in said.reply.sentence else ""
    return at + " + ".join(frames)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Close the window at 20:15.", "AT closing(container_portal=the window)"),
        ("Close the window at 6:30 pm.", "AT closing(container_portal=the window)"),
        ("Close the window at six thirty.", "AT closing(container_portal=the window)"),
        ("Close the window at 6 p.m.", "AT closing(container_portal=the window)"),
        ("Close the window at 9am", "AT closing(container_portal=the window)"),
        ("Close the window at 18 30", "AT closing(container_portal=the window)"),
        ("Mop the hallway at 9:15.", "AT wiping(object=the hallway)"),
        ("Return to the charger at 8am", "AT navigating_to_location(goal=the charger)"),
        ("Go to the office at seven forty-five.", "AT navigating_to_location(goal=the office)"),
        ("Close the window at six oh five.", "AT closing(container_portal=the window)"),
        (
            "Bring the mug to Anna in the kitchen at 18:45",
            "AT bringing(theme=the mug, beneficiary=Anna in the kitchen)",
        ),
        (
            "Put the mug on the table near the lamp at 7:45 am.",
            "AT placing(theme=the mug, goal=the table near the lamp)",
        ),
        ("Meet Anna at the door at 7:15 pm", "AT meeting(person=Anna, place=the door)"),
        ("Close the window at 20:15 and open the door at 20:30.", "asked"),
        ("Is the door open at 18:30?", "refused"),
        ("Tell Bob that dinner is ready at 18:30.", "telling(message=dinner is ready at 18:30, addressee=Bob)"),
        ("Bring me the 18:30 report.", "bringing(theme=the 18:30 report, beneficiary=me)"),
    ],
)
def test_a_time_of_the_clock_is_no_part_of_a_thing(pipeline: Pipeline, text: str, expected: str) -> None:
    assert outcome(pipeline.understand(text)) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Turn left 30º.", "turning(direction=left, angle=30, angle_unit=degrees)"),
        ("turn 60˚ left", "turning(direction=left, angle=60, angle_unit=degrees)"),
        ("Turn left ３０ degrees.", "turning(direction=left, angle=30, angle_unit=degrees)"),
        ("turn left 1.5rads", "turning(direction=left, angle=1.5, angle_unit=rads)"),
        ("Wait for 30sec.", "waiting(duration=30 sec)"),
        ("Wait for 3mins.", "waiting(duration=3 mins)"),
        ("Pause for 20sec.", "waiting(duration=20 sec)"),
        ("Move forward 10cms.", "moving(direction=forward, distance=10, distance_unit=cms)"),
        ("Move forward 2mtrs.", "moving(direction=forward, distance=2, distance_unit=mtrs)"),
        ("Move forward 1,5 m.", "refused"),
        ("turn left 30xyz", "refused"),
        ("wait for 30xyz", "refused"),
        ("wait for 5", "refused"),
        ("go to room 12b", "navigating_to_location(goal=room 12b)"),
        ("turn left and right 20 degrees each", "refused"),
        ("move forward and backward 2 meters", "asked"),
        ("spin around once", "asked"),
        ("rotate clockwise once", "asked"),
        ("turn left twice", "turning(direction=left, angle=90, angle_unit=degrees)"),
        ("turn left 2 turn left two", "refused"),
        ("Step 1: go to the kitchen. Step 2: take the mug.", "refused"),
        (
            "Move forward one meter, no wait, two meters.",
            "moving(direction=forward, distance=2, distance_unit=meters)",
        ),
    ],
)
def test_an_amount_is_the_amount_or_nothing_is_done(pipeline: Pipeline, text: str, expected: str) -> None:
    assert outcome(pipeline.understand(text)) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("go to the kit kitchen", "refused"),
        ("take the tea teapot", "refused"),
        ("bring mee the mug", "refused"),
        ("follow mee", "refused"),
        ("give himm the mug", "refused"),
        ("turn right n go to the hall", "refused"),
        ("move into the cellar first n go into the attic", "refused"),
        ("Stack the tin on the crate and put them in the tray.", "asked"),
        ("Move in reverse.", "refused"),
        ("Drive in reverse 1 meter.", "refused"),
        ("Go in reverse.", "refused"),
        ("go in kitchen", "navigating_to_location(goal=kitchen)"),
        ("bring ali the mug", "bringing(theme=the mug, beneficiary=ali)"),
    ],
)
def test_a_slip_is_no_thing(pipeline: Pipeline, text: str, expected: str) -> None:
    assert outcome(pipeline.understand(text)) == expected


ASKING = "Turn off the light in the hall."


@pytest.mark.parametrize("answer", ["yes yes", "yep please", "Yes, sir.", "y", "uh huh", "that is what I want", "👍🏽"])
def test_a_yes_answers(pipeline: Pipeline, answer: str) -> None:
    question = pipeline.understand(ASKING)
    assert question.reply.code == "CONFIRM"
    assert pipeline.understand(answer, question.context).reply.outcome == "DONE"
    assert pipeline.understand(answer).reply.sentence == "I have no open question."


@pytest.mark.parametrize("answer", ["nope thanks", "no sir", "n", "not that", "👎"])
def test_a_no_answers(pipeline: Pipeline, answer: str) -> None:
    question = pipeline.understand(ASKING)
    assert pipeline.understand(answer, question.context).reply.code == "DECLINED"
    assert pipeline.understand(answer).reply.outcome == "REFUSED"


@pytest.mark.parametrize("text", ["Thank you.", "the blue fnord", "What time is it?"])
def test_what_is_no_answer_leaves_the_question_open(pipeline: Pipeline, text: str) -> None:
    question = pipeline.understand(ASKING)
    beside = pipeline.understand(text, question.context)
    assert beside.reply.outcome == "DONE" or beside.reply.sentence.endswith(f"I still ask: {question.reply.sentence}")
    assert pipeline.understand("yes", beside.context).reply.outcome == "DONE"


def test_a_new_command_takes_the_place_of_a_question(pipeline: Pipeline) -> None:
    question = pipeline.understand(ASKING)
    after = pipeline.understand("Go to the kitchen.", question.context)
    assert after.reply.outcome == "DONE"
    assert pipeline.understand("yes", after.context).reply.outcome == "REFUSED"


def test_a_yes_names_no_place(pipeline: Pipeline) -> None:
    question = pipeline.understand("go to the")
    for answer in ("that is what I want", "uh huh", "yes"):
        after = pipeline.understand(answer, question.context)
        assert after.reply.sentence.endswith(f"I still ask: {question.reply.sentence}")
    assert pipeline.understand("the office", question.context).reply.outcome == "DONE"


def test_right_is_a_direction_where_one_is_asked_for(pipeline: Pipeline) -> None:
    question = pipeline.understand("spin")
    assert outcome(pipeline.understand("right", question.context)).startswith("turning(")
