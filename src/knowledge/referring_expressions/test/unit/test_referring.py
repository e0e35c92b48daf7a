"""Phrases and what they refer to in a small home."""

from dataclasses import replace
from typing import FrozenSet, Set

import pytest

from phrase_meanings.phrases import Phrases
from referring_expressions import Referents, Situation, question_of, resolve, with_referents
from referring_expressions.describing import article, describe, place_of, plural_of, question_of_speaker
from referring_expressions.fitting import is_of_unknown_speaker, is_speaker_asked_for
from stanford_parser_ros.model import shipped_parser
from typed_arguments import TypedArgument
from world_model import Relation, World
from world_model.world import snapshot
from world_model.world_file import load_world_file

HOME = """
places:
  kitchen: {x: 0, y: 0, size: [6, 6]}
  office: {x: 10, y: 0, size: [6, 6]}
doors:
  kitchen_door: {category: door, to: kitchen}
  office_door: {category: door, to: office}
things:
  table_1: {x: 1, y: 1}
  table_2: {x: 10, y: 1}
  coffee_table: {x: 9, y: -1}
  lamp_1: {on: table_1}
  lamp_2: {on: table_2}
  box_1: {beside: lamp_1, size: [0.1, 0.1, 0.1]}
  box_2: {beside: lamp_2, size: [0.3, 0.3, 0.3]}
  mug_1: {on: table_1, attributes: [red], of: anna, x: 1, y: 1.3}
  mug_2: {on: table_2, attributes: [blue], x: 10, y: 0.5}
  spoon_1: {on: table_1}
  spoon_2: {on: table_1}
  sofa_1: {in: office}
  bottle_1: {on: table_2, states: [empty]}
  bottle_2: {on: table_2, states: [full]}
persons:
  anna: {in: kitchen}
robots:
  robot: {x: 0, y: 0, heading: 0}
"""
NO_VERBS: FrozenSet[str] = frozenset()


@pytest.fixture(scope="module")
def home() -> World:
    return snapshot("home-1", {one.id: one for one in load_world_file(HOME, "home.yaml")})


def phrase(text: str) -> TypedArgument:
    """Return the argument of a sentence that is only a phrase."""
    tree = shipped_parser().parse(f"{text[0].upper()}{text[1:]}.", NO_VERBS)
    return Phrases(tree).argument("theme", tree.children(0)[0].index)


def resolved(text: str, home: World, **situation: object) -> Referents:
    found = resolve(phrase(text), Situation(home, **situation))
    assert found is not None, text
    return found


@pytest.mark.parametrize(
    "text, expected",
    [
        ("the red mug", "mug_1"),
        ("the mug on the table in the office", "mug_2"),
        ("the mug in the kitchen", "mug_1"),
        ("Anna's mug", "mug_1"),
        ("the coffee table", "coffee_table"),
        ("the couch", "sofa_1"),
        ("the kitchen", "kitchen"),
        ("Anna", "anna"),
        ("the door of the kitchen", "kitchen_door"),
        ("the biggest box", "box_2"),
        ("the smallest box", "box_1"),
        ("the nearest mug", "mug_1"),
        ("the full bottle", "bottle_2"),
        ("the empty bottle", "bottle_1"),
    ],
)
def test_phrase_refers_to_one(text: str, expected: str, home: World) -> None:
    found = resolved(text, home)
    assert (found.ids, found.count, found.is_ambiguous) == ((expected,), 1, False)


@pytest.mark.parametrize(
    "text, expected",
    [
        ("the mug", {"mug_1", "mug_2"}),
        ("the box near the lamp", {"box_1", "box_2"}),
        ("the door", {"kitchen_door", "office_door"}),
    ],
)
def test_several_fit_and_a_person_must_say_which(text: str, expected: Set[str], home: World) -> None:
    found = resolved(text, home)
    assert found.is_ambiguous
    assert set(found.ids) == expected


@pytest.mark.parametrize(
    "text, count, number",
    [
        ("both mugs", -1, 2),
        ("all bottles", -1, 2),
        ("a mug", 1, 2),
        ("two spoons", 2, 2),
        ("the mugs", -1, 2),
        ("the spoon", 1, 2),
    ],
)
def test_quantifier_says_how_many_are_meant(text: str, count: int, number: int, home: World) -> None:
    found = resolved(text, home)
    assert (found.count, len(found.ids), found.is_ambiguous) == (count, number, False)


@pytest.mark.parametrize("text", ["the green mug", "the unicorn", "Bob's mug", "the mug on the sofa"])
def test_nothing_known_fits(text: str, home: World) -> None:
    assert resolved(text, home) == Referents()


@pytest.mark.parametrize("text", ["two metres", "the left", "no red mug"])
def test_phrase_refers_to_nothing(text: str, home: World) -> None:
    found = resolve(phrase(text), Situation(home))
    assert found is None or not found.objects


def test_what_was_last_spoken_of_is_meant_and_the_other_one_is_not(home: World) -> None:
    assert resolved("the mug", home, spoken_of=("mug_2", "mug_1")).ids == ("mug_2",)
    assert resolved("the other mug", home, spoken_of=("mug_2", "mug_1")).ids == ("mug_1",)
    assert resolved("it", home, spoken_of=("mug_2", "mug_1")).ids == ("mug_2",)


def test_speaker_owns_what_is_mine(home: World) -> None:
    assert resolved("my mug", home, speaker="anna").ids == ("mug_1",)


def test_here_is_where_the_robot_is(home: World) -> None:
    assert resolved("here", home).ids == ("kitchen",)


@pytest.mark.parametrize(
    "text, expected",
    [
        ("the red one", "mug_1"),
        ("the one in the office", "mug_2"),
        ("the second one", "mug_2"),
        ("Anna's mug", "mug_1"),
    ],
)
def test_answer_chooses_from_what_was_offered(text: str, expected: str, home: World) -> None:
    assert resolved(text, home, offered=("mug_1", "mug_2")).ids == (expected,)


def test_list_refers_to_what_its_members_refer_to(home: World) -> None:
    found = resolved("the red mug and the sofa", home)
    assert (found.ids, found.count) == (("mug_1", "sofa_1"), 2)


def test_referents_travel_in_the_argument_and_in_its_parts(home: World) -> None:
    argument = with_referents(phrase("the mug on the table in the office"), Situation(home))
    assert (argument.referents, argument.referent_count, argument.world_version) == (("mug_2",), 1, "home-1")
    parts = [element for frame in argument.frames for element in frame.frame_elements]
    assert {name for part in parts for name in part.referents} >= {"table_2"}


def test_without_a_world_nothing_changes() -> None:
    argument = phrase("the red mug")
    assert with_referents(argument, Situation(World())) is argument


def test_question_tells_the_objects_apart(home: World) -> None:
    mugs = [home.by_id["mug_1"], home.by_id["mug_2"]]
    assert (
        question_of("mug", mugs, home) == "Which mug, the red one of Anna in the kitchen or the blue one in the office?"
    )
    bottles = [home.by_id["bottle_1"], home.by_id["bottle_2"]]
    assert (
        question_of("bottle", bottles, home)
        == "Which bottle, the empty one in the office or the full one in the office?"
    )


def test_place_in_words(home: World) -> None:
    assert place_of(home.by_id["spoon_1"], home) == "on the table in the kitchen"
    assert place_of(home.by_id["anna"], home) == "in the kitchen"
    assert place_of(replace(home.by_id["anna"], relations=()), home) == ""
    assert describe(home.by_id["anna"], home) == "Anna"


def test_whose_it_is_is_open_while_nobody_knows_who_speaks(home: World) -> None:
    assert is_of_unknown_speaker(phrase("my mug"), Situation(home))
    assert resolved("my mug", home).ids == ("mug_1",)
    assert not is_of_unknown_speaker(phrase("my mug"), Situation(home, speaker="anna"))
    # The other mug is nobody's, as far as the robot knows.
    assert resolved("my mug", home, speaker="ben").ids == ("mug_2",)
    assert resolved("my lamp", home).ids == ("lamp_1", "lamp_2")
    assert not is_speaker_asked_for(phrase("my lamp"), Situation(home), home.exactly("lamp"))
    hers = tuple(replace(one, relations=(Relation("of", "anna"),)) for one in home.exactly("lamp"))
    assert resolved("my lamp", World("1", hers), speaker="ben") == Referents()
    assert question_of_speaker((home.by_id["mug_1"],), home) == "Who are you? I know the mug of Anna."


def test_of_many_things_the_nearest_are_named(home: World) -> None:
    doors = tuple(replace(home.by_id["office_door"], id=f"door_{index}", name=f"door {index}") for index in range(9))
    question = question_of("door", doors, World("1", doors))
    assert question == "Which door, the door 0, the door 1, the door 2, the door 3 or another one? I know of 9."


def test_things_of_different_kinds_are_asked_about_by_their_names(home: World) -> None:
    question = question_of("thing", (home.by_id["mug_1"], home.by_id["table_1"]), home)
    assert question.startswith("Which thing, the red mug")
    assert " one" not in question


@pytest.mark.parametrize(
    ("noun", "with_article", "plural"),
    [
        ("mug", "a mug", "mugs"),
        ("apple", "an apple", "apples"),
        ("box", "a box", "boxes"),
        ("keys", "keys", "keys"),
        ("glasses", "glasses", "glasses"),
        ("glass", "a glass", "glasses"),
    ],
)
def test_nouns_in_a_list(noun: str, with_article: str, plural: str) -> None:
    assert (article(noun), plural_of(noun)) == (with_article, plural)
