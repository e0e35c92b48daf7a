"""What is done to a text before the parse."""

import pytest

from utterance_passes.engine.running import run_text_passes
from utterance_passes.slips.hesitation import false_starts, hesitation, repeated_starts
from utterance_passes.table import TEXT_PASSES
from utterance_passes.trees.spelling import Spelling, as_said


def rewrite(said: str) -> Spelling:
    return run_text_passes(said, TEXT_PASSES)


@pytest.mark.parametrize(
    "said, text",
    [
        ("turn 90° left", "turn 90 degrees left"),
        ("move 3ft", "move 3 ft"),
        ("move 10cm up", "move 10 cm up"),
        ("turn -90 degrees", "turn minus 90 degrees"),
        ("turn \u221290 degrees", "turn minus 90 degrees"),
        ("move -two metres", "move minus two metres"),
        ("move negative 3 m", "move minus 3 m"),
        ("a negative answer", "a negative answer"),
        ("turn forty-five°", "turn forty-five degrees"),
        ("move ½ metre", "move 1 / 2 metre"),
        ("move 2½ft", "move 2 1 / 2 ft"),
        ("move 3/4 metre", "move 3 / 4 metre"),
        ("turn forty\u2013five degrees", "turn forty-five degrees"),
        ("Roger’s  office ", "Roger's office"),
        ("wait 5s", "wait 5 s"),
        ("room 204", "room 204"),
        ("a well-known place", "a well-known place"),
        ("move forward <pause> two feet", "move forward two feet"),
        ("", ""),
    ],
)
def test_rewrite(said: str, text: str) -> None:
    assert rewrite(said).text == text


@pytest.mark.parametrize("said", ["turn 90° left", "  move  3ft now", "turn -90 degrees", "go"])
def test_rewrite_remembers_where_words_came_from(said: str) -> None:
    spelling = rewrite(said)
    assert len(spelling.origins) == len(spelling.text) + 1
    for word in ("left", "now", "degrees", "go"):
        if word in said:
            assert said[spelling.origins[spelling.text.index(word)] :].startswith(word)


@pytest.mark.parametrize(
    "said, written",
    [
        ("go to the off- the kitchen", "go to the kitchen"),
        ("turn le- right", "turn right"),
        ("go to the ki- go to the kitchen", "go to the kitchen"),
        ("take the two- or three-legged chair", "take the two- or three-legged chair"),
        ("move ten- twenty metres", "move ten- twenty metres"),
        ("pick-up the cup", "pick-up the cup"),
    ],
)
def test_false_starts(said: str, written: str) -> None:
    made = false_starts.run(as_said(said))
    assert made.text == written
    assert len(made.origins) == len(made.text) + 1
    assert [said[made.origins[place]] for place in range(len(made.text))] == list(made.text)


@pytest.mark.parametrize(
    "said, written",
    [
        ("take the take the red cup", "take the red cup"),
        ("turn left turn left", "turn left turn left"),
        ("bye bye", "bye bye"),
    ],
)
def test_repeated_starts(said: str, written: str) -> None:
    assert repeated_starts.run(as_said(said)).text == written


@pytest.mark.parametrize(
    "said, written",
    [
        ("could you you know close the door", "could you close the door"),
        ("take the, like, small cup", "take the small cup"),
        ("do you know the way", "do you know the way"),
        ("you know where it is", "you know where it is"),
        ("say you know, no", "say you know, no"),
        ("you know", "you know"),
    ],
)
def test_hesitation(said: str, written: str) -> None:
    assert " ".join(hesitation.run(as_said(said)).text.split()) == written


@pytest.mark.parametrize(
    "said, left",
    [
        ("move two, uh, metres", "move two metres"),
        ("move two, uh, eleven metres", "move two, uh, eleven metres"),  # the second number may correct the first
    ],
)
def test_a_filler_between_two_numbers_stays(said: str, left: str) -> None:
    assert hesitation.run(as_said(said)).text == left
