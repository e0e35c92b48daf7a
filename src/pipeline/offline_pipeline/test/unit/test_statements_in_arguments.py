"""What is to be checked or made sure of comes as frames of conditions."""

import pytest

from offline_pipeline.knowledge import load_knowledge, shipped_domains
from offline_pipeline.pipeline import Pipeline

CONTENTS = [
    ("Make sure that the door is closed.", ["condition_of_state(theme=the door, state=closed)"]),
    ("Make sure the stove is not on.", ["not condition_of_state(theme=the stove, state=on)"]),
    ("Make sure nobody is in the garage.", ["not condition_of_place(theme=somebody, location=the garage)"]),
    ("Make sure there is nothing on the table.", ["not condition_of_place(theme=something, location=the table)"]),
    ("Confirm that there are three cups on the table.", ["condition_of_place(theme=three cups, location=the table)"]),
    (
        "Make sure that the kitchen door and the garage door are closed.",
        [
            "condition_of_state(theme=the kitchen door, state=closed)",
            "condition_of_state(theme=the garage door, state=closed)",
        ],
    ),
    (
        "Make sure the door is closed and the light is off.",
        ["condition_of_state(theme=the door, state=closed)", "condition_of_state(theme=the light, state=off)"],
    ),
    ("Make sure the door or the window is closed.", []),
    ("Check whether the window is open.", ["condition_of_state(theme=the window, state=open)"]),
    ("Check that the stove isn't on.", ["not condition_of_state(theme=the stove, state=on)"]),
    ("Check the door.", []),
]


@pytest.fixture(scope="module")
def pipeline():
    return Pipeline(load_knowledge([shipped_domains()]))


@pytest.mark.parametrize(("text", "said"), CONTENTS)
def test_statements(pipeline, text, said):
    (reading,) = pipeline.understand(text).readings
    found = [
        f"{'not ' if frame.is_negated else ''}{frame.frame_name}"
        f"({', '.join(f'{one.name}={one.text}' for one in frame.frame_elements)})"
        for argument in reading.arguments
        for frame in argument.frames
        if frame.role == "says"
    ]
    assert found == said
