"""The reply to a prohibition or a correction comes when what runs has ended, and says how."""

import pytest

from command_server.open_commands import CommandText, Ending, Outcome
from command_server.withdrawals import CORRECTION, PROHIBITION, Withdrawals, is_against_what_runs

FOLLOW = CommandText("text-1", 1, "Follow me.")
TURN = CommandText("text-2", 2, "turn left")


def prohibition(code=PROHIBITION, sentence='I am not doing that. You said not to: "don\'t follow me".'):
    return Ending(CommandText("text-3", 3, "Don't follow me."), Outcome.REFUSED, "semantic_framer", code, sentence)


def end_of(command, outcome=Outcome.SUPERSEDED, code="STOPPED", sentence="Stopped."):
    return Ending(command, outcome, "executor", code, sentence)


@pytest.fixture
def withdrawals(clock):
    return Withdrawals(timeout_s=10.0, now=clock)


def test_prohibition_says_what_was_stopped(withdrawals):
    withdrawals.begin(prohibition(), [FOLLOW])
    (ending,) = withdrawals.hear_end(end_of(FOLLOW))
    assert ending.command == prohibition().command
    assert (ending.outcome, ending.code) == (Outcome.REFUSED, PROHIBITION)
    assert ending.sentence == 'I stopped "Follow me". You said not to.'
    assert withdrawals.next_deadline_s() is None and withdrawals.hear_end(end_of(FOLLOW)) == []


def test_correction_goes_on_to_say_what_is_missing(withdrawals):
    withdrawals.begin(prohibition(CORRECTION, "Say it in a whole sentence."), [FOLLOW])
    (ending,) = withdrawals.hear_end(end_of(FOLLOW))
    assert (ending.code, ending.sentence) == (CORRECTION, 'I stopped "Follow me". Say it in a whole sentence.')


def test_every_command_must_have_ended(withdrawals):
    withdrawals.begin(prohibition(), [FOLLOW, TURN])
    assert withdrawals.hear_end(end_of(TURN, sentence="Cancelled before it began.")) == []
    assert withdrawals.hear_end(end_of(CommandText("text-9", 9, "Ping."))) == []
    (ending,) = withdrawals.hear_end(end_of(FOLLOW))
    assert ending.sentence == 'I did not start "turn left". I stopped "Follow me". You said not to.'


@pytest.mark.parametrize(
    "outcome, code, sentence, told",
    [
        (Outcome.DONE, "DONE", "Done.", '"Follow me" was already done. You said not to.'),
        (
            Outcome.FAILED,
            "STAGE_SILENT",
            "executor did not answer within 5 s. I do not know whether the robot still moves.",
            (
                '"Follow me" has ended: executor did not answer within 5 s. I do not know whether the robot still '
                "moves. You said not to."
            ),
        ),
        (
            Outcome.SUPERSEDED,
            "STOPPED",
            "Stopped. legs did not end on cancel within 5 s.",
            'I stopped "Follow me". legs did not end on cancel within 5 s. You said not to.',
        ),
        (
            Outcome.SUPERSEDED,
            "NEW_COMMAND",
            "A newer command took its place.",
            'I stopped "Follow me". You said not to.',
        ),
    ],
)
def test_reply_is_true_however_the_command_ended(withdrawals, outcome, code, sentence, told):
    withdrawals.begin(prohibition(), [FOLLOW])
    (ending,) = withdrawals.hear_end(end_of(FOLLOW, outcome, code, sentence))
    assert ending.sentence == told


def test_wait_is_bounded(withdrawals, clock):
    withdrawals.begin(prohibition(), [FOLLOW, TURN])
    withdrawals.hear_end(end_of(TURN))
    assert withdrawals.next_deadline_s() == 110.0 and withdrawals.take_overdue() == []
    clock.now_s = 110.0
    (ending,) = withdrawals.take_overdue()
    assert (ending.outcome, ending.code) == (Outcome.FAILED, "NOT_STOPPED")
    assert ending.sentence == (
        'I stopped "turn left". I cancelled "Follow me", but the end was not confirmed within 10 s. '
        "The robot may still move."
    )
    assert withdrawals.take_overdue() == [] and withdrawals.hear_end(end_of(FOLLOW)) == []


def test_prohibition_that_is_answered_otherwise_waits_no_more(withdrawals, clock):
    withdrawals.begin(prohibition(), [FOLLOW])
    assert withdrawals.hear_end(end_of(prohibition().command)) == []
    assert withdrawals.hear_end(end_of(FOLLOW)) == []
    clock.now_s = 200.0
    assert withdrawals.take_overdue() == []


def test_two_prohibitions_wait_for_one_command(withdrawals):
    withdrawals.begin(prohibition(), [FOLLOW])
    withdrawals.begin(
        Ending(CommandText("text-4", 4, "no!"), Outcome.REFUSED, "semantic_framer", CORRECTION, "What?"), [FOLLOW]
    )
    endings = withdrawals.hear_end(end_of(FOLLOW))
    assert [ending.command.command_id for ending in endings] == ["text-3", "text-4"]


def test_only_what_was_said_before_is_ended(withdrawals):
    later = CommandText("text-5", 5, "Turn right.")
    assert withdrawals.begin(prohibition(), [FOLLOW, later]) == (FOLLOW,)
    assert withdrawals.begin(end_of(CommandText("text-0", 0, "no")), [FOLLOW]) == ()
    assert not withdrawals.is_waiting("text-0")


def test_what_waits_itself_is_not_ended(withdrawals):
    first = prohibition()
    withdrawals.begin(first, [FOLLOW])
    second = Ending(CommandText("text-4", 4, "no!"), Outcome.REFUSED, "semantic_framer", CORRECTION, "What?")
    assert withdrawals.begin(second, [FOLLOW, first.command]) == (FOLLOW,)


@pytest.mark.parametrize(
    "text, outcome, stage, code",
    [
        ("Don't follow me.", Outcome.REFUSED, "semantic_framer", "NEGATED"),
        ("not there", Outcome.REFUSED, "semantic_framer", "CORRECTION"),
        ("No, go to the garage.", Outcome.REFUSED, "frame_registrar", "NO_SERVER"),
        ("No, move forward 3 kilometres.", Outcome.REFUSED, "frame_registrar", "LIMIT"),
        ("no, wave", Outcome.REFUSED, "semantic_framer", "UNKNOWN_FRAME"),
        ("actually, take the lift", Outcome.REFUSED, "semantic_framer", "NO_READING"),
        ("nope, turn", Outcome.NEEDS_INFORMATION, "semantic_framer", "MISSING_ELEMENT"),
        ("no, turn left", Outcome.FAILED, "stanford_parser_ros", "STAGE_SILENT"),
    ],
)
def test_correction_that_anybody_refuses_is_against_what_runs(text, outcome, stage, code):
    assert is_against_what_runs(Ending(CommandText("a", 1, text), outcome, stage, code, "Why not."))


@pytest.mark.parametrize(
    "text, outcome, stage, code",
    [
        ("Go to the garage.", Outcome.REFUSED, "frame_registrar", "NO_SERVER"),
        ("No.", Outcome.REFUSED, "semantic_framer", "DECLINED"),
        ("no, keep going", Outcome.REFUSED, "semantic_framer", "CORRECTION"),
        ("no go on", Outcome.NEEDS_INFORMATION, "semantic_framer", "CORRECTION"),
        ("no, continue", Outcome.FAILED, "stanford_parser_ros", "STAGE_SILENT"),
        ("It is not hot.", Outcome.REFUSED, "semantic_framer", "REPORT"),
        ("I don't want coffee.", Outcome.REFUSED, "semantic_framer", "REPORT"),
        ("no, turn left", Outcome.DONE, "executor", "DONE"),
        ("no, turn left", Outcome.SUPERSEDED, "executor", "NEW_COMMAND"),
    ],
)
def test_what_is_no_correction_or_was_carried_out_is_against_nothing(text, outcome, stage, code):
    assert not is_against_what_runs(Ending(CommandText("a", 1, text), outcome, stage, code, "So it is."))


def test_refused_correction_says_what_was_stopped_and_why_it_is_refused(withdrawals):
    correction = Ending(
        CommandText("text-3", 3, "No, go to the garage."),
        Outcome.REFUSED,
        "frame_registrar",
        "NO_SERVER",
        "Nobody can do that.",
    )
    withdrawals.begin(correction, [FOLLOW])
    (ending,) = withdrawals.hear_end(end_of(FOLLOW))
    assert (ending.stage, ending.code) == ("frame_registrar", "NO_SERVER")
    assert ending.sentence == 'I stopped "Follow me". Nobody can do that.'
