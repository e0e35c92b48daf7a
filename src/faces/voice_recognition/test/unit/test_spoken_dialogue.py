"""The dialogue: states with an expiry."""

import random
from typing import List, Tuple

import pytest

from voice_recognition import dialogue
from voice_recognition.agreement import Heard, Verdict
from voice_recognition.dialogue import (
    Answered,
    Asked,
    Command,
    Confirm,
    Confirming,
    Deaf,
    DialogueSettings,
    Listening,
    OtherCommand,
    Pushed,
    Replying,
    RobotSpeaks,
    Say,
    Settled,
    SpeechEnded,
    Stop,
    Stopped,
    Thinking,
    Tick,
    Understood,
    Waiting,
    begin,
    step,
)
from voice_recognition.offers import Offer

SETTINGS = DialogueSettings()
ALWAYS = DialogueSettings(always_listening=True)
TURN = Offer("turning", (("direction", "left"),), "turn left", "turn left")
RIGHT = Offer("turning", (("direction", "right"),), "turn right", "turn right")
TIME = Offer("telling", (("message", "the time"),), "tell me the time", "tell you the time")
SURE = Heard(Verdict.SURE, (TURN,))


def run(events, settings: DialogueSettings = SETTINGS, state=None) -> Tuple[object, List[object]]:
    """Run events, each a second after the other."""
    state = begin(settings) if state is None else state
    done: List[object] = []
    for now, event in enumerate(events):
        state, actions = step(state, event, float(now), settings)
        done += actions
    return state, done


def spoken(heard: Heard, *, is_called: bool = False):
    return [SpeechEnded(), Understood(heard, is_called=is_called)]


def test_a_motion_is_asked_about_and_begins_with_a_yes() -> None:
    state, done = run([Pushed(), *spoken(SURE), *spoken(Heard(Verdict.SURE, answer="yes"))])
    assert done == [Say("Shall I turn left?", is_question=True), Command("turn left", "turning", is_confirmed=True)]
    assert state == Waiting()


def test_what_would_be_refused_is_asked_about_but_not_of_talk() -> None:
    refused = Heard(Verdict.LIKELY, (Offer("", (), "fly to the moon"),))
    _, done = run([Pushed(), *spoken(refused)])
    assert done == [Say('I heard "fly to the moon". Is that right?', is_question=True)]
    _, done = run(spoken(refused), ALWAYS)
    assert done == []


def test_no_ends_the_question() -> None:
    state, done = run([Pushed(), *spoken(SURE), *spoken(Heard(Verdict.SURE, answer="no"))])
    assert done[1:] == [Say(dialogue.ALL_RIGHT)] and state == Waiting()


def test_what_moves_nothing_is_not_asked_about() -> None:
    _, done = run([Pushed(), *spoken(Heard(Verdict.SURE, (TIME,)))])
    assert done == [Command("tell me the time", "telling", is_confirmed=False)]
    _, done = run([Pushed(), *spoken(Heard(Verdict.LIKELY, (TIME,)))])
    assert done == [Say("Shall I tell you the time?", is_question=True)]


@pytest.mark.parametrize(
    "confirm, frames, asks",
    [
        (Confirm.ALWAYS, {}, (True, True)),
        (Confirm.MOTION, {}, (True, False)),
        (Confirm.NEVER, {}, (False, False)),
        (Confirm.MOTION, {"telling": Confirm.ALWAYS, "turning": Confirm.NEVER}, (False, True)),
        (Confirm.NEVER, {"turning": Confirm.MOTION}, (True, False)),
    ],
)
def test_the_policy_counts_for_each_frame(confirm, frames, asks) -> None:
    settings = DialogueSettings(confirm=confirm, confirm_frames=frames)
    assert (settings.asks(TURN, Verdict.SURE), settings.asks(TIME, Verdict.SURE)) == asks
    assert settings.asks(TURN, Verdict.LIKELY) and settings.asks(TIME, Verdict.CHOICE)


def test_nothing_is_heard_without_a_push() -> None:
    assert run(spoken(SURE)) == (Waiting(), [])
    state, _ = run([Pushed(), *[Tick()] * 20, *spoken(SURE)])
    assert state == Waiting()


def test_it_listens_always_to_who_calls_it() -> None:
    talk = [spoken(Heard(Verdict.NOTHING)), spoken(Heard(Verdict.AGAIN)), spoken(SURE)]
    state, done = run([event for one in talk for event in one], ALWAYS)
    assert done == [] and state == begin(ALWAYS)
    state, done = run(spoken(SURE, is_called=True), ALWAYS)
    assert done == [Say("Shall I turn left?", is_question=True)]
    assert isinstance(state, Confirming)
    assert run(spoken(Heard(Verdict.NOTHING), is_called=True), ALWAYS) == (begin(ALWAYS), [])
    _, done = run(spoken(Heard(Verdict.AGAIN), is_called=True), ALWAYS)
    assert done == [Say(dialogue.AGAIN)]


def test_who_only_calls_it_is_listened_to_for_a_while() -> None:
    call = [SpeechEnded(), Understood(Heard(Verdict.NOTHING), is_called=True, is_call_only=True)]
    state, done = run([*call, *spoken(SURE)], ALWAYS)
    assert done == [Say(dialogue.CALLED), Say("Shall I turn left?", is_question=True)]
    state, _ = run([*call, *[Tick()] * 20], ALWAYS)
    assert state == begin(ALWAYS)
    assert run([Pushed(), *call])[1] == [Say(dialogue.CALLED)]


def test_a_stop_needs_no_call() -> None:
    assert run(spoken(Heard(Verdict.SURE, is_stop=True)), ALWAYS)[1] == [Stop()]


def test_a_choice_is_offered() -> None:
    events = [Pushed(), *spoken(Heard(Verdict.CHOICE, (TURN, RIGHT)))]
    _, done = run([*events, *spoken(Heard(Verdict.SURE, answer="second"))])
    assert done[0] == Say("Shall I first, turn left, or second, turn right?", is_question=True)
    assert done[1] == Command("turn right", "turning", is_confirmed=True)
    _, done = run([*events, *spoken(Heard(Verdict.SURE, answer="yes"))])
    assert not [one for one in done if isinstance(one, Command)]


def test_it_asks_again_and_gives_up() -> None:
    again = spoken(Heard(Verdict.AGAIN))
    state, done = run([Pushed(), *again, *again, *again])
    assert done == [Say(dialogue.AGAIN)] * 3 and state == Waiting()
    state, done = run([Pushed(), *spoken(SURE), *again, *again, *again])
    assert done[1:] == [Say(dialogue.YES_OR_NO, is_question=True)] * 2 + [Say(dialogue.ALL_RIGHT)]


def test_another_command_in_place_of_an_answer_is_offered() -> None:
    _, done = run([Pushed(), *spoken(SURE), *spoken(Heard(Verdict.SURE, (RIGHT,)))])
    assert done[-1] == Say("Shall I turn right?", is_question=True)


def test_it_is_deaf_while_the_robot_speaks_and_time_begins_afterwards() -> None:
    asking, _ = run([Pushed(), *spoken(SURE)])
    deaf, _ = step(asking, RobotSpeaks(True), 3.0, SETTINGS)
    assert isinstance(deaf, Deaf)
    same, done = run([SpeechEnded(), Understood(Heard(Verdict.SURE, answer="yes"))], state=deaf)
    assert (same, done) == (deaf, [])
    heard, _ = step(deaf, RobotSpeaks(False), 25.0, SETTINGS)
    assert heard == Confirming(25.0 + SETTINGS.answer_s, (TURN,))


def test_it_hears_again_though_nobody_says_that_the_robot_is_silent() -> None:
    asking, _ = run([Pushed(), *spoken(SURE)])
    deaf, _ = step(asking, RobotSpeaks(True), 3.0, SETTINGS)
    heard, _ = step(deaf, Tick(), 3.0 + SETTINGS.deaf_s, SETTINGS)
    assert isinstance(heard, Confirming)


@pytest.mark.parametrize("before", [[], [Pushed()], [Pushed(), *spoken(SURE)], [Pushed(), SpeechEnded()]])
@pytest.mark.parametrize("is_deaf", [False, True])
@pytest.mark.parametrize("is_emergency", [False, True])
def test_a_stop_needs_no_question_in_any_state(before, is_deaf: bool, is_emergency: bool) -> None:
    state, done = run([*before, RobotSpeaks(is_deaf), Stopped(is_emergency)])
    assert done[-1] == Stop(is_emergency)
    state, done = run([RobotSpeaks(False), Answered("yes"), *spoken(Heard(Verdict.SURE, answer="yes"))], state=state)
    assert not done and state == Waiting()


def test_an_answer_by_another_way_counts_even_while_the_robot_speaks() -> None:
    _, done = run([Pushed(), *spoken(SURE), RobotSpeaks(True), Answered("yes")])
    assert done[-1] == Command("turn left", "turning", is_confirmed=True)


def test_a_command_by_another_way_ends_the_question() -> None:
    state, done = run([Pushed(), *spoken(SURE), OtherCommand(), Answered("yes")])
    assert state == Waiting() and not [one for one in done if isinstance(one, Command)]


def test_a_question_without_an_answer_ends() -> None:
    asking, _ = run([Pushed(), *spoken(SURE)])
    state, done = step(asking, Tick(), 100.0, SETTINGS)
    assert state == Waiting() and done == (Say(dialogue.NOT_ANSWERED),)


def test_searches_that_never_end_do_not_stop_the_dialogue() -> None:
    thinking, _ = run([Pushed(), SpeechEnded()])
    assert isinstance(thinking, Thinking)
    state, _ = step(thinking, Tick(), 100.0, SETTINGS)
    assert isinstance(state, Listening)


@pytest.mark.parametrize("seed", range(200))
def test_no_motion_begins_without_a_yes_after_its_question(seed: int) -> None:
    """Whatever happens in whatever order: a motion is the one that was asked about last, and an answer followed."""
    chance = random.Random(seed)
    heard = [
        Heard(verdict, offers, answer=answer)
        for verdict in Verdict
        for offers in ((), (TURN,), (RIGHT,), (TURN, RIGHT))
        for answer in ("", "yes", "no", "first", "second")
        if bool(offers) == (verdict in (Verdict.SURE, Verdict.LIKELY, Verdict.CHOICE)) or answer
    ]
    events = [Pushed(), SpeechEnded(), Answered("yes"), OtherCommand(), Stopped(), Tick(), RobotSpeaks(True)]
    state = begin(SETTINGS)
    asked, now = "", 0.0
    for _ in range(300):
        event = chance.choice([*events, RobotSpeaks(False), Understood(chance.choice(heard))])
        now += chance.choice([0.1, 1.0, 6.0])
        state, actions = step(state, event, now, SETTINGS)
        for action in actions:
            if isinstance(action, Command):
                assert action.is_confirmed and action.text in asked
                assert isinstance(event, Answered) or (isinstance(event, Understood) and event.heard.answer)
        said = [action for action in actions if isinstance(action, Say) and "Shall I" in action.sentence]
        if said:
            asked = said[-1].sentence
        if not isinstance(event, (Tick, RobotSpeaks)) and any(isinstance(one, (Stop, Command)) for one in actions):
            asked = ""


def test_a_yes_answers_the_pipeline() -> None:
    state, done = run([Asked(True), *spoken(Heard(Verdict.SURE, answer="Yes"))])
    assert (state, done) == (Waiting(), [Command("Yes", "", is_confirmed=True)])


def test_a_choice_that_was_heard_is_confirmed() -> None:
    heard = Heard(Verdict.SURE, answer="the red mug")
    state, done = run([Asked(True), *spoken(heard), *spoken(Heard(Verdict.SURE, answer="yes"))])
    assert isinstance(done[0], Say) and "the red mug" in done[0].sentence
    assert (state, done[1:]) == (Waiting(), [Command("the red mug", "", is_confirmed=True)])
    assert run([Asked(True), Answered("the red mug")])[1] == [Command("the red mug", "", is_confirmed=True)]


def test_a_command_may_take_the_place_of_an_answer() -> None:
    state, done = run([Asked(True), *spoken(SURE)])
    assert isinstance(state, Confirming) and done == [Say("Shall I turn left?", is_question=True)]


def test_what_is_no_answer_is_asked_for_again_and_at_last_given_up() -> None:
    state, done = run([Asked(True), *spoken(Heard(Verdict.AGAIN)) * 2])
    assert isinstance(state, Replying) and done == [Say(dialogue.AGAIN, is_question=True)] * 2
    state, done = run(spoken(Heard(Verdict.AGAIN)), state=state)
    assert state == Waiting() and not any(isinstance(one, Command) for one in done)


@pytest.mark.parametrize("event", [Settled(), OtherCommand(), Stopped()])
def test_a_question_of_the_pipeline_that_is_answered_is_closed(event) -> None:
    assert run([Asked(True), event])[0] == Waiting()
    speaking, _ = run([RobotSpeaks(True), Asked(True), event])
    assert isinstance(speaking, Deaf) and speaking.behind == Waiting()


def test_a_question_of_the_pipeline_expires_without_a_word() -> None:
    state, _ = run([Asked(True)])
    assert step(state, Tick(), SETTINGS.answer_s, SETTINGS) == (Waiting(), ())


def test_an_open_question_is_answered_by_a_command() -> None:
    assert isinstance(run([Asked(False)])[0], Listening)


def test_the_own_question_comes_before_that_of_the_pipeline() -> None:
    state, _ = run([Pushed(), *spoken(SURE), Asked(True)])
    assert isinstance(state, Confirming)
