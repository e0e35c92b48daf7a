"""Whatever happens in the home, its rules hold: seeded sequences of actions, persons, faults and preemptions."""

import math
import random
import time

import pytest
from home_for_tests import make_home

from roboframenet_sim.home_actions import Action, can_reach
from roboframenet_sim.home_engine import Home
from roboframenet_sim.home_rules import RULES, TREATMENTS
from roboframenet_sim.home_state import ROBOT, Faults

ORDERS = ("stand", "sit", "walk", "follow", "take", "put")


def check_consistency(home):
    """Nothing vanishes, nothing is in two places or in itself, hands hold what they can, everybody is on the floor."""
    plan, state = home.plan, home.state
    things = {thing.id for thing in plan.of_kind("thing")}
    assert set(state.places) == things
    for thing, place in state.places.items():
        assert place.holder == ROBOT or place.holder in plan.entities, thing
        chain = [thing, *(one.holder for one in plan.holders(state, thing))]
        assert len(chain) == len(set(chain)), chain
        assert plan.room_at(plan.position(state, thing)), (thing, place)
        if place.relation == "on":
            holder = plan.entities[place.holder]
            assert holder.kind == "room" or "surface" in holder.traits, (thing, place)
    assert len(state.held_by(ROBOT)) <= plan.robot.hands
    assert set(state.people) == {person.id for person in plan.of_kind("person")}
    for person in state.people:
        assert len(state.held_by(person)) <= 2
        assert plan.room_at(plan.position(state, person)), person
    assert plan.room_at(plan.position(state, ROBOT))


def random_action(home, draw):
    """Something to do; what is near is preferred, so that much of it succeeds."""
    entities = list(home.plan.entities)
    near = list(home.floor.visible(home.state)) or entities
    within_reach = [one for one in near if can_reach(home.scene, one) is None]
    held = list(home.state.held_by(ROBOT))
    kind = draw.choice(["go", "go", "grasp", "grasp", "grasp", "put", "put", "give", "open", "open", *RULES])
    theme = draw.choice(within_reach or near if draw.random() < 0.8 else entities)
    if kind in ("put", "give", "throw", "pour") and held:
        theme = draw.choice(held)
    return Action(
        kind,
        theme=theme,
        goal=draw.choice(near if draw.random() < 0.7 else entities),
        relation=draw.choice(["on", "in", "beside", "under"]),
        value=draw.choice(["on", "off", "up", *TREATMENTS]),
        amount=draw.choice([math.nan, 0.2, 0.8]),
    )


def without_time(state):
    """What must not change without an action."""
    return state.places, state.properties, state.robot.lift_m, state.robot.arm


@pytest.mark.parametrize("seed", range(4))
def test_rules_hold_in_random_sequences(seed):
    draw = random.Random(seed)
    home = make_home(seed=seed, faults=Faults(slip=0.1, blocked_door=0.1))
    for door in home.plan.of_kind("door"):
        if draw.random() < 0.7:
            home.change(reason="test", **{door.id: {"is_open": True}})
    done = set()
    for _ in range(120):
        action = random_action(home, draw)
        before = home.state
        failure = home.begin(action)
        if failure is not None:
            assert failure.sentence[0].isupper() and failure.sentence.endswith(".")
            assert home.state == before
            continue
        if draw.random() < 0.2:
            person = draw.choice(list(home.state.people))
            home.tell_person(person, draw.choice(ORDERS), draw.choice([*home.plan.entities, ROBOT]))
        for _ in range(draw.randint(1, 300)):
            home.step(0.1)
            if not home.is_busy:
                break
        home.preempt()
        check_consistency(home)
        (outcome,) = home.outcomes()
        if outcome.is_done:
            done.add(action.kind)
    assert "go" in done and len(done) >= 5


@pytest.mark.parametrize("kind", ["grasp", "put", "give", "open", "throw", "pour", "push", "treat", "go"])
def test_preemption_at_every_step_leaves_all_or_nothing(kind):
    def ready():
        home = make_home()
        if kind == "push":
            home.perform(Action("go", goal="chair"))
            return home, Action("push", theme="chair")
        home.perform(Action("go", goal="water_bottle"))
        if kind == "grasp":
            return home, Action("grasp", theme="water_bottle")
        home.perform(Action("grasp", theme="water_bottle"))
        if kind == "put":
            return home, Action("put", theme="water_bottle", goal="coffee_table", relation="on")
        if kind == "give":
            home.perform(Action("go", goal="anna"))
            return home, Action("give", theme="water_bottle", goal="anna")
        if kind == "throw":
            return home, Action("throw", theme="water_bottle")
        if kind == "pour":
            return home, Action("pour", theme="water_bottle", goal="vase")
        if kind == "go":
            return home, Action("go", goal="kitchen_table")
        home.perform(Action("go", goal="drawer"))
        if kind == "treat":
            home.perform(Action("open", theme="drawer"))
            home.perform(Action("put", theme="water_bottle", goal="counter", relation="on"))
            home.perform(Action("go", goal="knife"))
            home.perform(Action("grasp", theme="knife"))
            home.perform(Action("go", goal="apple"))
            return home, Action("treat", theme="apple", value="peel")
        return home, Action("open", theme="drawer")

    whole, action = ready()
    begin = whole.state
    before = without_time(begin)
    assert whole.perform(action).is_done
    after = without_time(whole.state)
    steps = 0
    seen = set()
    while True:
        # A state is a value: the home goes on from it.
        home = Home(whole.plan, begin)
        assert home.begin(action) is None
        for _ in range(steps):
            home.step(0.1)
        is_over = not home.is_busy
        home.preempt()
        now = without_time(home.state)
        assert now in (before, after)
        seen.add(now == after)
        check_consistency(home)
        if is_over:
            break
        # A robot that can be preempted can act again.
        assert home.begin(Action("look")) is None
        steps += 3 if kind != "go" else 25
    assert seen == ({True} if kind == "go" else {False, True})


def test_same_seed_same_home():
    def run(seed):
        home = make_home(seed=seed, faults=Faults(slip=0.5))
        home.perform(Action("go", goal="spoon"))
        codes = [str(home.perform(Action("grasp", theme="spoon")).failure) for _ in range(3)]
        home.step(1000.0)
        return codes, home.state

    assert run(3) == run(3)


def test_nothing_changes_without_an_action():
    home = make_home()
    before = without_time(home.state)
    home.step(100.0)
    assert without_time(home.state) == before


def test_nothing_is_perceived_beyond_range_sight_and_view():
    draw = random.Random(1)
    home = make_home()
    limits = home.plan.robot
    for _ in range(40):
        home.perform(Action("go", goal=draw.choice(list(home.plan.entities))))
        if draw.random() < 0.5:
            home.perform(Action("look"))
        state = home.state
        x_m, y_m = home.plan.position(state, ROBOT)
        for ident in home.floor.visible(state):
            entity = home.plan.entities[ident]
            if entity.kind == "room":
                assert entity.contains((x_m, y_m))
                continue
            end = home.plan.position(state, ident)
            most_m = limits.sight_m if entity.kind == "thing" else limits.person_sight_m
            assert math.hypot(end[0] - x_m, end[1] - y_m) <= most_m
            for place in home.plan.holders(state, ident):
                assert not home.floor.is_hidden_in(state, place.holder, place.relation)
            room = home.plan.room_at(end)
            if room != home.plan.room_at((x_m, y_m)) and entity.kind != "door":
                # Through an open door.
                assert any(
                    state.is_(door.id, "is_open") or "open" in door.traits
                    for door in home.plan.of_kind("door")
                    if home.floor.leads_through(door.id, (x_m, y_m), end)
                )


def test_speed_is_printed(capsys):
    home = make_home(seed=5)
    draw = random.Random(5)
    begin_s = time.process_time()
    while home.state.time_s < 300.0:
        home.perform(Action("go", goal=draw.choice(list(home.plan.entities))))
        home.step(1.0)
        home.floor.visible(home.state)
    busy = home.state.time_s / max(1e-9, time.process_time() - begin_s)
    begin_s = time.process_time()
    home.step(300.0)
    idle = (time.process_time() - begin_s) / 300.0
    with capsys.disabled():
        print(f"\n[home] acting: {busy:.0f} times real time on one core; idle: {100 * idle:.2f} % of a core")
    assert home.state.time_s >= 600.0
