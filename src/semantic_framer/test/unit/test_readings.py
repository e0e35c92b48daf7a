"""Readings that no speaker means are left out; verbs that stand for others are read as those."""

from typing import Any, Dict, List, Tuple

import pytest

from semantic_framer.framer import LeftOverWords, Policy, Refusal, Understood, read
from semantic_framer.units.lexicon import Lexicon


def meant(outcome: Any) -> List[Tuple[str, Dict[str, str]]]:
    assert isinstance(outcome, Understood), outcome
    return [
        (readings[0].unit.frame_name, {value.name: value.text for value in readings[0].arguments if value.positions})
        for readings in outcome.clauses
    ]


@pytest.mark.parametrize(
    "text, frame, arguments",
    [
        ("take a right", "turning", {"direction": "right"}),
        ("hang a left", "turning", {"direction": "left"}),
        ("make a left turn", "turning", {"direction": "left"}),
        ("do a 180", "turning_around", {}),
        ("do a u-turn", "turning_around", {}),
        ("make a u-turn", "turning_around", {}),
        ("take a look at the clock", "perceiving", {"phenomenon": "the clock"}),
        ("set the thermostat to 20", "switching_device", {"device": "the thermostat", "operational_state": "20"}),
        ("can I have the remote please", "bringing", {"theme": "the remote"}),
        ("I'd love a cup of coffee", "bringing", {"theme": "a cup of coffee"}),
        ("get over here", "arriving", {"goal": "here"}),
        ("go to 221", "navigating_to_location", {"goal": "221"}),
    ],
)
def test_only_reading(understand: Any, text: str, frame: str, arguments: Dict[str, str]) -> None:
    outcome, _ = understand(text)
    assert meant(outcome) == [(frame, arguments)]
    assert {reading.unit.frame_name for reading in outcome.clauses[0]} == {frame}


@pytest.mark.parametrize(
    "text, code",
    [
        ("set the vase to 20", "NO_READING"),
        ("take the second left", "LEFT_OVER_WORDS"),
        ("move a little bit closer to the table", "LEFT_OVER_WORDS"),
        ("are you tall", "QUESTION"),
        ("is the door heavy to open", "QUESTION"),
        ("what did the table cost", "QUESTION"),
        ("would you be happy", "QUESTION"),
        ("I like the mug", "REPORT"),
        ("I have the mug", "REPORT"),
        ("do the mug", "UNKNOWN_VERB"),
    ],
)
def test_refusals(understand: Any, text: str, code: str) -> None:
    outcome, _ = understand(text, policy=Policy(left_over_words=LeftOverWords.STRICT))
    assert isinstance(outcome, Refusal) and outcome.code == code


@pytest.mark.parametrize("text, hint", [("do the mug", ""), ("tke the mug", 'Do you mean "take"')])
def test_verb_of_english_is_taken_for_no_typo(understand: Any, text: str, hint: str) -> None:
    outcome, _ = understand(text)
    assert outcome.code == "UNKNOWN_VERB" and ("Do you mean" in outcome.sentence) == bool(hint)
    assert hint in outcome.sentence


@pytest.mark.parametrize("text", ["Don't turn left.", "do not turn left", "don't do a u-turn"])
def test_do_is_no_command(understand: Any, text: str) -> None:
    assert understand(text)[0].code == "NEGATED"


@pytest.mark.parametrize("text", ["here is the kitchen", "there is a lamp on the desk", "The door is open."])
def test_statement_is_no_question(understand: Any, text: str) -> None:
    assert isinstance(understand(text)[0], Understood)


def test_how_far_a_bit_is_is_stated(understand: Any) -> None:
    outcome, _ = understand("scoot back a little")
    ((frame, arguments),) = meant(outcome)
    assert (frame, arguments["direction"], arguments["distance"]) == ("moving", "back", "20")
    assert outcome.clauses[0][0].clause_text == "scoot back a little (20 centimetres)"


def test_how_far_a_step_is_is_stated(understand: Any) -> None:
    outcome, _ = understand("take three steps back")
    reading = outcome.clauses[0][0]
    assert reading.clause_text == "take three steps back (1.5 metres)"
    distance = reading.argument("distance")
    assert distance.si == pytest.approx(1.5) and distance.measure.is_assumed


@pytest.mark.parametrize("text", ["bring me a bit of cake", "bring me a little milk", "go a bit closer to the table"])
def test_a_bit_of_something_is_no_amount(understand: Any, text: str) -> None:
    outcome, _ = understand(text)
    clauses = outcome.clauses if isinstance(outcome, Understood) else ()
    assert not [one for readings in clauses for one in readings[0].arguments if one.measure is not None]


@pytest.mark.parametrize(
    "text, names",
    [
        ("clean the jacket", ["washing_clothes", "cleaning"]),
        ("open the box", ["opening_container", "opening"]),
    ],
)
def test_unit_that_lists_a_word_comes_before_one_that_takes_any(understand: Any, text: str, names: List[str]) -> None:
    outcome, _ = understand(text)
    (readings,) = outcome.clauses
    assert [reading.unit.frame_name for reading in readings] == names
    assert [reading.unlikely for reading in readings] == [0, 1]


@pytest.mark.parametrize(
    "text, names", [("give me a high five", ["high_fiving"]), ("give me a low five", ["low_fiving"])]
)
def test_indefinite_noun_that_a_unit_lists_is_no_thing(understand: Any, text: str, names: List[str]) -> None:
    (readings,) = understand(text)[0].clauses
    assert [reading.unit.frame_name for reading in readings] == names


@pytest.mark.parametrize(
    "text, names",
    [
        ("This is the office.", ["naming_location", "being_in_category"]),
        ("This is Roger's office.", ["naming_location", "being_in_category"]),
        ("This is an office.", ["being_in_category", "naming_location"]),
    ],
)
def test_indefinite_noun_is_hardly_a_name(understand: Any, text: str, names: List[str]) -> None:
    (readings,) = understand(text)[0].clauses
    assert [reading.unit.frame_name for reading in readings] == names


@pytest.mark.parametrize(
    "text, frame, arguments",
    [
        ("Turn the oven off.", "switching_device", {"device": "the oven", "operational_state": "off"}),
        ("Turn on the light.", "switching_device", {"device": "the light", "operational_state": "on"}),
        (
            "There is a lamp on the desk.",
            "being_located",
            {"theme": "a lamp", "location": "the desk", "place": "There"},
        ),
    ],
)
def test_reading_that_says_less_is_dropped(understand: Any, text: str, frame: str, arguments: Dict[str, str]) -> None:
    outcome, _ = understand(text)
    assert meant(outcome) == [(frame, arguments)]
    assert len([reading for reading in outcome.clauses[0] if reading.unit.frame_name == frame]) == 1


def test_order_does_not_depend_on_the_order_of_the_files(parser: Any, lexicon: Lexicon, frames: Any) -> None:
    backwards = Lexicon.of_units(reversed(lexicon.units))
    verbs = frozenset(verb.split()[0] for verb in lexicon.verbs)
    for text in ("Wash the shirts.", "Carry the bag next to the door.", "Grab the red bottle.", "Give me a hug."):
        tree = parser.parse(text, verbs)
        one, other = (meant(read(tree, units, frames)[0]) for units in (lexicon, backwards))
        assert one == other


def test_taking_is_only_taking(understand: Any) -> None:
    outcome, _ = understand("take the box")
    assert [reading.unit.frame_name for reading in outcome.clauses[0]] == ["taking"]


@pytest.mark.parametrize(
    "text, words",
    [
        ("Turn left 120 degrees.", ["Turn left 120 degrees"]),
        ("Go to the kitchen, then turn left and say hello.", ["Go to the kitchen", "turn left", "say hello"]),
        ("go to the office and then to the kitchen", ["go to the office", "go to the kitchen"]),
        ("Could you please take the mug and bring it to me?", ["take the mug", "bring it to me"]),
        ("uh turn left no right", ["turn right"]),
        ("go to the kitchen to get the mug", ["go to the kitchen", "get the mug"]),
        ("robot, go near the tv and switch it off please", ["go near the tv", "switch it off"]),
    ],
)
def test_words_of_each_clause(understand: Any, text: str, words: List[str]) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Understood), outcome
    assert [readings[0].clause_text for readings in outcome.clauses] == words


def test_clause_that_was_asked_about_keeps_its_words(understand: Any) -> None:
    _, context = understand("Go to the kitchen and move forward.")
    outcome, _ = understand("two feet", context)
    assert [readings[0].clause_text for readings in outcome.clauses] == ["Go to the kitchen", "move forward"]
