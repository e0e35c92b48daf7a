"""The dialogue about who is meant, stops, the roster, the one answer of several, and the policies."""

from dataclasses import replace

import pytest

from robot_fleet.addressing import Addressed, Company, Dialogue, Order, Robot, Unaddressed, address, others_addressed
from robot_fleet.answers import Answer, OpenUtterance, Outcome
from robot_fleet.loss import Act, Hearing, Policy
from robot_fleet.places import place_in
from robot_fleet.robot_names import Names
from robot_fleet.roster import Roster
from robot_fleet.stops import stops

VERBS = frozenset("come go turn bring stop wait".split())
COMPANY = Company((Robot("alpha"), Robot("beta"), Robot("gamma")), ("delta",), VERBS)
NAMES = Names({"alpha": (), "beta": (), "gamma": ()})


def say(text, dialogue=None, *, company=COMPANY, now_s=1.0, near=None):
    return address(text, company, dialogue or Dialogue(), now_s=now_s, near=near)


def test_a_name_answers_the_question_who_should_do_it():
    asked = say("Come here.")
    assert isinstance(asked, Unaddressed)
    assert asked.sentence == "Who should do that: Alpha, Beta or Gamma?"
    answered = say("Beta, please.", asked.dialogue)
    assert isinstance(answered, Addressed)
    assert (answered.orders[0].robots, answered.orders[0].text) == (("beta",), "Come here.")
    assert answered.dialogue.pending is None


@pytest.mark.parametrize("answer", ["Nobody.", "No.", "Never mind."])
def test_nobody_answers_it_too(answer):
    declined = say(answer, say("Come here.").dialogue)
    assert isinstance(declined, Unaddressed)
    assert declined.code == "DECLINED"


def test_the_question_is_forgotten():
    asked = say("Come here.")
    late = say("Beta.", asked.dialogue, now_s=100.0)
    assert isinstance(late, Unaddressed)
    assert late.code == "ATTENTION"


def test_another_command_takes_the_place_of_the_question():
    again = say("Gamma, turn left.", say("Come here.").dialogue)
    assert isinstance(again, Addressed)
    assert again.orders[0].text == "turn left."


def test_who_was_spoken_to_long_ago_is_not_meant():
    spoken = say("Alpha, come here.")
    assert isinstance(say("Turn left.", spoken.dialogue, now_s=500.0), Addressed)
    assert isinstance(say("Turn left.", spoken.dialogue, now_s=700.0), Unaddressed)


def test_a_cry_for_all_leaves_the_dialogue_as_it_is():
    spoken = say("Alpha, come here.")
    stopped = say("Stop!", spoken.dialogue)
    assert stopped.orders[0].robots == ("alpha", "beta", "gamma")
    assert say("Turn left.", stopped.dialogue).orders[0].robots == ("alpha",)


def test_two_robots_that_ask_are_told_apart():
    asked = say("The red one.", Dialogue(last=("alpha",), asking=("alpha", "gamma"), said_s=0.0))
    assert asked.sentence == "Whom do you mean: Alpha or Gamma?"


def test_the_nearest_of_the_free_robots_is_asked_first():
    robots = (Robot("alpha", place=(0.0, 0.0)), Robot("beta", place=(5.0, 0.0)), Robot("gamma", is_free=False))
    company = replace(COMPANY, robots=robots)
    assert say("Somebody bring the cup.", company=company, near=(6.0, 0.0)).orders[0].robots == ("beta", "alpha")


def test_place_of_the_longest_name():
    places = [("table", (1.0, 0.0)), ("kitchen table", (2.0, 0.0))]
    assert place_in("Somebody, go to the kitchen table.", places) == (2.0, 0.0)
    assert place_in("Somebody, come here.", places) is None


def test_names_with_numbers_and_other_names():
    names = Company((Robot("tb3_0"), Robot("robot_1", spoken=("Robbie",))), verbs=VERBS)
    assert say("TB3 0, come here.", company=names).orders[0].robots == ("tb3_0",)
    assert say("Robot 1, come here.", company=names).orders[0].robots == ("robot_1",)
    assert say("Robbie come here.", company=names).orders[0].robots == ("robot_1",)


def test_nobody_is_there():
    assert say("Come here.", company=Company()).code == "NO_ROBOT"


@pytest.mark.parametrize(
    ("text", "stopped"),
    [
        ("Stop.", ("alpha", "beta", "gamma")),
        ("Everybody stop!", ("alpha", "beta", "gamma")),
        ("Alpha, stop.", ("alpha",)),
        ("Stop, Beta!", ("beta",)),
        ("Alpha and Gamma, stop.", ("alpha", "gamma")),
        ("Everybody but Beta, stop.", ("alpha", "gamma")),
        ("Tell Gamma to stop.", ("gamma",)),
        ("Alpha, turn left, and Beta, stop.", ("beta",)),
        ("The others, stop.", ("alpha", "beta", "gamma")),
        ("Rosie, stop!", ("alpha", "beta", "gamma")),
        ("Alpha, come here.", ()),
        ("Follow Beta.", ()),
    ],
)
def test_whom_a_cry_stops(text, stopped):
    assert tuple(robot for robot in ("alpha", "beta", "gamma") if stops(text, robot, NAMES)) == stopped


@pytest.mark.parametrize(
    ("text", "others"),
    [
        ("Beta, come here.", ("beta",)),
        ("Alpha, come here.", ()),
        ("Come here.", ()),
        ("Alpha and Beta, come here.", ()),
        ("Everybody, come here.", ()),
        ("Go to Beta.", ()),
    ],
)
def test_what_is_said_to_alpha_alone_may_be_for_another(text, others):
    assert others_addressed(text, "alpha", NAMES, VERBS) == others


def test_robots_join_and_leave():
    roster = Roster(silence_s=1.5)
    assert roster.hear("beta", "b", now_s=0.0).joined == ("beta",)
    assert roster.hear("alpha", "a", now_s=1.0).joined == ("alpha",)
    assert not roster.hear("beta", "b2", now_s=1.0)
    assert roster.members == ("a", "b2")
    assert not roster.turn(now_s=2.5)
    roster.hear("alpha", "a", now_s=2.4)
    assert roster.turn(now_s=2.6).left == ("beta",)
    assert (roster.members, roster.absent) == (("a",), ("beta",))
    assert roster.hear("beta", "b", now_s=3.0).joined == ("beta",)
    assert roster.absent == ()


def done(robot, sentence="Done."):
    return Answer(robot, Outcome.DONE, "DONE", sentence)


def test_one_answer_of_several_robots():
    utterance = OpenUtterance((Order(("alpha", "beta"), "turn left"),))
    assert [sending.robot for sending in utterance.begin()] == ["alpha", "beta"]
    assert utterance.hear(0, done("beta")) == ()
    assert not utterance.is_complete
    utterance.hear(0, Answer("alpha", Outcome.FAILED, "ALL_CANDIDATES_FAILED", "I am stuck."))
    assert utterance.is_complete
    whole = utterance.whole_answer()
    assert (whole.outcome, whole.sentence) == (Outcome.FAILED, "Alpha: I am stuck. Beta: Done.")


def test_an_answer_counts_once():
    utterance = OpenUtterance((Order(("alpha",), "turn left"),))
    utterance.begin()
    utterance.hear(0, done("alpha"))
    utterance.hear(0, done("alpha"))
    assert len(utterance.answers) == 1


def test_the_next_robot_is_asked_when_one_cannot():
    utterance = OpenUtterance((Order(("alpha", "beta"), "bring a cup", is_any=True),))
    assert [sending.robot for sending in utterance.begin()] == ["alpha"]
    following = utterance.hear(0, Answer("alpha", Outcome.REFUSED, "NO_SERVER", "I cannot."))
    assert [sending.robot for sending in following] == ["beta"]
    utterance.hear(0, done("beta"))
    assert utterance.whole_answer().sentence == "Beta: Done."


def test_one_that_has_tried_is_not_followed_by_another():
    utterance = OpenUtterance((Order(("alpha", "beta"), "bring a cup", is_any=True),))
    utterance.begin()
    assert utterance.hear(0, Answer("alpha", Outcome.FAILED, "ALL_CANDIDATES_FAILED", "It fell.")) == ()
    assert utterance.is_complete


def test_what_follows_waits_until_everything_before_it_is_done():
    orders = (Order(("alpha",), "turn left"), Order(("beta",), "come here", is_after=True))
    utterance = OpenUtterance(orders)
    assert [sending.robot for sending in utterance.begin()] == ["alpha"]
    assert [sending.robot for sending in utterance.hear(0, done("alpha"))] == ["beta"]
    failed = OpenUtterance(orders)
    failed.begin()
    assert failed.hear(0, Answer("alpha", Outcome.FAILED, "X", "I am stuck.")) == ()
    assert failed.is_complete
    assert failed.whole_answer().sentence == 'Alpha: I am stuck. I did not ask Beta to do this: "come here".'


@pytest.mark.parametrize(
    ("policy", "acts"),
    [
        (Policy.FINISH, (Act.TELL_LOSS,)),
        (Policy.STOP, (Act.TELL_LOSS, Act.STOP)),
        (Policy.GO_HOME, (Act.TELL_LOSS, Act.STOP, Act.GO_HOME)),
    ],
)
def test_policy_of_a_robot_that_is_alone(policy, acts):
    never, _ = Hearing(0.0).turn(100.0, silence_s=5.0, policy=policy)
    assert not never.is_lost
    heard, told = Hearing(0.0).hear(1.0)
    assert told == ()
    heard, told = heard.turn(6.0, silence_s=5.0, policy=policy)
    assert told == ()
    lost, told = heard.turn(6.1, silence_s=5.0, policy=policy)
    assert (told, lost.is_lost) == (acts, True)
    assert lost.turn(7.0, silence_s=5.0, policy=policy) == (lost, ())
    back, told = lost.hear(8.0)
    assert (told, back.is_lost) == ((Act.TELL_RETURN,), False)
