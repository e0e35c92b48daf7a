"""Places behind a noun, attached by what the robot knows: what describes a thing, and where it shall be."""

from dataclasses import replace
from typing import Optional, Tuple

import pytest

from offline_pipeline.knowledge import load_knowledge, pretend_servers, shipped_domains
from offline_pipeline.pipeline import Pipeline, Understanding
from semantic_frames.frame import UnknownPolicy
from typed_arguments import Source
from world_model import World
from world_model.world import snapshot
from world_model.world_file import load_world_file

#: The lamp and the box beside it are far from the table; the plate is on the shelf, and so is the cup beside it.
HOME = """
places:
  kitchen: {x: 20, y: 0, size: [4, 4]}
  hall: {x: 0, y: 0, size: [10, 10]}
things:
  table_1: {x: 4, y: 0}
  shelf_1: {x: -4, y: 0}
  lamp_1: {x: 0, y: 0}
  box_1: {x: 1, y: 0}
  plate_1: {on: shelf_1}
  cup_1: {on: shelf_1, near: plate_1}
  book_1: {on: table_1}
persons:
  anna: {in: hall}
"""


@pytest.fixture(scope="module")
def pipeline() -> Pipeline:
    knowledge = load_knowledge([shipped_domains()])
    pretend_servers(knowledge.graph)
    return Pipeline(knowledge, is_traced=True)


@pytest.fixture(scope="module")
def home() -> World:
    return snapshot("1", {one.id: one for one in load_world_file(HOME, "home.yaml")})


@pytest.fixture(scope="module")
def with_two_cups(pipeline: Pipeline) -> Pipeline:
    home = HOME.replace("persons:", "  cup_2: {on: table_1}\npersons:")
    return pipeline.in_world(snapshot("1", {one.id: one for one in load_world_file(home, "home.yaml")}))


def read(understood: Understanding) -> str:
    return "; ".join(map(str, understood.readings))


@pytest.mark.parametrize(
    ("text", "plain", "in_home"),
    [
        (
            "take the box near the lamp on the table",
            "taking(theme=the box near the lamp on the table)",
            "bringing(theme=the box near the lamp, goal=the table)",
        ),
        (
            "take the book near the plate on the shelf",
            "taking(theme=the book near the plate on the shelf)",
            "bringing(theme=the book, goal=the plate on the shelf)",
        ),
        (
            "take the cup near the plate on the shelf",
            "taking(theme=the cup near the plate on the shelf)",
            None,
        ),
        (
            "bring the book on the table in the kitchen",
            "bringing(theme=the book on the table, goal=the kitchen)",
            None,
        ),
        (
            "bring the cup on the table in the hall",
            "bringing(theme=the cup on the table, goal=the hall)",
            "bringing(theme=the cup, goal=the table in the hall)",
        ),
        (
            "carry the cup on the shelf near the plate",
            "bringing(theme=the cup on the shelf, goal=the plate)",
            "bringing(theme=the cup on the shelf near the plate)",
        ),
        ("put the cup on the table", "placing(theme=the cup, goal=the table)", None),
        ("take the vase near the lamp on the table", "taking(theme=the vase near the lamp on the table)", None),
        ("take the box near the sofa on the table", "taking(theme=the box near the sofa on the table)", None),
        ("inspect the box on the table", "inspecting(ground=the box on the table)", None),
        ("follow Anna near the table", "following(cotheme=Anna near the table)", None),
    ],
)
def test_places_are_attached_by_the_world(
    text: str, plain: str, in_home: Optional[str], pipeline: Pipeline, home: World
) -> None:
    assert read(pipeline.understand(text)) == plain
    found = pipeline.in_world(home).understand(text)
    assert read(found) == (in_home or plain)
    assert any(line.rule == "attached_by_world" for line in found.trace) == (in_home is not None)


def test_a_goal_that_only_the_world_makes_is_asked_about(pipeline: Pipeline, home: World) -> None:
    in_home = pipeline.in_world(home)
    asked = in_home.understand("take the box near the lamp on the table")
    assert asked.reply.code == "CONFIRM"
    assert asked.reply.sentence == (
        "I know of no box near the lamp on the table. Do you want me to put it there: on the table? Say yes or no."
    )
    assert in_home.understand("no", asked.context).reply.code == "DECLINED"
    agreed = in_home.understand("yes", asked.context)
    assert agreed.reply.code == "DONE"
    assert agreed.candidates[0][0].frames[0].name == "bringing"


def test_a_world_that_knows_nothing_changes_nothing(pipeline: Pipeline) -> None:
    text = "take the box near the lamp on the table"
    assert pipeline.in_world(World()).understand(text) == pipeline.understand(text)


@pytest.mark.parametrize(
    ("policy", "code", "sentence"),
    [
        (UnknownPolicy.ACT, "DONE", "I would do grasping on grasping."),
        (
            UnknownPolicy.ASK,
            "CONFIRM",
            'I know of no vase. Shall I really do this: "grasp the vase"? Say yes or no.',
        ),
        (UnknownPolicy.REFUSE, "UNKNOWN_THING", "I know of no vase."),
    ],
)
def test_a_frame_says_what_happens_with_an_unknown_thing(
    policy: UnknownPolicy, code: str, sentence: str, home: World
) -> None:
    knowledge = load_knowledge([shipped_domains()])
    knowledge.graph.frames["grasping"]  # a frame that is shipped
    frames = {**knowledge.frames, "grasping": replace(knowledge.frames["grasping"], on_unknown=policy)}
    knowledge.graph._frames = frames
    pretend_servers(knowledge.graph)
    in_home = Pipeline(knowledge, world=home)
    found = in_home.understand("grasp the vase").reply
    assert (found.code, found.sentence) == (code, sentence)
    # What is known, and what nobody can know: without a world there is nothing to compare with.
    assert in_home.understand("grasp the cup").reply.code == "DONE"
    assert in_home.in_world(World()).understand("grasp the vase").reply.code == "DONE"


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Put the book in the box and close it.", ("box_1",)),
        ("Take the book out of the box and close it.", ("box_1",)),
        ("Go to the shelf, take the book and put it there.", ("book_1",)),
        ("Take the plate, take the book and bring them to Anna.", ("plate_1", "book_1")),
        ("Take the plate and the book and put them both on the table.", ("plate_1", "book_1")),
        ("Take the red mug and bring it to Anna.", ()),
    ],
)
def test_a_pronoun_refers_to_what_it_stands_for(
    pipeline: Pipeline, home: World, text: str, meant: Tuple[str, ...]
) -> None:
    pronoun = pipeline.in_world(home).understand(text).readings[-1].arguments[0]
    assert pronoun.source is Source.INFERRED
    assert pronoun.referents == meant


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Go to the room where Anna is.", ("hall",)),
        ("Go to the room Anna is in.", ("hall",)),
        ("Bring me the book from the room where Anna is.", ("hall",)),
        ("Go to the table where the book is.", ("table_1",)),
        ("Go to the room where Bob is.", ()),
        ("Go to the room where Anna was.", ()),
        ("Go to the room where Anna is not.", ()),
        ("Go to the room where Anna is sitting.", ("hall",)),
    ],
)
def test_a_place_is_the_one_where_somebody_or_something_is(
    pipeline: Pipeline, home: World, text: str, meant: Tuple[str, ...]
) -> None:
    assert pipeline.in_world(home).understand(text).readings[0].arguments[-1].referents == meant


@pytest.mark.parametrize("text", ["Any of them.", "I don't care.", "Whichever you like."])
def test_a_choice_may_be_left_to_the_robot(with_two_cups: Pipeline, text: str) -> None:
    asked = with_two_cups.understand("bring the cup")
    assert asked.reply.code == "AMBIGUOUS"
    chosen = with_two_cups.understand(text, asked.context)
    assert chosen.reply.code == "DONE"
    assert chosen.readings[0].arguments[0].referents in (("cup_1",), ("cup_2",))


def test_none_of_the_things_that_were_offered(with_two_cups: Pipeline) -> None:
    asked = with_two_cups.understand("bring the cup")
    assert with_two_cups.understand("Neither.", asked.context).reply.code == "DECLINED"
