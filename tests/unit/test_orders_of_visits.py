"""Goals in an order, and places that the robot keeps out of on its way."""

import pytest


def read(pipeline, text):
    understanding = pipeline.understand(text)
    assert understanding.reply.outcome == "DONE", understanding.reply
    return [{one.name: one.text for one in reading.arguments} for reading in understanding.readings]


KITCHEN = {"goal": "the kitchen", "avoided": "the hall"}


@pytest.mark.parametrize(
    "text",
    [
        "Go to the kitchen avoiding the hall.",
        "Go to the kitchen and avoid the hall on the way.",
        "Go to the kitchen without going through the hall.",
        "Come to the kitchen without entering the hall.",
        "Go to the kitchen, but not through the hall.",
        "Go to the kitchen while avoiding the hall.",
        "Avoiding the hall, go to the kitchen.",
    ],
)
def test_place_to_keep_out_of(pipeline, text):
    assert read(pipeline, text) == [KITCHEN]


def test_all_goals_of_a_list_avoid_it(pipeline):
    said = read(pipeline, "Visit the office and the kitchen, avoiding the hall on the way.")
    assert said == [{"goal": "the office and the kitchen", "avoided": "the hall"}]


@pytest.mark.parametrize(
    "text",
    [
        "Go first to the kitchen, then to the office, and finally to the hall.",
    ],
)
def test_goals_with_prepositions(pipeline, text):
    assert [one["goal"] for one in read(pipeline, text)] == ["the kitchen", "the office", "the hall"]


@pytest.mark.parametrize(
    "text",
    [
        "Visit the kitchen, then the office and finally the hall.",
    ],
)
def test_words_of_order_are_no_part_of_an_item(pipeline, text):
    assert read(pipeline, text) == [{"goal": "the kitchen, the office and the hall"}]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("Greet Anna, then Bob.", [{"addressee": "Anna, Bob"}]),
        ("Bring Anna a cup, then Bob.", [{"theme": "a cup", "beneficiary": "Anna, Bob"}]),
    ],
)
def test_person_behind_a_word_of_order_is_not_spoken_to(pipeline, text, said):
    assert read(pipeline, text) == said


@pytest.mark.parametrize("text", ["Tell me the colour of the mug.", "Tell Anna the color of the mug."])
def test_what_is_told_may_be_asked_for_without_a_verb(pipeline, text):
    (message,) = [
        one for reading in pipeline.understand(text).readings for one in reading.arguments if one.name == "message"
    ]
    assert [frame.frame_name for frame in message.frames] == ["question_of_colour"]
