"""People who correct themselves: the correction counts where it is certain, and what was abandoned never does."""

from typing import Any, Dict, List, Tuple

import pytest

from semantic_framer.framer import Question, Refusal, Understood, read
from semantic_framer.units.lexicon import Lexicon
from semantic_frames import load_frame
from utterance_passes.engine.running import run_tree_passes
from utterance_passes.table import CORRECTION_PASSES
from utterance_passes.trees.conllu import from_conllu

UNITS = """
- frame_name: turning
  verb: turn
  frame_element_grammatical_relations: [{name: direction, relation: advmod, words: [left, right]}]
- frame_name: taking
  verb: take
  frame_element_grammatical_relations: [{name: theme, relation: dobj, argument: phrase}]
"""
FRAMES = {
    name: load_frame(f"name: {name}\nframe_elements:\n  - {{name: {element}, is_core: True}}\n", "frame.yaml")
    for name, element in (("turning", "direction"), ("taking", "theme"))
}


def lexicon() -> Lexicon:
    made = Lexicon()
    made.add_file(UNITS, "units.yaml")
    return made


TURN_LEFT = "1 turn turn VERB VB _ 0 root _ _\n2 left left ADV RB _ 1 advmod _ _"
#: "turn left no right", as the shipped models parse it.
NO_RIGHT = TURN_LEFT + "\n3 no no DET DT _ 4 det _ _\n4 right right NOUN NN _ 1 obj _ _"
#: "turn left uh I mean right", as the shipped models parse it.
I_MEAN_RIGHT = TURN_LEFT + (
    "\n3 uh uh INTJ UH _ 1 discourse _ _\n4 I I PRON PRP _ 5 nsubj _ _\n5 mean mean VERB VBP _ 1 parataxis _ _"
    "\n6 right right ADV RB _ 5 advmod _ _"
)
#: The root is in the correction.
ROOT_BEHIND = (
    "1 turn turn VERB VB _ 4 csubj _ _\n2 left left ADV RB _ 1 advmod _ _\n3 no no DET DT _ 4 det _ _"
    "\n4 right right NOUN NN _ 0 root _ _"
)


@pytest.mark.parametrize("rows", [NO_RIGHT, I_MEAN_RIGHT, ROOT_BEHIND])
def test_correction_takes_the_place_of_what_it_corrects(rows: str) -> None:
    tree = from_conllu(rows)
    corrected = run_tree_passes(tree, lexicon(), CORRECTION_PASSES)
    assert [word.form for word in corrected.words] == [word.form for word in tree.words]
    assert corrected.abandoned == frozenset(range(2, len(tree.words)))
    assert sum(1 for word in corrected.words if word.head == 0) == 1
    outcome, _ = read(tree, lexicon(), FRAMES)
    assert isinstance(outcome, Understood)
    assert outcome.clauses[0][0].argument("direction").positions == (len(tree.words),)


def test_sentence_without_a_correction_is_left_as_it_is() -> None:
    tree = from_conllu(TURN_LEFT)
    assert run_tree_passes(tree, lexicon(), CORRECTION_PASSES) is tree


def test_command_that_is_taken_back_altogether() -> None:
    outcome, _ = read(from_conllu(TURN_LEFT + "\n3 no no INTJ UH _ 1 discourse _ _"), lexicon(), FRAMES)
    assert isinstance(outcome, Refusal) and outcome.code == "DECLINED"


def test_answer_that_is_corrected_is_not_taken() -> None:
    question, context = read(from_conllu("1 turn turn VERB VB _ 0 root _ _"), lexicon(), FRAMES)
    assert isinstance(question, Question)
    rows = "1 left left ADV RB _ 0 root _ _\n2 no no INTJ UH _ 1 discourse _ _\n3 right right ADV RB _ 1 advmod _ _"
    assert isinstance(read(from_conllu(rows), lexicon(), FRAMES, context=context)[0], Refusal)


def meant(outcome: Any) -> List[Tuple[str, Dict[str, str]]]:
    assert isinstance(outcome, Understood), outcome
    return [
        (clause[0].unit.frame_name, {value.name: value.text for value in clause[0].arguments if value.positions})
        for clause in outcome.clauses
    ]


@pytest.mark.parametrize(
    "text, done",
    [
        ("turn left no right", [("turning", {"direction": "right"})]),
        ("turn left, no, right", [("turning", {"direction": "right"})]),
        ("turn left uh I mean right", [("turning", {"direction": "right"})]),
        ("turn left or rather right", [("turning", {"direction": "right"})]),
        ("turn left no wait turn right", [("turning", {"direction": "right"})]),
        ("turn left no right no left", [("turning", {"direction": "left"})]),
        ("go to the kitchen sorry the office", [("navigating_to_location", {"goal": "the office"})]),
        ("go to the kitchen, sorry, to the office", [("navigating_to_location", {"goal": "the office"})]),
        ("go to the kitchen no Roger's office", [("navigating_to_location", {"goal": "Roger's office"})]),
        ("turn left no go to the kitchen", [("navigating_to_location", {"goal": "the kitchen"})]),
        ("bring me the mug no the plate", [("bringing", {"theme": "the plate", "beneficiary": "me"})]),
        ("bring the mug to the kitchen no to the office", [("bringing", {"theme": "the mug", "goal": "the office"})]),
        (
            "move forward 2 no 3 metres",
            [("moving", {"direction": "forward", "distance": "3", "distance_unit": "metres"})],
        ),
        (
            "go to the kitchen no the office and turn left",
            [("navigating_to_location", {"goal": "the office"}), ("turning", {"direction": "left"})],
        ),
        (
            "go to the kitchen and turn left no turn right",
            [("navigating_to_location", {"goal": "the kitchen"}), ("turning", {"direction": "right"})],
        ),
        ("um go to the kitchen", [("navigating_to_location", {"goal": "the kitchen"})]),
        ("go to the um kitchen", [("navigating_to_location", {"goal": "the kitchen"})]),
        (
            "turn left ninety uh ninety degrees",
            [("turning", {"direction": "left", "angle": "90", "angle_unit": "degrees"})],
        ),
        ("turn turn left", [("turning", {"direction": "left"})]),
        ("go go to the the kitchen", [("navigating_to_location", {"goal": "the kitchen"})]),
        (
            "move forward uhhh five feet",
            [("moving", {"direction": "forward", "distance": "5", "distance_unit": "feet"})],
        ),
        ("say no", [("saying", {"message": "no"})]),
        ("say sorry to Bob", [("saying", {"message": "sorry", "addressee": "Bob"})]),
    ],
)
def test_what_is_meant_is_done(understand: Any, text: str, done: List[Tuple[str, Dict[str, str]]]) -> None:
    assert meant(understand(text)[0]) == done


@pytest.mark.parametrize(
    "text, readings",
    [
        (
            "bring the mug to the kitchen no the office",
            ("bring the office to the kitchen", "bring the mug to the office"),
        ),
        ("bring the mug on the table no the plate", ("bring the plate on the table", "bring the mug on the plate")),
        ("go to the kitchen and follow Bob no turn left", ("go to the kitchen and turn left", "turn left")),
        ("move forward two metres no three", ("move forward three metres",)),
        ("give the mug to the man no Bob", ("give the mug to the man", "Bob")),
    ],
)
def test_correction_that_is_not_certain_is_asked_about(understand: Any, text: str, readings: Tuple[str, ...]) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Question) and outcome.code == "AMBIGUOUS"
    assert all(f'"{reading}"' in outcome.sentence for reading in readings)


@pytest.mark.parametrize(
    "text",
    [
        "if the door is open turn left no turn right",
        "turn left when I say so no turn right",
        "tomorrow turn left no turn right",
        "turn left tomorrow, no, go to the kitchen",
        "if the door is open turn left no right",
        "turn left no right tomorrow",
        "turn left no right if the door is open",
    ],
)
def test_correction_does_not_lose_a_condition_or_a_time(understand: Any, text: str) -> None:
    outcome, _ = understand(text)
    assert not isinstance(outcome, Understood) or "IF(" in str(outcome.plan)


@pytest.mark.parametrize(
    "text",
    [
        "don't turn left I mean right",
        "take the mug and no plate",
        "bring the mug but no plate",
        "bring Bob no mug",
        "give the mug to no one",
        "follow me no more",
        "go to the kitchen and turn left no wait",
    ],
)
def test_words_that_correct_nothing_do_not_make_a_command(understand: Any, text: str) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Refusal) and outcome.code in ("NEGATED", "DECLINED", "LEFT_OVER_WORDS")


@pytest.mark.parametrize(
    "text",
    ["Turn right 5,5 radians.", "Go forward 5,5 centimeters.", "turn right 5, 5 radians", "turn left 90 90 degrees"],
)
def test_a_number_that_is_written_twice_is_no_restart(understand: Any, text: str) -> None:
    outcome, _ = understand(text)
    assert isinstance(outcome, Refusal) and outcome.code == "LEFT_OVER_WORDS"


TERMS = ("no", ", no,", "sorry", ", sorry,", "I mean", "uh I mean", "no wait", "no, I mean", "or rather", "uh no sorry")
PAIRS = (
    ("turn {}", "left", "right"),
    ("turn {}", "left 45 degrees", "right 90 degrees"),
    ("go to {}", "the kitchen", "the office"),
    ("go {}", "to the kitchen", "to the office"),
    ("{}", "follow me", "go to the office"),
    ("take {}", "the mug", "the red box"),
    ("bring me {}", "the mug", "the plate"),
    ("move forward {}", "two metres", "three feet"),
    ("put the box {}", "on the table", "on the shelf"),
    ("give the mug to {}", "Bob", "Alice"),
)


def test_what_was_abandoned_is_never_done(understand: Any) -> None:
    done = 0
    for pattern, abandoned, corrected in PAIRS:
        only = meant(understand(pattern.format(corrected))[0])
        for term in TERMS:
            text = pattern.format(f"{abandoned} {term} {corrected}".replace(" ,", ","))
            outcome, _ = understand(text)
            if isinstance(outcome, Understood):
                assert meant(outcome) == only, text
                done += 1
    # Corrections are understood, and not only refused.
    assert done >= 80
