"""A skill that is preempted at any moment leaves a home whose rules hold, and a robot that can act."""

import contextlib

import pytest
from direct_body import DirectBody
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from shared_home import make_home
from test_skills import phrase

from home_servers.body import CannotDo, Interrupted
from home_servers.frames import FRAMES
from home_servers.skills import Skills
from roboframenet_sim.home_state import ROBOT, Faults
from typed_arguments import FilledFrame

THINGS = ("the apple", "the milk", "the newspaper", "the keys", "the bowl", "the towel")
PLACES = ("the desk", "the cupboard", "the sofa", "the fridge", "the bathtub")
#: Frames, and what their elements may be.
COMMANDS = st.one_of(
    st.tuples(st.just("taking"), st.fixed_dictionaries({"theme": st.sampled_from(THINGS)})),
    st.tuples(
        st.just("placing"),
        st.fixed_dictionaries({"theme": st.sampled_from(THINGS), "goal": st.sampled_from(PLACES)}),
    ),
    st.tuples(
        st.just("giving"),
        st.fixed_dictionaries({"theme": st.sampled_from(THINGS), "recipient": st.sampled_from(("Bob", "Anna"))}),
    ),
    st.tuples(
        st.just("opening"), st.fixed_dictionaries({"container_portal": st.sampled_from(("the fridge", "the door"))})
    ),
    st.tuples(
        st.just("navigating_to_location"), st.fixed_dictionaries({"goal": st.sampled_from(("the bathroom", "Bob"))})
    ),
)


def filled(command):
    name, elements = command
    return FilledFrame(name, tuple(phrase(text, name=element) for element, text in elements.items()))


def check(home):
    """Each thing is in one place that there is, hands hold what they can, and nothing goes on."""
    plan, state = home.plan, home.state
    assert set(state.places) == {thing.id for thing in plan.of_kind("thing")}
    for thing, place in state.places.items():
        assert place.holder == ROBOT or place.holder in plan.entities
        assert plan.room_at(plan.position(state, thing))
    assert len(state.held_by(ROBOT)) <= plan.robot.hands
    assert not home.is_busy


@pytest.mark.parametrize("slip", [0.0, 0.2])
@settings(max_examples=6, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck))
@given(command=COMMANDS, most_s=st.floats(0.5, 150.0))
def test_preempted_skills_leave_a_consistent_home(slip, command, most_s):
    home = make_home(seed=1, faults=Faults(slip=slip, blocked_door=slip))
    with contextlib.suppress(CannotDo, Interrupted):
        FRAMES[command[0]](Skills(DirectBody(home, most_s=most_s), speaker="alice"), filled(command))
    check(home)
    # The robot goes on with another command.
    held = home.state.held_by(ROBOT)
    body = DirectBody(home)
    Skills(body, speaker="alice").go("hall")
    assert home.plan.room_at(body.place()) == "hall"
    assert home.state.held_by(ROBOT) == held
    check(home)
