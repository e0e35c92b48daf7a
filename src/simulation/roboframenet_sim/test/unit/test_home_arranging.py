"""A home is arranged for a test, and starts anew."""

import pytest
from home_for_tests import make_home

from roboframenet_sim.home_actions import Action
from roboframenet_sim.home_arranging import ArrangementError, arranged


def test_things_and_persons_are_where_they_are_wanted():
    home = make_home()
    wishes = {"apple": "on desk", "banana": "on desk", "milk": "in cupboard", "bob": "at sofa sitting"}
    state = arranged(home.plan, home.floor, home.state, wishes)
    assert [(state.places[one].relation, state.places[one].holder) for one in ("apple", "milk")] == [
        ("on", "desk"),
        ("in", "cupboard"),
    ]
    assert home.plan.position(state, "apple") != home.plan.position(state, "banana")
    assert home.plan.room_at(home.plan.position(state, "bob")) == "living_room"
    assert state.people["bob"].posture == "sitting"


@pytest.mark.parametrize(
    "wish", [("moon", "on desk"), ("apple", "on moon"), ("bob", "on sofa"), ("apple", "on desk now 1")]
)
def test_a_wish_that_makes_no_sense_is_refused(wish):
    home = make_home()
    with pytest.raises(ArrangementError, match=wish[0]):
        arranged(home.plan, home.floor, home.state, dict([wish]))


def test_a_home_starts_anew_while_something_runs():
    home = make_home()
    begin = home.state
    assert home.begin(Action("go", goal="bedroom")) is None
    home.step(5.0)
    home.start_anew(begin)
    assert not home.is_busy
    assert [one.is_preempted for one in home.outcomes()] == [True]
    assert home.state.robot.pose == begin.robot.pose
    assert home.state.time_s == pytest.approx(5.0)
    home.step(1.0)
    assert home.state.places == begin.places


def test_a_walk_ends_whatever_rounding_leaves_of_it():
    home = make_home(seed=11)
    home.start_anew(arranged(home.plan, home.floor, home.state, {"bob": "at counter", "anna": "at bedroom"}))
    home.step(32.65)
    assert home.tell_person("bob", "walk", "living_room") is None
    for _ in range(600):
        home.step(0.05)
    assert home.plan.room_at(home.plan.position(home.state, "bob")) == "living_room"
