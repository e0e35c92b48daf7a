"""Finding what words mean, looking for it, and putting right what fails."""

import pytest
from direct_body import DirectBody
from shared_home import make_home

from home_servers.body import CannotDo, Interrupted
from home_servers.frames import FRAMES
from home_servers.going import follow, move_along
from home_servers.handling import put
from home_servers.memory import Known, Memory
from home_servers.skills import Skills
from roboframenet_sim.home_state import NO_FAULTS, PR2, ROBOT, TURTLEBOT, Faults
from roboframenet_sim.home_truth import truth_of
from typed_arguments import EmbeddedFrame, FilledFrame, Modifier, TypedArgument


def make(*, robot=PR2, faults=NO_FAULTS, seed=0, most_s=900.0):
    home = make_home(robot=robot, seed=seed, faults=faults)
    body = DirectBody(home, most_s=most_s)
    return home, body, Skills(body, speaker="alice")


def phrase(text, *, head="", **values):
    head = head or text.split()[-1]
    return TypedArgument(text=text, head=head, lemma=head, **values)


def test_memory_keeps_what_is_newer():
    memory = Memory()
    memory.update([Known("mug", "thing", ("mug",), relation="on", holder="table", stamp_s=2.0)])
    memory.update([Known("mug", "thing", ("mug",), relation="on", holder="desk", stamp_s=1.0)])
    assert memory.get("mug").holder == "table"
    memory.forget_place("mug")
    assert memory.get("mug").relation == ""


@pytest.mark.parametrize(
    "owner, what, found",
    [
        ("the desk", "drawer", ["desk_drawer"]),
        ("the kitchen", "drawer", ["drawer"]),
        ("the hall table", "drawer", []),
        ("the kitchen", "door", ["kitchen_door"]),
        ("Anna", "drawer", ["drawer", "desk_drawer"]),
    ],
)
def test_the_part_of_a_piece_of_furniture_is_no_other_one(owner, what, found):
    _, body, _ = make()
    said = phrase(f"{owner}'s {what}", possessor=phrase(owner))
    assert [one.id for one in body.memory.find(said, "furniture", "door")] == found


def test_modifiers_tell_things_apart():
    memory = Memory()
    memory.update(
        [
            Known("mug_1", "thing", ("mug",), attributes=("red",), relation="on"),
            Known("mug_2", "thing", ("mug",), attributes=("blue",), relation="on"),
        ]
    )
    blue = phrase("the blue mug", modifiers=(Modifier("adjective", "blue", "blue"),))
    green = phrase("the green mug", modifiers=(Modifier("adjective", "green", "green"),))
    assert [one.id for one in memory.find(blue)] == ["mug_2"]
    assert memory.find(green) == []
    assert [one.id for one in memory.find(phrase("the mug", referents=("mug_2",)))] == ["mug_2"]


def test_robot_knows_only_the_map_and_what_it_saw():
    home, body, _ = make()
    known = {one.id for one in body.memory.all("thing")}
    assert known == {one for one in home.floor.visible(home.state) if home.plan.entities[one].kind == "thing"}
    assert body.memory.get("fridge").states == ()
    assert len(body.memory.all("room")) == 8


def test_it_goes_looking():
    home, body, skills = make()
    assert body.memory.find(phrase("the teddy")) == []
    assert skills.find(phrase("the teddy"), "thing").id == "teddy"
    assert home.plan.room_at(body.place()) == "bedroom"


def test_what_is_not_there_is_not_found():
    _, _, skills = make()
    with pytest.raises(CannotDo, match=r"^I have not seen the trumpet\.$"):
        skills.find(phrase("the trumpet"), "thing")


@pytest.mark.parametrize(
    ("relation", "place"), [("behind", "you"), ("on", "your left"), ("on", "the right"), ("next_to", "me")]
)
def test_what_only_a_side_of_somebody_tells_is_refused(relation, place):
    _, _, skills = make()
    side = f"{relation.replace('_', ' ')} {place}"
    location = EmbeddedFrame(
        role="place",
        frame_name="being_located",
        words=side,
        frame_elements=(phrase(place, name="location", relation=relation),),
    )
    with pytest.raises(CannotDo, match=f'what is meant by "{side}"'):
        skills.find(phrase(f"the table {side}", head="table", frames=(location,)), "furniture")
    assert skills.find(phrase("the table"), "furniture").id == "kitchen_table"


def test_along_the_room_where_it_is_the_robot_drives_to_the_end():
    _, body, skills = make()
    begin = body.place()
    move_along(skills, FilledFrame("moving_along_path", (phrase("the hall", name="path", relation="along"),)))
    assert body.room() == "hall"
    assert abs(body.place()[0] - begin[0]) > 3.0


def test_a_way_past_furniture_is_refused():
    _, _, skills = make()
    with pytest.raises(CannotDo, match="past or along the sofa"):
        move_along(skills, FilledFrame("moving_along_path", (phrase("the sofa", name="path"),)))


def test_what_was_told_is_looked_at_first():
    home, body, skills = make()
    body.memory.tell("pen", "desk_drawer")
    assert skills.find(phrase("the pen"), "thing").holder == "desk_drawer"
    assert home.state.time_s < 60.0
    skills.tidy()
    assert not home.state.is_("desk_drawer", "is_open")


def test_a_thing_that_was_taken_is_noticed():
    home, body, skills = make()
    newspaper = skills.find(phrase("the newspaper"), "thing")
    home.tell_person("anna", "walk", "newspaper")
    home.step(30.0)
    home.tell_person("anna", "take", "newspaper")
    home.tell_person("anna", "walk", "garage")
    home.step(60.0)
    with pytest.raises(CannotDo, match="Anna has the newspaper"):
        skills.take(newspaper)
    assert body.held() == ()


@pytest.mark.parametrize("seed", range(3))
def test_slips_and_blocked_doors_are_overcome_or_told(seed):
    home, _, skills = make(faults=Faults(slip=0.2, blocked_door=0.2), seed=seed)
    try:
        skills.take(skills.find(phrase("the newspaper"), "thing"))
        assert home.state.held_by(ROBOT) == ("newspaper",)
    except CannotDo as reason:
        assert str(reason).endswith(".")
        assert "newspaper" not in home.state.held_by(ROBOT)


def test_a_robot_without_hands_says_so():
    _, _, skills = make(robot=TURTLEBOT)
    with pytest.raises(CannotDo, match="I have no hand"):
        skills.take(skills.find(phrase("the letter"), "thing"))


def test_interruption_ends_the_action():
    home, _, skills = make(most_s=5.0)
    with pytest.raises(Interrupted):
        skills.go("bedroom")
    assert not home.is_busy


def test_doors_are_closed_behind():
    home, _, skills = make()
    skills.look_in(skills.memory.get("bathroom"))
    assert home.state.is_("bathroom_door", "is_open")
    skills.go("office")
    assert not home.state.is_("bathroom_door", "is_open")
    assert home.plan.room_at(home.plan.position(home.state, ROBOT)) == "office"


def test_the_speaker_is_looked_for():
    _, body, skills = make()
    assert body.memory.get("alice") is None
    assert skills.speaker().id == "alice"
    skills.join(skills.speaker())
    assert skills.company() is None


def test_following_ends_where_somebody_has_arrived():
    home, _, skills = make()
    skills.person(phrase("Alice"))
    assert home.tell_person("alice", "walk", "kitchen_table") is None
    follow(skills, FilledFrame("following", (phrase("Alice", name="cotheme"),)))
    assert home.plan.room_at(home.plan.position(home.state, ROBOT)) == "kitchen"
    assert home.state.people["alice"].posture == "standing"


def test_whoever_does_not_walk_is_not_followed():
    _, _, skills = make()
    with pytest.raises(CannotDo, match="Alice does not go anywhere"):
        follow(skills, FilledFrame("following", (phrase("Alice", name="cotheme"),)))


def test_a_person_is_whoever_is_here():
    _, _, skills = make()
    skills.go("office")
    a_person = phrase("a person", quantifier="a", referents=("alice",))
    assert skills.find(a_person, "person").id == "bob"
    assert skills.find(phrase("someone", referents=("alice",))).id == "bob"
    assert skills.find(phrase("Alice", referents=("alice",)), "person").id == "alice"


def test_what_cannot_be_put_so_is_not_even_taken():
    _, body, skills = make()
    members = (phrase("the sofa"), phrase("the table"))
    goal = phrase("the sofa and the table", name="goal", relation="between", members=members, conjunction="and")
    frame = FilledFrame("placing", (phrase("the mug", name="theme"), goal))
    with pytest.raises(CannotDo, match=r"^I cannot put anything between the sofa and the table\.$"):
        put(skills, frame)
    assert not body.held()


def test_a_tool_goes_back_where_it_was_also_when_the_task_fails():
    home, body, skills = make()
    knife = skills.find(phrase("the knife"), "thing")
    skills.tidy()
    with pytest.raises(CannotDo, match=r"^The bread is gone\.$"), skills.borrowed(knife):
        assert body.held() == ("knife",)
        skills.tidy()
        raise CannotDo("The bread is gone.")
    skills.tidy()
    assert truth_of(home.plan, home.state)["knife.place"] == "in drawer"
    assert not home.state.is_("drawer", "is_open")


def test_what_somebody_had_it_take_stays_in_the_hand():
    _, body, skills = make()
    knife = skills.find(phrase("the knife"), "thing")
    for name in ("the newspaper", "the vase"):
        skills.take(skills.find(phrase(name), "thing"))
    with skills.borrowed(skills.memory.get("vase")):
        pass
    full = "My hands are full: I hold the newspaper and the vase. I need a hand for the knife."
    with pytest.raises(CannotDo, match=f"^{full}$"), skills.borrowed(knife):
        pass
    assert set(body.held()) == {"newspaper", "vase"}


def test_a_clock_that_begins_anew_makes_nothing_old():
    memory = Memory()
    memory.update([Known("mug", "thing", ("mug",), relation="on", holder="table", stamp_s=500.0)])
    memory.begin_anew()
    memory.update([Known("mug", "thing", ("mug",), relation="on", holder="desk", stamp_s=1.0)])
    assert memory.get("mug").holder == "desk"


def test_what_the_robot_does_is_told_in_words():
    body = DirectBody(make_home(), most_s=900.0)
    skills = Skills(body, speaker="alice")
    FRAMES["taking"](skills, FilledFrame("taking", (phrase("the glasses", name="theme"),)))
    looking = [words for words in body.shown if words.startswith("looking for the glasses in ")]
    assert looking and all("_" not in words for words in body.shown)
    assert body.shown[-1] == "taking the glasses"
    FRAMES["opening"](skills, FilledFrame("opening", (phrase("the wardrobe", name="container_portal"),)))
    assert body.shown[-1] == "opening the wardrobe"
