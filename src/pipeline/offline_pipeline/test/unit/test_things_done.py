"""Things that are told apart by what the robot did to them: "the door *that you closed*"."""

from typing import Tuple

import pytest

from offline_pipeline.pipeline import Pipeline
from typed_arguments import FilledFrame, TypedArgument
from world_model.world import snapshot
from world_model.world_file import load_world_file

HOME = """
places:
  kitchen: {x: 20, y: 0, size: [4, 4]}
  hall: {x: 0, y: 0, size: [10, 10]}
things:
  table_1: {x: 4, y: 0}
  shelf_1: {x: -4, y: 0}
  mug_1: {on: shelf_1}
  mug_2: {on: table_1}
  mug_3: {on: table_1}
"""


def done_to(frame: str, element: str, *ids: str, count: int = 1) -> FilledFrame:
    """Return a frame that was carried out, with the things that fill one of its elements."""
    filler = TypedArgument(element, "it", referents=ids, referent_count=count, world_version="1")
    return FilledFrame(frame, (filler,), "server")


WASHED = done_to("washing_dishes", "object", "mug_2")


@pytest.fixture(name="home", scope="module")
def _home(pipeline: Pipeline) -> Pipeline:
    return pipeline.in_world(snapshot("1", {one.id: one for one in load_world_file(HOME, "home.yaml")}))


def meant(home: Pipeline, text: str) -> Tuple[str, ...]:
    """Return the code of the reply and the ids of the last argument that refers to something."""
    understood = home.understand(text)
    found = [one.referents for reading in understood.readings for one in reading.arguments if one.referents]
    return (understood.reply.code, *(found[-1] if found else ()))


@pytest.mark.parametrize(
    "text",
    [
        "Bring me the mug that you washed.",
        "When Anna comes, bring me the mug that you washed.",
    ],
)
def test_it_is_what_the_deed_was_done_to(home: Pipeline, text: str) -> None:
    assert meant(home.having_done(WASHED), text) == ("DONE", "mug_2")


def test_other_elements_of_the_deed_count(home: Pipeline) -> None:
    on_shelf = FilledFrame("placing", (*done_to("placing", "theme", "mug_1").arguments, TypedArgument("goal", "shelf")))
    on_table = FilledFrame("placing", (*done_to("placing", "theme", "mug_3").arguments, TypedArgument("goal", "table")))
    there = home.having_done(on_shelf, on_table)
    assert meant(there, "Bring me the mug that you put on the table.") == ("DONE", "mug_3")


def test_of_two_it_is_asked_which(home: Pipeline) -> None:
    both = home.having_done(WASHED, done_to("washing_dishes", "object", "mug_1"))
    assert meant(both, "Bring me the mug that you washed.")[0] == "AMBIGUOUS"


def test_what_was_not_done(home: Pipeline) -> None:
    both = home.having_done(WASHED, done_to("washing_dishes", "object", "mug_1"))
    assert meant(both, "Bring me the mug that you did not wash.") == ("DONE", "mug_3")


@pytest.mark.parametrize(
    "done",
    [
        done_to("cleaning", "theme", "mug_2"),
        done_to("washing_dishes", "object", "table_1"),
        # It was one of the mugs, and nobody knows which.
        done_to("washing_dishes", "object", "mug_1", "mug_2"),
    ],
)
def test_what_the_robot_does_not_remember_is_not_done(home: Pipeline, done: FilledFrame) -> None:
    understood = home.having_done(done).understand("Bring me the mug that you washed.")
    assert (understood.reply.outcome, understood.reply.code) == ("REFUSED", "UNKNOWN_THING")
    assert '"that you washed"' in understood.reply.sentence


def test_deed_that_is_not_clear_is_not_done(home: Pipeline) -> None:
    understood = home.having_done(WASHED).understand("Bring me the mug that you washed and broke.")
    assert understood.reply.outcome == "REFUSED"
