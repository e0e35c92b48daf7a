"""What the robot can do in the home, and why not."""

import math

import pytest
from home_for_tests import make_home

from roboframenet_sim.base import Pose, Velocity
from roboframenet_sim.home_actions import Action
from roboframenet_sim.home_state import ROBOT, TURTLEBOT, Faults, Place


def do(home, kind, **values):
    outcome = home.perform(Action(kind, **values))
    assert outcome.is_done, outcome
    return home.state


def why_not(home, kind, **values):
    outcome = home.perform(Action(kind, **values))
    assert outcome.failure is not None, outcome
    return outcome.failure.code


def test_a_mug_is_brought_to_a_person():
    home = make_home()
    do(home, "go", goal="red_mug")
    do(home, "grasp", theme="red_mug")
    assert home.state.held_by(ROBOT) == ("red_mug",)
    do(home, "go", goal="bob")
    do(home, "give", theme="red_mug", goal="bob")
    assert home.state.held_by("bob") == ("red_mug",)
    assert home.state.time_s > 20.0


def test_too_far():
    assert why_not(make_home(), "grasp", theme="red_mug") == "too_far"


def test_a_wall_is_no_way_to_reach_through():
    home = make_home()
    # In the living room, with the wall between the robot and the hall table.
    home.base.pose = Pose(9.5, 6.4, -1.57)
    home.step(0.1)
    assert math.hypot(9.5 - home.state.places["letter"].x_m, 6.4 - home.state.places["letter"].y_m) < 1.1
    assert why_not(home, "grasp", theme="letter") == "too_far"


def test_closed_furniture_hides_and_keeps_its_things():
    home = make_home()
    do(home, "go", goal="fridge")
    do(home, "look")
    assert "milk" not in home.floor.visible(home.state)
    assert why_not(home, "grasp", theme="milk") == "closed"
    do(home, "open", theme="fridge")
    do(home, "look", theme="fridge")
    assert "milk" in home.floor.visible(home.state)
    do(home, "go", goal="milk")
    do(home, "grasp", theme="milk")
    do(home, "close", theme="fridge")
    assert why_not(home, "put", theme="milk", goal="fridge", relation="in") == "closed"


def test_hands_are_full():
    home = make_home()
    do(home, "go", goal="kitchen_table")
    for thing in ("apple", "spoon"):
        do(home, "go", goal=thing)
        do(home, "grasp", theme=thing)
    do(home, "go", goal="bread")
    assert why_not(home, "grasp", theme="bread") == "hands_full"
    assert why_not(home, "grasp", theme="apple") == "held"


def test_too_heavy_but_it_can_be_pushed():
    home = make_home()
    do(home, "go", goal="cart")
    assert why_not(home, "grasp", theme="cart") == "too_heavy"
    before = home.state.places["cart"]
    do(home, "push", theme="cart", amount=0.5)
    after = home.state.places["cart"]
    assert math.hypot(after.x_m - before.x_m, after.y_m - before.y_m) == pytest.approx(0.5, abs=0.2)


def test_lift_is_needed_for_what_is_high():
    home = make_home()
    do(home, "go", goal="book")
    assert why_not(home, "grasp", theme="book") == "too_high"
    do(home, "lift", amount=0.3)
    do(home, "grasp", theme="book")
    assert why_not(home, "lift", amount=3.0) == "too_high"


def test_locked():
    home = make_home()
    do(home, "go", goal="bathroom_door")
    do(home, "open", theme="bathroom_door")
    do(home, "go", goal="bathroom_cabinet")
    assert why_not(home, "open", theme="bathroom_cabinet") == "locked"
    do(home, "unlock", theme="bathroom_cabinet")
    do(home, "open", theme="bathroom_cabinet")
    assert why_not(home, "lock", theme="bathroom_cabinet") == "open"


def test_a_closed_door_is_in_the_way_and_hides():
    home = make_home()
    outcome = home.perform(Action("go", goal="bathtub"))
    assert (outcome.failure.code, outcome.failure.entity) == ("closed", "bathroom_door")
    assert outcome.failure.sentence == "The bathroom door is closed."


def test_somebody_takes_it_while_the_arm_moves():
    home = make_home()
    do(home, "go", goal="newspaper")
    assert home.tell_person("anna", "walk", "newspaper") is None
    home.step(20.0)
    assert home.begin(Action("grasp", theme="newspaper")) is None
    home.step(0.5)
    assert home.tell_person("anna", "take", "newspaper") is None
    home.step(5.0)
    (outcome,) = home.outcomes()
    assert (outcome.failure.code, outcome.failure.sentence) == ("gone", "Anna has the newspaper.")
    assert home.state.held_by("anna") == ("newspaper",)


def test_a_door_closes_while_the_robot_drives():
    home = make_home()
    assert home.begin(Action("go", goal="kitchen_table")) is None
    home.step(1.0)
    home.change(reason="test", kitchen_door={"is_open": False}, living_room_door={"is_open": False})
    home.step(60.0)
    (outcome,) = home.outcomes()
    assert outcome.failure.code == "blocked"
    assert outcome.failure.entity in ("kitchen_door", "living_room_door")
    assert home.plan.room_at(home.plan.position(home.state, ROBOT)) == "hall"


def test_treatments_need_tool_station_and_power():
    home = make_home()
    do(home, "go", goal="kitchen_table")
    assert why_not(home, "treat", theme="kitchen_table", value="wipe") == "no_tool"
    do(home, "go", goal="cloth")
    do(home, "grasp", theme="cloth")
    do(home, "go", goal="kitchen_table")
    home.change(reason="test", kitchen_table={"is_dirty": True})
    do(home, "treat", theme="kitchen_table", value="wipe")
    assert home.state.get("kitchen_table", "is_dirty") is False
    do(home, "go", goal="soup")
    assert why_not(home, "treat", theme="soup", value="boil") == "off"
    do(home, "switch", theme="stove", value="on")
    do(home, "treat", theme="soup", value="boil")
    assert home.state.get("soup", "cooked") == "boiled"
    assert why_not(home, "treat", theme="kitchen_table", value="paint") == "unknown"


def test_pour_and_throw():
    home = make_home()
    do(home, "go", goal="water_bottle")
    do(home, "grasp", theme="water_bottle")
    do(home, "go", goal="glass")
    do(home, "pour", theme="water_bottle", goal="glass")
    assert home.state.get("glass", "contents") == "water"
    assert why_not(home, "throw", theme="glass") == "not_held"
    assert why_not(home, "throw", theme="water_bottle", goal="bob") == "too_far"
    do(home, "throw", theme="water_bottle")
    assert home.state.places["water_bottle"].holder == "kitchen"


def test_people_hear_in_earshot_and_not_through_walls():
    home = make_home()
    home.change(reason="test", living_room_door={"is_open": False})
    assert home.say(ROBOT, "Hello") == ("alice",)
    assert home.state.events[-1].to == ("alice",)
    assert home.say("anna", "Hello") == ()


def test_persons_obey_rules_too():
    home = make_home()
    assert home.tell_person("bob", "take", "red_mug").code == "too_far"
    assert home.tell_person("bob", "put", "red_mug").code == "not_held"
    assert home.tell_person("carol", "sit").code == "unknown"
    assert home.tell_person("bob", "fly").code == "unknown"
    assert home.tell_person("bob", "walk", "armchair") is None
    assert home.state.people["bob"].posture == "walking"
    home.step(60.0)
    assert home.state.people["bob"].posture == "sitting"
    assert home.plan.room_at(home.plan.position(home.state, "bob")) == "living_room"
    assert home.tell_person("bob", "follow", ROBOT) is None
    do(home, "go", goal="garage")
    home.step(30.0)
    x_m, y_m = home.plan.position(home.state, "bob")
    assert math.hypot(x_m - home.state.robot.pose.x_m, y_m - home.state.robot.pose.y_m) < 1.5


def test_habits_lead_about_the_home():
    home = make_home()
    home.step(900.0)
    postures = home.state.people["anna"]
    assert postures.pose != make_home().state.people["anna"].pose


def test_base_drives_by_velocity_and_stops_at_walls():
    home = make_home()
    for _ in range(200):
        home.drive(Velocity(linear_m_per_s=0.5))
        home.step(0.1)
    assert home.state.robot.pose.x_m == home.base.pose.x_m < 14.0
    assert home.plan.room_at(home.plan.position(home.state, ROBOT)) == "hall"


def test_docking_charges():
    home = make_home()
    assert why_not(home, "dock", theme="charging_station") == "too_far"
    do(home, "go", goal="charging_station")
    do(home, "dock", theme="charging_station")
    before = home.state.robot.battery
    home.step(60.0)
    assert home.state.robot.battery > before
    do(home, "go", goal="hall")
    assert not home.state.robot.is_docked


def test_turtlebot_has_no_hand():
    home = make_home(robot=TURTLEBOT)
    do(home, "go", goal="kitchen_table")
    assert why_not(home, "grasp", theme="spoon") == "no_hand"
    assert why_not(home, "open", theme="drawer") == "no_hand"
    do(home, "look")
    do(home, "gesture", value="dance")


def test_slips():
    home = make_home(faults=Faults(slip=1.0))
    do(home, "go", goal="spoon")
    assert why_not(home, "grasp", theme="spoon") == "slipped"
    assert home.state.places["spoon"].holder == "kitchen_table"
    home.faults = Faults()
    do(home, "grasp", theme="spoon")
    home.faults = Faults(slip=1.0)
    assert why_not(home, "put", theme="spoon", goal="kitchen_table", relation="on") == "slipped"
    assert home.state.places["spoon"] == Place("on", "kitchen", *home.plan.position(home.state, ROBOT))


def test_blocked_door_is_free_again():
    home = make_home(faults=Faults(blocked_door=1.0))
    assert why_not(home, "go", goal="kitchen_table") in ("blocked", "closed")
    home.faults = Faults()
    home.step(30.0)
    do(home, "go", goal="kitchen_table")


@pytest.mark.parametrize("value", [-0.1, 1.1, math.nan])
def test_faults_are_probabilities(value):
    with pytest.raises(ValueError):
        Faults(slip=value)


def test_two_actions_at_a_time_only_with_different_parts():
    home = make_home()
    assert home.begin(Action("go", goal="kitchen_table")) is None
    assert home.begin(Action("go", goal="bedroom")).code == "busy"
    assert home.begin(Action("look")) is None
    assert home.begin(Action("gesture", value="nod")).code == "busy"
    assert home.begin(Action("fly")).code == "unknown"
    assert home.begin(Action("arm", value="extended")) is None
