"""Amounts come out as they were said, or are asked about, or refused: never a part of what was said."""

from typing import Any, Dict

import pytest

from semantic_framer.framer import LeftOverWords, Policy, Question, Refusal, Understood, read
from semantic_framer.units.lexicon import Lexicon
from semantic_frames import load_frame

IGNORING = Policy(left_over_words=LeftOverWords.IGNORE)
WARNING = Policy(left_over_words=LeftOverWords.WARN)


def best(outcome: Any) -> Any:
    assert isinstance(outcome, Understood), outcome
    reading = outcome.clauses[0][0]
    return reading.unit.frame_name, {value.name: value.text for value in reading.arguments}


@pytest.mark.parametrize(
    "text, frame_name, arguments",
    [
        ("Turn left forty-five degrees.", "turning", {"angle": "45", "direction": "left"}),
        ("Move forward twenty-five centimetres.", "moving", {"distance": "25", "distance_unit": "centimetres"}),
        ("Turn left two hundred and twenty-five degrees.", "turning", {"angle": "225"}),
        ("Move forward 3/4 metre.", "moving", {"distance": "0.75"}),
        ("Move forward one and three quarters feet.", "moving", {"distance": "1.75"}),
        ("Move forward 3 1/2 feet.", "moving", {"distance": "3.5"}),
        ("Move forward ½ metre.", "moving", {"distance": "0.5"}),
        ("Move forward -two metres.", "moving", {"distance": "-2"}),
        ("Move forward negative two metres.", "moving", {"distance": "-2"}),
        ("Turn left one oh five degrees.", "turning", {"angle": "105"}),
        ("Make a quarter turn to the right.", "turning", {"direction": "right", "angle": "0.25", "angle_unit": "turn"}),
        ("make a 30-degree turn to the left", "turning", {"direction": "left", "angle": "30"}),
        ("turn to the right fifteen degrees", "turning", {"direction": "right", "angle": "15"}),
        ("Turn around.", "turning_around", {"direction": "around", "angle": "180", "angle_unit": "degrees"}),
        ("Turn around 90 degrees.", "turning_around", {"angle": "90", "angle_unit": "degrees"}),
        ("turn around to the left", "turning_around", {"direction": "left", "angle": "180"}),
        ("spin two and one fifth turns clockwise", "turning", {"direction": "clockwise", "angle": "2.2"}),
        ("wait two and a half minutes", "waiting", {"duration": "2.5 minutes"}),
    ],
)
@pytest.mark.parametrize("policy", [Policy(), IGNORING], ids=["strict", "ignore"])
def test_what_can_be_read_plainly_is_read(
    understand: Any, text: str, frame_name: str, arguments: Dict[str, str], policy: Policy
) -> None:
    outcome, _ = understand(text, policy=policy)
    name, found = best(outcome)
    assert name == frame_name
    assert {key: found.get(key) for key in arguments} == arguments


@pytest.mark.parametrize("policy", [Policy(), WARNING, IGNORING], ids=["strict", "warn", "ignore"])
@pytest.mark.parametrize(
    "text",
    [
        "Move forward not two metres.",
        "Move forward five five metres.",
        "Move forward two meters minus one.",
        "Move forward 1,5 metres.",
        "Move forward 1 000 metres.",
        "Move forward - two metres.",
        "Move forward less than two metres.",
        "Turn left e5 degrees.",
        "Turn left 1e5e5 degrees.",
        "Turn left umpteen degrees.",
        "Turn left 20%.",
        "Turn left two and a half.",
        "make a half left turn",
        "take one left turn",
        "turn right five inches",
        "move two metres or ten to fifteen",
        "move forward a metre or two",
        "move forward two metres, three metres",
        "turn four point six eight radians to three left",
        "turn to the left anything but one point six one radians",
    ],
)
def test_half_of_what_was_said_is_never_done(understand: Any, text: str, policy: Policy) -> None:
    outcome, _ = understand(text, policy=policy)
    assert isinstance(outcome, (Refusal, Question)), outcome


@pytest.mark.parametrize("policy", [Policy(), IGNORING], ids=["strict", "ignore"])
@pytest.mark.parametrize(
    "text, answer, arguments",
    [
        ("Turn left ten to fifteen degrees.", "fifteen degrees", {"direction": "left", "angle": "15"}),
        ("Move forward 2 or 3 metres.", "2", {"distance": "2", "distance_unit": "metres"}),
        ("Move forward between two and three metres.", "the second one", {"distance": "3"}),
        ("Move back at least two feet.", "yes", {"distance": "2", "distance_unit": "feet"}),
    ],
)
def test_a_range_or_a_bound_is_asked_about(
    understand: Any, text: str, answer: str, arguments: Dict[str, str], policy: Policy
) -> None:
    outcome, context = understand(text, policy=policy)
    assert isinstance(outcome, Question) and outcome.code == "AMBIGUOUS"
    outcome, _ = understand(answer, context=context, policy=policy)
    _, found = best(outcome)
    assert {key: found.get(key) for key in arguments} == arguments


@pytest.mark.parametrize("policy", [Policy(), IGNORING], ids=["strict", "ignore"])
def test_an_amount_belongs_to_the_verb_before_it(understand: Any, policy: Policy) -> None:
    outcome, _ = understand("Move back 17 centimeters and turn left a three quarter turn", policy=policy)
    assert isinstance(outcome, Understood), outcome
    arguments = [{value.name: value.text for value in clause[0].arguments} for clause in outcome.clauses]
    assert (arguments[0]["distance"], arguments[1]["angle"]) == ("17", "0.75")


def test_a_range_is_no_answer(understand: Any) -> None:
    outcome, context = understand("Move forward.")
    assert isinstance(outcome, Question) and outcome.code == "MISSING_ELEMENT"
    outcome, _ = understand("two or three metres", context=context)
    assert not isinstance(outcome, Understood)
    outcome, _ = understand("twenty-five centimetres", context=context)
    assert best(outcome)[1]["distance"] == "25"


@pytest.mark.parametrize("text", ["drive east three metres", "walk to your left one metre", "move three metres north"])
def test_no_other_direction_is_meant_where_one_was_said(understand: Any, text: str) -> None:
    for policy in (Policy(), IGNORING):
        outcome, _ = understand(text, policy=policy)
        assert not isinstance(outcome, Understood) or best(outcome)[0] != "moving", outcome


@pytest.mark.parametrize(
    "text, frame_name", [("bring me two or three mugs", "bringing"), ("go to room 2 or 3", "navigating_to_location")]
)
def test_what_counts_or_names_things_is_no_measure(understand: Any, text: str, frame_name: str) -> None:
    outcome, _ = understand(text)
    assert best(outcome)[0] == frame_name


def test_a_unit_of_2012_gets_the_whole_number_and_never_a_half(parser: Any) -> None:
    lexicon = Lexicon()
    lexicon.add_file(
        """
frame_name: turning
verb: turn
frame_element_grammatical_relations:
  - {name: direction, relation: advmod}
  - {name: angle, relation: num}
  - {name: angle_unit, relation: tmod}
""".replace("relation: advmod", "relation: advmod, words: [left, right]"),
        "turning.yaml",
    )
    elements = "".join(f"\n  - {{name: {name}, is_core: True}}" for name in ("direction", "angle", "angle_unit"))
    frames = {"turning": load_frame(f"name: turning\nframe_elements:{elements}\n", "turning.yaml")}

    def understood(text: str) -> Any:
        return read(parser.parse(text, frozenset(["turn"])), lexicon, frames, policy=IGNORING)[0]

    assert best(understood("Turn left 120 degrees."))[1] == {
        "direction": "left",
        "angle": "120",
        "angle_unit": "degrees",
    }
    assert best(understood("Turn left three degrees."))[1]["angle"] == "three"
    assert best(understood("Turn left forty-five degrees."))[1]["angle"] == "45"
    for text in ("Turn left ten to fifteen degrees.", "Turn left five five degrees.", "Turn left not 5 degrees."):
        assert not isinstance(understood(text), Understood)
