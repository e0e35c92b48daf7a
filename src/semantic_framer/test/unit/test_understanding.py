"""What is understood of real sentences, with the shipped models and the frames of the domains."""

import itertools
from typing import Any, Dict, List, Tuple

import pytest

from semantic_framer.framer import Alternatives, LeftOverWords, Policy, Question, Refusal, Understood, read


def frames_of(outcome: Any) -> List[Tuple[str, Dict[str, str]]]:
    """Name and arguments of the best reading of each clause."""
    assert isinstance(outcome, Understood), outcome
    return [
        (readings[0].unit.frame_name, {value.name: value.text for value in readings[0].arguments})
        for readings in outcome.clauses
    ]


@pytest.mark.parametrize(
    "text, frame, arguments",
    [
        ("Turn left 120 degrees.", "turning", {"direction": "left", "angle": "120", "angle_unit": "degrees"}),
        ("Turn right 2 radians.", "turning", {"direction": "right", "angle": "2", "angle_unit": "radians"}),
        ("turn left", "turning", {"direction": "left", "angle": "90", "angle_unit": "degrees"}),
        ("turn left one eighty", "turning", {"angle": "180", "angle_unit": "degrees"}),
        ("rotate ninety degrees to the left", "turning", {"direction": "left", "angle": "90"}),
        ("Move forward 3 feet.", "moving", {"direction": "forward", "distance": "3", "distance_unit": "feet"}),
        ("move backwards one metre", "moving", {"direction": "backwards", "distance": "1", "distance_unit": "metre"}),
        ("back up two feet", "moving_backward", {"distance": "2", "distance_unit": "feet"}),
        ("move forward half a metre", "moving", {"distance": "0.5", "distance_unit": "metre"}),
        ("move forward a couple of metres", "moving", {"distance": "2", "distance_unit": "metres"}),
        ("move forward 5 feet 6 inches", "moving", {"distance": "5.5", "distance_unit": "feet"}),
        ("move forward five foot six", "moving", {"distance": "5.5", "distance_unit": "foot"}),
        ("move two metres fifty forward", "moving", {"distance": "2.5", "distance_unit": "metres"}),
        ("Turn left 1e400 degrees.", "turning", {"angle": "1e400"}),
        ("Go to the office.", "navigating_to_location", {"goal": "the office"}),
        ("Go to Roger's office.", "navigating_to_location", {"goal": "Roger's office"}),
        ("Come to the fridge.", "arriving", {"goal": "the fridge"}),
        ("Give me 5.", "high_fiving", {"hand": "5"}),
        ("Give me the mug.", "giving", {"theme": "the mug", "recipient": "me"}),
        ("High five!", "high_fiving", {}),
        ("Give me a hug.", "hugging", {"act": "hug"}),
        ("Ping.", "pinging", {}),
        ("Follow me.", "following", {"cotheme": "me"}),
        ("Put the mug on the table.", "placing", {"theme": "the mug", "goal": "the table"}),
        ("bring the mug to the table", "bringing", {"theme": "the mug", "goal": "the table"}),
        ("bring the mug on the table", "bringing", {"theme": "the mug on the table", "goal": ""}),
        ("grab the red mug on the kitchen table", "taking", {"theme": "the red mug on the kitchen table"}),
        ("grab the red mug from the kitchen table", "taking", {"theme": "the red mug", "source": "the kitchen table"}),
        ("carry the box near the window", "bringing", {"theme": "the box", "goal": "the window"}),
        ("look for the remote in the living room", "locating", {"ground": "the living room"}),
        ("follow the person in front of you", "following", {"cotheme": "the person in front of you"}),
        ("empty the trash can", "emptying", {"object": "the trash can"}),
        ("let go of the rope", "ungrasping", {"theme": "the rope"}),
        ("give Bob a low five", "low_fiving", {"partner": "Bob"}),
        ("take the box", "taking", {"theme": "the box"}),
        ("take the box to the kitchen", "bringing", {"theme": "the box", "goal": "the kitchen"}),
        ("come with me", "following", {"cotheme": "me"}),
        ("come with me to the kitchen", "following", {"cotheme": "me", "goal": "the kitchen"}),
        ("go straight ahead two feet", "moving", {"direction": "straight", "distance": "2"}),
        ("take a picture of the door", "photographing", {"represented": "the door"}),
        ("take the picture off the wall", "taking", {"theme": "the picture", "source": "the wall"}),
        ("leave the room", "departing", {"source": "the room"}),
        ("leave the box on the table", "ungrasping", {"theme": "the box", "goal": "the table"}),
        ("go through the doorway to your left", "moving_along_path", {"path": "the doorway to your left"}),
        ("continue down the hallway", "moving_along_path", {"path": "the hallway"}),
        ("go down the hallway", "moving_along_path", {"path": "the hallway"}),
        ("walk along the corridor", "moving_along_path", {"path": "the corridor"}),
        ("move forward through the hall", "moving_along_path", {"path": "the hall", "direction": "forward"}),
        ("go through the door to the kitchen", "navigating_to_location", {"path": "the door", "goal": "the kitchen"}),
        ("pick up the box", "taking", {"theme": "the box"}),
        ("pick the ball up", "taking", {"theme": "the ball"}),
        ("switch the radio off", "switching_device", {"device": "the radio", "operational_state": "off"}),
        ("could you please turn left", "turning", {"direction": "left"}),
        ("I want you to follow me", "following", {"cotheme": "me"}),
        ("would you mind closing the door", "closing", {"container_portal": "the door"}),
        ("I need the mug.", "bringing", {"theme": "the mug"}),
        ("uh okay turn left", "turning", {"direction": "left"}),
    ],
)
def test_one_frame(understand: Any, text: str, frame: str, arguments: Dict[str, str]) -> None:
    ((name, filled),) = frames_of(understand(text)[0])
    assert name == frame
    assert {key: filled.get(key, "") for key in arguments} == arguments


def test_words_that_a_unit_lists_exclude_units_that_list_fewer(understand: Any) -> None:
    outcome, _ = understand("Give me a low five.")
    assert [reading.unit.frame_name for reading in outcome.clauses[0]] == ["low_fiving"]


def test_statement_about_a_place_names_it_too(understand: Any) -> None:
    outcome, _ = understand("This is the office.")
    (naming,) = [reading for reading in outcome.clauses[0] if reading.unit.frame_name == "naming_location"]
    assert naming.argument("location").text == "the office"


def test_clauses_in_order(understand: Any) -> None:
    found = frames_of(understand("Go to the kitchen, then turn left and say hello")[0])
    assert [name for name, _ in found] == ["navigating_to_location", "turning", "saying"]


@pytest.mark.parametrize(
    "text, expected",
    [
        (
            "Go to the office and then to the kitchen.",
            [("navigating_to_location", {"goal": "the office"}), ("navigating_to_location", {"goal": "the kitchen"})],
        ),
        (
            "take the mug to the kitchen and then to the office",
            [
                ("bringing", {"theme": "the mug", "goal": "the kitchen"}),
                ("bringing", {"theme": "the mug", "goal": "the office"}),
            ],
        ),
        ("turn right and then left", [("turning", {"direction": "right"}), ("turning", {"direction": "left"})]),
        ("turn left then right", [("turning", {"direction": "left"}), ("turning", {"direction": "right"})]),
        (
            "go to the kitchen to get the mug",
            [("navigating_to_location", {"goal": "the kitchen"}), ("taking", {"theme": "the mug"})],
        ),
        ("go get the mug", [("taking", {"theme": "the mug"})]),
        ("turn right to face the desk", [("facing", {"goal": "the desk", "direction": "right"})]),
        ("Turn to face the desk.", [("facing", {"goal": "the desk"})]),
        (
            "you are in the bedroom and the bed is between two lamps",
            [
                ("being_located", {"theme": "you", "location": "the bedroom"}),
                ("being_located", {"theme": "the bed", "location": "two lamps"}),
            ],
        ),
        ("check whether the tv is on the table", [("inspecting", {"desired_state": "is on the table"})]),
        ("check if the lights are off", [("inspecting", {"ground": "the lights", "desired_state": "are off"})]),
        ("find out whether the door is closed", [("inspecting", {"ground": "the door", "desired_state": "is closed"})]),
        (
            "pick up the cup off the foot of the bed",
            [("taking", {"theme": "the cup", "source": "the foot of the bed"})],
        ),
        ("pick up the cup from behind the sink", [("taking", {"theme": "the cup", "source": "the sink"})]),
        ("bring the mug and not the plate", [("bringing", {"theme": "the mug"})]),
    ],
)
def test_verbs_that_share_words(understand: Any, text: str, expected: List[Tuple[str, Dict[str, str]]]) -> None:
    outcome, _ = understand(text)
    found = frames_of(outcome)
    assert [name for name, _ in found] == [name for name, _ in expected]
    for (_, arguments), (_, wanted) in zip(found, expected):
        assert {name: arguments.get(name) for name in wanted} == wanted


@pytest.mark.parametrize(
    "text, code",
    [
        ("don't go to the kitchen to get the mug", "NEGATED"),
        ("don't go to the office and then to the kitchen", "NEGATED"),
        ("turn right then not left", "NEGATED"),
        # What the cloth is for is the speaker's task.
        ("bring me a cloth to clean the table", "LEFT_OVER_WORDS"),
    ],
)
def test_verbs_that_share_words_and_are_not_to_be_done(understand: Any, text: str, code: str) -> None:
    outcome, _ = understand(text, policy=Policy(left_over_words=LeftOverWords.STRICT))
    assert isinstance(outcome, Refusal) and outcome.code == code


def test_it_is_what_was_spoken_of_before(understand: Any) -> None:
    (_, taken), (_, placed) = frames_of(understand("take the box and put it on the table")[0])
    assert (taken["theme"], placed["theme"], placed["goal"]) == ("the box", "the box", "the table")


def test_it_and_there_reach_back_to_the_command_before(understand: Any) -> None:
    _, context = understand("Bring the mug to the kitchen.")
    outcome, _ = understand("Take it.", context)
    assert frames_of(outcome)[0][1]["theme"] == "the mug"


def test_pronoun_is_not_told_apart_by_its_place(understand: Any) -> None:
    _, (frame, brought) = frames_of(understand("take the mug and bring it in the kitchen")[0])
    assert (frame, brought["theme"], brought["goal"]) == ("bringing", "the mug", "the kitchen")


def test_if_that_a_unit_asks_for_is_no_condition(understand: Any) -> None:
    outcome, _ = understand("check if the oven is hot")
    assert isinstance(outcome, Understood)
    filled = {value.name: value.text for value in outcome.clauses[0][0].arguments}
    assert filled == {"ground": "the oven", "desired_state": "is hot"}
    assert str(understand("check the oven if the door is open")[0].plan) == "IF(the door is open, check the oven)"


def test_it_without_anything_before_is_asked_for(understand: Any) -> None:
    outcome, _ = understand("Take it.")
    assert isinstance(outcome, Question) and outcome.code == "AMBIGUOUS"


def test_list_is_one_argument_with_items(understand: Any) -> None:
    outcome, _ = understand("Bring me the mug and the plate.")
    value = outcome.clauses[0][0].argument("theme")
    assert (value.conjunction, tuple(member.text for member in value.members)) == ("and", ("the mug", "the plate"))


def test_alternatives_are_asked_for_where_the_policy_says_so(understand: Any) -> None:
    outcome, _ = understand("Take the mug or the plate.", policy=Policy(alternatives=Alternatives.ASK))
    assert isinstance(outcome, Question) and "the mug or the plate" in outcome.sentence


def test_typed_value_stands_beside_the_argument(understand: Any) -> None:
    value = understand("Move forward 3 feet.")[0].clauses[0][0].argument("distance")
    assert (value.text, value.measure.amount, value.measure.unit, value.measure.kind) == ("3", 3.0, "foot", "length")
    assert value.si == pytest.approx(0.9144)


def test_possessor_is_known(understand: Any) -> None:
    value = understand("Go to Roger's office.")[0].clauses[0][0].argument("goal")
    assert (value.possessor.text, value.head, value.lemma) == ("Roger", "office", "office")


@pytest.mark.parametrize(
    "text, code",
    [
        ("Don't turn left.", "NEGATED"),
        ("never go to the kitchen", "NEGATED"),
        ("I don't want you to follow me", "NEGATED"),
        ("go to the kitchen later", "CONDITION"),
        ("in the evening go to the kitchen", "CONDITION"),
        ("go in the evening", "CONDITION"),
        ("next week go to the kitchen", "CONDITION"),
        ("turn left five minutes from now", "CONDITION"),
        ("take no box", "NEGATED"),
        ("high five no one", "NEGATED"),
        ("take none of the boxes", "NEGATED"),
        ("Fly to the moon.", "UNKNOWN_VERB"),
        ("Colorless green ideas sleep furiously.", "UNKNOWN_VERB"),
        ("the office", "NO_VERB"),
        ("Ping sideways with the hammer.", "LEFT_OVER_WORDS"),
        ("move forward five foot thirteen", "LEFT_OVER_WORDS"),
        ("put it in the dishwasher sideways", "LEFT_OVER_WORDS"),
        ("turn left 5 feet 6 inches", "LEFT_OVER_WORDS"),
    ],
)
def test_refusals(understand: Any, text: str, code: str) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Refusal) and outcome.code == code and outcome.sentence


@pytest.mark.parametrize(
    "text, name, argument",
    [
        ("take the morning paper", "theme", "the morning paper"),
        ("go to the day room", "goal", "the day room"),
        ("take the second box", "theme", "the second box"),
        ("wait for an hour", "duration", "1 hour"),
        ("say good evening", "message", "good evening"),
        ("bring me breakfast", "theme", "breakfast"),
    ],
)
def test_words_of_time_that_say_what_or_how_long(understand: Any, text: str, name: str, argument: str) -> None:
    ((_, filled),) = frames_of(understand(text)[0])
    assert filled[name] == argument


def test_left_over_words_are_named_and_may_be_ignored(understand: Any) -> None:
    outcome, _ = understand("Ping sideways.")
    assert isinstance(outcome, Refusal) and outcome.left_over == ("sideways",)
    assert isinstance(understand("Ping sideways.", policy=Policy(left_over_words=LeftOverWords.IGNORE))[0], Understood)
    assert "sideways" in understand("Ping sideways.", policy=Policy(left_over_words=LeftOverWords.WARN))[0].warning


def test_question_is_answered_by_a_fragment(understand: Any) -> None:
    outcome, context = understand("Move forward.")
    assert isinstance(outcome, Question) and outcome.code == "MISSING_ELEMENT" and "three feet" in outcome.sentence
    answered, after = understand("two metres", context)
    assert frames_of(answered) == [("moving", {"direction": "forward", "distance": "2", "distance_unit": "metres"})]
    assert after.pending is None


@pytest.mark.parametrize("fragment, frame", [("three feet", "moving"), ("the office", "navigating_to_location")])
def test_move_asks_how_far_and_where_to(understand: Any, fragment: str, frame: str) -> None:
    outcome, context = understand("Move.")
    assert isinstance(outcome, Question) and outcome.code == "MISSING_ELEMENT"
    assert "How far should I move?" in outcome.sentence and "Where should I go?" in outcome.sentence
    assert [name for name, _ in frames_of(understand(fragment, context)[0])] == [frame]


def test_question_expires(understand: Any) -> None:
    _, context = understand("Move forward.", policy=Policy(question_timeout_s=30.0), now_s=0.0)
    assert isinstance(understand("two metres", context, now_s=31.0)[0], Refusal)


def test_question_is_forgotten_when_a_command_follows(understand: Any) -> None:
    _, context = understand("Move forward.")
    outcome, after = understand("Turn left.", context)
    assert frames_of(outcome)[0][0] == "turning" and after.pending is None


NEGATIONS = (
    "don't {}",
    "do not {}",
    "never {}",
    "please don't {}",
    "robot, do not {}",
    "you must not {}",
    "I don't want you to {}",
)
CONDITIONS = (
    "if the door is open, {}",
    "{} when I say so",
    "{} in five minutes",
    "{} later",
    "{} after lunch",
    "unless I say no, {}",
    "{} once Bob is here",
    "{} tomorrow",
    "tomorrow {}",
    "{} on Monday",
    "on Monday, {}",
    "{} in the evening",
    "in the evening {}",
    "{} at noon",
    "at five {}",
    "{} next week",
    "next week, {}",
    "later {}",
)
ACTIONS = (
    "turn left",
    "go to the kitchen",
    "move forward 2 metres",
    "follow me",
    "take the mug",
    "open the door",
    "put the box on the table",
    "bring me the book",
    "say hello",
    "close the window",
    "chop the onions",
    "clean the table",
    "pick up the ball",
    "come to the fridge",
    "rotate 90 degrees to the right",
)


@pytest.mark.parametrize(
    "text, plan",
    [
        ("turn left when I say so", "SEQUENCE(WAIT(I say so), turn left)"),
        ("move forward 2 metres in five minutes", "AT(in five minutes, move forward 2 metres)"),
        ("if you see Bob, go to the office", "IF(you see Bob, go to the office)"),
        ("do me a favour and turn left when I say so", "SEQUENCE(WAIT(I say so), turn left)"),
        ("say hello when Bob comes", "SEQUENCE(WAIT(Bob comes), say hello)"),
        ("say hello in five minutes", "AT(in five minutes, say hello)"),
        ("take a photo until you are at the gate", "UNTIL(you are at the gate, take a photo)"),
        ("turn left at five", "AT(at five, turn left)"),
        ("turn left at 5 pm", "AT(at 5 pm, turn left)"),
    ],
)
def test_condition_makes_a_tree(understand: Any, text: str, plan: str) -> None:
    assert str(understand(text)[0].plan) == plan


@pytest.mark.parametrize(
    "text",
    [
        "turn left tomorrow",
        "turn left on Monday",
        "turn left Monday morning",
        "bring the mug on Monday",
        "turn left every day",
        "high five tomorrow",
    ],
)
def test_a_day_without_a_time_is_asked_about(understand: Any, text: str) -> None:
    outcome = understand(text)[0]
    assert isinstance(outcome, Question)


def test_the_day_of_another_week_is_not_taken_for_the_next_one(understand: Any) -> None:
    outcome = understand("next Monday turn left")[0]
    assert isinstance(outcome, Refusal)
    assert outcome.left_over == ("next",)


@pytest.mark.parametrize(
    "text", ["see if the oven is hot when I say so", "look if the window is closed when I say so", "tell me when it is"]
)
def test_condition_beside_a_thing_to_find_out_is_not_dropped(understand: Any, text: str) -> None:
    outcome = understand(text)[0]
    assert not isinstance(outcome, Understood) or outcome.plan is not None


def test_nothing_negated_or_conditional_is_ever_done(understand: Any) -> None:
    said = [pattern.format(action) for pattern, action in itertools.product(NEGATIONS + CONDITIONS, ACTIONS)]
    assert len(said) >= 300
    outcomes = {text: understand(text)[0] for text in said}
    # With a condition or a time that is understood, there is a tree: nothing is done without it.
    reasons = {
        text: ("DONE" if outcome.plan is None else "CONDITION") if isinstance(outcome, Understood) else outcome.code
        for text, outcome in outcomes.items()
        if isinstance(outcome, Understood) or outcome.code != "MISSING_ELEMENT"
    }
    assert {
        text: code for text, code in reasons.items() if code not in ("NEGATED", "CONDITION", "LEFT_OVER_WORDS")
    } == {}


@pytest.mark.parametrize("text", ["Turn one eighty.", "Turn 180.", "turn five"])
def test_a_number_is_no_device(understand: Any, text: str) -> None:
    outcome = understand(text)[0]
    assert isinstance(outcome, Question) and "left or right" in outcome.sentence


def test_unit_whose_frame_is_missing_says_nothing_of_a_state(parser: Any, lexicon: Any, frames: Any) -> None:
    others = {name: frame for name, frame in frames.items() if name != "docking"}
    for text in ("Are you docked?", "If you are docked, say hello.", "Go to the cup that you saw."):
        read(parser.parse(text, lexicon.verbs), lexicon, others)
