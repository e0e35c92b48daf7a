"""What was stopped goes on only after a question, and a yes."""

from dataclasses import replace

import pytest

from command_server.going_on import GoingOn, Stopped
from command_server.open_commands import CommandText, Ending, Outcome

STOP_NS = 1000
GO_ON = Ending(
    CommandText("text-9", 2000, "Go on."), Outcome.DONE, "question_answering", "DONE", "No standing order is suspended."
)
KITCHEN = Stopped("text-1", 10, "a plan", '"go to the kitchen"', heard_ns=900)
HELLO = Stopped("text-2", 20, "another plan", '"say hello"', heard_ns=950)


@pytest.fixture
def going_on(clock):
    return GoingOn(now=clock)


def ask(going_on, ending=GO_ON, stop_stamp_ns=STOP_NS):
    return going_on.asked(ending, stop_stamp_ns=stop_stamp_ns)


def test_question_names_what_is_left(going_on):
    going_on.hear_stopped(KITCHEN)
    asked = ask(going_on)
    assert (asked.outcome, asked.stage, asked.code) == (Outcome.NEEDS_INFORMATION, "command_server", "CONFIRM")
    assert asked.sentence == 'No standing order is suspended. Shall I go on with "go to the kitchen"?'
    refused = replace(GO_ON, outcome=Outcome.REFUSED, code="NO_SERVER", sentence="Nobody can do that.")
    assert ask(going_on, refused).sentence == 'Shall I go on with "go to the kitchen"?'


@pytest.mark.parametrize("text", ["yes", "Yes, please.", "go ahead", "Do it!"])
def test_yes_goes_on_once(going_on, text):
    going_on.hear_stopped(KITCHEN)
    ask(going_on)
    assert going_on.answered(text) == ("a plan",)
    assert going_on.answered(text) is None
    assert ask(going_on) == GO_ON


def test_no_forgets_it(going_on):
    going_on.hear_stopped(KITCHEN)
    ask(going_on)
    assert going_on.answered("No.") == ()
    assert ask(going_on) == GO_ON


@pytest.mark.parametrize("text", ["Turn left.", "yes, turn left", "what?"])
def test_another_utterance_ends_the_question_and_not_the_memory(going_on, text):
    going_on.hear_stopped(KITCHEN)
    ask(going_on)
    assert going_on.answered(text) is None
    assert going_on.answered("yes") is None
    assert ask(going_on) != GO_ON


def test_question_expires(going_on, clock):
    going_on.hear_stopped(KITCHEN)
    ask(going_on)
    clock.now_s += 61.0
    assert going_on.answered("yes") is None


def test_nobody_is_asked_about_what_no_stop_has_ended(going_on):
    assert ask(going_on) == GO_ON
    going_on.hear_stopped(replace(KITCHEN, stamp_ns=STOP_NS + 1))
    assert ask(going_on) == GO_ON


def test_what_was_forbidden_is_not_offered_after_a_later_stop(going_on):
    going_on.hear_cancelled(KITCHEN.command_id)
    going_on.hear_stopped(KITCHEN)
    assert ask(going_on) == GO_ON


def test_one_stop_may_end_several(going_on):
    going_on.hear_stopped(HELLO)
    going_on.hear_stopped(KITCHEN)
    assert ask(going_on).sentence.endswith('Shall I go on with "go to the kitchen", and then with "say hello"?')
    assert going_on.answered("yes") == ("a plan", "another plan")


def test_later_stop_replaces_an_earlier_one(going_on):
    going_on.hear_stopped(KITCHEN)
    going_on.hear_stopped(replace(HELLO, stamp_ns=901))
    assert ask(going_on).sentence.endswith('Shall I go on with "say hello"?')


@pytest.mark.parametrize("text", ["Keep following me.", "Drive on.", "Go on to the kitchen.", "What are you doing?"])
def test_only_going_on_asks(going_on, text):
    going_on.hear_stopped(KITCHEN)
    other = replace(GO_ON, command=CommandText("text-9", 2000, text))
    assert ask(going_on, other) == other
