"""Rooms and doors that the robot keeps out of on its way."""

import pytest
from direct_body import DirectBody
from shared_home import make_home

from home_servers.body import CannotDo
from home_servers.going import navigate
from home_servers.skills import Skills
from roboframenet_sim.base import Pose
from roboframenet_sim.home_state import ROBOT
from typed_arguments import FilledFrame, TypedArgument

#: In the living room, nearer to the way through the hall than to the passage.
AT_THE_DOOR = (7.55, 6.35)


class Watched(DirectBody):
    """A body that remembers the rooms where the robot was."""

    def __init__(self, home):
        super().__init__(home, most_s=900.0)
        self.rooms = {self.room()}
        step = home.step

        def watched_step(duration_s):
            step(duration_s)
            self.rooms.add(home.plan.room_at(home.plan.position(home.state, ROBOT)))

        home.step = watched_step


def make(begin):
    home = make_home(robot_state={"pose": Pose(*begin)})
    body = Watched(home)
    return home, body, Skills(body, speaker="alice")


def go(skills, goal, avoided):
    said = [TypedArgument("goal", goal, head=goal, lemma=goal), TypedArgument("avoided", avoided)]
    navigate(skills, FilledFrame("navigating_to_location", tuple(one for one in said if one.text)))


@pytest.mark.parametrize(
    ("goal", "avoided", "ways"),
    [
        ("counter", "", {"living_room", "hall", "kitchen"}),
        ("counter", "the hall", {"living_room", "kitchen"}),
        ("bin", "", {"living_room", "kitchen"}),
        ("bin", "the passage", {"living_room", "hall", "kitchen"}),
        ("counter", "the living room door", {"living_room", "kitchen"}),
    ],
)
def test_way_leads_around_what_is_to_be_avoided(goal, avoided, ways):
    _, body, skills = make(AT_THE_DOOR)
    go(skills, goal, avoided)
    assert body.rooms - {""} == ways


@pytest.mark.parametrize(
    ("goal", "avoided", "reason"),
    [
        ("office", "the hall", "I know no way there that avoids the hall."),
        ("office", "the office", "I cannot go to the office: that is where I shall not go."),
        ("desk", "the office", "I cannot go to the desk: that is where I shall not go."),
        ("kitchen", "the living room", "I cannot keep out of the living room: I am there."),
        ("kitchen", "the sofa", "I can keep out of rooms and doors that I know, but not of the sofa."),
    ],
)
def test_robot_stands_and_says_why_it_cannot(goal, avoided, reason):
    home, _, skills = make(AT_THE_DOOR)
    begin = home.state.robot.pose
    with pytest.raises(CannotDo) as refusal:
        go(skills, goal, avoided)
    assert str(refusal.value) == reason
    assert home.state.robot.pose == begin


def test_door_behind_what_is_to_be_avoided_is_not_closed():
    home, body, skills = make(AT_THE_DOOR)
    body.memory.opened["living_room_door"] = "living_room"
    go(skills, "kitchen", "the hall")
    assert "hall" not in body.rooms
    assert home.state.is_("living_room_door", "is_open")
