"""What the arguments of commands refer to, the question which thing is meant, and its answer."""

from dataclasses import replace
from typing import Tuple

import pytest

from offline_pipeline.knowledge import Knowledge, load_knowledge, shipped_domains
from semantic_framer.framer import Outcome, Question, Understood, hear
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.dialogue import Context
from stanford_parser_ros.model import shipped_parser
from typed_arguments import TypedArgument
from world_model.world import World, snapshot
from world_model.world_file import load_world_file

HOME = """
places:
  kitchen:
  office:
things:
  table_1: {in: kitchen}
  desk_1: {in: office}
  mug_1: {on: table_1, attributes: [red]}
  mug_2: {on: desk_1, attributes: [blue]}
  box_1: {in: office}
persons:
  anna: {in: office}
"""
QUESTION = "Which mug, the red one in the kitchen or the blue one in the office?"


@pytest.fixture(scope="module")
def knowledge() -> Knowledge:
    return load_knowledge([shipped_domains()])


class Home:
    """Hears one sentence after the other in a world."""

    def __init__(self, knowledge: Knowledge, world: World) -> None:
        self._known = FramedLexicon(knowledge.lexicon, knowledge.frames, world=world)
        self._verbs = frozenset(verb.split()[0] for verb in knowledge.lexicon.verbs)
        self._context = Context()

    def see(self, text: str) -> None:
        """The robot knows something else from now on."""
        self._known = replace(self._known, world=world_of(text, str(len(text))))

    def hear(self, text: str) -> Outcome:
        heard = hear(shipped_parser().parse(text, self._verbs), self._known, context=self._context)
        self._context = heard.context
        return heard.outcome

    def argument(self, text: str, element: str) -> TypedArgument:
        outcome = self.hear(text)
        assert isinstance(outcome, Understood), outcome
        found = outcome.clauses[0][0].argument(element)
        assert found is not None
        return found


def world_of(text: str, version: str) -> World:
    return snapshot(version, {one.id: one for one in load_world_file(text, "home.yaml")})


@pytest.fixture
def home(knowledge: Knowledge) -> Home:
    return Home(knowledge, world_of(HOME, "7"))


@pytest.mark.parametrize(
    ("text", "element", "referents", "count"),
    [
        ("Take the red mug.", "theme", ("mug_1",), 1),
        ("Take the mug on the table.", "theme", ("mug_1",), 1),
        ("Go to the kitchen.", "goal", ("kitchen",), 1),
        ("Take the spoon.", "theme", (), 0),
    ],
)
def test_argument_has_its_referents(
    text: str, element: str, referents: Tuple[str, ...], count: int, home: Home
) -> None:
    argument = home.argument(text, element)
    assert (argument.referents, argument.referent_count, argument.world_version) == (referents, count, "7")


@pytest.mark.parametrize(
    ("answer", "referent", "text"),
    [
        ("The red one.", "mug_1", "the red mug"),
        ("In the office.", "mug_2", "the mug in the office"),
        ("The second one.", "mug_2", "the second mug"),
    ],
)
def test_several_are_asked_about_and_an_answer_chooses(answer: str, referent: str, text: str, home: Home) -> None:
    assert home.hear("Take the mug.") == Question("AMBIGUOUS", QUESTION)
    argument = home.argument(answer, "theme")
    assert (argument.referents, argument.text) == ((referent,), text)


def test_what_chooses_nothing_is_no_answer(home: Home) -> None:
    home.hear("Take the mug.")
    assert not isinstance(home.hear("The green one."), Understood)


def test_it_is_what_was_spoken_of(home: Home) -> None:
    home.hear("Take the blue mug.")
    assert home.argument("Bring it to the kitchen.", "theme").referents == ("mug_2",)
    assert home.argument("Take the mug.", "theme").referents == ("mug_2",)


def test_it_is_not_an_older_thing_if_the_last_one_is_unknown(home: Home) -> None:
    home.hear("Take the blue mug.")
    home.hear("Take the spoon.")
    assert home.argument("Bring it to the kitchen.", "theme").referents == ()


UNSEEN = """
places:
  kitchen:
things:
  table_1: {in: kitchen}
"""
TAKEN = HOME.replace("mug_1: {on: table_1", "mug_1: {held_by: robot") + "robots:\n  robot: {in: kitchen}\n"


@pytest.mark.parametrize("said", ["Take the red mug.", "Take the mug.", "Take a mug."])
def test_what_was_named_before_it_was_seen_is_known_by_now(said: str, home: Home) -> None:
    home.see(UNSEEN)
    assert home.argument(said, "theme").referents == ()
    home.see(TAKEN)
    assert home.argument("Put the mug on the table.", "theme").referents == ("mug_1",)


def test_of_any_mug_the_one_was_meant_that_the_robot_has_taken(home: Home) -> None:
    assert home.argument("Take a mug.", "theme").referent_count == 1
    home.see(TAKEN)
    assert home.argument("Put the mug on the table.", "theme").referents == ("mug_1",)


def test_several_that_were_seen_later_are_asked_about(home: Home) -> None:
    home.see(UNSEEN)
    home.hear("Take the mug.")
    home.see(HOME)
    assert home.hear("Put the mug on the table.") == Question("AMBIGUOUS", QUESTION)


def test_it_is_what_was_named_before_it_was_seen(home: Home) -> None:
    home.see(UNSEEN)
    home.hear("Take the red mug.")
    assert home.argument("Bring it to the kitchen.", "theme").referents == ()
    home.see(TAKEN)
    assert home.argument("Bring it to the kitchen.", "theme").referents == ("mug_1",)
    assert home.argument("Put the mug on the table.", "theme").referents == ("mug_1",)


@pytest.mark.parametrize("said", ["Take the mug on the table.", "Take my mug."])
def test_it_stays_the_same_thing_wherever_it_is_by_now(said: str, home: Home) -> None:
    home.see(UNSEEN)
    home.hear(said)
    for holder in ("robot", "anna"):
        home.see(TAKEN.replace("held_by: robot", f"held_by: {holder}"))
        assert home.argument("Bring it to the kitchen.", "theme").referents == ("mug_1",)


def test_my_things_are_those_of_nobody_else(home: Home) -> None:
    assert home.argument("Take my box.", "theme").referents == ("box_1",)
    home.see(HOME.replace("box_1: {in: office}", "box_1: {in: office, of: anna}"))
    assert home.hear("Take my box.") == Question("AMBIGUOUS", "Who are you? I know the box of Anna.")


def test_without_a_world_words_remain_words(knowledge: Knowledge) -> None:
    argument = Home(knowledge, World()).argument("Take the mug.", "theme")
    assert (argument.referents, argument.world_version) == ((), "")
