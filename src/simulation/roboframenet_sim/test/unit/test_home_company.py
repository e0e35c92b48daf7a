"""Two robots in one home: what one changes is so for the other, and each finds the other there."""

import math

import pytest
from home_for_tests import make_home

from roboframenet_sim.base import Pose
from roboframenet_sim.home_actions import Action
from roboframenet_sim.home_company import Company, Member
from roboframenet_sim.home_state import PR2, ROBOT, TURTLEBOT

STEP_S = 0.1


@pytest.fixture
def company():
    home = make_home()
    pose = home.state.robot.pose
    start = Pose(pose.x_m + 1.5, pose.y_m, pose.yaw_rad)
    members = [Member("pr2", "PR2", PR2), Member("turtlebot", "Turtlebot", TURTLEBOT, start)]
    return Company(home.plan, home.state, members)


def begin(company, name, action):
    with company.acting(name) as home:
        return home.begin(action)


def perform(company, *actions, most_s=120.0):
    """Let robots act at the same time; returns the outcomes by robot."""
    for name, action in actions:
        assert begin(company, name, action) is None, action
    found = {}
    for _ in range(round(most_s / STEP_S)):
        company.step(STEP_S)
        for name, _ in actions:
            for outcome in company.homes[name].outcomes():
                found[name] = outcome
        if len(found) == len(actions):
            break
    return found


def room(company, name):
    home = company.homes[name]
    return home.plan.room_at(home.plan.position(home.state, ROBOT))


def test_both_drive_at_the_same_time(company):
    ends = perform(company, ("pr2", Action("go", goal="kitchen")), ("turtlebot", Action("go", goal="bedroom")))
    assert all(outcome.is_done for outcome in ends.values()), ends
    assert (room(company, "pr2"), room(company, "turtlebot")) == ("kitchen", "bedroom")


def test_what_one_takes_the_other_cannot_find(company):
    perform(company, ("pr2", Action("go", goal="hall_table")))
    assert perform(company, ("pr2", Action("grasp", theme="letter")))["pr2"].is_done
    company.step(STEP_S)
    assert company.homes["pr2"].state.held_by(ROBOT) == ("letter",)
    other = company.homes["turtlebot"].state
    assert (other.held_by(ROBOT), other.held_by("pr2")) == ((), ("letter",))


def test_what_one_changes_stays_changed(company):
    perform(company, ("pr2", Action("go", goal="hall_light")))
    assert perform(company, ("pr2", Action("switch", theme="hall_light", value="on")))["pr2"].is_done
    perform(company, ("turtlebot", Action("go", goal="office")))
    assert all(home.state.is_("hall_light", "is_on") for home in company.homes.values())


def test_each_sees_the_other_where_it_is(company):
    perform(company, ("pr2", Action("look")))
    pr2, turtlebot = company.homes["pr2"], company.homes["turtlebot"]
    assert "turtlebot" in pr2.floor.visible(pr2.state)
    assert pr2.plan.position(pr2.state, "turtlebot") == turtlebot.plan.position(turtlebot.state, ROBOT)
    assert perform(company, ("pr2", Action("go", goal="turtlebot")))["pr2"].is_done
    assert math.dist(pr2.plan.position(pr2.state, "turtlebot"), pr2.plan.position(pr2.state, ROBOT)) < 1.1


def test_a_robot_without_hands_takes_nothing(company):
    perform(company, ("turtlebot", Action("go", goal="hall_table")))
    assert begin(company, "turtlebot", Action("grasp", theme="letter")).code == "no_hand"


def test_persons_and_robots_hear_what_one_says(company):
    with company.acting("turtlebot") as home:
        heard = home.say(ROBOT, "Hello, Alice.")
    assert {"alice", "pr2"} <= set(heard)
    company.step(STEP_S)
    assert [(one.who, ROBOT in one.to) for one in company.homes["pr2"].state.events] == [("turtlebot", True)]
    assert [one.who for one in company.homes["turtlebot"].state.events] == [ROBOT]


def test_who_is_asked_by_one_follows_that_one(company):
    with company.acting("turtlebot") as home:
        home.say(ROBOT, "Alice, please follow me.")
    perform(company, ("turtlebot", Action("go", goal="office")))
    for _ in range(300):
        company.step(STEP_S)
    home = company.homes["turtlebot"]
    assert home.plan.room_at(home.plan.position(home.state, "alice")) == "office"
    assert (home.state.people["alice"].follows, company.homes["pr2"].state.people["alice"].follows) == (
        ROBOT,
        "turtlebot",
    )


def test_nobody_orders_a_robot_like_a_person(company):
    with company.acting("pr2") as home:
        assert home.tell_person("turtlebot", "walk", "kitchen").code == "unknown"


def test_an_only_robot_is_in_a_home_as_ever():
    alone = make_home(seed=5)
    company = Company(alone.plan, alone.state, [Member(ROBOT, "PR2", PR2)], seed=5)
    home = company.homes[ROBOT]
    for action in (Action("go", goal="hall_table"), Action("grasp", theme="letter"), Action("go", goal="kitchen")):
        expected = alone.perform(action, step_s=STEP_S)
        assert perform(company, (ROBOT, action))[ROBOT].failure == expected.failure
    assert home.state.places == alone.state.places
    assert home.state.robot.pose == alone.state.robot.pose
