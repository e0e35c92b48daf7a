"""What a robot sees depends on nothing that it is not asked for: nothing is looked at again while this stays."""

from dataclasses import replace

from home_for_tests import make_home

from roboframenet_sim.base import Pose


def test_time_and_charge_change_no_sight() -> None:
    one = make_home()
    state = one.state
    later = replace(state, time_s=state.time_s + 60.0, robot=replace(state.robot, battery=0.1))
    assert one.floor.sight_of(later) == one.floor.sight_of(state)
    assert one.floor.visible(later) == one.floor.visible(state)


def test_what_moves_opens_or_turns_changes_the_sight() -> None:
    one = make_home()
    state, sight_of = one.state, one.floor.sight_of
    pose = state.robot.pose
    thing, person = next(iter(state.places)), next(iter(state.people))
    others = (
        state.with_robot(pose=Pose(pose.x_m, pose.y_m, pose.yaw_rad + 0.5)),
        state.with_robot(looks_at=thing),
        state.with_robot(scanned_s=state.time_s),
        state.with_property("fridge", is_open=not state.is_("fridge", "is_open")),
        state.with_person(person, posture="lying"),
        state.with_place(thing, replace(state.places[thing], x_m=state.places[thing].x_m + 0.5)),
    )
    assert [sight_of(other) == sight_of(state) for other in others] == [False] * len(others)


def test_a_look_all_round_ends() -> None:
    one = make_home()
    around = one.state.with_robot(scanned_s=one.state.time_s)
    assert one.floor.sight_of(around) != one.floor.sight_of(replace(around, time_s=around.time_s + 2.0))
