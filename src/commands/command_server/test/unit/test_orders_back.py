"""Right after a standing order was given, "forget that" means the order. At any other time it stops the robot."""

import copy

import pytest
import rospy
from roboframenet_msgs.msg import Command, CommandStatus, Reply

from command_server.open_commands import Outcome
from command_server.orders_back import FORGET_ALL, order_words, said_behind, takes_order_back
from command_server.ros_orders_back import OrdersTakenBack
from command_server.stop_words import find_cry

GIVEN = {"is_free": True, "stage": "standing_orders", "outcome": Outcome.DONE, "age_s": 2.0}


@pytest.mark.parametrize(
    "text", "Forget that.; forget it; Oh, forget it!; never mind; cancel that; Scratch that.".split("; ")
)
def test_takes_the_order_back(text):
    assert takes_order_back(text, **GIVEN)


@pytest.mark.parametrize(
    "text", "Stop.; stop, forget it; Wait!; Halt!; Don't move!; hold on; enough; Go on.".split("; ")
)
def test_other_cries_stop(text):
    assert not takes_order_back(text, **GIVEN)


@pytest.mark.parametrize("text", ["Forget it, come back.", "forget it and go home", "forget it, stop!"])
def test_another_command_behind_it_is_a_stop_and_that_command(text):
    assert not takes_order_back(text, **GIVEN)


@pytest.mark.parametrize(
    "other",
    [
        {"is_free": False},
        {"stage": "executor"},
        {"stage": ""},
        {"outcome": Outcome.REFUSED},
        {"age_s": 61.0},
        {"age_s": -5.0},
    ],
)
def test_at_any_other_time_it_is_a_stop(other):
    assert not takes_order_back("Forget that.", **{**GIVEN, **other})


@pytest.mark.parametrize(
    "text",
    [
        "Forget everything.",
        "Please forget everything, robot.",
        "Forget all orders.",
        "forget all my orders",
        "Cancel all orders.",
        "Forget everything I told you.",
    ],
)
def test_all_orders_are_forgotten_behind_the_stop(text):
    cry = find_cry(text)
    assert cry is not None
    assert said_behind(cry) == FORGET_ALL
    assert order_words(text) == FORGET_ALL


@pytest.mark.parametrize(
    "text",
    ["Forget it.", "Forget the last command.", "Forget my last orders.", "Cancel everything.", "Forget what I said."],
)
def test_other_cries_keep_the_orders(text):
    cry = find_cry(text)
    assert cry is not None
    assert not said_behind(cry)


def test_a_command_behind_a_cry_comes_first():
    cry = find_cry("Forget everything and come back.")
    assert cry is not None
    assert said_behind(cry) == "come back."


def test_what_is_done_behind_the_stop_is_no_stop():
    assert find_cry(FORGET_ALL) is None


SAID = CommandStatus(active=[Command(id="text-1", text="Forget that.", stamp=rospy.Time(99))])
ANSWERED = CommandStatus(last_reply=Reply(command=SAID.active[0], stage="question_answering", stamp=rospy.Time(99.5)))
NEXT_SAID = CommandStatus(active=[Command(id="text-2", text="What do you wait for?", stamp=rospy.Time(99.6))])
NEXT_ANSWERED = CommandStatus(last_reply=Reply(command=NEXT_SAID.active[0], stage="question_answering"))


@pytest.fixture(autouse=True)
def _now(monkeypatch):
    monkeypatch.setattr(rospy.Time, "now", lambda: rospy.Time(100))


def _is_meant(text, *statuses):
    orders_back = OrdersTakenBack()
    for status in statuses:
        orders_back.hear_status(status)
    return orders_back.is_meant(text)


@pytest.mark.parametrize("statuses", [[SAID], [ANSWERED], [SAID, NEXT_SAID], [ANSWERED, NEXT_SAID, NEXT_ANSWERED]])
@pytest.mark.parametrize("text", ["Forget that.", "forget that"])
def test_who_hears_it_after_the_command_server_takes_it_for_no_cry(text, statuses):
    assert _is_meant(text, *statuses)


def test_who_hears_the_reply_first_takes_it_for_no_cry():
    orders_back = OrdersTakenBack()
    orders_back.hear_status(NEXT_SAID)
    orders_back.hear_reply(ANSWERED.last_reply)
    assert orders_back.is_meant("Forget that.")


def _changed(status, **changes):
    changed = copy.deepcopy(status)
    for path, value in changes.items():
        *owners, name = path.split("__")
        target = changed
        for owner in owners:
            target = target[int(owner)] if owner.isdigit() else getattr(target, owner)
        setattr(target, name, value)
    return changed


@pytest.mark.parametrize(
    ("text", "status"),
    [
        ("Cancel that.", SAID),
        ("Forget that.", _changed(SAID, active__0__stamp=rospy.Time(90))),
        ("Forget that.", _changed(SAID, active__0__id="text-1-then")),
        ("Forget that.", _changed(ANSWERED, last_reply__stage="stop_server")),
        ("Forget that.", _changed(ANSWERED, last_reply__stage="command_server")),
        ("Forget that.", _changed(ANSWERED, last_reply__command__stamp=rospy.Time(90))),
        ("Forget that.", NEXT_SAID),
        ("Stop.", _changed(SAID, active__0__text="Stop.")),
        ("Stop.", _changed(ANSWERED, last_reply__command__text="Stop.")),
    ],
)
def test_who_hears_it_alone_stops(text, status):
    assert not _is_meant(text, status)


def test_what_was_said_long_ago_is_another_utterance():
    assert not _is_meant("Forget that.", _changed(SAID, active__0__stamp=rospy.Time(90)), NEXT_SAID)


def test_order_that_was_just_given_is_taken_back():
    given = CommandStatus(last_reply=Reply(stage="standing_orders", outcome=Reply.DONE, stamp=rospy.Time(98)))
    assert _is_meant("Forget that.", given)
    assert not _is_meant("Stop.", given)
