"""What the robot makes sure of and checks: denials, opposites and places."""

from contextlib import nullcontext
from dataclasses import replace

import pytest
from direct_body import DirectBody
from shared_home import make_home

from home_servers.body import CannotDo
from home_servers.checking import inspect, statements, verify
from home_servers.skills import Skills
from roboframenet_sim.home_truth import truth_of
from typed_arguments import EmbeddedFrame, FilledFrame, TypedArgument

PLACE, STATE = "condition_of_place", "condition_of_state"


def phrase(text):
    return TypedArgument(text=text, quantifier="the" if text.startswith("the ") else "")


def says(name, *, is_negated=False, mood="statement", **elements):
    """A clause in an argument: each element as a text, or as a typed argument without its name."""
    phrases = {key: phrase(one) if isinstance(one, str) else one for key, one in elements.items()}
    filled = tuple(replace(one, name=key) for key, one in phrases.items())
    return EmbeddedFrame("says", name, "what is said", mood=mood, is_negated=is_negated, frame_elements=filled)


def is_at(theme, relation, place, **flags):
    return says(PLACE, theme=theme, location=TypedArgument(text=place, relation=relation), **flags)


def content(*frames):
    return TypedArgument("content", "what is said", frames=frames)


def test_only_states_and_places_are_checked():
    closed = says(STATE, theme="the door", state="closed")
    assert statements(content(closed, is_at("Anna", "in", "the kitchen"))) != ()
    assert statements(content()) == ()
    assert statements(content(closed, says("condition_of_arriving", theme="Anna"))) == ()
    assert statements(content(is_at("you", "in", "the kitchen"))) == ()
    assert statements(content(says(STATE, mood="question", theme="the door", state="closed"))) == ()


def body_with(**changes):
    home = make_home()
    home.change(reason="test", **changes)
    return home, DirectBody(home, most_s=900.0)


def verified(body, *frames):
    verify(Skills(body, speaker="alice"), FilledFrame("verifying", (content(*frames),)))


def test_nobody_is_somewhere():
    _, body = body_with()
    verified(body, is_at("somebody", "in", "the garage", is_negated=True))
    assert body.said == ["I see nobody in the garage."]


def test_somebody_is_where_nobody_shall_be():
    _, body = body_with()
    with pytest.raises(CannotDo, match=r"^I see Bob in the office\.$"):
        verified(body, is_at("somebody", "in", "the office", is_negated=True))


@pytest.mark.parametrize("is_so", [True, False])
def test_a_number_is_checked(is_so):
    _, body = body_with()
    plates = TypedArgument(text="plates", head="plates", lemma="plate", is_plural=True, count=1 if is_so else 3)
    with nullcontext() if is_so else pytest.raises(CannotDo, match="I see the plate on the kitchen table"):
        verified(body, is_at(plates, "on", "the kitchen table"))


@pytest.mark.parametrize("theme", ["the stove", "stove"])
def test_what_shall_not_be_on_is_switched_off(theme):
    home, body = body_with(stove={"is_on": True})
    verified(body, says(STATE, theme=theme, state="on", is_negated=True))
    assert truth_of(home.plan, home.state)["stove.is_on"] is False


def test_each_item_of_a_list_is_made_sure_of():
    home, body = body_with(stove={"is_on": True}, garage_door={"is_open": True})
    verified(body, says(STATE, theme="the stove", state="off"), says(STATE, theme="the garage door", state="closed"))
    truth = truth_of(home.plan, home.state)
    assert (truth["stove.is_on"], truth["garage_door.is_open"]) == (False, False)


def test_a_passage_is_no_door_that_could_be_closed():
    home, body = body_with(garage_door={"is_open": True})
    doors = TypedArgument(text="all the doors", head="doors", lemma="door", quantifier="all", is_plural=True)
    verified(body, says(STATE, theme=doors, state="closed"))
    truth = truth_of(home.plan, home.state)
    assert not [name for name in truth if name.endswith("_door.is_open") and truth[name]]


@pytest.mark.parametrize(
    "frames",
    [
        (says(STATE, theme="the table", state="red", is_negated=True),),
        (says(STATE, theme=TypedArgument(text="all doors", quantifier="all"), state="open", is_negated=True),),
        (says("condition_of_arriving", theme="somebody", goal="the kitchen", is_negated=True),),
        (),
    ],
)
def test_what_is_left_open_or_is_no_state_is_not_checked(frames):
    _, body = body_with()
    with pytest.raises(CannotDo, match='do not know how to check "what is said"'):
        verified(body, *frames)


@pytest.mark.parametrize(
    ("statement", "said"),
    [
        (is_at("somebody", "in", "the office", is_negated=True), "No, I see Bob in the office."),
        (is_at("somebody", "in", "the garage", is_negated=True), "Yes, I see nobody in the garage."),
        (says(STATE, theme="the garage door", state="open", is_negated=True), "No, the garage door is open."),
        (says(STATE, theme="the garage door", state="closed", is_negated=True), "Yes, the garage door is not closed."),
        (says(STATE, theme="the garage door", state="open"), "Yes, the garage door is open."),
        (says(STATE, theme="the garage door", state="warm"), "I cannot see whether the garage door is warm."),
    ],
)
def test_whether_something_is_so(statement, said):
    _, body = body_with()
    ground = TypedArgument("ground", "the garage door")
    state = TypedArgument("desired_state", "so", frames=(statement,))
    inspect(Skills(body, speaker="alice"), FilledFrame("inspecting", (ground, state)))
    assert body.said == [said]


def test_state_of_a_client_that_sends_only_texts():
    _, body = body_with()
    texts = (TypedArgument("ground", "the garage door"), TypedArgument("desired_state", "open"))
    inspect(Skills(body, speaker="alice"), FilledFrame("inspecting", texts))
    assert body.said == ["Yes, the garage door is open."]
