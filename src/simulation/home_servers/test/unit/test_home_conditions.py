"""Conditions of a home: what the robot sees, has seen, was told, and does not know."""

from types import SimpleNamespace
from typing import Any

import pytest

from home_servers.conditions import CannotTell, Conditions, Sight
from home_servers.memory import Known, Memory
from typed_arguments import TypedArgument


@pytest.fixture
def memory() -> Memory:
    found = Memory()
    found.update(
        [
            Known("kitchen", "room", ("kitchen",), room="kitchen", stamp_s=-1.0),
            Known("office", "room", ("office",), room="office", stamp_s=-1.0),
            Known("office_door", "door", ("office door",), "door", stamp_s=5.0, states=("open",), x_m=2.0),
            Known("front_door", "door", ("front door",), "door", stamp_s=-1.0, x_m=9.0),
            Known("stove", "furniture", ("stove",), stamp_s=5.0, states=("on", "dirty"), room="kitchen"),
            Known("table", "furniture", ("table",), stamp_s=-1.0, room="kitchen"),
            Known("mug", "thing", ("mug",), "mug", relation="on", holder="table", room="kitchen", stamp_s=5.0),
            Known("key", "thing", ("key",), "key", relation="held", holder="anna", room="kitchen", stamp_s=5.0),
            Known("anna", "person", ("Anna",), room="kitchen", stamp_s=5.0, states=("standing",)),
        ]
    )
    return found


IN_KITCHEN = Sight(frozenset(["anna", "mug"]), frozenset(["mug"]), "kitchen")
IN_OFFICE = Sight(room="office")


class Filled(SimpleNamespace):
    """A frame with texts."""

    def __getitem__(self, element: str) -> TypedArgument:
        found = self.arguments.get(element, TypedArgument(element))
        return found if isinstance(found, TypedArgument) else TypedArgument(element, found)


def holds(memory: Memory, sight: Sight, frame: str, **arguments: Any) -> bool:
    return Conditions(memory, sight, speaker="anna").holds(Filled(name=f"condition_of_{frame}", arguments=arguments))


@pytest.mark.parametrize(
    "phenomenon, sight, expected",
    [
        ("Anna", IN_KITCHEN, True),
        ("me", IN_KITCHEN, True),
        ("somebody", IN_KITCHEN, True),
        ("the mug", IN_KITCHEN, True),
        ("Anna", IN_OFFICE, False),
        ("somebody", IN_OFFICE, False),
        ("a unicorn", IN_KITCHEN, False),
    ],
)
def test_sees_only_what_is_in_sight(memory: Memory, phenomenon: str, sight: Sight, expected: bool) -> None:
    assert holds(memory, sight, "perceiving", perceiver="you", phenomenon=phenomenon) is expected


def test_sees_in_a_place_and_not_for_others(memory: Memory) -> None:
    seeing = {"perceiver": "you", "phenomenon": "Anna"}
    assert holds(memory, IN_KITCHEN, "perceiving", **seeing, location="the kitchen") is True
    assert holds(memory, IN_KITCHEN, "perceiving", **seeing, location="the office") is False
    with pytest.raises(CannotTell, match="what Bob can see"):
        holds(memory, IN_KITCHEN, "perceiving", perceiver="Bob", phenomenon="Anna")


@pytest.mark.parametrize(
    "theme, location, expected",
    [
        ("Anna", "the kitchen", True),
        ("Anna", "the office", False),
        ("the mug", "the table", True),
        ("you", "the office", True),
        ("you", "the kitchen", False),
    ],
)
def test_places_are_those_that_were_seen(memory: Memory, theme: str, location: str, expected: bool) -> None:
    assert holds(memory, IN_OFFICE, "place", theme=theme, location=location) is expected


def test_place_may_be_told_and_is_not_guessed(memory: Memory) -> None:
    with pytest.raises(CannotTell, match="I have not seen the newspaper"):
        holds(memory, IN_OFFICE, "place", theme="the newspaper", location="the kitchen")
    memory.tell("newspaper", "office")
    assert holds(memory, IN_OFFICE, "place", theme="the newspaper", location="the office") is True
    with pytest.raises(CannotTell, match="I do not know where the attic is"):
        holds(memory, IN_OFFICE, "place", theme="Anna", location="the attic")


def test_coming_and_leaving(memory: Memory) -> None:
    assert holds(memory, IN_KITCHEN, "arriving", theme="Anna") is True
    assert holds(memory, IN_KITCHEN, "arriving", theme="Anna", goal="the office") is False
    # What was seen before is no arrival.
    assert holds(memory, Sight(room="kitchen"), "arriving", theme="Anna") is False
    assert holds(memory, IN_OFFICE, "arriving", theme="you", goal="the office") is True
    assert holds(memory, IN_KITCHEN, "departing", theme="Anna", source="the kitchen") is False
    assert holds(memory, IN_KITCHEN, "departing", theme="Anna", source="the office") is True
    assert holds(memory, IN_OFFICE, "departing", theme="you", source="the kitchen") is True
    with pytest.raises(CannotTell, match="I have not seen Bob"):
        holds(memory, IN_OFFICE, "departing", theme="Bob", source="the kitchen")


@pytest.mark.parametrize(
    "theme, state, expected",
    [
        ("the office door", "open", True),
        ("the office door", "shut", False),
        ("the door", "closed", False),
        ("the stove", "on", True),
        ("the stove", "running", True),
        ("the stove", "clean", False),
        ("the stove", "dry", True),
        ("Anna", "standing", True),
    ],
)
def test_states_are_those_that_were_seen(memory: Memory, theme: str, state: str, expected: bool) -> None:
    assert holds(memory, IN_OFFICE, "state", theme=theme, state=state) is expected


@pytest.mark.parametrize(
    "theme, state, reason",
    [
        ("the front door", "open", "I have not seen the front door"),
        ("the stove", "hot", 'cannot see whether the stove is "hot"'),
        ("the stove", "open", "the stove does not show whether it is open"),
        ("the window", "open", "I know of no window"),
    ],
)
def test_state_that_is_not_known_is_not_guessed(memory: Memory, theme: str, state: str, reason: str) -> None:
    with pytest.raises(CannotTell, match=reason):
        holds(memory, IN_OFFICE, "state", theme=theme, state=state)


def test_one_or_all_of_several(memory: Memory) -> None:
    memory.update([Known("front_door", "door", ("front door",), "door", stamp_s=6.0, states=("closed",), x_m=9.0)])
    a_door = TypedArgument("theme", "a door", head="door", quantifier="a")
    all_doors = TypedArgument("theme", "all doors", head="doors", lemma="door", quantifier="all", is_plural=True)
    assert holds(memory, IN_OFFICE, "state", theme=a_door, state="closed") is True
    assert holds(memory, IN_OFFICE, "state", theme=all_doors, state="closed") is False


def test_who_holds_something(memory: Memory) -> None:
    assert holds(memory, IN_KITCHEN, "possession", owner="you", possession="the mug") is True
    assert holds(memory, IN_KITCHEN, "possession", owner="you", possession="the key") is False
    assert holds(memory, IN_KITCHEN, "possession", owner="Anna", possession="the key") is True
    with pytest.raises(CannotTell, match="I have not seen Bob"):
        holds(memory, IN_KITCHEN, "possession", owner="Bob", possession="the key")


def test_presence(memory: Memory) -> None:
    assert holds(memory, IN_KITCHEN, "presence", theme="somebody") is True
    assert holds(memory, IN_OFFICE, "presence", theme="somebody") is False


@pytest.mark.parametrize("stove, runs", [("on", True), ("off", False)])
def test_what_runs_has_started_and_not_ended(memory: Memory, stove: str, runs: bool) -> None:
    memory.update([Known("radio", "furniture", ("radio", "music"), stamp_s=5.0, states=(stove,))])
    assert holds(memory, IN_OFFICE, "starting", activity="the music") is runs
    assert holds(memory, IN_OFFICE, "ending", activity="the music") is not runs


@pytest.mark.parametrize("activity", ["the meeting", "the table", ""])
def test_what_does_not_run_neither_starts_nor_ends(memory: Memory, activity: str) -> None:
    for frame in ("starting", "ending"):
        with pytest.raises(CannotTell):
            holds(memory, IN_OFFICE, frame, activity=activity)


def test_as_many_as_were_said(memory: Memory) -> None:
    three = TypedArgument("theme", "three people", head="people", lemma="person", count=3, is_plural=True)
    one = TypedArgument("theme", "one person", head="person", lemma="person", count=1)
    assert holds(memory, IN_KITCHEN, "place", theme=one, location="the kitchen") is True
    assert holds(memory, IN_KITCHEN, "place", theme=three, location="the kitchen") is False
    assert holds(memory, IN_KITCHEN, "presence", theme=three) is False


@pytest.mark.parametrize(("quantifier", "holds_of"), [("", True), ("any", True), ("the", False), ("all", False)])
def test_a_bare_plural_is_of_some(memory: Memory, quantifier: str, holds_of: bool) -> None:
    lamps = ("on", "off")
    memory.update([Known(f"lamp_{one}", "furniture", ("lamp",), stamp_s=5.0, states=(one,)) for one in lamps])
    theme = TypedArgument("theme", "lamps", head="lamps", lemma="lamp", quantifier=quantifier, is_plural=True)
    assert holds(memory, IN_OFFICE, "state", theme=theme, state="on") is holds_of
